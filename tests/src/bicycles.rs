//! The bicycles that ship, read from their files by nothing but a TOML parser.

use carvallo::Model;
use carvallo_models::{BICYCLES, Whipple};
use toml::{Table, Value};

/// Every bicycle, with its name.
pub fn all() -> Vec<(&'static str, Whipple)> {
    BICYCLES.iter().map(|bicycle| (bicycle.name, design(bicycle.toml))).collect()
}

/// The bicycle called `name`.
pub fn named(name: &str) -> Whipple {
    let bicycle = BICYCLES.iter().find(|bicycle| bicycle.name == name);
    design(bicycle.unwrap_or_else(|| panic!("no bicycle is called {name}")).toml)
}

/// The measured standard deviations of the parameters of the bicycle called `name`, in declared order; zero for those that
/// have none.
pub fn deviations(name: &str) -> Vec<f64> {
    let bicycle = BICYCLES.iter().find(|bicycle| bicycle.name == name);
    let deviation = |value: &Value| value.as_table().map_or(0.0, |measured| number(&measured["std"]));
    parameters(bicycle.unwrap_or_else(|| panic!("no bicycle is called {name}")).toml, deviation)
}

fn design(text: &str) -> Whipple {
    Whipple::from_slice(&parameters(text, number)).expect("as many values as parameters")
}

fn parameters(text: &str, number: impl Fn(&Value) -> f64) -> Vec<f64> {
    let file: Table = text.parse().expect("a TOML file");
    let parameters = file["parameters"].as_table().expect("a table of parameters");
    Whipple::INFO.parameters.iter().map(|p| number(&parameters[p.name])).collect()
}

fn number(value: &Value) -> f64 {
    match value {
        Value::Float(number) => *number,
        Value::Integer(number) => *number as f64,
        Value::Table(measured) => number(&measured["value"]),
        // The two steer axis tilts that the papers give by an expression, by their nearest `f64`.
        Value::String(expression) if expression == "pi/10" => 0.314_159_265_358_979_3,
        Value::String(expression) if expression == "atan(1/3)" => 0.321_750_554_396_642_2,
        other => panic!("not a number: {other:?}"),
    }
}
