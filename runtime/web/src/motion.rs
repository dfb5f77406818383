//! Motions in time.

use std::ops::ControlFlow;

use carvallo_design::{Design, Failure, Problem};
use carvallo_plot::analysis::simulation::{Linear, Motion, Nonlinear, Solver, read};
use serde::Serialize;

use crate::question::{Question, missing};

/// What a step may err where a motion is drawn: far less than a point of the screen, in a third of the steps of a file.
const DRAWN: f64 = 1e-8;

/// The motion that is asked for.
pub struct Asked {
    /// In m/s.
    pub speed: f64,
    /// In s.
    pub duration: f64,
    /// How many steps the rows are of.
    pub steps: u32,
    /// Positions and rates at the beginning, such as `phi_rate=0.5` or `phi=5 deg`.
    pub initial: Vec<String>,
}

impl Asked {
    /// What a question has of it.
    ///
    /// # Errors
    /// If something is missing, or of another kind.
    pub fn read(mut question: Question) -> Result<Self, Failure> {
        let mut number = |name: &str| question.number(name)?.ok_or_else(|| missing(name));
        let (speed, duration, steps) = (number("speed")?, number("duration")?, number("steps")? as u32);
        Ok(Self { speed, duration, steps, initial: question.texts("initial")?.unwrap_or_default() })
    }
}

/// A motion. The numbers are row by row: the time in s, then the positions of all quantities, and the forces of feedback; where
/// the paths of wheels are known they are among the positions, as `x` and `y`.
#[derive(Serialize)]
pub struct Told {
    is_linear: bool,
    rows: usize,
    quantities: Vec<Named>,
    forces: Vec<Force>,
    end: Option<String>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct Named {
    name: &'static str,
    label: &'static str,
    unit: &'static str,
}

/// What follows from the motion by a law.
#[derive(Serialize)]
struct Force {
    name: String,
    unit: &'static str,
}

/// Simulates a design.
///
/// # Errors
/// Everything that is wrong with the parameters or the state at the beginning, or that there is no motion.
pub fn simulate(design: &Design, asked: &Asked, numbers: &mut Vec<f64>) -> Result<Told, Failure> {
    move_by(design, asked, Some(DRAWN), &mut |motion| {
        for row in &motion.rows {
            numbers.push(row.t);
            numbers.extend(row.positions.iter().chain(&row.feedback));
        }
        let named = |quantity: &carvallo_plot::analysis::simulation::Quantity| Named {
            name: quantity.name,
            label: quantity.label,
            unit: quantity.unit,
        };
        Ok(Told {
            is_linear: motion.is_linear,
            rows: motion.rows.len(),
            quantities: motion.quantities.iter().map(named).collect(),
            forces: motion.feedback().into_iter().map(|(name, unit)| Force { name, unit }).collect(),
            end: motion.end.clone(),
            notes: motion.notes.clone(),
        })
    })
}

/// Hands the motion to what tells it, solved with a tolerance of its own if one is given.
///
/// # Errors
/// As [`simulate`], or what the teller says.
pub fn move_by<T>(
    design: &Design,
    asked: &Asked,
    tolerance: Option<f64>,
    tell: &mut dyn FnMut(&Motion) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let mut told = None;
    let machine = design.with_machine(&mut |machine| {
        let solver = Nonlinear::new(machine);
        let solver = match tolerance {
            Some(tolerance) => solver.tolerance(tolerance),
            None => solver,
        };
        let motion = solve(&solver, design, asked);
        told = Some(motion.and_then(|motion| tell(&motion)));
    });
    let note = machine.err().map(|without| format!("{}; these are the linear ones", design.explain(&without)));
    told.unwrap_or_else(|| {
        let mut motion = solve(&Linear::new(design), design, asked)?;
        motion.notes.extend(note);
        tell(&motion)
    })
}

fn solve<'a>(solver: &dyn Solver, design: &'a Design, asked: &Asked) -> Result<Motion<'a>, Failure> {
    let Asked { speed, duration, steps, ref initial, .. } = *asked;
    let range =
        |what: &str, value: f64, required: &str| Failure::usage(format!("{what} is {value}; it must be {required}"));
    if !(duration > 0.0 && duration.is_finite()) {
        return Err(range("the duration in s", duration, "> 0"));
    }
    if !speed.is_finite() {
        return Err(range("the speed in m/s", speed, "finite"));
    }
    let speed = if design.model.depends_on_speed() { speed } else { 0.0 };
    let given = read(solver, design, initial, &[], duration).map_err(|problems| Failure::Input(nameless(problems)))?;
    let steps = steps.max(1);
    let times: Vec<f64> = (0..=steps).map(|step| duration * f64::from(step) / f64::from(steps)).collect();
    solver.run(design, &given, speed, &times, &|_| ControlFlow::Continue(()))
}

/// Without the names of options of the command line, which a page has not.
fn nameless(mut problems: Vec<Problem>) -> Vec<Problem> {
    for problem in &mut problems {
        if let carvallo_design::Place::Option(option) = &mut problem.place {
            *option = option.trim_start_matches("--initial ").to_owned();
        }
    }
    problems
}
