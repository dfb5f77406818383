//! Feedback: forces that follow from the motion, which close a loop by changing the coefficients of the equations of motion.
//!
//! A law such as `Tdelta = -10*phi_rate + 3*v*phi` is a force `f = -(dC q' + dK q)` with powers of the speed that the
//! matrices have, so that `M q'' + C q' + K q = f` becomes `M q'' + (C + dC) q' + (K + dK) q = 0`: a model like any other.

mod law;
mod parse;
mod terms;

use carvallo::{Coefficients, MatrixName, ModelInfo};

use crate::failure::{Place, Problem};

pub use self::law::Law;

/// A force on the coordinate `row` that is a number times what a matrix multiplies, of the coordinate `column`: `q'/v` for
/// C-1, `v q` for K1. Both count from zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain {
    /// What multiplies the motion besides the value.
    pub matrix: MatrixName,
    /// The coordinate that the force acts on.
    pub row: usize,
    /// The coordinate that it follows from.
    pub column: usize,
    /// In SI units; a positive one drives away from where the coordinate is zero.
    pub value: f64,
}

/// Closes the loop: forces stand on the other side of the equation than the matrices.
pub(crate) fn close<const N: usize>(mut open: Coefficients<f64, N>, gains: &[Gain]) -> Coefficients<f64, N> {
    let gains = if cfg!(feature = "full") { gains } else { &[] };
    for Gain { matrix, row, column, value } in gains {
        open.matrix_mut(*matrix)[(*row, *column)] -= value;
    }
    open
}

/// Reads laws for a model, each with the place that it stands at.
///
/// # Errors
/// Everything that is wrong with them, and every second law on a coordinate.
pub(crate) fn read(laws: &[(Place, String)], info: &ModelInfo) -> Result<Vec<Law>, Vec<Problem>> {
    let (mut read, mut problems): (Vec<(&Place, Law)>, Vec<Problem>) = (Vec::new(), Vec::new());
    for (place, text) in laws {
        let problem = |message: String| Problem { place: place.clone(), message };
        match Law::read(text, info) {
            Ok(law) => match read.iter().find(|(_, other)| other.input == law.input) {
                Some((first, _)) => {
                    let name = info.coordinates[law.input].name;
                    let message =
                        format!("there is a law for the force on `{name}` already, at {first}; expected one sum");
                    problems.push(problem(message));
                }
                None => read.push((place, law)),
            },
            Err(message) => problems.push(problem(message)),
        }
    }
    if problems.is_empty() { Ok(read.into_iter().map(|(_, law)| law).collect()) } else { Err(problems) }
}
