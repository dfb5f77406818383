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

fn design(text: &str) -> Whipple {
    let file: Table = text.parse().expect("a TOML file");
    let parameters = file["parameters"].as_table().expect("a table of parameters");
    let values: Vec<f64> = Whipple::<f64>::INFO.parameters.iter().map(|p| number(&parameters[p.name])).collect();
    Whipple::from_slice(&values).expect("as many values as parameters")
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
