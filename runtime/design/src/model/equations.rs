//! The linearized equations of motion of any number of coordinates, and what is made of them.

use std::any::Any;
use std::fmt::Debug;

use carvallo::simulation::LinearMotion;
use carvallo::{
    Branches, Coefficients, Complex, CriticalSpeed, Eigenvectors, Matrix, MatrixName, Stability, StateSpace, States,
    SystemError,
};

use super::written;

/// The right and the left eigenvector of an eigenvalue, by coordinate.
#[derive(Clone, Debug)]
pub struct Shape {
    /// As [`Eigenvectors`] has it.
    pub right: Vec<Complex<f64>>,
    /// As [`Eigenvectors`] has it.
    pub left: Vec<Complex<f64>>,
}

/// The linearized equations of motion for any number of coordinates.
pub trait Equations: Debug {
    /// All matrices, with their rows.
    fn matrices(&self) -> [(MatrixName, Vec<Vec<f64>>); 8];

    /// The eigenvalues in 1/s at a speed in m/s and a gravitational field strength in N/kg, sorted by real part, then by
    /// imaginary part.
    ///
    /// # Errors
    /// If there are none, as for a singular mass matrix.
    fn eigenvalues(&self, speed: f64, gravity: f64) -> Result<Vec<Complex<f64>>, SystemError>;

    /// The motion at a speed in m/s and a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If there is none, as for a singular mass matrix.
    fn motion(&self, speed: f64, gravity: f64) -> Result<LinearMotion, SystemError>;

    /// The matrices M, C and K at a speed in m/s and a gravitational field strength in N/kg, row by row.
    ///
    /// # Errors
    /// If there are none, as at rest with a C-1.
    fn system(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 3], SystemError>;

    /// The matrices A and B of the state-space form `x' = A x + B f` at a speed in m/s and a gravitational field strength in
    /// N/kg, row by row. The states x are the positions that are states, then the rates; the inputs f are the forces of all
    /// coordinates.
    ///
    /// # Errors
    /// If there are none, as for a singular mass matrix.
    fn state_space(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 2], SystemError>;

    /// The eigenvectors of all eigenvalues at a speed, given in any order, in the same order.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn eigenvectors(&self, speed: f64, gravity: f64, values: &[Complex<f64>]) -> Result<Vec<Shape>, SystemError>;

    /// The critical speeds and stable ranges at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If there are none, as for a singular mass matrix.
    fn stability(&self, gravity: f64) -> Result<Stability, SystemError>;

    /// The eigenvalues followed one by one over a range of speeds in m/s, at a gravitational field strength in N/kg, with names
    /// from critical speeds; as those of a machine that leans and steers, or of any other.
    ///
    /// # Errors
    /// If there are none at some speed in the range.
    fn branches(
        &self,
        gravity: f64,
        critical_speeds: &[CriticalSpeed],
        range: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Branches, SystemError>;

    /// The coefficients of exactly two coordinates, for which there is more to be had: without C-1 and K1, and with
    /// positions and rates for states.
    fn of_two(&self) -> Option<&Coefficients<f64, 2>>;

    /// Why there are no equations of motion at rest, if there are none, as the end of a sentence.
    fn without_rest(&self) -> Option<&'static str>;
}

impl<const N: usize> Equations for Coefficients<f64, N> {
    fn matrices(&self) -> [(MatrixName, Vec<Vec<f64>>); 8] {
        written::all(&|name| self.matrix(name).as_slice(), N)
    }

    fn eigenvalues(&self, speed: f64, gravity: f64) -> Result<Vec<Complex<f64>>, SystemError> {
        self.at(speed, gravity)?.eigenvalues()
    }

    fn motion(&self, speed: f64, gravity: f64) -> Result<LinearMotion, SystemError> {
        LinearMotion::new(&self.at(speed, gravity)?)
    }

    fn system(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 3], SystemError> {
        let system = self.at(speed, gravity)?;
        Ok(written::by_rows([system.m.as_slice(), system.c.as_slice(), system.k.as_slice()], N))
    }

    fn state_space(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 2], SystemError> {
        let StateSpace { stiffness, damping, input, states } = self.at(speed, gravity)?.state_space()?;
        Ok(written::state_space([stiffness.as_slice(), damping.as_slice(), input.as_slice()], &states))
    }

    fn eigenvectors(&self, speed: f64, gravity: f64, values: &[Complex<f64>]) -> Result<Vec<Shape>, SystemError> {
        let vectors = self.at(speed, gravity)?.eigenvectors(values)?;
        let shape = |of: &Eigenvectors<N>| written::shape(of.right.as_slice(), of.left.as_slice());
        Ok(vectors.iter().map(shape).collect())
    }

    fn stability(&self, gravity: f64) -> Result<Stability, SystemError> {
        Stability::new(self, gravity)
    }

    fn branches(
        &self,
        gravity: f64,
        critical_speeds: &[CriticalSpeed],
        range: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Branches, SystemError> {
        Branches::new(self, gravity, critical_speeds, range, is_bicycle)
    }

    fn of_two(&self) -> Option<&Coefficients<f64, 2>> {
        let is_zero = |matrix: &Matrix<f64, N>| matrix.iter().all(|&entry| entry == 0.0);
        let has_both = self.states.iter().all(|states| *states == States::Both);
        as_of_two(self).filter(|_| has_both && is_zero(&self.cm1) && is_zero(&self.k1))
    }

    fn without_rest(&self) -> Option<&'static str> {
        written::without_rest([&self.m, &self.cm1, &self.c0].map(|matrix| matrix.as_slice()), &self.states)
    }
}

/// What is of any number of coordinates, as what is of two, for which there is more to be had; `None` if it is of another
/// number. The types differ with the number, and only their identity tells whether it is two; it is known when the program
/// is compiled, so that nothing is left of the question.
fn as_of_two<T: Any, Two: Any>(value: &T) -> Option<&Two> {
    (value as &dyn Any).downcast_ref()
}
