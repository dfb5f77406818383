//! The linear quadratic regulator at one speed.

use carvallo_design::number::{fixed, shortest};
use carvallo_design::{Design, Failure};
use nalgebra::{Complex, DMatrix, DVector};

use super::modes::{NEARLY_ZERO, ZERO, eigenvalues, unreached, unseen};
use super::riccati::Riccati;
use super::weights::Weights;
use crate::StateSpace;

/// The gains K of `u = -K x` that keep the integral of `sum q y^2 + sum r u^2` as small as it can be (Kalman 1960), for the
/// linearized motion at one speed.
///
/// ```
/// use carvallo_control::{Ports, Regulator, Weights};
/// use carvallo_design::input::{self, Request};
///
/// let bicycle = input::load(&Request::default())?;
/// let ports = Ports::of(&bicycle);
/// let inputs = [ports.input("Tdelta").unwrap()];
/// let weights = Weights::read(&["phi=10".to_owned(), "delta_rate=0.1".to_owned()], &ports, &inputs)?;
/// // Far below the speed at which it is stable by itself.
/// let regulator = Regulator::new(&bicycle, 2.0, &weights)?;
/// assert_eq!(regulator.gains.shape(), (1, 4));
/// assert!(regulator.eigenvalues.iter().all(|value| value.re < 0.0));
/// # Ok::<(), carvallo_design::Failure>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Regulator {
    /// What is regulated: its outputs are those that have a weight.
    pub space: StateSpace,
    /// K: one row for each input, and a column for each state.
    pub gains: DMatrix<f64>,
    /// X, the integral from the state x on being `x' X x`.
    pub cost: DMatrix<f64>,
    /// Those of `A - B K` in 1/s, sorted by real part, then by imaginary part.
    pub eigenvalues: Vec<Complex<f64>>,
    /// What is left of the Riccati equation, relative to its terms.
    pub residual: f64,
}

impl Regulator {
    /// Of a design at a forward speed in m/s, which matters only where its equations depend on it.
    ///
    /// # Errors
    /// If there are no equations of motion at the speed, if no input reaches a mode that does not die away by itself, or if no
    /// weight sees a mode that neither grows nor dies away.
    pub fn new(design: &Design, speed: f64, weights: &Weights) -> Result<Self, Failure> {
        let (inputs, r): (Vec<usize>, Vec<f64>) = weights.inputs.iter().copied().unzip();
        let (outputs, q): (Vec<_>, Vec<f64>) = weights.outputs.iter().copied().unzip();
        let space = StateSpace::new(design, speed, &inputs, &outputs)?;
        let fail = |message: String| {
            let at = space.speed.map(|speed| format!(" at {} m/s", shortest(speed))).unwrap_or_default();
            Failure::Run(format!("{}{at}: {message}", design.title()))
        };
        let (a, b) = (&space.a, &space.b);
        let names = space.inputs.iter().map(|input| input.name.as_str()).collect::<Vec<_>>().join(", ");
        let lost = "which does not die away by itself: no gains stabilize it";
        if let Some(value) = unreached(a, b, ZERO) {
            return Err(fail(format!("{names} does not reach the mode with the eigenvalue {}, {lost}", told(value))));
        }
        let seen = DMatrix::from_fn(q.len(), a.ncols(), |row, column| q[row].sqrt() * space.c[(row, column)]);
        if let Some(value) = unseen(a, &seen) {
            let why = "which neither grows nor dies away: a weight on one of its coordinates is needed";
            return Err(fail(format!("no weight sees the mode with the eigenvalue {}, {why}", told(value))));
        }
        let inverse = DMatrix::from_diagonal(&DVector::from_iterator(r.len(), r.iter().map(|r| 1.0 / r)));
        let to_gains = inverse * b.transpose();
        let solved = Riccati::new(a, &(b * &to_gains), &(seen.transpose() * &seen));
        let Riccati { solution: cost, residual } = solved.map_err(|error| match unreached(a, b, NEARLY_ZERO) {
            Some(value) => fail(format!("{names} hardly reaches the mode with the eigenvalue {}, {lost}", told(value))),
            None => fail(error.to_string()),
        })?;
        let gains = to_gains * &cost;
        let eigenvalues =
            eigenvalues(a - b * &gains).ok_or_else(|| fail("its eigenvalues are not found".to_owned()))?;
        Ok(Self { gains, cost, eigenvalues, residual, space })
    }
}

/// An eigenvalue for messages.
fn told(value: Complex<f64>) -> String {
    const ROUNDING: f64 = 1e-12;
    let re = fixed(if value.re.abs() > ROUNDING * value.norm() { value.re } else { 0.0 }, 4);
    if value.im == 0.0 { format!("{re}/s") } else { format!("({re} ± {} i)/s", fixed(value.im.abs(), 4)) }
}
