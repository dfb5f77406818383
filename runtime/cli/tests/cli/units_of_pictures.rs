//! Pictures in other units: axes, their numbers, legends and notes.

use crate::Directory;

/// Pictures of the commands that compare, move and turn: axes, their numbers, legends and notes.
#[test]
fn pictures_of_comparisons_motions_and_turns_are_in_other_units() {
    let directory = Directory::of_this_test();
    let draw = |arguments: &[&str], option: &str, units: &str| {
        let run = directory.run(&[arguments, &[option, "a.svg", "--units", units][..]].concat());
        assert!(run.code == Some(0) && !run.stderr.contains("--units"), "{arguments:?}: {}", run.stderr);
        std::fs::read_to_string(directory.0.join("a.svg")).unwrap()
    };
    let shows = |picture: &str, texts: &[&str]| {
        let labels: Vec<&str> =
            picture.split("aria-label=\"").skip(1).filter_map(|label| label.split('"').next()).collect();
        texts.iter().for_each(|text| assert!(labels.contains(text), "no {text:?}: {labels:?}"));
        assert!(!labels.iter().any(|label| label.contains("m/s")), "{labels:?}");
    };
    // How a curve of a colour is drawn.
    let curves = |picture: &str, color: &str| -> Vec<String> {
        let stroke = format!("stroke=\"#{color}\"");
        picture.lines().filter(|line| line.contains(&stroke)).map(str::to_owned).collect()
    };
    // 4.29238 and 6.02426 m/s, as the paper prints them, times 3.6 and by 0.44704; 18 degrees are 0.314 rad.
    let compare = ["compare", "benchmark", "benchmark:lam=20deg"];
    let picture = draw(&[&compare[..], &["--xlim", "0:10"]].concat(), "--plot", "km/h");
    shows(&picture, &["speed v (km/h)", "stable 15.45 to 21.69 km/h", "35"]);
    let picture = draw(&compare, "--contributions", "mph,rad");
    shows(&picture, &["contribution to the difference of the critical speed (mph)", "0.314 to 0.349 rad"]);
    assert!(picture.contains("weave speed, from 9.6018 to "));
    let turns = draw(&["turns"], "--plot", "in,mph,rad");
    shows(&turns, &["speed v of the rear wheel (mph)", "angles (rad)", "radius (in)", "12"]);
    assert!(turns.contains("radius, up to 300 in: "));
    let optimize = ["optimize", "--vary", "c=0.06:0.1", "--minimize", "weave-speed", "--starts", "1"];
    shows(&draw(&optimize, "--plot", "km/h"), &["speed v (km/h)"]);
    // 5 m/s, and 2 N m s/rad by 0.5 rad/s; after 1 s it is 5 m ahead, of which 4000 mm is a tick.
    let simulate = ["simulate", "--speed", "5", "--duration", "1", "--initial", "phi_rate=0.5", "--feedback"];
    let simulate = [&simulate[..], &["Tdelta=-2*phi_rate"]].concat();
    let picture = draw(&simulate, "--plot", "km/h,mm,lbf*in");
    let path = ["forward at the start, x (mm)", "to the right, y (mm)", "4000"];
    shows(&picture, &[&["angles (°)", "torques (lbf in)", "v (km/h)", "18.0"], &path[..]].concat());
    // The same curves, where the axes are a hundred times as long in a hundredth of the unit.
    for (arguments, units, color) in [(&simulate[..], ["m", "cm"], "d06a10"), (&compare[..], ["m/s", "cm/s"], "1f6fb4")]
    {
        let drawn = units.map(|units| curves(&draw(arguments, "--plot", units), color));
        assert!(!drawn[0].is_empty() && drawn[0] == drawn[1], "{arguments:?}: {drawn:?}");
    }
}

/// Lengths, masses and the angle in side views: an inch is 0.0254 m, and a pound 0.45359237 kg.
#[test]
fn side_views_are_in_other_units() {
    let directory = Directory::of_this_test();
    let draw = |arguments: &[&str]| {
        let run = directory.run(arguments);
        assert!(run.code == Some(0) && !run.stderr.contains("--units"), "{arguments:?}: {}", run.stderr);
        std::fs::read_to_string(directory.0.join("a.svg")).unwrap()
    };
    let shows = |picture: &str, texts: &[&str]| {
        texts.iter().for_each(|text| assert!(picture.contains(&format!("\"{text}\"")), "no {text:?}: {picture}"));
    };
    let show = ["show", "benchmark", "--plot", "a.svg", "--units"];
    let picture = draw(&[&show[..], &["in,lb,rad"]].concat());
    shows(&picture, &["wheel base w = 40.157 in", "trail c = 3.15 in", "B  187.393 lb", "λ = 0.3142 rad"]);
    let picture = draw(&[&show[..], &["mm"]].concat());
    shows(&picture, &["wheel base w = 1020 mm", "trail c = 80 mm", "B  85 kg", "λ = 18.00°"]);
    let compare = ["compare", "benchmark", "benchmark:lam=20deg", "--side-view", "a.svg", "--units"];
    let picture = draw(&[&compare[..], &["imperial"]].concat());
    shows(&picture, &["benchmark: wheel base 40.16 in, trail 3.15 in, tilt 18.00°"]);
    let picture = draw(&[&compare[..], &["mm"]].concat());
    shows(&picture, &["benchmark: wheel base 1020 mm, trail 80 mm, tilt 18.00°"]);
}
