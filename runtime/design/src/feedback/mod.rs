//! Feedback: forces that follow from the motion, which close a loop by changing the coefficients of the equations of motion.
//!
//! A law such as `Tdelta = -10*phi_rate + 3*v*phi` is a force `f = -(dC q' + dK q)` with powers of the speed that the
//! matrices have, so that `M q'' + C q' + K q = f` becomes `M q'' + (C + dC) q' + (K + dK) q = 0`: a model like any other. In the
//! nonlinear equations the force is [added](Closed) to those that are applied.

mod closed;
mod input;
mod law;
mod parse;
mod terms;

use carvallo::{Coefficients, MatrixName, ModelInfo};

use crate::failure::{Failure, Place, Problem};

pub use self::closed::{Closed, Closing, Unclosed};
pub use self::input::Input;
pub use self::law::Law;

/// A force that is a number times what a matrix multiplies, of the coordinate `column`: `q'/v` for C-1, `v q` for K1. Coordinates count
/// from zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain {
    /// What multiplies the motion besides the value.
    pub matrix: MatrixName,
    /// What the force acts on.
    pub input: Input,
    /// The coordinate that it follows from.
    pub column: usize,
    /// In SI units; a positive one drives away from where the coordinate is zero.
    pub value: f64,
}

/// Closes the loop: forces stand on the other side of the equation than the matrices. Of gains of forces that act on no coordinate there
/// must be those on coordinates instead.
///
/// ```
/// use carvallo::{Model, Stability};
/// use carvallo_design::feedback::{self, Gain};
/// use carvallo_models::Whipple;
///
/// let bicycle = Whipple::BENCHMARK;
/// let laws = feedback::laws(&["Tdelta = 10*(4.7 - v)*phi_rate".to_owned()], Whipple::<f64>::INFO)?;
/// let gains: Vec<Gain> = laws.iter().flat_map(|law| law.gains.clone()).collect();
/// let closed = feedback::close(bicycle.coefficients(), &gains);
/// let stability = Stability::new(&closed, bicycle.g).unwrap();
/// assert!((stability.stable_ranges[0].from - 1.0948652805741492).abs() < 1e-14);
/// # Ok::<(), carvallo_design::Failure>(())
/// ```
///
/// # Panics
/// If a gain is of a coordinate that there is none of.
pub fn close<const N: usize>(mut open: Coefficients<f64, N>, gains: &[Gain]) -> Coefficients<f64, N> {
    for Gain { matrix, input, column, value } in gains {
        if let Input::Coordinate(row) = input {
            open.matrix_mut(*matrix)[(*row, *column)] -= value;
        }
    }
    open
}

/// The same gains on coordinates alone: a force that acts on none of them is one on all that move what it acts on, by `shares`, which has
/// those of each force of the mechanism.
pub(crate) fn on_coordinates(gains: &[Gain], shares: impl Fn(usize) -> Vec<f64>) -> Vec<Gain> {
    let of = |gain: &Gain| match gain.input {
        Input::Coordinate(_) => vec![*gain],
        Input::Applied(force) => {
            let shares = shares(force).into_iter().enumerate();
            shares
                .map(|(row, share)| Gain { input: Input::Coordinate(row), value: share * gain.value, ..*gain })
                .collect()
        }
    };
    gains.iter().flat_map(of).filter(|gain| gain.value != 0.0).collect()
}

/// The force of each law, in their order, at a speed in m/s, and at the position and the rate of each coordinate by its place; in SI
/// units.
pub fn forces(laws: &[Law], speed: f64, motion: impl Fn(usize) -> (f64, f64)) -> Vec<f64> {
    let part = |gain: &Gain| {
        let (position, rate) = motion(gain.column);
        gain.force(speed, position, rate)
    };
    laws.iter().map(|law| law.gains.iter().map(part).sum()).collect()
}

/// The laws in some texts for a model, such as `Tdelta = -10*phi_rate`.
///
/// # Errors
/// Everything that is wrong with them, and every second law on a coordinate.
pub fn laws(texts: &[String], info: &ModelInfo) -> Result<Vec<Law>, Failure> {
    let placed = |text: &String| (Place::Option(format!("feedback '{text}'")), text.clone());
    read(&texts.iter().map(placed).collect::<Vec<_>>(), info).map_err(Failure::Input)
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
                    let name = law.force(info).0;
                    let message =
                        format!("there is a law for the force `{name}` already, at {first}; expected one sum");
                    problems.push(problem(message));
                }
                None => read.push((place, law)),
            },
            Err(message) => problems.push(problem(message)),
        }
    }
    if problems.is_empty() { Ok(read.into_iter().map(|(_, law)| law).collect()) } else { Err(problems) }
}
