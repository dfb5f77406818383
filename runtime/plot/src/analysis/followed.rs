//! How the eigenvalues of a design are told apart along the speed.

use carvallo::{Branches, ModeValue, Modes, Stability, SystemError};
use carvallo_design::{Equations, Shipped};

use super::{is_bicycle, leans_and_steers};

/// Where there is no motion at rest, eigenvalues are followed from this part of the speeds on.
const NEAR_REST: f64 = 1.0 / 256.0;

/// How eigenvalues are told apart.
pub enum Followed {
    /// By the names that all modes of a bicycle have.
    Bicycle(Box<Modes>),
    /// By where they come from.
    Any(Branches),
    /// Nothing depends on the speed.
    Not,
}

impl Followed {
    /// Up to a speed in m/s.
    ///
    /// # Errors
    /// If there are none at some speed.
    pub fn new(
        model: &Shipped,
        equations: &dyn Equations,
        gravity: f64,
        stability: &Stability,
        to: f64,
    ) -> Result<Self, SystemError> {
        Ok(match equations.of_two() {
            Some(two) if is_bicycle(model.info) => Self::Bicycle(Box::new(Modes::new(two, gravity)?)),
            _ if !model.depends_on_speed() => Self::Not,
            _ => {
                // Near rest what is divided by the speed leaves every bound.
                let from = if equations.without_rest().is_some() { NEAR_REST * to } else { 0.0 };
                let critical = &stability.critical_speeds;
                Self::Any(equations.branches(gravity, critical, [from, to], leans_and_steers(model.info))?)
            }
        })
    }

    /// The eigenvalues at a speed in m/s with their names; none where nothing depends on it.
    ///
    /// # Errors
    /// If there are none.
    pub fn at(&self, speed: f64) -> Result<Vec<ModeValue>, SystemError> {
        match self {
            Self::Bicycle(modes) => Ok(modes.at(speed)?.to_vec()),
            Self::Any(branches) => branches.at(speed),
            Self::Not => Ok(Vec::new()),
        }
    }
}
