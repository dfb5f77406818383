//! Motions in time of one design.

use carvallo::simulation::Force;
use carvallo_design::units::Units;
use carvallo_design::{Design, Failure};
use carvallo_plot::analysis::simulation::{Given, Linear, Motion, Nonlinear, Row, Solver, read};
use carvallo_plot::picture::draw_motion;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::events::Event;
use crate::one::About;
use crate::signals::{Signals, listening};
use crate::words::in_python;

/// What a motion begins with, what acts on it, and by which equations it goes.
#[derive(FromPyObject)]
pub struct Asked {
    /// Forward, in m/s.
    #[pyo3(item)]
    speed: f64,
    /// In s, from 0.
    #[pyo3(item)]
    times: Vec<f64>,
    /// `phi=5 deg`.
    #[pyo3(item)]
    initial: Vec<String>,
    /// `delta=2 N m`.
    #[pyo3(item)]
    constant: Vec<String>,
    /// Names with points of time and force.
    #[pyo3(item)]
    varying: Vec<(String, Vec<(f64, f64)>)>,
    #[pyo3(item)]
    events: Vec<Event>,
    #[pyo3(item)]
    linear: bool,
}

/// How many rows a picture is drawn from, but one.
const DRAWN: u32 = 1000;

impl Asked {
    fn solve<'a>(
        &self,
        design: &'a Design,
        solver: &dyn Solver,
        times: &[f64],
        signals: &Signals,
    ) -> Result<Motion<'a>, Failure> {
        // A force that varies is zero at first, so that its name is judged as all others.
        let zero = self.varying.iter().map(|(name, _)| format!("{name}=0"));
        let forces: Vec<String> = self.constant.iter().cloned().chain(zero).collect();
        let end = times.last().copied().unwrap_or(0.0);
        let names: Vec<&'static str> = solver.givable().iter().map(|givable| givable.quantity.name).collect();
        let mut given: Given = read(solver, design, &self.initial, &forces, end).map_err(Failure::Input)?;
        for (name, points) in &self.varying {
            let is_called = |names: &[String]| names.iter().any(|own| own.eq_ignore_ascii_case(name.trim()));
            let force = Force::through(points);
            let force = force.map_err(|error| Failure::usage(format!("the force `{name}`: {error}")))?;
            if let Some(channel) = solver.channels().iter().position(|channel| is_called(&channel.names)) {
                given.forces[channel] = force;
            }
        }
        given.watches = self.events.iter().map(|event| event.watch(&names, signals)).collect();
        solver.run(design, &given, self.speed, times, &|_| signals.look())
    }

    fn linear<'a>(&self, design: &'a Design, times: &[f64], signals: &Signals) -> Result<Motion<'a>, Failure> {
        self.solve(design, &Linear::new(design), times, signals)
    }

    /// The motion by the nonlinear equations, unless the linear ones were asked for or there are no others.
    fn motion<'a>(&self, design: &'a Design, times: &[f64], signals: &Signals) -> Result<Motion<'a>, Failure> {
        let mut found = None;
        if !self.linear {
            // Without nonlinear equations it is the motion of the linear ones, which is told.
            let _ = design.with_machine(&mut |machine| {
                found = Some(self.solve(design, &Nonlinear::new(machine), times, signals))
            });
        }
        found.unwrap_or_else(|| self.linear(design, times, signals))
    }

    fn picture(&self, design: &Design, signals: &Signals) -> Result<String, Failure> {
        let motion = self.motion(design, &self.times, signals)?;
        let end = motion.rows.last().map_or(0.0, |row| row.t);
        let fine: Vec<f64> = (0..=DRAWN).map(|row| end * f64::from(row) / f64::from(DRAWN)).collect();
        let drawn = self.motion(design, &fine, signals)?;
        let linear = (!drawn.is_linear).then(|| self.linear(design, &fine, signals)).transpose()?;
        Ok(draw_motion(&drawn, linear.as_ref(), &Units::default()).svg())
    }
}

/// A motion as arrays.
#[derive(IntoPyObject)]
pub struct Told<'py> {
    is_linear: bool,
    quantities: Vec<(&'static str, &'static str, &'static str)>,
    wheels: Vec<&'static str>,
    t: Bound<'py, PyArray1<f64>>,
    /// By time and quantity.
    positions: Bound<'py, PyArray2<f64>>,
    rates: Bound<'py, PyArray2<f64>>,
    accelerations: Bound<'py, PyArray2<f64>>,
    /// By time: kinetic and potential.
    energy: Option<Bound<'py, PyArray2<f64>>>,
    /// By time, wheel and axis.
    contact_forces: Bound<'py, PyArray3<f64>>,
    /// By time and law.
    feedback: Bound<'py, PyArray2<f64>>,
    /// What the laws are on, with units.
    laws: Vec<(String, &'static str)>,
    /// What happened, by the place of the event; and the motion there, by event and quantity.
    happened: Vec<usize>,
    happened_t: Bound<'py, PyArray1<f64>>,
    happened_positions: Bound<'py, PyArray2<f64>>,
    happened_rates: Bound<'py, PyArray2<f64>>,
    happened_accelerations: Bound<'py, PyArray2<f64>>,
    end: Option<String>,
    notes: Vec<String>,
}

/// What is left of a motion when the design that it is of has gone.
struct Rows {
    is_linear: bool,
    quantities: Vec<(&'static str, &'static str, &'static str)>,
    wheels: Vec<&'static str>,
    rows: Vec<Row>,
    laws: Vec<(String, &'static str)>,
    happened: Vec<usize>,
    happened_rows: Vec<Row>,
    end: Option<String>,
    notes: Vec<String>,
}

impl Rows {
    fn of(motion: Motion) -> Self {
        let laws = motion.feedback();
        let quantities = motion.quantities.iter().map(|quantity| (quantity.name, quantity.label, quantity.unit));
        Self {
            is_linear: motion.is_linear,
            quantities: quantities.collect(),
            wheels: motion.wheels,
            laws,
            happened: motion.events.iter().map(|event| event.watch).collect(),
            happened_rows: motion.events.into_iter().map(|event| event.row).collect(),
            rows: motion.rows,
            end: motion.end.as_deref().map(in_python),
            notes: motion.notes.iter().map(|note| in_python(note)).collect(),
        }
    }

    fn told<'py>(self, py: Python<'py>) -> PyResult<Told<'py>> {
        let Self { rows, quantities, wheels, happened_rows, .. } = &self;
        let (count, width, wheel_count) = (rows.len(), quantities.len(), wheels.len());
        let by_row = |rows: &[Row], width: usize, of: fn(&Row) -> &[f64]| {
            PyArray1::from_vec(py, rows.iter().flat_map(of).copied().collect()).reshape([rows.len(), width])
        };
        let times = |rows: &[Row]| PyArray1::from_vec(py, rows.iter().map(|row| row.t).collect());
        let energy: Option<Vec<[f64; 2]>> = rows.iter().map(|row| row.energy).collect();
        let energy = energy
            .filter(|_| count > 0)
            .map(|energy| PyArray1::from_vec(py, energy.into_iter().flatten().collect()).reshape([count, 2]));
        let forces: Vec<f64> = rows.iter().flat_map(|row| row.contact_forces.iter().flatten()).copied().collect();
        Ok(Told {
            t: times(rows),
            positions: by_row(rows, width, |row| &row.positions)?,
            rates: by_row(rows, width, |row| &row.rates)?,
            accelerations: by_row(rows, width, |row| &row.accelerations)?,
            feedback: by_row(rows, self.laws.len(), |row| &row.feedback)?,
            happened_t: times(happened_rows),
            happened_positions: by_row(happened_rows, width, |row| &row.positions)?,
            happened_rates: by_row(happened_rows, width, |row| &row.rates)?,
            happened_accelerations: by_row(happened_rows, width, |row| &row.accelerations)?,
            laws: self.laws,
            happened: self.happened,
            energy: energy.transpose()?,
            contact_forces: PyArray1::from_vec(py, forces).reshape([count, wheel_count, 3])?,
            is_linear: self.is_linear,
            quantities: self.quantities,
            wheels: self.wheels,
            end: self.end,
            notes: self.notes,
        })
    }
}

#[pymethods]
impl Designs {
    /// The motion of one design.
    fn simulate<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<Told<'py>> {
        let design = self.described(py, about)?;
        listening(py, |signals| asked.motion(&design.build()?, &asked.times, signals).map(Rows::of))?.told(py)
    }

    /// The picture of a motion, as SVG.
    fn motion_svg(&self, py: Python<'_>, about: About, asked: Asked) -> PyResult<String> {
        let design = self.described(py, about)?;
        listening(py, |signals| asked.picture(&design.build()?, signals))
    }
}
