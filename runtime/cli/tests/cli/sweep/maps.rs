//! Maps of two parameters.

use crate::Directory;
use crate::pictures::{points, texts};

fn map(arguments: &[&str]) -> (Vec<String>, String) {
    let directory = Directory::of_this_test();
    let run = directory.run(&[&["sweep"], arguments, &["--map", "map.svg"]].concat());
    assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{}", run.stderr);
    assert!(run.stderr.ends_with("wrote: map.svg\n"), "{}", run.stderr);
    let svg = std::fs::read_to_string(directory.0.join("map.svg")).unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    (texts(&svg), svg)
}

const UNSTABLE: &str = "fill=\"#d9d9d9\"";
const ENDLESS: &str = "fill=\"#f7c9e0\"";
const ERROR: &str = "fill=\"#c0283c\"";

#[test]
fn a_map_has_axes_scales_and_a_legend() {
    let (texts, svg) = map(&["--vary", "w=-0.05:1.2:0.05", "--vary", "lam=-10 deg:30 deg:2 deg"]);
    for expected in [
        "Stability of benchmark over two parameters",
        "wheel base w (m)",
        "steer axis tilt λ (°)",
        "stable from (m/s)",
        "width of the stable range (m/s)",
        "no stable range",
        "stable range without end",
        "no results: invalid parameters",
        "benchmark",
        "1.0",
        "−10",
    ] {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
    // In both panels and in the legend; a range without end has a beginning, so that only its width has no colour.
    assert_eq!([UNSTABLE, ERROR, ENDLESS].map(|color| svg.matches(color).count()), [3, 3, 2]);
}

/// Cells are as wide as they should be: of two values, one of them without a result, each has half of the map.
#[test]
fn cells_stand_at_their_values() {
    let (_, svg) = map(&["--vary", "w=-1,1.02", "--vary", "mB=80,90"]);
    let path = svg.lines().find(|line| line.contains(ERROR)).unwrap();
    let xs = points(path).into_iter().map(|(x, _)| x);
    let (low, high) = xs.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    // A panel is 400 wide, and cells overlap a little.
    assert!((high - low - 200.0).abs() < 1.0, "{low} to {high}");
}

#[test]
fn a_map_may_have_nothing_stable_and_come_with_a_table() {
    let (texts, svg) = map(&["--vary", "w=1,1.1", "--vary", "lam=-20 deg,-10 deg"]);
    assert!(texts.iter().any(|text| text == "no stable range"));
    assert_eq!(svg.matches(UNSTABLE).count(), 3);
    let directory = Directory::new("sweep-map");
    let arguments = ["sweep", "--vary", "c=0:0.1:0.05", "--vary", "w=1,1.1", "--map", "map.png", "--output", "map.csv"];
    assert_eq!(directory.run(&arguments).code, Some(0));
    assert!(std::fs::read(directory.0.join("map.png")).unwrap().starts_with(b"\x89PNG\r\n\x1a\n"));
    assert_eq!(std::fs::read_to_string(directory.0.join("map.csv")).unwrap().lines().count(), 7);
}

/// Of a scale of 400 pixels and a font of 13.
#[test]
fn labels_of_narrow_and_large_ranges_can_be_read() {
    for (x, y, expected) in [
        ("c=0.08:0.0801:0.00001", "w=1.02:1.021:0.0001", ["0.08002", "1.0205"]),
        ("c=0.08:0.080001:5 points", "w=1.02:1.0200001:5 points", ["0.0800005", "1.02000002"]),
        ("mB=0:1000000:50000", "c=0.000001:0.00001:0.000001", ["200000", "2.0e−6"]),
    ] {
        let (texts, _) = map(&["--vary", x, "--vary", y]);
        for expected in expected {
            // In both panels.
            assert_eq!(texts.iter().filter(|text| *text == expected).count(), 2, "{expected}: {texts:?}");
        }
        assert!(!texts.iter().any(|text| text.ends_with("e0")), "{texts:?}");
        for between in ["0.08001", "0.0800002", "100000"] {
            assert!(!texts.iter().any(|text| text == between), "{between}: {texts:?}");
        }
    }
}

/// The trail in mm goes from 50 to 100, speeds to km/h; a name that says it all stands once.
#[test]
fn maps_are_in_the_units_that_are_asked_for() {
    let vary = ["--vary", "trail=0.05:0.1:0.01", "--vary", "head_angle=68 deg:74 deg:2 deg"];
    let (plain, _) = map(&vary);
    let (shown, _) = map(&[&vary[..], &["--units", "mm,km/h,rad"]].concat());
    for (texts, expected) in [
        (&plain, ["trail (m)", "angle of the steer axis from the ground head_angle (°)", "stable from (m/s)", "0.10"]),
        (
            &shown,
            ["trail (mm)", "angle of the steer axis from the ground head_angle (rad)", "stable from (km/h)", "100"],
        ),
    ] {
        for expected in expected {
            assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
        }
    }
}
