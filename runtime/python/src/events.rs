//! Events of the user's own: functions of Python that are watched during a motion.

use carvallo::simulation::{Crossing, Moment};
use carvallo_plot::analysis::simulation::Watch;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::signals::Signals;

/// A function of the time and the state, as SciPy has it.
#[derive(FromPyObject)]
pub struct Event {
    /// In messages.
    #[pyo3(item)]
    name: String,
    /// `event(t, state) -> float`.
    #[pyo3(item)]
    function: Py<PyAny>,
    /// The motion ends when it has happened so often.
    #[pyo3(item)]
    ends: Option<usize>,
    /// Above zero where only rising ones count, below zero where only falling ones do.
    #[pyo3(item)]
    direction: f64,
}

impl Event {
    /// What is watched for in a motion of quantities with such names; what the function raises ends the motion.
    pub fn watch<'a>(&'a self, names: &'a [&'static str], signals: &'a Signals) -> Watch<'a> {
        let crossing = match self.direction {
            direction if direction > 0.0 => Crossing::Rising,
            direction if direction < 0.0 => Crossing::Falling,
            _ => Crossing::Any,
        };
        let function = move |moment: &Moment| {
            // What happens to a motion that has been given up does not matter.
            if signals.is_raised() {
                return 0.0;
            }
            Python::attach(|py| self.value(py, names, moment)).unwrap_or_else(|error| {
                signals.raise(error);
                0.0
            })
        };
        Watch { name: self.name.clone(), crossing, ends: self.ends, function: Box::new(function) }
    }

    fn value(&self, py: Python<'_>, names: &[&str], moment: &Moment) -> PyResult<f64> {
        let state = PyDict::new(py);
        for (name, (position, rate)) in names.iter().zip(moment.positions.iter().zip(moment.rates)) {
            state.set_item(name, position)?;
            state.set_item(format!("{name}_rate"), rate)?;
        }
        let given = self.function.call1(py, (moment.time, state))?;
        let Ok(value) = given.extract::<f64>(py) else {
            let given = given.bind(py).repr()?;
            return Err(PyTypeError::new_err(format!("the event `{}` gives {given}; expected a number", self.name)));
        };
        if value.is_nan() {
            let (name, time) = (&self.name, moment.time);
            return Err(PyValueError::new_err(format!("the event `{name}` gives nan at {time} s; expected a number")));
        }
        Ok(value)
    }
}
