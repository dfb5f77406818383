//! Bicycles in the names and axes of others: held against what their programs make of them, there and back.

mod forms;
mod geometry;
mod libbicycle;
mod mistakes;
mod pairs;
mod scripts;
mod settings;
mod twice;

use std::collections::BTreeMap;

use crate::Directory;

/// The same bicycles in two conventions each, by the programs that have them; `conventions.py` beside it says which.
const PAIRS: &str = include_str!("../../../../../tests/data/conventions.tsv");

/// The values of a side of a pair.
fn side(pair: &str, side: &str) -> BTreeMap<String, f64> {
    let rows = PAIRS.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect::<Vec<_>>());
    let rows = rows.filter(|row| row[0] == pair && row[1] == side);
    let values: BTreeMap<_, _> = rows.map(|row| (row[2].to_owned(), row[3].parse().unwrap())).collect();
    assert!(!values.is_empty(), "{pair} has no {side}");
    values
}

/// As BicycleParameters has it.
fn text(values: &BTreeMap<String, f64>) -> String {
    values.iter().map(|(name, value)| format!("{name} = {value:?}\n")).collect()
}

/// The parameters of a file, converted.
fn converted(directory: &Directory, file: &str, to: &str) -> BTreeMap<String, f64> {
    let run = directory.run(&["convert", file, "--to", to, "--format", "json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let values = json["parameters"].as_object().unwrap().iter();
    let number = |value: &serde_json::Value| value.as_f64().or_else(|| value["value"].as_f64()).unwrap();
    values.map(|(name, value)| (name.clone(), number(value))).collect()
}

/// Every value of `expected` is there, to so many parts of the largest.
#[track_caller]
fn close(found: &BTreeMap<String, f64>, expected: &BTreeMap<String, f64>, tolerance: f64) {
    for (name, value) in expected {
        let found = found.get(name).unwrap_or_else(|| panic!("{name} is missing in {found:?}"));
        assert!((found - value).abs() <= tolerance * value.abs().max(1.0), "{name} is {found}, not {value}");
    }
}
