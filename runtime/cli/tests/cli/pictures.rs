//! Pictures: that they are written, hold what they should, and say so.

use crate::Directory;

/// The texts of a picture; they are drawn as outlines and labelled for readers that cannot see them.
pub fn texts(svg: &str) -> Vec<String> {
    let labels = svg.split("aria-label=\"").skip(1);
    labels.filter_map(|rest| rest.split_once('"')).map(|(text, _)| text.to_owned()).collect()
}

#[track_caller]
fn picture(arguments: &[&str]) -> Vec<String> {
    let directory = Directory::of_this_test();
    let run = directory.run(&[arguments, &["--plot", "picture.svg"]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stderr.ends_with("wrote: picture.svg\n"), "{}", run.stderr);
    let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    texts(&svg)
}

#[test]
fn eigenvalues_have_axes_modes_and_critical_speeds() {
    let texts = picture(&["analyze", "benchmark"]);
    for expected in [
        "forward speed v (m/s)",
        "eigenvalue λ (1/s)",
        "stable",
        "weave 4.2924",
        "capsize 6.0243",
        "double root 0.6843",
        "castering",
        "capsize",
        "weave, real part",
        "weave, imaginary part",
    ] {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
}

/// Real parts above imaginary parts, and each mode with its name in both where it oscillates.
#[test]
fn modes_of_other_models_are_drawn_one_by_one() {
    let has = |texts: &[String], wanted: &str| texts.iter().any(|text| text == wanted);
    let count = |texts: &[String], wanted: &str| texts.iter().filter(|text| *text == wanted).count();
    let of_three = picture(&["analyze", "--model", "ThreePipes"]);
    let of_two = picture(&["analyze", "--model", "TwoPipes"]);
    for texts in [&of_three, &of_two] {
        for expected in ["speed v (m/s)", "real parts (1/s)", "imaginary parts (rad/s)", "stable"] {
            assert_eq!(count(texts, expected), 1, "{expected}: {texts:?}");
        }
        assert!(!has(texts, "castering") && !has(texts, "weave, real part"), "{texts:?}");
    }
    assert!(has(&of_three, "Eigenvalues of ThreePipes hose against speed"), "{of_three:?}");
    assert!(has(&of_two, "divergence 5.6256") && has(&of_three, "flutter 5.6395"));
    assert_eq!(["flutter", "mode 2", "mode 3"].map(|name| count(&of_three, name)), [2, 2, 2], "{of_three:?}");
    // Without anything that oscillates there is one graph.
    let car = picture(&["analyze", "--model", "Car", "oversteering"]);
    assert!(has(&car, "divergence 63.3542") && !has(&car, "imaginary parts (rad/s)"), "{car:?}");
    let motorcycle = picture(&["analyze", "--model", "Motorcycle"]);
    for expected in ["weave 5.9253", "capsize 10.7321", "wobble 55.3775"] {
        assert!(has(&motorcycle, expected), "{motorcycle:?}");
    }
    assert_eq!(["weave", "wobble", "capsize"].map(|name| count(&motorcycle, name)), [2, 2, 1], "{motorcycle:?}");
}

/// What is fast is below the axis at 8 m/s, and above the other one at rest.
#[test]
fn what_leaves_either_graph_is_told_apart() {
    let notes = |arguments: &[&str]| -> Vec<String> {
        picture(arguments).into_iter().filter(|text| text.starts_with("Beyond the axes")).collect()
    };
    let pipes = notes(&["analyze", "--model", "ThreePipes"]);
    assert!(pipes[0].starts_with("Beyond the axes of real parts: mode 2 to −25.9 at 8 m/s; "), "{pipes:?}");
    assert_eq!(pipes[1], "Beyond the axes of imaginary parts: mode 3 to 20.3 at 0 m/s");
}

/// Castering of the benchmark is at -24.6246 1/s at 10 m/s, weave at 10.9068 i (Meijaard et al. 2007, Table 2).
#[test]
fn what_leaves_the_axes_is_told() {
    let note = |arguments: &[&str]| picture(arguments).into_iter().find(|text| text.starts_with("Beyond the axes: "));
    let expected = "Beyond the axes: weave, imaginary part to 10.9 at 10 m/s; castering to −24.6 at 10 m/s";
    assert_eq!(note(&["analyze", "benchmark"]).as_deref(), Some(expected));
    assert_eq!(note(&["analyze", "benchmark", "--ylim", "-30:20"]), None);
    let cut = note(&["analyze", "benchmark", "--ylim=-3:3", "--xlim", "2:8"]).unwrap();
    assert!(cut.contains("all of castering, −20.3 to −8.67") && cut.contains("capsize to −3.07 at 2 m/s"), "{cut}");
    // A range in which castering is far below the others: something of it shows all the same.
    assert!(!note(&["analyze", "benchmark", "--speeds", "7:10:1"]).is_some_and(|text| text.contains("all of")));
}

#[test]
fn limits_are_two_numbers_that_ascend() {
    let directory = Directory::of_this_test();
    for (option, message) in [
        ("--ylim=3:-3", "the limits are 3 and -3; the second must be above the first"),
        ("--ylim=3", "expected two limits LOW:HIGH, such as -10:10"),
        ("--ylim=a:3", "a limit is `a`; it must be a finite number"),
        ("--xlim=-1:3", "a speed is -1; it must be >= 0"),
        ("--xlim=2:2", "the limits are 2 and 2; the second must be above the first"),
    ] {
        let run = directory.run(&["analyze", "--plot", "picture.svg", option]);
        assert_eq!(run.code, Some(2), "{option}");
        assert!(run.stderr.contains(message), "{option}: {}", run.stderr);
        assert!(!directory.0.join("picture.svg").exists());
    }
    assert_eq!(directory.run(&["analyze", "--ylim=-3:3"]).code, Some(2));
}

#[test]
fn a_side_view_has_every_body_and_tells_what_it_leaves_out() {
    let has = |texts: &[String], wanted: &str| texts.iter().any(|text| text == wanted);
    let leaning = picture(&["show", "--model", "WhippleLeaning"]);
    assert!(has(&leaning, "U  40 kg") && has(&leaning, "hip axis"), "{leaning:?}");
    assert!(has(&leaning, "Not drawn: moments and products of inertia, kU, dU"), "{leaning:?}");
    // As `show` says: mR is the mass of the front wheel, of 2 kg, and the steered wheel, of 3 kg, is the rear one.
    let reversed = picture(&["show", "--model", "RearSteered"]);
    assert!(has(&reversed, "front wheel R  2 kg") && has(&reversed, "rear wheel F  3 kg"), "{reversed:?}");
    let directory = Directory::new("left-out");
    let run = directory.run(&["show", "--model", "WhippleLeaning", "--plot", "picture.svg"]);
    assert!(run.stderr.contains("the side view has no place for kU, dU"), "{}", run.stderr);
}

#[test]
fn a_bar_chart_has_a_legend_and_every_parameter_with_its_step() {
    let texts = picture(&["sensitivity"]);
    for expected in [
        "Sensitivity of benchmark: what 1 % of each parameter changes",
        "weave speed, 4.2924 m/s",
        "capsize speed, 6.0243 m/s",
        "λ",
        "+0.18°",
        "IRxx",
        "−0.009 m",
        "+0.85 kg",
    ] {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
    assert!(texts.iter().any(|text| text.starts_with("change of the critical speed (m/s)")), "{texts:?}");
    assert!(!texts.iter().any(|text| text == "IByy" || text.contains('*')), "{texts:?}");
    let texts = picture(&["sensitivity", "--set", "IFyy=0"]);
    assert!(texts.iter().any(|text| text.starts_with("* +")) && !texts.iter().any(|text| text.contains("capsize")));
}

/// Wobble at 215 m/s, where the motion has been unstable for long, depends on everything: beside it nothing else would be seen.
#[test]
fn a_bar_chart_is_of_the_speeds_that_matter() {
    let texts = picture(&["sensitivity", "--model", "Motorcycle"]);
    let note = "Not drawn, beyond the speeds that matter: wobble speed, 215.2466 m/s";
    for expected in ["wobble speed, 55.3775 m/s", "capsize speed, 10.7321 m/s", note] {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
    // 1 % of the load of the front wheel moves the capsize speed by 1.13 m/s, and the axis goes no further than that.
    let ticks = texts.iter().filter_map(|text| text.replace('−', "-").parse::<f64>().ok()).map(f64::abs);
    assert_eq!(ticks.fold(0.0, f64::max), 1.2, "{texts:?}");
    assert!(!texts.contains(&"wobble speed, 215.2466 m/s".to_owned()));
}

#[test]
fn every_bicycle_has_both_pictures() {
    for bicycle in ["benchmark", "balanceassistv1", "browser", "pista", "silver", "yellowrev", "pista-rider"] {
        assert!(picture(&["analyze", bicycle]).len() > 20);
        let side = picture(&["show", bicycle]);
        for expected in ["steer axis", "wheel base", "trail", "λ = ", "B  ", "H  ", "R  ", "F  "] {
            assert!(side.iter().any(|text| text.starts_with(expected)), "{expected} is not in {side:?}");
        }
    }
}

#[test]
fn a_side_view_copes_with_odd_geometry() {
    for setting in ["c=-0.1", "lam=-0.5", "lam=1.5", "xB=40", "zB=0.2", "rF=0.01"] {
        picture(&["show", "benchmark", "--set", setting]);
    }
    let texts = picture(&["show", "benchmark", "--set", "w=1e300"]);
    assert!(texts.iter().any(|text| text == "wheel base w = 1e300 m"), "{texts:?}");
}

/// The wheel base is shorter than the wheels: the steer axis still reaches past them, and the dimension has room.
#[test]
fn a_short_wheel_base_has_its_steer_axis() {
    let directory = Directory::new("short");
    directory.run(&["show", "benchmark", "--set", "w=0.01", "--plot", "picture.svg"]);
    let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
    let axis = svg.lines().find(|line| line.contains("stroke-dasharray=\"12 4\"")).unwrap();
    let [(foot_x, foot_y), (x, y)] = points(axis)[..] else { panic!("{axis}") };
    // In the benchmark the front wheel has a radius of 0.35 m, and the trail is 0.08 m; the view is 960 wide.
    assert!((foot_x - x).hypot(foot_y - y) > 350.0, "{axis}");
}

/// The letters of a machine that runs backwards alone would mislead.
#[test]
fn wheels_of_a_rear_steered_bicycle_are_named() {
    let texts = picture(&["show", "--model", "RearSteered"]);
    for expected in ["front wheel R  2 kg", "rear wheel F  3 kg", "backwards: side view to scale, forward to the right"]
    {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
}

/// At 0.6843 m/s two real eigenvalues become a pair, whose imaginary part begins at zero, however narrow the axes.
#[test]
fn imaginary_parts_begin_at_zero() {
    let directory = Directory::new("begin");
    directory.run(&["analyze", "--plot", "picture.svg", "--ylim", "-0.02:0.02"]);
    let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
    let of = |wanted: &str| {
        let line = svg.lines().find(|line| line.contains(wanted)).unwrap();
        points(line).into_iter().map(|(_, y)| y).fold(0.0, f64::max)
    };
    let zero = of("stroke=\"#222222\" stroke-width=\"1.2\"");
    let lowest = of("stroke-dasharray=\"7 5\"");
    assert!((lowest - zero).abs() < 1.0, "the pair begins at {lowest}, and zero is at {zero}");
}

/// A curve that no label has room beside is named below the graph.
#[test]
fn every_curve_has_its_name() {
    let texts = picture(&["analyze", "pista", "--speeds", "0:1e3:1"]);
    for expected in
        ["castering", "capsize", "weave, real part", "weave, imaginary part", "castering/capsize, imaginary part"]
    {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
}

#[test]
fn eigenvalues_can_be_drawn_at_any_speeds_and_gravity() {
    for speeds in ["3,5", "0:30:1", "0:0.001:0.001", "0:1e6:1e3"] {
        picture(&["analyze", "benchmark", "--speeds", speeds]);
    }
    picture(&["analyze", "benchmark", "--gravity", "0"]);
}

#[test]
fn png_is_written_by_its_ending() {
    let directory = Directory::new("png");
    for name in ["picture.png", "PICTURE.PNG"] {
        directory.run(&["analyze", "--plot", name]);
        let bytes = std::fs::read(directory.0.join(name)).unwrap();
        assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n"));
    }
    directory.run(&["show", "benchmark", "--plot", "picture.SVG"]);
    assert!(std::fs::read_to_string(directory.0.join("picture.SVG")).unwrap().starts_with("<svg "));
}

/// Labels of ticks, titles and critical speeds keep off each other and on the page, whatever the numbers.
#[test]
fn labels_keep_clear_of_the_axis() {
    let directory = Directory::new("labels");
    for arguments in [["--speeds", "0:1e6:1e3"], ["--gravity", "1e-300"], ["--set", "mB=90"]] {
        directory.run(&[&["analyze", "--plot", "picture.svg"], &arguments[..]].concat());
        let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
        let boxes: Vec<(&str, [f64; 2])> = svg.lines().filter_map(labelled).collect();
        let of = |wanted: &str| boxes.iter().find(|(text, _)| *text == wanted).unwrap().1;
        let [_, title_right] = of("eigenvalue λ (1/s)");
        for (text, [left, right]) in &boxes {
            assert!(*left >= 0.0 && *right <= 960.0, "{text} leaves the page: {left} to {right}");
            let is_title = *text == "eigenvalue λ (1/s)";
            assert!(
                is_title || *left > title_right,
                "{text} begins at {left}, in the title that ends at {title_right}"
            );
        }
        let frame = boxes.iter().filter(|(text, _)| text.starts_with('−')).map(|(_, [_, right])| *right);
        let frame = frame.fold(0.0, f64::max);
        for (text, [left, _]) in boxes.iter().filter(|(text, _)| text.starts_with("weave ")) {
            assert!(*left > frame, "{text} begins at {left}, left of the frame");
        }
    }
}

#[test]
fn a_critical_speed_makes_way_for_a_label_on_it() {
    let directory = Directory::new("crossed");
    directory.run(&["analyze", "yellowrev", "--plot", "picture.svg"]);
    let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
    // Four critical speeds; the label of castering and capsize fits beside none.
    assert_eq!(svg.matches("stroke-dasharray=\"2 3\"").count(), 5);
}

/// A text of a picture, and where its outlines begin and end from left to right.
fn labelled(line: &str) -> Option<(&str, [f64; 2])> {
    let (text, _) = line.strip_prefix("<path aria-label=\"")?.split_once('"')?;
    let points = points(line);
    let x = || points.iter().map(|(x, _)| *x);
    Some((text, [x().fold(f64::INFINITY, f64::min), x().fold(0.0, f64::max)]))
}

/// The points of a path on the page: what is written are the ways from one to the next.
pub fn points(line: &str) -> Vec<(f64, f64)> {
    let data = line.split_once(" d=\"").unwrap().1.split_once('"').unwrap().0;
    let mut points = Vec::new();
    let (mut place, mut start) = ((0.0, 0.0), (0.0, 0.0));
    let is_command = |c: char| c.is_ascii_alphabetic();
    for (at, _) in data.match_indices(is_command) {
        let numbers = data[at + 1..].split(is_command).next().unwrap().replace('-', " -");
        let numbers: Vec<f64> = numbers.split_whitespace().map(|number| number.parse().unwrap()).collect();
        match data[at..].chars().next() {
            Some('z') => place = start,
            Some('h') => numbers.iter().for_each(|length| place.0 += length),
            Some('v') => numbers.iter().for_each(|length| place.1 += length),
            // Control points are told from where the curve begins, as its end is.
            Some(command) => {
                let count = "mlqc".find(command).map(|at| [2, 2, 4, 6][at]).unwrap();
                for curve in numbers.chunks(count) {
                    let from = place;
                    for point in curve.chunks(2) {
                        place = (from.0 + point[0], from.1 + point[1]);
                        points.push(place);
                    }
                }
                if command == 'm' {
                    start = place;
                }
            }
            None => {}
        }
        points.push(place);
    }
    points.dedup();
    points
}

/// Titles, legends and notes of designs with long names end in dots at the edge; readers that cannot see them have all of it.
#[test]
fn long_names_do_not_leave_a_picture() {
    let directory = Directory::of_this_test();
    let name = "a bicycle with a name that is much longer than any picture is wide, by far, and goes on ".repeat(3);
    let shown = directory.run(&["show", "benchmark", "--set", "mB=60", "--set", "w=1.1"]).stdout;
    directory.write("long.toml", shown.replace("name = \"benchmark\"", &format!("name = \"{}\"", name.trim())));
    for option in ["--plot", "--side-view", "--contributions"] {
        let run = directory.run(&["compare", "benchmark", "long.toml", option, "picture.svg"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
        let width: f64 = svg.split_once("width=\"").unwrap().1.split_once('"').unwrap().0.parse().unwrap();
        let all: Vec<(&str, [f64; 2])> = svg.lines().filter_map(labelled).collect();
        assert!(all.iter().any(|(text, _)| text.contains(name.trim()) || text.contains("long.toml")), "{all:?}");
        assert!(all.iter().all(|(_, [low, high])| *low >= 0.0 && *high <= width), "{all:?}");
    }
}
