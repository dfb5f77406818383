//! The formulas that are printed make the matrices that were compiled: for every model and all of its sets.

use carvallo::MatrixName;
use carvallo_design::MODELS;
use carvallo_slips::Formulas;

#[test]
fn formulas_make_the_matrices_of_every_model() {
    for model in MODELS {
        let formulas = Formulas::new(model.info).expect("formulas that can be read");
        for set in model.info.sets {
            let values = formulas.values(set.values);
            let equations = model.equations(set.values).expect("a set that holds");
            let count = formulas.count;
            for (at, (name, rows)) in equations.matrices().into_iter().enumerate() {
                assert_eq!(name, MatrixName::ALL[at]);
                let largest = rows.iter().flatten().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
                for (place, expected) in rows.iter().flatten().enumerate() {
                    let found = values.entries[at * count * count + place];
                    let is_same = (found - expected).abs() <= 1e-12 * largest;
                    assert!(is_same, "{} {}: {name} {place}: {found} {expected}", model.info.name, set.name);
                }
            }
        }
    }
}

/// The design of a machine, each parameter changed by up to a tenth, by the golden ratio.
fn varied(values: &[f64], number: usize) -> Vec<f64> {
    let fraction = |at: usize| ((at + 1 + 37 * number) as f64 * 0.618_033_988_749_895).fract();
    values.iter().enumerate().map(|(at, value)| value * (0.9 + 0.2 * fraction(at))).collect()
}

/// Also by the attributes of mechanisms, for other designs than those that ship.
#[test]
fn attributes_make_the_matrices_of_every_mechanism() {
    let mut mechanisms = 0;
    for model in MODELS {
        let formulas = Formulas::with_attributes(model.info, model.info.attributes).expect("formulas that can be read");
        let mut designs = 0;
        for (set, number) in model.info.sets.iter().flat_map(|set| (0..20).map(move |number| (set, number))) {
            let values = if number == 0 { set.values.to_vec() } else { varied(set.values, number) };
            let Some(found) = formulas.entries_of_mechanism(&values) else { break };
            let Ok(equations) = model.equations(&values) else { continue };
            for (at, (name, rows)) in equations.matrices().into_iter().enumerate() {
                let largest = rows.iter().flatten().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
                for (place, expected) in rows.iter().flatten().enumerate() {
                    let found = found[at * formulas.count * formulas.count + place];
                    let is_same = (found - expected).abs() <= 1e-12 * largest;
                    assert!(is_same, "{} {}: {name} {place}: {found} {expected}", model.info.name, set.name);
                }
            }
            designs += 1;
        }
        mechanisms += usize::from(designs >= 20);
    }
    assert_eq!(mechanisms, 13);
}
