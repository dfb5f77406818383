//! What matrices are multiplied by, and what that may be of.

use std::fmt::{self, Display};

use carvallo::MatrixName;
use carvallo_design::number::shortest;

use super::solve::digits;
use crate::conventions::power;
use crate::machine::Machine;
use crate::predict::World;

/// What matrices are multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scaled {
    /// All of them by a factor.
    All(f64),
    /// Those before which a power of the speed stands by that power of a speed in m/s.
    Speed(f64),
    /// One of these alone.
    One(MatrixName, f64),
}

/// A pound in kg, an inch and a foot in m, a pound of force in N.
const LB: f64 = 0.453_592_37;
const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
const LBF: f64 = 4.448_221_615_260_5;

/// What a factor may be of: by how much numbers in these units are larger.
const UNITS: [(f64, &str); 13] = [
    (1.0 / LB, "lb in the place of kg"),
    (1.0 / (LB * INCH * INCH), "lb*in^2 in the place of kg*m^2"),
    (1.0 / (LB * FOOT * FOOT), "lb*ft^2 in the place of kg*m^2"),
    (1.0 / LBF, "lbf in the place of N"),
    (1.0 / (LBF * INCH), "lbf*in in the place of N*m"),
    (1.0 / (LBF * FOOT), "lbf*ft in the place of N*m"),
    (1.0 / 9.806_65, "kgf in the place of N"),
    (1e3, "N*mm in the place of N*m"),
    (1e4, "kg*cm^2 in the place of kg*m^2"),
    (1e6, "kg*mm^2 in the place of kg*m^2"),
    (1e7, "g*cm^2 in the place of kg*m^2"),
    (1e9, "g*mm^2 in the place of kg*m^2"),
    (1e-3, "kN in the place of N"),
];

/// Conversions that people remember are off by so much, as 2.2 lb.
const CONVERTED: f64 = 2.5e-3;

/// The unit that a factor is of, with its own factor.
pub fn unit(factor: f64) -> Option<(f64, &'static str)> {
    UNITS.into_iter().find(|(of_unit, _)| (of_unit / factor - 1.0).abs() < CONVERTED)
}

impl Scaled {
    /// The matrices.
    pub fn world(self, machine: &Machine) -> World {
        let mut world = machine.world();
        let square = machine.formulas.count * machine.formulas.count;
        for (matrix, entries) in MatrixName::ALL.into_iter().zip(world.entries.chunks_exact_mut(square)) {
            let factor = match self {
                Self::All(factor) => factor,
                Self::Speed(speed) => speed.powi(power(matrix)),
                Self::One(own, speed) => speed.powi(if own == matrix { power(matrix) } else { 0 }),
            };
            entries.iter_mut().for_each(|entry| *entry *= factor);
        }
        world
    }
}

impl Display for Scaled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::All(factor) => {
                // Those of units to as many digits as conversions have.
                let rounded = |x: f64, digits: usize| -> f64 { format!("{x:.digits$e}").parse().unwrap_or(x) };
                let inverse = rounded(1.0 / factor, 14);
                match unit(factor) {
                    Some((_, unit)) => {
                        write!(f, "all matrices are multiplied by {}, as for {unit}", shortest(rounded(factor, 5)))
                    }
                    None if factor.abs() < 1.0 && digits(inverse) < digits(factor) => {
                        write!(f, "all matrices are divided by {}", shortest(inverse))
                    }
                    None => write!(f, "all matrices are multiplied by {}", shortest(factor)),
                }
            }
            Self::Speed(speed) => {
                write!(f, "the speed is in the matrices, as {} m/s: they are multiplied already", shortest(speed))
            }
            Self::One(matrix, speed) => {
                write!(f, "the speed is in {matrix}, as {} m/s: it is multiplied already", shortest(speed))
            }
        }
    }
}
