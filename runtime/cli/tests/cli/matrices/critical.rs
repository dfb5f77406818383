//! Critical speeds of given matrices, against closed forms and print.

use serde_json::Value;

use super::part;
use crate::Directory;

/// Three masses that are not coupled: s^2 + (v - 1) s + 4, s^2 + 3 s + 9 - v^2 and s^2 + 5 s + 6.
const UNCOUPLED: &str = r#"{"M": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "C0": [[-1, 0, 0], [0, 3, 0], [0, 0, 5]],
  "C1": [[1, 0, 0], [0, 0, 0], [0, 0, 0]], "Kc": [[4, 0, 0], [0, 9, 0], [0, 0, 6]],
  "K2": [[0, 0, 0], [0, -1, 0], [0, 0, 0]]}"#;

/// The first is stable from 1 m/s, where its eigenvalues are 2 i and -2 i, and the second up to 3 m/s.
#[test]
fn critical_speeds_of_three_coordinates_are_those_of_each() {
    let directory = Directory::new("matrices-critical");
    directory.write("three.json", UNCOUPLED);
    let text = directory.run(&["analyze", "three.json", "--speeds", "2"]).ok();
    let found: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("Critical")).take(4).collect();
    let expected = [
        "Critical speeds (m/s)",
        "  flutter      1                   becomes stable, at λ = ±2.0000 i",
        "  divergence   3                   becomes unstable, at λ = 0",
        "  self-stable from 1 to 3 m/s",
    ];
    assert_eq!(found, expected);
    let json = directory.run(&["analyze", "three.json", "--speeds", "2", "--format", "json"]).json();
    let kinds = [0, 1].map(|index| json["critical_speeds"][index]["kind"].as_str().unwrap());
    assert_eq!((kinds, &json["stable_ranges"]), (["flutter", "divergence"], &serde_json::json!([[1.0, 3.0]])));
    assert_eq!(json["undecided_ranges"], serde_json::json!([]));
    let sweep = ["sweep", "three.json", "--vary", "C0_11=-1,-2,1", "--eigenvalues", "2"];
    let run = directory.run(&sweep);
    let rows: Vec<Vec<&str>> = run.stdout.lines().map(|line| line.split(',').collect()).collect();
    let cell = |row: usize, name: &str| rows[row][rows[0].iter().position(|found| *found == name).unwrap()];
    let cells = |name: &str| [1, 2, 3].map(|row| cell(row, name));
    assert_eq!(cells("flutter_count"), ["1", "1", "0"]);
    assert_eq!(cells("flutter_1"), ["1.0", "2.0", ""]);
    assert_eq!(cells("divergence_1"), ["3.0", "3.0", "3.0"]);
    assert_eq!(cells("stable_from_1"), ["1.0", "2.0", "0.0"]);
    assert_eq!(cells("stable_to_1"), ["3.0", "3.0", "3.0"]);
    assert_eq!(cells("undecided_count"), ["0", "0", "0"]);
    assert_eq!(cells("verdict_at_2"), ["stable", "marginal", "stable"]);
    assert_eq!(cells("error"), ["", "", ""]);
}

/// As printed by Sharp (1971), Tables 1 to 3, in columns for the speeds in ft/s: capsize, weave and wobble.
const SHARP: [[f64; 8]; 6] = [
    [10.0, 20.0, 30.0, 50.0, 70.0, 100.0, 130.0, 160.0],
    [-3.56, -2.83, -0.13, 0.08, 0.08, 0.07, 0.05, 0.04],
    [2.01, -0.18, -3.36, -6.59, -3.97, -1.82, -1.13, -0.96],
    [1.63, 2.09, 4.56, 11.4, 16.8, 19.2, 20.4, 21.2],
    [-5.2, -5.91, -6.42, -6.52, -5.7, -3.94, -2.24, -0.82],
    [55.7, 55.8, 55.5, 54.6, 54.0, 54.3, 55.6, 57.5],
];

/// Six coordinates, two of which are rates and two of first order: all 24 eigenvalues to the last printed digit, and critical
/// speeds from equations that were derived apart from these, at 25 digits, of which 17 stand here.
#[test]
fn the_motorcycle_of_sharp() {
    let directory = Directory::new("matrices-sharp");
    directory.write("motorcycle.toml", include_str!("../../../docs/motorcycle.toml"));
    let speeds = SHARP[0].map(|speed| format!("{speed}*0.3048")).join(",");
    let json = directory.run(&["analyze", "motorcycle.toml", "--format", "json", "--speeds", &speeds]).json();
    let mut compared = 0;
    for (column, row) in json["eigenvalues"].as_array().unwrap().iter().enumerate() {
        let values = row["values"].as_array().unwrap();
        assert_eq!(values.len(), 8);
        let is_printed = |value: &Value, re: f64, im: f64| {
            let half = |printed: f64| 0.5 * if printed.abs() < 10.0 { 0.01 } else { 0.1 } + 1e-9;
            let [found_re, found_im] = [part(value, "re"), part(value, "im").abs()];
            // Frequencies below 10 have two decimals, those above one, and one real part of 5.2 has one.
            let re_half = if re == -5.2 || re == -5.7 { 0.05 } else { half(re) };
            (found_re - re).abs() <= re_half && (found_im - im).abs() <= if im == 0.0 { 0.0 } else { half(im) }
        };
        for (re, im) in [(1, None), (2, Some(3)), (4, Some(5))] {
            let (re, im) = (SHARP[re][column], im.map_or(0.0, |im: usize| SHARP[im][column]));
            assert!(values.iter().any(|value| is_printed(value, re, im)), "{re} {im}: {row}");
            compared += 1;
        }
    }
    assert_eq!(compared, 24);
    let critical = json["critical_speeds"].as_array().unwrap();
    let expected = [
        ("weave", 19.440006372816047, 2.0855133306714594),
        ("capsize", 35.210269211458693, 0.0),
        ("wobble", 181.6847617200115, 59.281250592044735),
        ("wobble", 706.1897005481802, 130.954_309_695_381_4),
    ];
    assert_eq!(critical.len(), expected.len());
    for (found, (kind, speed, frequency)) in critical.iter().zip(expected) {
        assert_eq!(found["kind"], kind);
        assert!((part(found, "speed") / (0.3048 * speed) - 1.0).abs() < 1e-12, "{found}");
        assert!((part(&found["eigenvalue"], "im") - frequency).abs() <= 1e-11 * frequency, "{found}");
    }
    directory.write("shown.toml", directory.run(&["show", "motorcycle.toml"]).ok());
    let again = directory.run(&["analyze", "shown.toml", "--format", "json", "--speeds", &speeds]);
    assert_eq!(again.code, Some(0), "{}", again.stderr);
}

/// Toward rest its eigenvalues differ by the fourth power of the speed, and doubles have not the digits for all speeds.
const SPREAD: &str = r#"{"M": [[1.04, 1.08, -0.93, -0.74, -1.07], [1.08, 5.12, -0.64, -2.88, -0.29], [-0.93, -0.64, 7.7, -0.22, 0.48], [-0.74, -2.88, -0.22, 2.49, 0.65], [-1.07, -0.29, 0.48, 0.65, 3.57]],
  "C-1": [[0.09, -0.74, -0.92, -0.46, 0.22], [-1.01, -0.21, -0.16, 0.54, 0.21], [0.36, -0.65, -0.13, 0.78, 1.49], [-1.26, 1.51, 1.35, 0.78, 0.26], [-0.31, 1.46, 1.96, 1.8, 1.32]],
  "C1": [[0.36, -1.21, 0.0, 0.66, -1.29], [0.4, 0.43, 0.7, -1.18, -0.66], [-0.44, -1.17, 1.74, -0.5, 0.33], [-0.26, 1.58, 1.32, 0.63, -2.2], [0.05, 0.68, 1.0, -0.62, 1.82]],
  "K2": [[-1.32, -0.66, 0.94, 0.05, 2.0], [0.19, -0.63, -0.38, -1.09, -1.28], [0.63, 0.58, 1.29, -0.75, 1.69], [-0.29, 1.57, -0.43, -0.74, 0.25], [1.03, 0.16, -0.59, -1.34, -1.4]]}"#;

/// Where i w is an eigenvalue, by the determinant at 40 digits; its place by a scan of all eigenvalues at 6,000 speeds.
#[test]
fn eigenvalues_of_very_different_sizes_lose_no_critical_speed() {
    let directory = Directory::new("matrices-spread");
    directory.write("spread.json", SPREAD);
    let json = directory.run(&["analyze", "spread.json", "--speeds", "1", "--format", "json"]).json();
    let critical = json["critical_speeds"].as_array().unwrap();
    assert_eq!((critical.len(), &json["undecided_ranges"]), (1, &serde_json::json!([])));
    let found = [part(&critical[0], "speed"), part(&critical[0]["eigenvalue"], "im")];
    for (found, expected) in found.into_iter().zip([0.977_304_056_916_000_1, 0.383_437_733_496_961_8]) {
        assert!((found / expected - 1.0_f64).abs() < 1e-12, "{found} is not {expected}");
    }
}
