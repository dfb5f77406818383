//! How the critical speeds of a design change with its parameters.

use carvallo::{
    Change, Complex, CriticalDerivative, CriticalKind, CriticalSpeed, ModelInfo, NotDifferentiable, SensitivityError,
    Stability, standard_deviation, variance_shares,
};
use carvallo_design::{Design, DisplayUnit, Equations, Failure, matrices};

use crate::analysis::reach::reach;
use crate::analysis::{extremes, leans_and_steers};

/// A design with the derivatives of its critical speeds.
pub struct Changes {
    /// What is analyzed.
    pub design: Design,
    /// Its critical speeds and stable ranges.
    pub stability: Stability,
    /// What 1 % is, for each parameter in the order of the model.
    pub steps: Vec<Step>,
    /// All of them, ascending.
    pub critical_speeds: Vec<Critical>,
    /// The standard deviations of the parameters, zero where there is none; `None` if there are none at all.
    pub deviations: Option<Vec<f64>>,
    /// The standard deviations of the entries of the matrices, if parameters have any.
    pub matrix_deviations: Option<Box<dyn Equations>>,
    /// What tables and pictures show speeds and parameters in, by the units that they are declared in.
    pub shown: Box<dyn Fn(&str) -> DisplayUnit>,
}

/// The change of a parameter whose effect is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// 1 % of its value, with its sign.
    OfValue(f64),
    /// The parameter is zero: 1 % of the median size of the others in the same unit, or of a radian.
    OfScale(f64),
    /// The parameter is zero, and so are the others in the same unit.
    Unknown,
}

/// A critical speed with its derivatives.
pub struct Critical {
    /// The critical speed.
    pub speed: CriticalSpeed,
    /// Its derivatives, or why it has none.
    pub derivatives: Result<Derivatives, NotDifferentiable>,
}

/// The derivatives of a critical speed with respect to each parameter, in m/s per unit, and of its eigenvalue.
pub struct Derivatives {
    /// Of the speed, in m/s per unit of the parameter.
    pub speed: Vec<f64>,
    /// Of the eigenvalue, in 1/s per unit of the parameter.
    pub eigenvalue: Vec<Complex<f64>>,
    /// How far rounding of the matrices may move the speed, as [`CriticalDerivative`] has it.
    pub condition: f64,
    /// In m/s, if parameters have standard deviations.
    pub deviation: Option<f64>,
    /// The share of the variance that comes from each parameter, if parameters have standard deviations.
    pub variance_shares: Option<Vec<f64>>,
}

impl Step {
    /// The change in the unit of the parameter.
    pub fn size(self) -> Option<f64> {
        match self {
            Self::OfValue(step) | Self::OfScale(step) => Some(step),
            Self::Unknown => None,
        }
    }
}

impl Changes {
    /// The derivatives of all critical speeds of a design.
    ///
    /// # Errors
    /// If the equations of motion have no answer, or the model was compiled without derivatives.
    pub fn new(design: Design) -> Result<Self, Failure> {
        let run = |error: String| Failure::Run(format!("{}: {error}{}", design.title(), extremes(&design)));
        let fail = |error: SensitivityError| run(error.to_string());
        let stability = design.equations.stability(design.gravity().unwrap_or(0.0));
        let stability = stability.map_err(|error| fail(error.into()))?;
        let sensitivity = design.model.sensitivity(&design.values()).map_err(run)?;
        let deviations: Vec<f64> = design
            .parameters
            .iter()
            .map(|given| given.deviation.as_ref().map_or(0.0, |deviation| deviation.value))
            .collect();
        let deviations = deviations.iter().any(|&deviation| deviation > 0.0).then_some(deviations);
        let critical = |&speed: &CriticalSpeed| {
            let derivatives = match sensitivity.critical_speed(&speed)? {
                CriticalDerivative::None(reason) => Err(reason),
                CriticalDerivative::Smooth { speed, eigenvalue, condition } => {
                    let (deviation, variance_shares) = match (&design.covariance, &deviations) {
                        (Some(known), _) => {
                            (Some(known.standard_deviation(&speed)?), Some(known.variance_shares(&speed)?))
                        }
                        (None, Some(known)) => {
                            (Some(standard_deviation(&speed, known)?), Some(variance_shares(&speed, known)?))
                        }
                        (None, None) => (None, None),
                    };
                    Ok(Derivatives { deviation, variance_shares, speed, eigenvalue, condition })
                }
            };
            Ok(Critical { speed, derivatives })
        };
        let critical_speeds = stability.critical_speeds.iter().map(critical).collect::<Result<_, _>>().map_err(fail)?;
        let of_matrices = match &design.covariance {
            Some(covariance) => Some(sensitivity.correlated_matrix_deviations(covariance)),
            None => deviations.as_ref().map(|deviations| sensitivity.matrix_deviations(deviations)),
        };
        let matrix_deviations = of_matrices.transpose().map_err(fail)?;
        let steps = steps(design.info(), &design.values());
        Ok(Self {
            steps,
            critical_speeds,
            deviations,
            matrix_deviations,
            stability,
            design,
            shown: Box::new(DisplayUnit::declared),
        })
    }

    /// The critical speeds that have derivatives and decide about stability, weave first, and these.
    pub fn ranked(&self) -> Vec<(&CriticalSpeed, &Derivatives)> {
        let of = |kind: CriticalKind| {
            let of_kind = self.critical_speeds.iter().filter(move |critical| critical.speed.kind == kind);
            let deciding = of_kind.filter(|critical| decides(&critical.speed));
            deciding.filter_map(|critical| Some((&critical.speed, critical.derivatives.as_ref().ok()?)))
        };
        of(CriticalKind::Weave).chain(of(CriticalKind::Capsize)).chain(of(CriticalKind::DoubleRoot)).collect()
    }

    /// The ranked ones as far as graphs against the speed go, or all, if these show none. What is beyond decides nothing, and may
    /// depend on everything.
    pub fn within_reach(&self) -> Vec<(&CriticalSpeed, &Derivatives)> {
        let reach = reach(&self.stability, leans_and_steers(self.design.info()));
        let ranked = self.ranked();
        let within: Vec<_> = ranked.iter().copied().filter(|(critical, _)| critical.speed <= reach).collect();
        if within.is_empty() { ranked } else { within }
    }

    /// What speeds are shown in.
    pub fn of_speeds(&self) -> DisplayUnit {
        (self.shown)("m/s")
    }

    /// What a parameter is shown in.
    pub fn of_parameter(&self, parameter: usize) -> DisplayUnit {
        (self.shown)(self.design.info().parameters[parameter].unit)
    }

    /// Whether the parameters are the entries of given matrices.
    pub fn are_entries(&self) -> bool {
        matrices::is_called(self.design.info().name)
    }

    /// The effect of 1 % of a parameter on a critical speed, in m/s; none if it leaves the range of doubles.
    pub fn effect(&self, derivatives: &Derivatives, parameter: usize) -> Option<f64> {
        let effect = derivatives.speed[parameter] * self.steps[parameter].size()?;
        effect.is_finite().then_some(effect)
    }

    /// The parameters that have an effect on the ranked speeds, the largest effect on one within reach first; those whose 1 % is
    /// not known come last. Of given matrices those entries are left out, of which there are many, each as good as a zero of structure.
    pub fn order(&self) -> Vec<usize> {
        let ranked = self.ranked();
        let within_reach = self.within_reach();
        let largest = |parameter: usize| {
            let effects = within_reach.iter().filter_map(|(_, derivatives)| self.effect(derivatives, parameter));
            effects.map(f64::abs).fold(-1.0, f64::max)
        };
        let has_effect = |&parameter: &usize| ranked.iter().any(|(_, derivatives)| derivatives.speed[parameter] != 0.0);
        let is_told = |&parameter: &usize| self.steps[parameter] != Step::Unknown || !self.are_entries();
        let mut order: Vec<usize> = (0..self.steps.len()).filter(is_told).filter(has_effect).collect();
        order.sort_by(|&a, &b| largest(b).total_cmp(&largest(a)));
        order
    }
}

/// Whether eigenvalues become stable or unstable at a critical speed: not at every double root.
pub fn decides(critical: &CriticalSpeed) -> bool {
    critical.kind != CriticalKind::DoubleRoot || matches!(critical.change, Change::Stabilizes | Change::Destabilizes)
}

/// What 1 % of each parameter is. Entries of given matrices have no units to find others by.
fn steps(info: &ModelInfo, values: &[f64]) -> Vec<Step> {
    let step = |(index, &value): (usize, &f64)| match (value, scale(info, index, values)) {
        (0.0, Some(scale)) => Step::OfScale(scale / 100.0),
        (0.0, None) => Step::Unknown,
        (value, _) => Step::OfValue(value / 100.0),
    };
    values.iter().enumerate().map(step).collect()
}

/// What a parameter may be measured by: the median size of those in its unit that are not zero; of angles a radian.
fn scale(info: &ModelInfo, parameter: usize, values: &[f64]) -> Option<f64> {
    let unit = info.parameters[parameter].unit;
    if matrices::is_called(info.name) {
        return None;
    }
    if unit == "rad" {
        return Some(1.0);
    }
    let of_unit = info.parameters.iter().zip(values).filter(|(info, value)| info.unit == unit && **value != 0.0);
    let mut sizes: Vec<f64> = of_unit.map(|(_, value)| value.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied()
}
