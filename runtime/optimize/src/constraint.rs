//! What must be kept: an inequality between expressions in the parameters and in measures of the design.

use carvallo::ModelInfo;
use carvallo_design::conventions::Convention;
use carvallo_design::parameter::find;
use carvallo_design::quantity::{self, Context, Mistake, Reason};
use carvallo_design::{Dual, Failure, Place};

use crate::goal::Measure;
use crate::measures::Measures;

/// An inequality.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// As it was given, or what it is if it is built in.
    pub written: String,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    /// Texts of which the first must be at most the second, the unit that both are read in, and the convention of what varies.
    Texts { small: String, large: String, unit: &'static str, beside: Option<&'static Convention> },
    /// A function of the parameters, and of a part of the machine, that must be zero or less.
    Built { function: Excess, part: &'static str },
}

/// By how much something is too large, by the parameters of a model under their names, and the letter of a part of the machine.
pub type Excess = fn(&dyn Fn(&str) -> Dual, &str) -> Dual;

impl Constraint {
    /// Reads `EXPRESSION <= EXPRESSION`, or with `>=`; `<` and `>` mean the same, since the difference is one of rounding. Names
    /// are those of parameters, of the model or of a convention, and `stable_range`, `weave_speed`, `capsize_speed` and `flutter_speed`,
    /// which may have `-` in them.
    pub(crate) fn parse(
        written: &str,
        info: &ModelInfo,
        values: &[f64],
        beside: Option<&'static Convention>,
    ) -> Result<Self, Failure> {
        let fail = |message: String| Failure::at(Place::Option(format!("--keep '{written}'")), message);
        let signs = ["<=", ">=", "≤", "≥", "<", ">"].into_iter();
        let Some((sign, (left, right))) = signs.filter_map(|sign| Some((sign, written.split_once(sign)?))).next()
        else {
            return Err(fail("expected an inequality, such as xB >= 0.2 or rR + rF <= 0.8*w".to_owned()));
        };
        let [left, right] = [left, right].map(|side| Measure::with_underscores(side.trim()));
        let (left, right) = (left.as_str(), right.as_str());
        // Beside a parameter or a speed alone, numbers may have units.
        let unit = |text: &str| Measure::find(text, info, beside).map(Measure::unit);
        let unit = unit(left).or_else(|| unit(right)).unwrap_or("1");
        for side in [left, right] {
            // Any value does for a speed that the design may not have.
            let names = |name: &str| {
                let own = |at: usize| Dual::constant(values[at]);
                Some(match Measure::find(name, info, beside) {
                    Some(Measure::Parameter(quantity)) => {
                        quantity.value(info, &own).map(|it| it.value).ok_or_else(|| untold(name))
                    }
                    Some(_) => Ok(1.0),
                    None => Err(find(name, info).err()?),
                })
            };
            evaluate(side, unit, &names).map_err(|message| fail(format!("`{side}` is no value: {message}")))?;
        }
        let (small, large) = if sign.starts_with(['>', '≥']) { (right, left) } else { (left, right) };
        Ok(Self {
            written: written.to_owned(),
            kind: Kind::Texts { small: small.to_owned(), large: large.to_owned(), unit, beside },
        })
    }

    /// One that needs not be asked for.
    pub(crate) fn built(written: String, function: Excess, part: &'static str) -> Self {
        Self { written, kind: Kind::Built { function, part } }
    }

    /// By how much it is missed: zero or less where it holds; `None` where a speed that stands in it is not there, or an
    /// expression has no value.
    pub(crate) fn excess(&self, info: &ModelInfo, values: &[f64], measures: Option<&Measures>) -> Option<f64> {
        let sides = self.sides(info, &|position| values[position].into(), &|measure| take(measures, measure));
        sides.map(|(small, large)| (small - large).value)
    }

    /// The size of its sides, to tell what is little.
    pub(crate) fn scale(&self, info: &ModelInfo, values: &[f64], measures: Option<&Measures>) -> f64 {
        let sides = self.sides(info, &|position| values[position].into(), &|measure| take(measures, measure));
        let size = sides.map_or(0.0, |(small, large)| small.value.abs().max(large.value.abs()));
        if size > 0.0 && size.is_finite() { size } else { 1.0 }
    }

    /// The derivatives of the excess, exactly, by what the parameters have these derivatives by.
    pub(crate) fn gradient(
        &self,
        info: &ModelInfo,
        values: &[f64],
        measures: Option<&Measures>,
        slopes: &[Vec<f64>],
    ) -> Vec<f64> {
        let by = |slopes: &Vec<f64>| {
            let own = |position: usize| Dual { value: values[position], slope: slopes[position] };
            let speed = |measure: Measure| {
                let measured = measures?.take(measure).ok()??;
                Some(Dual { value: measured.value, slope: measured.along(slopes) })
            };
            self.sides(info, &own, &speed).map_or(0.0, |(small, large)| (small - large).slope)
        };
        slopes.iter().map(by).collect()
    }

    fn sides(
        &self,
        info: &ModelInfo,
        own: &dyn Fn(usize) -> Dual,
        speed: &dyn Fn(Measure) -> Option<Dual>,
    ) -> Option<(Dual, Dual)> {
        match &self.kind {
            Kind::Built { function, part } => {
                // Constraints are there only for models that have the parameters.
                let value = |name: &str| info.position(name).map_or(Dual::default(), own);
                Some((function(&value, part), Dual::default()))
            }
            Kind::Texts { small, large, unit, beside } => {
                let names = |name: &str| {
                    Some(match Measure::find(name, info, *beside)? {
                        Measure::Parameter(quantity) => quantity.value(info, own).ok_or_else(|| untold(name)),
                        measure => speed(measure).ok_or_else(|| format!("there is no {name}")),
                    })
                };
                let side = |text: &str| quantity::differentiated(text, unit, &names).ok();
                Some((side(small)?, side(large)?))
            }
        }
    }
}

/// Of a name of which the parameters of the model tell no value.
fn untold(name: &str) -> String {
    format!("`{name}` does not follow from the parameters of the model")
}

fn take(measures: Option<&Measures>, measure: Measure) -> Option<Dual> {
    measures?.value(measure).map(Dual::constant)
}

fn evaluate(text: &str, unit: &str, names: &quantity::Lookup) -> Result<f64, String> {
    quantity::number(text, Context { unit, names }).map_err(|Mistake { reason, .. }| match reason {
        Reason::Unit(unit) => format!("`{unit}` is no unit for it"),
        Reason::Other(reason) => reason,
    })
}
