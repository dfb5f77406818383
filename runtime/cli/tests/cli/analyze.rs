//! Results against the published ones: Meijaard, Papadopoulos, Ruina & Schwab (2007), and for the second benchmark
//! Schwab, Meijaard & Papadopoulos (2005). Critical speeds and eigenvalues were recomputed at 50 and 60 digits.

use serde_json::Value;

use crate::Directory;

#[track_caller]
fn assert_near(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value - expected).abs() <= tolerance * expected.abs().max(1.0), "{value} is not {expected}");
}

#[track_caller]
fn assert_matrix(json: &Value, name: &str, expected: [[f64; 2]; 2]) {
    for (row, expected) in expected.iter().enumerate() {
        for (column, expected) in expected.iter().enumerate() {
            assert_near(&json["matrices"][name][row][column], *expected, 1e-13);
        }
    }
}

#[track_caller]
fn assert_critical(json: &Value, expected: &[(&str, f64)]) {
    let critical = json["critical_speeds"].as_array().unwrap();
    assert_eq!(critical.len(), expected.len(), "{critical:?}");
    for (critical, (kind, speed)) in critical.iter().zip(expected) {
        assert_eq!(critical["kind"], *kind);
        assert_near(&critical["speed"], *speed, 4e-15);
    }
}

#[test]
fn the_benchmark_has_its_published_results() {
    let json = Directory::new("benchmark").run(&["analyze", "--format", "json"]).json();
    assert_eq!((&json["model"], &json["bicycle"]), (&"Whipple".into(), &"benchmark".into()));
    assert_matrix(&json, "M", [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]]);
    assert_matrix(&json, "C1", [[0.0, 33.86641391492494], [-0.85035641456978, 1.6854039739756]]);
    assert_matrix(&json, "K0", [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]]);
    assert_matrix(&json, "K2", [[0.0, 76.59734589573222], [0.0, 2.65431523794604]]);
    let (weave, capsize) = (4.292_382_536_341_104, 6.024_262_015_388_359);
    assert_critical(&json, &[("double_root", 0.684_283_078_892_455_8), ("weave", weave), ("capsize", capsize)]);
    assert_near(&json["critical_speeds"][0]["eigenvalue"]["re"], 3.782_904_051_293_2, 1e-7);
    assert_near(&json["critical_speeds"][1]["eigenvalue"]["im"], 3.435_033_848_661_436_6, 1e-12);
    assert_eq!(json["stable_ranges"].as_array().unwrap().len(), 1);
    assert_near(&json["stable_ranges"][0][0], weave, 4e-15);
    assert_near(&json["stable_ranges"][0][1], capsize, 4e-15);
    assert_eq!(json["eigenvalues"].as_array().unwrap().len(), 101);
}

/// Table 2 of the paper, at its eleven speeds.
#[test]
fn the_benchmark_has_its_published_eigenvalues() {
    #[rustfmt::skip]
    let published = [
        // castering, capsize, and the two of weave, each re and im
        [(-5.530943717653934, 0.0), (-3.131643247906556, 0.0), (3.131643247906556, 0.0), (5.530943717653934, 0.0)],
        [(-7.110080146374408, 0.0), (-3.134231250665784, 0.0), (3.526961709900694, -0.80774027519931), (3.526961709900694, 0.80774027519931)],
        [(-8.673879848317372, 0.0), (-3.071586456415143, 0.0), (2.682345175127454, -1.680662965906758), (2.682345175127454, 1.680662965906758)],
        [(-10.35101467245923, 0.0), (-2.633661372536653, 0.0), (1.706756056639735, -2.315824473843244), (1.706756056639735, 2.315824473843244)],
        [(-12.15861426576444, 0.0), (-1.429444273613257, 0.0), (0.4132533152112413, -3.079108186032053), (0.4132533152112413, 3.079108186032053)],
        [(-14.07838969279825, 0.0), (-0.322866429004087, 0.0), (-0.7753418821958418, -4.464867713788225), (-0.7753418821958418, 4.464867713788225)],
        [(-16.08537123098028, 0.0), (-0.004066900769703362, 0.0), (-1.526444865841417, -5.876730605987084), (-1.526444865841417, 5.876730605987084)],
        [(-18.15788466125202, 0.0), (0.1026817057476642, 0.0), (-2.138756442583634, -7.195259133298043), (-2.138756442583634, 7.195259133298043)],
        [(-20.27940894394566, 0.0), (0.1432787976571295, 0.0), (-2.693486835810948, -8.460379713969336), (-2.693486835810948, 8.460379713969336)],
        [(-22.43788559040859, 0.0), (0.157901840309173, 0.0), (-3.216754022524907, -9.693773515317822), (-3.216754022524907, 9.693773515317822)],
        [(-24.62459635017404, 0.0), (0.1610533865317155, 0.0), (-3.720168404372876, -10.90681139476288), (-3.720168404372876, 10.90681139476288)],
    ];
    let json = Directory::new("eigenvalues").run(&["analyze", "--format", "json", "--speeds", "0:10:1"]).json();
    for (index, (row, expected)) in json["eigenvalues"].as_array().unwrap().iter().zip(published).enumerate() {
        assert_near(&row["speed"], index as f64, 0.0);
        let mut values = row["values"].as_array().unwrap().clone();
        let modes: Vec<&str> = values.iter().map(|value| value["mode"].as_str().unwrap()).collect();
        assert_eq!(modes, ["castering", "capsize", "weave", "weave"]);
        let order = |value: &Value| (value["re"].as_f64().unwrap(), value["im"].as_f64().unwrap());
        values[2..].sort_by(|a, b| order(a).partial_cmp(&order(b)).unwrap());
        for (value, (re, im)) in values.iter().zip(expected) {
            assert_near(&value["re"], re, 1e-12);
            assert_near(&value["im"], im, 1e-12);
        }
    }
}

#[test]
fn the_benchmark_of_2005_has_its_published_results() {
    let json = Directory::new("benchmark-2005").run(&["analyze", "benchmark-2005", "--format", "json"]).json();
    assert_matrix(&json, "M", [[80.8121, 2.32343142623549], [2.32343142623549, 0.30126570934256]]);
    assert_matrix(&json, "C1", [[0.0, 33.7738694759301], [-0.84823447825693, 1.70696539792387]]);
    assert_matrix(&json, "K2", [[0.0, 76.40620875965657], [0.0, 2.67560553633218]]);
    // Published with gravity in it.
    let with_gravity = [[-794.1195, -25.739089291258], [-25.739089291258, -8.139414705882]];
    assert_matrix(&json, "K0", with_gravity.map(|row| row.map(|value| value / 9.81)));
    assert_critical(
        &json,
        &[
            ("double_root", 0.693_712_762_387_387_5),
            ("weave", 4.301_611_037_733_119),
            ("capsize", 6.057_011_283_544_488),
        ],
    );
}

#[test]
fn the_table_tells_critical_speeds_to_all_digits() {
    let text = Directory::new("table").run(&["analyze"]).ok();
    let json = Directory::new("table-json").run(&["analyze", "--format", "json"]).json();
    for critical in json["critical_speeds"].as_array().unwrap() {
        let speed = critical["speed"].as_f64().unwrap().to_string();
        assert!(text.contains(&speed), "{speed} is not in {text}");
    }
    assert!(text.contains("80.81722"), "{text}");
    assert!(text.contains("-10.351015"), "{text}");
    assert!(!text.contains('\u{1b}'), "colours are for terminals: {text}");
}

#[test]
fn csv_has_a_row_a_speed_and_the_same_numbers_as_json() {
    let directory = Directory::new("csv");
    let text = directory.run(&["analyze", "pista", "--format", "csv"]).ok();
    let json = directory.run(&["analyze", "pista", "--format", "json"]).json();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!((header[0], header[1], header[8]), ("speed (m/s)", "castering re (1/s)", "weave 2 im (1/s)"));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 101);
    for (row, expected) in rows.iter().zip(json["eigenvalues"].as_array().unwrap()) {
        assert_eq!(row.len(), 9);
        assert_eq!(Some(row[0]), expected["speed"].as_f64());
        for (index, value) in expected["values"].as_array().unwrap().iter().enumerate() {
            assert_eq!(Some(row[1 + 2 * index]), value["re"].as_f64());
            assert_eq!(Some(row[2 + 2 * index]), value["im"].as_f64());
        }
    }
}

#[test]
fn speeds_may_be_one_or_a_list() {
    let directory = Directory::new("speeds");
    for (speeds, expected) in
        [("4.5", vec![4.5]), ("3,0.1,8", vec![3.0, 0.1, 8.0]), ("0:0.3:0.1", vec![0.0, 0.1, 0.2, 0.3])]
    {
        let json = directory.run(&["analyze", "--format", "json", "--speeds", speeds]).json();
        let rows = json["eigenvalues"].as_array().unwrap().iter().map(|row| row["speed"].as_f64().unwrap());
        assert_eq!(rows.collect::<Vec<f64>>(), expected);
    }
}

/// Critical speeds from Appendix A at 50 digits, with the damper on the steering axis: where the Hurwitz determinant,
/// det K and the discriminant are zero. Of the speeds every 5 km/h only 30 km/h = 8.33 m/s is between the last two.
#[test]
fn a_steering_damper_counts_and_speeds_may_be_in_km_per_hour() {
    let directory = Directory::of_this_test();
    directory.write("motorcycle.toml", include_str!("motorcycle.toml"));
    for speeds in ["20 km/h:220 km/h:5 km/h", "20/3.6:220/3.6:5/3.6"] {
        let json = directory.run(&["analyze", "motorcycle.toml", "--format", "json", "--speeds", speeds]).json();
        let (weave, capsize) = (7.795_832_047_191_757, 8.609_817_746_130_9);
        assert_critical(&json, &[("double_root", 2.985_341_748_892_18), ("weave", weave), ("capsize", capsize)]);
        let rows = json["eigenvalues"].as_array().unwrap();
        assert_eq!(rows.len(), 41);
        for (index, row) in rows.iter().enumerate() {
            let speed = (20.0 + 5.0 * index as f64) / 3.6;
            assert_near(&row["speed"], speed, 1e-15);
            let values = row["values"].as_array().unwrap();
            let is_stable = values.iter().all(|value| value["re"].as_f64().unwrap() < 0.0);
            assert_eq!(is_stable, index == 2, "at {speed} m/s: {values:?}");
        }
    }
}

/// The moon has less than a sixth of the gravity: speeds scale with its square root.
#[test]
fn gravity_can_be_set() {
    let directory = Directory::new("gravity");
    let scale = (1.62_f64 / 9.81).sqrt();
    for arguments in [["--gravity", "1.62"], ["--set", "g=1.62"]] {
        let json = directory.run(&[&["analyze", "--format", "json"], &arguments[..]].concat()).json();
        assert_near(&json["critical_speeds"][1]["speed"], 4.292_382_536_341_104 * scale, 1e-14);
        assert_near(&json["parameters"]["g"], 1.62, 0.0);
    }
}

#[test]
fn the_list_has_every_bicycle_with_its_critical_speeds() {
    let text = Directory::new("list").run(&["bicycles"]).ok();
    let line = |name: &str| text.lines().find(|line| line.starts_with(&format!("{name} "))).unwrap();
    assert_eq!(text.lines().count(), 15);
    assert!(line("benchmark").contains("4.2924 to 6.0243"), "{text}");
    assert!(line("benchmark-2005").contains("4.3016 to 6.0570"), "{text}");
}

/// M = 1 and C0 = d, so that -λ² - d λ is an eigenvalue of Kc + v² K2: 5/2 ± √(1/4 - v²). The two meet at v = 1/2, where
/// λ = -d/2 ± i √(5/2 - d²/4).
#[test]
fn a_double_root_off_the_real_axis_has_its_imaginary_part() {
    let directory = Directory::of_this_test();
    for (d, expected) in [("0", "±1.5811 i"), ("1", "-0.5000 ± 1.5000 i")] {
        directory.write("flutter.json", FLUTTER.replace('d', d));
        let text = directory.run(&["analyze", "flutter.json", "--gravity", "0"]).ok();
        let line = text.lines().find(|line| line.trim_start().starts_with("double root")).unwrap();
        assert!(line.contains(" 0.5 ") && line.ends_with(&format!("at λ = {expected}")), "{text}");
    }
    let text = directory.run(&["analyze"]).ok();
    assert!(text.contains("become an oscillation, at λ = 3.7829\n"), "{text}");
}

/// Without damping, flutter comes after motion that neither grows nor decays.
#[test]
fn a_marginal_range_below_a_critical_speed_is_told() {
    let directory = Directory::of_this_test();
    let summary = |d| {
        directory.write("flutter.json", FLUTTER.replace('d', d));
        directory.run(&["analyze", "flutter.json", "--gravity", "0"]).ok()
    };
    let text = summary("0");
    assert!(text.contains("\n  marginal from 0 to 0.5 m/s: it neither falls nor comes to rest\n"), "{text}");
    assert!(!text.contains("at no speed") && !text.contains("marginal above"), "{text}");
    let text = summary("1");
    assert!(text.contains("\n  self-stable from 0 to ") && !text.contains("marginal from"), "{text}");
}

const FLUTTER: &str = r#"{"M":[[1,0],[0,1]],"C0":[[d,0],[0,d]],"Kc":[[3,0],[0,2]],"K2":[[-1,1],[-1,1]]}"#;

/// Below the weave speed, at rest as well: JSON has the real parts that say so.
#[test]
fn a_row_is_stable_by_the_verdict_at_its_speed() {
    let directory = Directory::of_this_test();
    let settings = ["--set", "zB=0.9", "--set", "zH=0.7", "--set", "k=100", "--set", "d=5", "--speeds", "0,0.0005,1"];
    let arguments = [&["analyze", "--model", "WhippleSprung"], &settings[..]].concat();
    let table = directory.run(&arguments).stdout;
    let json = directory.run(&[&arguments[..], &["--format", "json"]].concat()).stdout;
    let json: Value = serde_json::from_str(&json).unwrap();
    let rows: Vec<&str> = table.lines().skip_while(|line| !line.contains("v (m/s)")).skip(1).collect();
    let is_stable =
        |row: &Value| row["values"].as_array().unwrap().iter().all(|value| value["re"].as_f64().unwrap() < 0.0);
    let stable: Vec<bool> = json["eigenvalues"].as_array().unwrap().iter().map(is_stable).collect();
    assert_eq!(stable, [true, true, false]);
    assert_eq!(rows.iter().map(|row| row.ends_with("  stable")).collect::<Vec<bool>>(), stable, "{table}");
}

/// A faired recumbent whose weave splits once it is stable, so that no name goes through all of its double roots. Its
/// speeds are from Appendix A at 50 digits, where det K and the Hurwitz determinant are zero.
#[test]
fn kind_mode_and_change_agree_where_names_cannot_go_on() {
    let directory = Directory::of_this_test();
    directory.write("recumbent.txt", RECUMBENT);
    let table = directory.run(&["analyze", "recumbent.txt"]).stdout;
    let line = |start: &str| table.lines().find(|line| line.trim_start().starts_with(start)).unwrap().to_owned();
    assert!(line("capsize ").contains("becomes unstable, as another mode is already"), "{table}");
    assert!(line("weave ").contains("becomes stable, at"), "{table}");
    let json = directory.run(&["analyze", "recumbent.txt", "--format", "json", "--speeds", "3.14,8.12"]).stdout;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let critical = |kind: &str| {
        json["critical_speeds"].as_array().unwrap().iter().find(|critical| critical["kind"] == kind).unwrap().clone()
    };
    assert_near(&critical("capsize")["speed"], 3.141_383_418_925_678, 1e-14);
    assert_near(&critical("weave")["speed"], 8.117_449_357_326_007, 1e-14);
    assert_eq!(critical("capsize")["verdicts"], serde_json::json!(["unstable", "unstable"]));
    assert_eq!(critical("weave")["verdicts"], serde_json::json!(["unstable", "stable"]));
    // The eigenvalue that is next to the imaginary axis has the name of the kind.
    for (row, mode) in [(0, "capsize"), (1, "weave")] {
        let values = json["eigenvalues"][row]["values"].as_array().unwrap();
        let distance = |value: &&serde_json::Value| value["re"].as_f64().unwrap().abs();
        let nearest = values.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
        assert_eq!(nearest["mode"], mode, "{values:?}");
    }
    let csv = directory.run(&["analyze", "recumbent.txt", "--format", "csv", "--speeds", "3,9"]).stdout;
    let cells: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((cells[0][9], cells[0].len()), ("real 1 re (1/s)", 13));
    // Without weave, and without anything that has no name.
    assert_eq!((&cells[1][5..9], &cells[2][9..]), (&[""; 4][..], &[""; 4][..]));
}

const RECUMBENT: &str = "\
w = 1.092
c = 0.089
lam = 0.129154
g = 9.81
rR = 0.2445
mR = 1.14
IRxx = 0.02
IRyy = 0.04
xB = 0.68151
zB = -0.39088
mB = 106.216
IBxx = 5.55605664918
IByy = 25.06012355961
IBzz = 23.52409141966
IBxz = 2.04399182523
xH = 1.0
zH = -0.604
mH = 3.17
IHxx = 0.07577148120
IHyy = 0.08696201242
IHzz = 0.01550348533
IHxz = 0.03034277154
rF = 0.2445
mF = 1.81
IFxx = 0.027
IFyy = 0.052
";

/// Undamped, the halves of a pair become real through zero, and nothing is left there but zero.
#[test]
fn a_double_root_at_zero_is_zero() {
    let text = Directory::of_this_test().run(&["analyze", "--model", "TypicalSection"]).ok();
    assert!(text.contains("two real eigenvalues become an oscillation, at λ = 0.0000\n"), "{text}");
}

/// At 5 m/s by mpmath at 30 digits, from the matrices of Meijaard et al. (2007), Table 1: null vectors on both sides.
#[test]
fn eigenvectors_are_shapes_of_the_modes() {
    let directory = Directory::of_this_test();
    let arguments = ["analyze", "--speeds", "5", "--eigenvectors"];
    let json = directory.run(&[&arguments[..], &["--format", "json"]].concat()).json();
    let expected = [
        ("castering", [(0.0022845799397661, 0.0), (1.0, 0.0)], [(0.00975922584904304, 0.0), (-0.300715917361048, 0.0)]),
        ("capsize", [(1.0, 0.0), (0.428171013447849, 0.0)], [(0.0107739065546498, 0.0), (-0.354381142315253, 0.0)]),
        (
            "weave",
            [(0.758790036615888, -0.133838846873162), (1.0, 0.0)],
            [(-0.00718615016866993, -0.000408536144502747), (0.226225825106488, -0.0439048449316772)],
        ),
    ];
    let values = json["eigenvalues"][0]["values"].as_array().unwrap();
    for (value, (mode, right, left)) in values.iter().zip(expected) {
        assert_eq!(value["mode"], mode);
        for (found, expected) in [(&value["right"], right), (&value["left"], left)] {
            for (component, (re, im)) in expected.into_iter().enumerate() {
                assert_near(&found[component]["re"], re, 1e-11);
                assert_near(&found[component]["im"], im, 1e-11);
            }
        }
    }
    // atan(0.13384/0.75879) is 10 degrees, by which lean leads steer in the half that is shown.
    let table = directory.run(&arguments).ok();
    assert!(table.contains("  weave -0.7753 + 4.4649 i       0.7705 at    10°   1.0000"), "{table}");
    let message = "error: --eigenvectors: CSV has no columns for them; they are in a table and in --format json\n";
    directory.run(&[&arguments[..], &["--format", "csv"]].concat()).fails(2, message);
    // Of any number of coordinates, rates where only these are states.
    let table = directory.run(&["analyze", "--model", "Motorcycle", "--speeds", "20", "--eigenvectors"]).ok();
    let title = table.lines().find(|line| line.starts_with("  at 20 m/s")).unwrap_or_default();
    let names: Vec<&str> = title.split_whitespace().skip(3).collect();
    assert_eq!(names, ["y’", "psi’", "phi", "delta", "er", "ef"]);
}
