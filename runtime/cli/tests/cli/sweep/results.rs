//! What is computed for each design.

use serde_json::Value;

use super::{sweep, table};
use crate::Directory;

fn numbers<'a>(values: impl IntoIterator<Item = &'a Value>) -> Vec<f64> {
    values.into_iter().map(|value| value.as_f64().unwrap()).collect()
}

/// The same designs, one by one, by `carvallo analyze`.
#[test]
fn results_are_those_of_analyze() {
    let directory = Directory::new("sweep-analyze");
    let tilts = ["2 deg", "10 deg", "18 deg", "26 deg"];
    let masses = ["20", "85"];
    for bicycle in ["benchmark", "browser", "yellowrev"] {
        let vary = format!("lam={}", tilts.join(","));
        let arguments = ["sweep", bicycle, "--vary", &vary, "--vary", "mB=20,85", "--eigenvalues", "0,4.5"];
        let table = table(directory.run(&arguments));
        assert_eq!(table.rows.len(), 8);
        for row in 0..8 {
            let settings = [format!("lam={}", tilts[row / 2]), format!("mB={}", masses[row % 2])];
            let [lam, mass] = &settings;
            let arguments = ["analyze", bicycle, "--set", lam, "--set", mass, "--format", "json", "--speeds", "0,4.5"];
            // Warnings about implausible inertias are not of interest here.
            let expected: Value = serde_json::from_str(&directory.run(&arguments).stdout).unwrap();
            assert_eq!(table.number(row, "lam"), expected["parameters"]["lam"].as_f64());
            assert_eq!(table.number(row, "mB"), expected["parameters"]["mB"].as_f64());
            assert_eq!(table.text(row, "error"), "");
            for kind in ["weave", "capsize", "double_root"] {
                let critical = expected["critical_speeds"].as_array().unwrap();
                let speeds = numbers(critical.iter().filter(|c| c["kind"] == kind).map(|c| &c["speed"]));
                assert_eq!(table.numbered(row, kind), speeds, "{bicycle} {settings:?} {kind}");
                assert_eq!(table.number(row, &format!("{kind}_count")), Some(speeds.len() as f64));
            }
            let ranges = expected["stable_ranges"].as_array().unwrap();
            assert_eq!(table.number(row, "stable_count"), Some(ranges.len() as f64));
            for index in 0..6 {
                let end = |end: usize| ranges.get(index).and_then(|range| range[end].as_f64());
                assert_eq!(table.number(row, &format!("stable_from_{}", index + 1)), end(0));
                assert_eq!(table.number(row, &format!("stable_to_{}", index + 1)), end(1));
            }
            for (at, speed) in expected["eigenvalues"].as_array().unwrap().iter().zip(["0", "4.5"]) {
                let mut values: Vec<[f64; 2]> = at["values"].as_array().unwrap().iter().map(part).collect();
                values.sort_by(|a, b| a.partial_cmp(b).unwrap());
                for (index, value) in values.iter().enumerate() {
                    for (part, expected) in ["re", "im"].iter().zip(value) {
                        let found = table.number(row, &format!("eigenvalue_{}_{part}_at_{speed}", index + 1)).unwrap();
                        assert!((found - expected).abs() < 1e-9, "{bicycle} {settings:?} {speed}: {found} {expected}");
                    }
                }
            }
        }
    }
}

fn part(value: &Value) -> [f64; 2] {
    ["re", "im"].map(|part| value[part].as_f64().unwrap())
}

/// The published weave and capsize speeds of the benchmark (Meijaard et al. 2007, table 2), and the verdicts around them.
#[test]
fn the_benchmark_has_its_published_speeds() {
    let table = sweep(&["--vary", "w=1.02", "--eigenvalues", "4,5,7"]);
    assert!((table.number(0, "weave_1").unwrap() - 4.292_382_536_341_11).abs() < 1e-13);
    assert!((table.number(0, "capsize_1").unwrap() - 6.024_262_015_388_37).abs() < 1e-13);
    let verdicts = ["4", "5", "7"].map(|speed| table.text(0, &format!("verdict_at_{speed}")));
    assert_eq!(verdicts, ["unstable", "stable", "unstable"]);
}

/// A range without end has a beginning; where there is no range there is neither.
#[test]
fn ranges_without_end_are_told_from_none() {
    // Steering backwards without trail, and a short, steep bicycle that never capsizes.
    let table = sweep(&["--set", "w=0.9", "--vary", "lam=-10 deg,2 deg"]);
    let ends = |row| (table.number(row, "stable_from_1").is_some(), table.number(row, "stable_to_1").is_some());
    assert_eq!((ends(0), table.text(0, "stable_count")), ((false, false), "0"));
    assert_eq!((ends(1), table.text(1, "stable_count")), ((true, false), "1"));
    assert_eq!((table.text(1, "capsize_count"), table.number(1, "capsize_1")), ("0", None));
}

#[test]
fn designs_that_cannot_be_have_their_error_and_nothing_else() {
    let directory = Directory::new("sweep-errors");
    let run = directory.run(&["sweep", "--vary", "w=-1,0,1.02", "--eigenvalues", "5"]);
    assert!(
        run.stderr.contains("note: 2 of 3 designs have no results; the column `error` says why\n"),
        "{}",
        run.stderr
    );
    let table = table(run);
    assert_eq!(table.text(0, "error"), "`w` is -1 m; it must be > 0");
    assert_eq!(table.text(1, "error"), "`w` is 0 m; it must be > 0");
    assert_eq!(table.text(2, "error"), "");
    for (row, filled) in [(0, 2), (1, 2)] {
        assert_eq!(table.rows[row].iter().filter(|field| !field.is_empty()).count(), filled, "{:?}", table.rows[row]);
    }
    assert!(table.number(2, "weave_1").is_some());
    // Equations without an answer: a mass only where the steer axis turns.
    let zero = [
        "mR", "IRxx", "IRyy", "IBxx", "IByy", "IBzz", "IBxz", "IHxx", "IHyy", "IHzz", "IHxz", "mF", "IFxx", "IFyy",
        "xH", "zH",
    ];
    let settings = zero.map(|name| format!("{name}=0"));
    let mut arguments = vec!["sweep", "--vary", "mB=0,85"];
    settings.iter().for_each(|setting| arguments.extend(["--set", setting]));
    let singular = super::table(directory.run(&arguments));
    assert_eq!(singular.text(0, "error"), "the mass matrix M is singular; it must be invertible");
}

/// A pendulum swings with the angular frequency sqrt(g / l); its eigenvalues depend on no speed.
#[test]
fn models_without_critical_speeds_have_their_eigenvalues() {
    let arguments =
        ["--model", "Pendulum", "--set", "g=9", "--set", "c=0", "--vary", "l=0.25:4:0.25", "--eigenvalues", "0"];
    let table = sweep(&arguments);
    assert_eq!(table.rows.len(), 16);
    assert!(!table.header.iter().any(|name| name.starts_with("weave") || name.starts_with("stable")));
    for (row, length) in table.column("l").into_iter().enumerate() {
        assert_eq!(length, 0.25 * (row as f64 + 1.0));
        let frequency = (9.0 / length).sqrt();
        let found = [1, 2].map(|index| table.number(row, &format!("eigenvalue_{index}_im_at_0")).unwrap());
        assert!((found[0] + frequency).abs() < 1e-12 && (found[1] - frequency).abs() < 1e-12, "{length}: {found:?}");
        assert_eq!(table.text(row, "verdict_at_0"), "marginal");
    }
    let three = sweep(&["--model", "ThreePipes", "--vary", "g=1:3:1", "--eigenvalues", "0,2"]);
    assert!(three.number(2, "eigenvalue_6_re_at_2").is_some());
}
