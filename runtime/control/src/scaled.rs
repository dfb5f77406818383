//! State spaces and gains in other units than those of the SI.

use carvallo_design::DisplayUnit;
use carvallo_design::number::shortest;
use nalgebra::DMatrix;

use crate::feedback::{Regulator, Schedule};
use crate::signal::Signal;
use crate::state_space::StateSpace;

/// The unit that a quantity is shown in, by that which it is declared in, such as `rad` or `N*m`.
pub type ShownIn<'a> = dyn Fn(&str) -> DisplayUnit + 'a;

/// What values are multiplied with to be shown.
fn factors(signals: &[Signal], shown: &ShownIn) -> Vec<f64> {
    signals.iter().map(|signal| shown(&signal.unit).value(1.0)).collect()
}

/// A matrix whose rows and columns are in other units.
fn scaled(matrix: &DMatrix<f64>, rows: &[f64], columns: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
        let entry = matrix[(row, column)];
        if rows[row] == columns[column] { entry } else { entry * rows[row] / columns[column] }
    })
}

fn renamed(signals: &[Signal], shown: &ShownIn) -> Vec<Signal> {
    signals.iter().map(|signal| Signal { unit: shown(&signal.unit).written, ..signal.clone() }).collect()
}

impl StateSpace {
    /// The same with states, inputs and outputs in other units, and with the speed shown in another.
    #[must_use]
    pub fn in_units(&self, shown: &ShownIn) -> Self {
        let [states, inputs, outputs] = [&self.states, &self.inputs, &self.outputs].map(|own| factors(own, shown));
        Self {
            a: scaled(&self.a, &states, &states),
            b: scaled(&self.b, &states, &inputs),
            c: scaled(&self.c, &outputs, &states),
            d: scaled(&self.d, &outputs, &inputs),
            states: renamed(&self.states, shown),
            inputs: renamed(&self.inputs, shown),
            outputs: renamed(&self.outputs, shown),
            speed: self.speed,
            speed_unit: shown("m/s"),
        }
    }

    /// A state in the units that are [shown](Self::in_units), which is given in those of this state space.
    pub fn state_in_units(&self, state: &[f64], shown: &ShownIn) -> Vec<f64> {
        state.iter().zip(factors(&self.states, shown)).map(|(value, factor)| value * factor).collect()
    }

    /// The speed with its unit, `5 m/s`; nothing where the equations do not depend on it.
    pub fn speed_text(&self) -> Option<String> {
        let unit = &self.speed_unit;
        self.speed.map(|speed| format!("{} {}", shortest(unit.value(speed)), unit.unit()))
    }

    /// The speed in the unit that it is shown in.
    pub fn shown_speed(&self) -> Option<f64> {
        self.speed.map(|speed| self.speed_unit.value(speed))
    }
}

impl Schedule {
    /// The same with states and inputs in other units, and with speeds shown in another.
    #[must_use]
    pub fn in_units(&self, shown: &ShownIn) -> Self {
        let regulator = |own: &Regulator| {
            let states = factors(&own.space.states, shown);
            let inverse: Vec<f64> = states.iter().map(|factor| 1.0 / factor).collect();
            Regulator {
                gains: own.gains_in_units(&own.gains, shown),
                cost: scaled(&own.cost, &inverse, &states),
                space: own.space.in_units(shown),
                ..own.clone()
            }
        };
        Self { regulators: self.regulators.iter().map(regulator).collect(), unstable: self.unstable.clone() }
    }
}

impl Regulator {
    /// Gains, or derivatives of them, in the units that are [shown](Schedule::in_units), which are given in those of this regulator.
    pub fn gains_in_units(&self, gains: &DMatrix<f64>, shown: &ShownIn) -> DMatrix<f64> {
        scaled(gains, &factors(&self.space.inputs, shown), &factors(&self.space.states, shown))
    }
}
