//! Feedback in nonlinear motion.

use carvallo::motion::{Energy, MotionError, MotionInfo};
use carvallo::simulation::{Drive, Machine, Moving};
use carvallo::{MatrixName, ModelInfo};

use super::{Gain, Law};

/// A machine with forces that follow from its motion: the nonlinear equations of a closed loop.
///
/// Positions and rates in a law are those of the motion, at any lean and steer, and the speed v in it is that at the moment, by
/// the rate that [`Drive`] tells it by: of a bicycle `-rR thetaR'`. To first order about straight running at a speed that
/// is what [`close`](super::close) makes of the linear equations, as the speed does not change to first order.
///
/// Forces that are applied are added to those of feedback.
pub struct Closed<'a> {
    machine: &'a dyn Machine,
    closing: Closing,
}

/// The laws of feedback, with the places of what they are between in a machine.
pub struct Closing {
    drive: Option<Drive>,
    parts: Vec<Part>,
}

/// A gain, with the places of what it is between in a machine.
struct Part {
    gain: Gain,
    force: usize,
    position: usize,
}

/// Why laws cannot be part of the nonlinear equations of a machine, which are there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unclosed {
    /// There is no force on what the law, by its place, acts on.
    Force(usize),
    /// There is no position for a coordinate of the law.
    Position(usize),
    /// The law has powers of the speed, and nothing in the machine runs.
    Speed(usize),
}

impl<'a> Closed<'a> {
    /// A machine with the laws of a model, whose coordinates are among its positions.
    ///
    /// # Errors
    /// If a law cannot be part of its equations.
    pub fn new(machine: &'a dyn Machine, model: &ModelInfo, laws: &[Law]) -> Result<Self, Unclosed> {
        Ok(Self { machine, closing: Closing::new(machine, model, laws)? })
    }

    fn forces(&self, positions: &[f64], speeds: &[f64], applied: &[f64]) -> Result<Vec<f64>, MotionError> {
        self.closing.forces(self.machine, positions, speeds, applied)
    }
}

impl Closing {
    /// The laws of a model, whose coordinates are among the positions of a machine.
    ///
    /// # Errors
    /// If a law cannot be part of its equations.
    pub fn new(machine: &dyn Moving, model: &ModelInfo, laws: &[Law]) -> Result<Self, Unclosed> {
        let (info, drive) = (machine.info(), Drive::of(machine));
        let mut parts = Vec::new();
        for (place, law) in laws.iter().enumerate() {
            let force = law.input.in_machine(machine, model).ok_or(Unclosed::Force(place))?;
            for &gain in &law.gains {
                let position = info.position(model.coordinates[gain.column].name).ok_or(Unclosed::Position(place))?;
                if gain.power() != 0 && drive.is_none() {
                    return Err(Unclosed::Speed(place));
                }
                parts.push(Part { gain, force, position });
            }
        }
        Ok(Self { drive, parts })
    }

    /// The applied forces with those of feedback, in a state of that machine.
    ///
    /// # Errors
    /// If the state is singular, or if a force is not finite.
    pub fn forces(
        &self,
        machine: &dyn Moving,
        positions: &[f64],
        speeds: &[f64],
        applied: &[f64],
    ) -> Result<Vec<f64>, MotionError> {
        let mut rates = vec![0.0; positions.len()];
        machine.rates(positions, speeds, &mut rates)?;
        let speed = self.drive.map_or(0.0, |drive| drive.speed(&rates));
        let mut forces = applied.to_vec();
        for Part { gain, force, position } in &self.parts {
            forces[*force] += gain.force(speed, positions[*position], rates[*position]);
        }
        // As a law with 1/v at rest.
        match self.parts.iter().find(|part| !forces[part.force].is_finite()) {
            None => Ok(forces),
            Some(Part { force, .. }) => Err(MotionError::NotFinite {
                name: machine.info().forces[*force].name,
                what: "force of feedback",
                value: forces[*force],
            }),
        }
    }
}

impl Gain {
    /// The force at a speed in m/s, and at the position and the rate of the coordinate that it follows from.
    pub fn force(&self, speed: f64, position: f64, rate: f64) -> f64 {
        let motion =
            if matches!(self.matrix, MatrixName::Cm1 | MatrixName::C0 | MatrixName::C1) { rate } else { position };
        self.value * speed.powi(self.power()) * motion
    }

    /// The power of the speed that it is multiplied by.
    fn power(&self) -> i32 {
        match self.matrix {
            MatrixName::Cm1 => -1,
            MatrixName::C1 | MatrixName::K1 => 1,
            MatrixName::K2 => 2,
            _ => 0,
        }
    }
}

impl Moving for Closed<'_> {
    fn info(&self) -> &'static MotionInfo {
        self.machine.info()
    }

    fn close(&self, positions: &mut [f64]) -> Result<(), MotionError> {
        self.machine.close(positions)
    }

    fn rates(&self, positions: &[f64], speeds: &[f64], rates: &mut [f64]) -> Result<(), MotionError> {
        self.machine.rates(positions, speeds, rates)
    }

    fn accelerations(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        accelerations: &mut [f64],
    ) -> Result<(), MotionError> {
        let forces = self.forces(positions, speeds, forces)?;
        self.machine.accelerations(positions, speeds, &forces, accelerations)
    }
}

impl Machine for Closed<'_> {
    fn derivatives(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        rates: &mut [f64],
        of_speeds: &mut [f64],
    ) -> Result<(), MotionError> {
        let forces = self.forces(positions, speeds, forces)?;
        self.machine.derivatives(positions, speeds, &forces, rates, of_speeds)
    }

    fn energy(&self, positions: &[f64], speeds: &[f64]) -> Result<Energy, MotionError> {
        self.machine.energy(positions, speeds)
    }

    fn contact_forces(&self, positions: &[f64], speeds: &[f64], forces: &[f64]) -> Result<Vec<[f64; 3]>, MotionError> {
        self.machine.contact_forces(positions, speeds, &self.forces(positions, speeds, forces)?)
    }
}
