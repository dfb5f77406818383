//! A rider from a few measures, against what was published of the same rider.

use carvallo_measure::rider::{EXAMPLE, Rider};

/// The points of the frame of a Batavus Browser that a rider touches, by the lengths and angles of its tubes: pedals, saddle and
/// hands, x forward of the rear contact and y up, as bike_inertia_jason_browser_mod.m of Moore's PhysicalParameters has them.
fn browser() -> [[f64; 2]; 3] {
    let (wheel, base, bracket, stay, angle) = (0.342, 1.12, 0.295, 0.46, 68.5_f64.to_radians());
    let (seat_tube, seat_post, trail, fork, stem, handle) = (0.53, 0.24, 0.055, 0.455, 0.25, 0.19);
    let (s, c) = angle.sin_cos();
    let pedals = [f64::sqrt(stay * stay - (wheel - bracket) * (wheel - bracket)), bracket];
    let saddle = [pedals[0] - (seat_tube + seat_post) * c, pedals[1] + (seat_tube + seat_post) * s];
    let offset: f64 = wheel * c - trail * s;
    let along = (fork * fork - offset * offset).sqrt();
    let crown = [base - offset * s - along * c, wheel - offset * c + along * s];
    let top = bracket + seat_tube * s;
    let head = [crown[0] + (crown[1] - top) / angle.tan(), top];
    [pedals, saddle, [head[0] - stem * c - handle, head[1] + stem * s]]
}

fn with_places([pedals, saddle, hands]: [[f64; 2]; 3]) -> Rider {
    let place = |name: &str, [x, y]: [f64; 2]| format!("{name} = [{x}, {}]", -y);
    let line = |line: &str| match line.split(' ').next() {
        Some("pedals") => place("pedals", pedals),
        Some("saddle") => place("saddle", saddle),
        Some("hands") => place("hands", hands),
        _ => line.to_owned(),
    };
    let text: Vec<String> = EXAMPLE.lines().map(line).collect();
    Rider::read("rider.toml", text.join("\n").into_bytes()).unwrap()
}

/// BicycleParameters, data/riders/Jason/Parameters/JasonBrowserBenchmark.txt; in Moore (2012), "Moore method", they are rounded to
/// [0.291, 0, -1.109] m and [8.00, 8.07, 2.36, -1.93] kg m^2.
#[test]
fn the_published_rider_comes_out() {
    let rider = with_places(browser());
    assert_eq!(rider.mass, [72.0, 0.0]);
    let found = [rider.at[0], rider.at[1], rider.moments[0], rider.moments[1], rider.moments[2], rider.moments[3]];
    let published = [0.2909, -1.1091, 7.9985, 8.0689, 2.3624, -1.9272];
    for ([found, deviation], published) in found.into_iter().zip(published) {
        assert!((found - published).abs() <= 0.5e-4, "{found}, not {published}");
        assert_eq!(deviation, 0.0);
    }
    // With the places of the example, which are rounded to a tenth of a millimetre.
    let example = Rider::read("rider.toml", EXAMPLE.as_bytes().to_vec()).unwrap();
    assert!((example.moments[0][0] - 7.9985).abs() < 2e-3, "{example:?}");
}

/// Deviations go along: of the mass, to first order, in proportion.
#[test]
fn a_heavier_rider_is_heavier_everywhere() {
    let text = EXAMPLE.replace("mass = 72 ", "mass = \"72 +/- 2\" ");
    let rider = Rider::read("rider.toml", text.into_bytes()).unwrap();
    assert_eq!(rider.mass, [72.0, 2.0]);
    for [value, deviation] in rider.moments {
        assert!((deviation / value.abs() - 2.0 / 72.0).abs() < 1e-12);
    }
    assert!(rider.at.iter().all(|[_, deviation]| *deviation < 1e-15));
}

#[test]
fn mistakes_are_told_at_their_place() {
    let of = |from: &str, to: &str| {
        assert!(EXAMPLE.contains(from), "{from}");
        Rider::read("rider.toml", EXAMPLE.replace(from, to).into_bytes()).unwrap_err().to_string()
    };
    let line = EXAMPLE.lines().position(|line| line.starts_with("upper_leg ")).unwrap() + 1;
    let at = |message: &str| format!("rider.toml:{line}: {message}");
    assert_eq!(of("upper_leg = 0.46", "upper_leg = -0.46"), at("`upper_leg` is -0.46 m; it must be > 0"));
    let misspelt = of("upper_leg = ", "uper_leg = ");
    assert!(misspelt.contains(&at("`uper_leg` is no measure of a rider; did you mean `upper_leg`?")), "{misspelt}");
    assert!(misspelt.contains("rider.toml: missing: upper_leg"), "{misspelt}");
    let short = of("upper_leg = 0.46", "upper_leg = 0.26");
    assert!(
        short.contains("pedals and saddle are 0.770 m apart, where `lower_leg` and `upper_leg`, 0.46 m and"),
        "{short}"
    );
    assert!(of("[0.5829, -1.0207]", "0.5829").contains("`hands` is no place; expected x and z in m"));
    assert!(of("chest_girth = 0.94", "chest_girth = 0.6").contains("make a torso"));
    assert_eq!(
        of("upper_leg = 0.46", "upper_leg = 46"),
        at("`upper_leg` is 46 m; it must be at most 3 m: if it is in cm, write \"46 cm\"")
    );
    assert!(
        of("[0.5829, -1.0207]", "[582.9, -1020.7]")
            .contains("`x of hands` is 582.9 m; it must be at most 3 m: if it is in mm")
    );
    assert!(
        of("[0.5829, -1.0207]", "[0.5829, 1.0207]")
            .contains("`z of hands` is 1.0207 m, below the ground; z is counted down")
    );
    assert!(of("mass = 72 ", "mass = 72000 ").contains("`mass` is 72000 kg; it must be at most 500 kg; is it in g?"));
    // 1.45 rad are 83.08 degrees.
    let radians = of("lean = 82.9", "lean = 1.45");
    let told = "`lean` is 1.45 deg, since plain numbers are in degrees; for 83.1 degrees write \"1.45 rad\", or \"1.45 deg\" if \
                that is meant";
    assert!(radians.ends_with(told), "{radians}");
    assert!(Rider::read("rider.toml", EXAMPLE.replace("lean = 82.9", "lean = '1.45 rad'").into_bytes()).is_ok());
    assert!(of("lean = 82.9", "lean = 200").contains("`lean` is"));
}

/// A tape measure is in centimetres: one slip, however many numbers.
#[test]
fn a_file_in_another_unit_is_one_mistake() {
    let in_centimetres = |line: &str| match line.split_once(" = ") {
        Some((name, value)) if !["name", "mass", "lean"].contains(&name.trim()) => {
            let number = |text: &str| text.trim_matches(['[', ']', ' ']).parse::<f64>().map(|number| 100.0 * number);
            let (value, comment) = value.split_once('#').unwrap_or((value, ""));
            let numbers: Vec<f64> = value.split(',').map(|text| number(text.trim()).unwrap()).collect();
            let value = if numbers.len() > 1 { format!("{numbers:?}") } else { numbers[0].to_string() };
            format!("{name} = {value} # {comment}\n")
        }
        _ => format!("{line}\n"),
    };
    let text: String = EXAMPLE.lines().map(in_centimetres).collect();
    let message = Rider::read("rider.toml", text.into_bytes()).unwrap_err().to_string();
    // Of three places two numbers each, and thirteen lengths.
    let told =
        "m; it must be at most 3 m, and so must 18 more numbers: if they are in cm, write the unit behind each, as in";
    assert!(message.lines().count() == 1 && message.contains(told), "{message}");
}
