//! The straight path between the parameters of two designs, and the critical speeds on it with their derivatives along it.

use carvallo::{CriticalDerivative, CriticalSpeed};
use carvallo_design::{Design, Shipped};

use super::{is_rounding, largest};
use crate::analysis::sensitivity::decides;

/// From the parameters of one design, at 0, to those of another one, at 1.
pub struct Path {
    model: &'static Shipped,
    from: Vec<f64>,
    to: Vec<f64>,
    /// The parameters that differ, by their positions in the model, ascending.
    pub parameters: Vec<usize>,
}

/// The critical speeds at a place on the path at which stability changes.
#[derive(Clone, Debug)]
pub struct Point {
    /// From 0 to 1.
    pub place: f64,
    /// Ascending.
    pub critical: Vec<Critical>,
}

/// A critical speed at a place on the path.
#[derive(Clone, Debug)]
pub struct Critical {
    pub critical: CriticalSpeed,
    /// `None` where it has no derivatives.
    pub slopes: Option<Slopes>,
}

/// Derivatives along the path, per unit of the path.
#[derive(Clone, Debug)]
pub struct Slopes {
    /// Of the speed, what each parameter that differs makes of it, in m/s.
    pub terms: Vec<f64>,
    /// Their sum.
    pub speed: f64,
    /// Of the imaginary part of the eigenvalue, in 1/s.
    pub frequency: f64,
}

impl Path {
    /// # Errors
    /// If the designs are of different models, or with different feedback.
    pub fn new(from: &Design, to: &Design) -> Result<Self, String> {
        let names =
            |design: &Design| design.info().parameters.iter().map(|parameter| parameter.name).collect::<Vec<_>>();
        if from.info().name != to.info().name || names(from) != names(to) {
            let [first, other] = [from, to].map(|design| design.info().name);
            let models = if first == other {
                format!("the machines of the model {first} have other matrices or coordinates")
            } else {
                format!("the models are {first} and {other}")
            };
            return Err(format!("{models}, so that no parameters lead from one to the other"));
        }
        let laws = |design: &Design| design.feedback.iter().map(|law| law.written.clone()).collect::<Vec<_>>();
        if laws(from) != laws(to) {
            return Err("the laws of feedback are others, and no parameters lead from one to the other".to_owned());
        }
        let designs = [from, to];
        let (model, from, to) = (from.model, from.values(), to.values());
        let differs = |index: &usize| {
            let unit = model.info.parameters[*index].unit;
            from[*index] != to[*index] && !is_rounding(from[*index], to[*index], largest(designs, unit))
        };
        let parameters = (0..from.len()).filter(differs).collect();
        Ok(Self { model, from, to, parameters })
    }

    /// What there is at a place.
    ///
    /// # Errors
    /// If there the parameters are not possible, or the equations of motion have no answer.
    pub fn at(&self, place: f64) -> Result<Point, String> {
        let values = self.values(place);
        let gravity = self.model.info.gravity.map_or(0.0, |position| values[position]);
        let fail = |error: String| format!("at {:.4} % of the way from one to the other: {error}", 100.0 * place);
        let found = || -> Result<Vec<Critical>, String> {
            let stability = self.model.equations(&values)?.stability(gravity).map_err(|error| error.to_string())?;
            let sensitivity = self.model.sensitivity(&values)?;
            let critical = |&critical: &CriticalSpeed| {
                let derivative = sensitivity.critical_speed(&critical).map_err(|error| error.to_string())?;
                Ok(Critical { critical, slopes: self.slopes(derivative) })
            };
            stability.critical_speeds.iter().filter(|critical| decides(critical)).map(critical).collect()
        };
        Ok(Point { place, critical: found().map_err(fail)? })
    }

    /// The parameters at a place; at the ends exactly those of the designs.
    fn values(&self, place: f64) -> Vec<f64> {
        let value = |(&from, &to): (&f64, &f64)| if place == 1.0 { to } else { from + place * (to - from) };
        self.from.iter().zip(&self.to).map(value).collect()
    }

    fn slopes(&self, derivative: CriticalDerivative) -> Option<Slopes> {
        let CriticalDerivative::Smooth { speed, eigenvalue, .. } = derivative else { return None };
        let change = |index: usize| self.to[index] - self.from[index];
        let terms: Vec<f64> = self.parameters.iter().map(|&index| change(index) * speed[index]).collect();
        let frequency = self.parameters.iter().map(|&index| change(index) * eigenvalue[index].im).sum();
        Some(Slopes { speed: terms.iter().sum(), frequency, terms })
    }
}
