//! How the gains of a regulator change with the parameters of its design.

use carvallo_design::{Design, Failure};
use nalgebra::{DMatrix, DVector};

use super::regulator::Regulator;
use super::riccati::lyapunov;
use super::weights::Weights;
use crate::derivatives::StateSpaceDerivative;

impl Regulator {
    /// The derivatives of the gains with respect to each parameter of the design, in declared order, each of the shape of the gains and
    /// in their units by that of the parameter.
    ///
    /// They are exact to rounding: the derivative of the Riccati equation is a Lyapunov equation in that of its solution,
    ///
    /// ```text
    /// (A - B K)' dX + dX (A - B K) + dA' X + X dA - X dG X + dQ = 0,  G = B R^-1 B',
    /// ```
    ///
    /// and `K = R^-1 B' X` has the derivative `R^-1 (dB' X + B' dX)`. Weights stay what they are.
    ///
    /// # Errors
    /// If the model was compiled without derivatives, or one is not finite.
    pub fn sensitivities(&self, design: &Design, weights: &Weights) -> Result<Vec<DMatrix<f64>>, Failure> {
        let (inputs, r): (Vec<usize>, Vec<f64>) = weights.inputs.iter().copied().unzip();
        let (outputs, q): (Vec<_>, Vec<f64>) = weights.outputs.iter().copied().unzip();
        let derivatives = StateSpaceDerivative::of_parameters(design, &self.space, &inputs, &outputs)?;
        let inverse = DMatrix::from_diagonal(&DVector::from_iterator(r.len(), r.iter().map(|r| 1.0 / r)));
        let weight = DMatrix::from_diagonal(&DVector::from_vec(q));
        let (b, c, x) = (&self.space.b, &self.space.c, &self.cost);
        let closed = &self.space.a - b * &self.gains;
        let of = |change: StateSpaceDerivative| {
            let twice = |half: DMatrix<f64>| &half + half.transpose();
            let of_g = twice(&change.b * &inverse * b.transpose());
            let of_q = twice(change.c.transpose() * &weight * c);
            let right = twice(x * &change.a) - x * of_g * x + of_q;
            let of_x = lyapunov(&closed, &right)?;
            let gains = &inverse * (change.b.transpose() * x + b.transpose() * of_x);
            gains.iter().all(|entry| entry.is_finite()).then_some(gains)
        };
        let found: Option<Vec<DMatrix<f64>>> = derivatives.into_iter().map(of).collect();
        found.ok_or_else(|| {
            Failure::Run(format!("{}: a derivative of a gain leaves the range of doubles", design.title()))
        })
    }
}
