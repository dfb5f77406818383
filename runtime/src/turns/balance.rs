//! What makes a turn steady: no free position is accelerated.

use core::cell::RefCell;

use nalgebra::DMatrix;

use super::TurnsError;
use super::differences::jacobian;
use crate::motion::{MotionError, PositionKind};
use crate::simulation::Machine;

/// A machine in turns, described by its free positions and its speed, or its yaw rate.
pub(super) struct Balance<'a> {
    pub machine: &'a dyn Machine,
    /// The free positions.
    pub free: Vec<usize>,
    /// Which of them is the lean, if one is.
    pub lean: Option<usize>,
    /// The place of the rate of each among the speeds.
    rates: Vec<usize>,
    /// The place among the speeds of the one that drives, and its value at 1 m/s.
    drive: (usize, f64),
    x: usize,
    /// The place of the yaw, if turns are described by its rate: where a machine turns about a wheel that does not roll.
    yaw: Option<usize>,
    /// Where the search for the dependent positions begins: at those that were found last.
    near: RefCell<Vec<f64>>,
}

/// A state of the machine: all positions and speeds.
pub(super) struct At {
    pub positions: Vec<f64>,
    pub speeds: Vec<f64>,
}

impl<'a> Balance<'a> {
    pub fn new(machine: &'a dyn Machine) -> Result<Self, TurnsError> {
        let info = machine.info();
        let kinds = || info.positions.iter().enumerate();
        let free: Vec<usize> =
            kinds().filter(|(_, position)| position.kind == PositionKind::Free).map(|(place, _)| place).collect();
        let rates: Option<Vec<usize>> = free.iter().map(|&place| info.speed_of(place)).collect();
        let rates = rates.filter(|rates| rates.len() + 1 == info.speeds.len()).ok_or(TurnsError::NoTurns)?;
        let drive = (0..info.speeds.len()).find(|speed| !rates.contains(speed)).ok_or(TurnsError::NoTurns)?;
        let x = info.position("x").ok_or(TurnsError::NoTurns)?;
        let lean = free.iter().position(|&place| info.positions[place].name == "phi");
        let near = RefCell::new(vec![0.0; info.positions.len()]);
        let mut balance = Self { machine, free, lean, rates, drive: (drive, 1.0), x, yaw: None, near };
        let per_rate = balance.forward(&balance.at(&vec![0.0; balance.free.len()], 1.0).map_err(TurnsError::Motion)?);
        let per_rate = per_rate.map_err(TurnsError::Motion)?;
        if per_rate == 0.0 {
            return Err(TurnsError::NoTurns);
        }
        balance.drive.1 = 1.0 / per_rate;
        Ok(balance)
    }

    /// The same by the yaw rate in the place of the speed; `None` without a yaw.
    pub fn by_yaw(self) -> Option<Self> {
        let yaw = self.machine.info().position("psi")?;
        Some(Self { yaw: Some(yaw), ..self })
    }

    pub fn is_by_yaw(&self) -> bool {
        self.yaw.is_some()
    }

    /// The state with these free positions and this speed, or yaw rate.
    pub fn at(&self, free: &[f64], speed: f64) -> Result<At, MotionError> {
        let mut positions = self.near.borrow().clone();
        self.free.iter().zip(free).for_each(|(&place, &value)| positions[place] = value);
        self.machine.close(&mut positions)?;
        *self.near.borrow_mut() = positions.clone();
        let mut speeds = vec![0.0; self.machine.info().speeds.len()];
        speeds[self.drive.0] = self.drive.1;
        let mut at = At { positions, speeds };
        let factor = if let Some(yaw) = self.yaw { speed / self.rates(&at)?[yaw] } else { speed };
        at.speeds[self.drive.0] *= factor;
        Ok(at)
    }

    /// The speed at which the first wheel's contact goes forward.
    fn forward(&self, at: &At) -> Result<f64, MotionError> {
        Ok(self.rates(at)?[self.x])
    }

    pub fn rates(&self, at: &At) -> Result<Vec<f64>, MotionError> {
        let mut rates = vec![0.0; at.positions.len()];
        self.machine.rates(&at.positions, &at.speeds, &mut rates)?;
        Ok(rates)
    }

    /// The accelerations of the free positions: zero in a steady turn. So is then that of the drive, since energy is
    /// conserved.
    pub fn accelerations(&self, free: &[f64], speed: f64) -> Result<Vec<f64>, MotionError> {
        let at = self.at(free, speed)?;
        let of_speeds = self.of_speeds(&at)?;
        Ok(self.rates.iter().map(|&place| of_speeds[place]).collect())
    }

    /// The derivatives of the rates of free positions and of the speeds, with respect to these: what decides how a turn goes on,
    /// and where the next one is.
    pub fn slopes(&self, free: &[f64], speeds: &[f64]) -> Result<DMatrix<f64>, MotionError> {
        let info = self.machine.info();
        let At { positions, .. } = self.at(free, 0.0)?;
        let Some(linearization) = self.machine.linearize(&positions, speeds, &vec![0.0; info.forces.len()]) else {
            return jacobian(&[free, speeds].concat(), |state| self.derivatives(state));
        };
        let states: Vec<usize> =
            self.free.iter().copied().chain((0..speeds.len()).map(|i| positions.len() + i)).collect();
        Ok(linearization?.a.select_rows(&states).select_columns(&states))
    }

    /// The derivatives of the accelerations of the free positions with respect to these, and to the speed or the yaw rate.
    pub fn slopes_of_turns(&self, free: &[f64], speed: f64) -> Result<DMatrix<f64>, MotionError> {
        // The speeds that make a yaw rate depend on the free positions.
        if self.is_by_yaw() {
            return jacobian(&[free, &[speed]].concat(), |point| {
                self.accelerations(&point[..free.len()], point[free.len()])
            });
        }
        let slopes = self.slopes(free, &self.at(free, speed)?.speeds)?;
        let count = self.free.len();
        let entry = |row: usize, column: usize| {
            let place = count + self.rates[row];
            if column < count { slopes[(place, column)] } else { slopes[(place, count + self.drive.0)] * self.drive.1 }
        };
        Ok(DMatrix::from_fn(count, count + 1, entry))
    }

    /// The derivatives of free positions and speeds in time.
    fn derivatives(&self, state: &[f64]) -> Result<Vec<f64>, MotionError> {
        let (free, speeds) = state.split_at(self.free.len());
        let at = At { speeds: speeds.to_vec(), ..self.at(free, 0.0)? };
        let of_speeds = self.of_speeds(&at)?;
        Ok(self.rates.iter().map(|&place| speeds[place]).chain(of_speeds).collect())
    }

    fn of_speeds(&self, at: &At) -> Result<Vec<f64>, MotionError> {
        let forces = vec![0.0; self.machine.info().forces.len()];
        let (mut rates, mut of_speeds) = (vec![0.0; at.positions.len()], vec![0.0; at.speeds.len()]);
        self.machine.derivatives(&at.positions, &at.speeds, &forces, &mut rates, &mut of_speeds)?;
        Ok(of_speeds)
    }
}
