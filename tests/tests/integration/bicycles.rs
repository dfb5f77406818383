//! The bicycles that ship are whole, valid, and the ones that the tables of facts speak of.

use std::collections::BTreeSet;

use carvallo::Model;
use carvallo_models::{BICYCLES, Whipple};
use carvallo_tests::{bicycles, facts};
use toml::{Table, Value};

#[test]
fn fourteen_ship_under_the_name_in_their_file() {
    assert_eq!(BICYCLES.len(), 14);
    for bicycle in BICYCLES {
        let file: Table = bicycle.toml.parse().unwrap();
        assert_eq!(file["name"].as_str(), Some(bicycle.name));
    }
}

#[test]
fn every_file_names_a_source_and_every_parameter_once() {
    let expected: BTreeSet<&str> = Whipple::INFO.parameters.iter().map(|parameter| parameter.name).collect();
    for bicycle in BICYCLES {
        let file: Table = bicycle.toml.parse().unwrap();
        assert!(file["source"].as_str().is_some_and(|source| !source.is_empty()), "{}", bicycle.name);
        let parameters = file["parameters"].as_table().unwrap();
        assert_eq!(parameters.keys().map(String::as_str).collect::<BTreeSet<_>>(), expected, "{}", bicycle.name);
    }
}

#[test]
fn standard_deviations_are_positive() {
    for bicycle in BICYCLES {
        let file: Table = bicycle.toml.parse().unwrap();
        for (name, value) in file["parameters"].as_table().unwrap() {
            if let Value::Table(measured) = value {
                let std = measured["std"].as_float().unwrap();
                assert!(std > 0.0 && std.is_finite(), "{}: {name} ± {std}", bicycle.name);
            }
        }
    }
}

#[test]
fn every_bicycle_is_in_the_domain_of_the_model() {
    for (name, bicycle) in bicycles::all() {
        assert_eq!(bicycle.validate(), Ok(()), "{name}");
    }
}

#[test]
fn the_file_of_the_benchmark_is_the_set_that_the_model_declares() {
    assert_eq!(bicycles::named("benchmark"), Whipple::BENCHMARK);
}

#[test]
fn the_table_of_critical_speeds_covers_every_bicycle() {
    let covered: BTreeSet<&str> = facts::critical_speeds().iter().map(|critical| critical.bicycle).collect();
    assert_eq!(covered, BICYCLES.iter().map(|bicycle| bicycle.name).collect());
}
