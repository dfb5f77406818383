//! What follows from the motion, on the motions that the wheels leave free.

use super::matrix::Matrix;
use super::mechanism::{Fed, Mechanism};
use super::motion::Motions;
use crate::matrix_name::{MatrixName, Whole};
use crate::symbolic::Form;

/// Adds what is fed back to matrices with a row for each freedom, and a column for each freedom or each joint.
///
/// The rate of a joint that is no freedom is `rates q' + v positions z`: positions come with one more power of the speed.
pub fn add_feedback(
    mechanism: &Mechanism<Form>,
    motions: &Motions,
    by_rates: &mut [(MatrixName, Matrix)],
    by_positions: &mut [(MatrixName, Matrix)],
) {
    for Fed { on, of, matrix, formula } in &mechanism.fed {
        let virtual_motions = &motions.rates[*on];
        let add = |matrices: &mut [(MatrixName, Matrix)], name: MatrixName, columns: &[Form]| {
            let Some((_, matrix)) = matrices.iter_mut().find(|(known, _)| *known == name) else { return };
            for (row, moved) in matrix.iter_mut().zip(virtual_motions).filter(|(_, moved)| !moved.is_nothing()) {
                for (entry, measured) in row.iter_mut().zip(columns).filter(|(_, measured)| !measured.is_nothing()) {
                    *entry = &*entry + &(&(moved * formula) * measured);
                }
            }
        };
        if Whole::Stiffness.parts().contains(matrix) {
            add(by_positions, *matrix, &motions.places[*of]);
            continue;
        }
        match motions.freedoms.iter().position(|freedom| freedom == of) {
            Some(own) => {
                let unit = (0..motions.freedoms.len()).map(|freedom| Form::number(i64::from(freedom == own)));
                add(by_rates, *matrix, &unit.collect::<Vec<Form>>());
            }
            None => {
                add(by_rates, *matrix, &motions.rates[*of]);
                if let Some(faster) = times_speed(*matrix) {
                    add(by_positions, faster, &motions.positions[*of]);
                }
            }
        }
    }
}

/// The matrix of positions whose power of the speed is one more than that of a matrix of rates.
fn times_speed(matrix: MatrixName) -> Option<MatrixName> {
    match matrix {
        MatrixName::Cm1 => Some(MatrixName::Kc),
        MatrixName::C0 => Some(MatrixName::K1),
        MatrixName::C1 => Some(MatrixName::K2),
        _ => None,
    }
}
