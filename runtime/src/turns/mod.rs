//! Steady turns: the circles that a machine runs in by itself, hands free.
//!
//! Where straight running loses its stability to capsize, a curve of circles begins: at a lean and a steer that are in
//! balance, at one speed each. [`Turns`] follows it from there to its end, and tells of each [`Turn`] whether it is stable; and
//! it finds the curves that begin elsewhere, as the three of the benchmark bicycle in Basu-Mandal, Chatterjee & Papadopoulos
//! (2007).

mod balance;
mod differences;
mod follow;
mod others;
mod stability;

use core::fmt;

use nalgebra::Complex;

use crate::motion::MotionError;

/// A circle that a machine runs in at constant speed, lean and steer, without forces but those of gravity and of the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    /// All positions, in the order of [`MotionInfo`](crate::motion::MotionInfo); those that the turn does not depend on are
    /// zero.
    pub positions: Vec<f64>,
    /// The rates of all positions, where x is forward.
    pub rates: Vec<f64>,
    /// Speed of the point at which the first wheel touches the ground, in m/s.
    pub speed: f64,
    /// Yaw rate in rad/s, positive to the right.
    pub yaw_rate: f64,
    /// Radius of the circle that this point runs in, in m; infinite for straight running, and at rest that of the circle in
    /// which it would begin to roll.
    pub radius: f64,
    /// The eigenvalues in 1/s of the motion near the turn, sorted by real part and then by imaginary part: two for each
    /// free position. One more is zero, as from circle to circle nothing drives back.
    pub eigenvalues: Vec<Complex<f64>>,
}

impl Turn {
    /// Whether every small deviation dies away, but for one to a neighbouring circle.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.eigenvalues.iter().all(|eigenvalue| eigenvalue.re < 0.0)
    }
}

/// A curve of steady turns, in the order in which they follow from each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Turns {
    /// Where the curve begins: in straight running, if that is at a capsize speed.
    pub begin: TurnsEnd,
    /// The turns. From a capsize speed the first one is straight running at that.
    pub turns: Vec<Turn>,
    /// Where the curve ends.
    pub end: TurnsEnd,
    /// Whether it was followed by yaw rates.
    by_yaw: bool,
}

/// Where a curve of turns ends, or begins.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TurnsEnd {
    /// At rest: an equilibrium.
    Rest,
    /// In straight running, at another speed.
    Straight,
    /// It was followed only so far, since a machine that leans by 80 degrees or is turned around has fallen.
    Fallen,
    /// It was followed only so far, since its speed grows beyond all bounds.
    Fast,
    /// It could not be followed further.
    Lost(Option<MotionError>),
}

/// Why there are no turns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TurnsError {
    /// The machine does not run on wheels, or the rate of one of its free positions is none of its speeds.
    NoTurns,
    /// The speed with which the curve should begin is not finite or not above zero.
    Speed {
        /// The speed in m/s.
        speed: f64,
    },
    /// At the speed with which the curve should begin no lean and steer are in balance: it is no capsize speed.
    NoBalance {
        /// The speed in m/s.
        speed: f64,
    },
    /// The equations have no value in straight running.
    Motion(MotionError),
}

impl fmt::Display for TurnsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoTurns => f.write_str("it is no machine on wheels with one free speed beside what leans and steers, and only of these turns are found"),
            Self::Speed { speed } => write!(f, "the speed is {speed} m/s; it must be finite and > 0"),
            Self::NoBalance { speed } => {
                write!(f, "at {speed} m/s no lean and steer are in balance; turns begin at a capsize speed")
            }
            Self::Motion(error) => write!(f, "in straight running {error}"),
        }
    }
}

impl core::error::Error for TurnsError {}
