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
