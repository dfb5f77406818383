//! The values that parameters may take.

use super::constants::evaluate_in;
use super::units::dimension::Dimension;
use crate::constant::Constant;
use crate::domain::{Bound, Domain};
use crate::report::{Region, Report};
use crate::syntax::{self, Relation};

/// A domain with its bounds beyond double precision, so that `lam < pi/2` is decided exactly.
#[derive(Clone, Debug, Default)]
pub struct ExactDomain {
    lower: Option<(Constant, f64, bool)>,
    upper: Option<(Constant, f64, bool)>,
    nonzero: bool,
}

/// Reads the domain that the bounds of a quantity of dimension `own` make.
pub fn read_domain(bounds: &[syntax::Bound], own: Option<Dimension>, report: &mut Report) -> ExactDomain {
    let mut domain = ExactDomain::default();
    for bound in bounds {
        let constant = match evaluate_in(&bound.value, own) {
            Ok(constant) => constant,
            Err(error) => {
                report.push(error);
                continue;
            }
        };
        let value = match constant.to_f64() {
            Ok(value) => value,
            Err(message) => {
                report.error(bound.value.region(), message);
                continue;
            }
        };
        let (side, end, included) = match bound.relation {
            Relation::NotEqual => {
                if value != 0.0 {
                    report.error(
                        bound.region,
                        format!("found `!= {value}`: expected `!= 0`, the one value to leave out"),
                    );
                }
                domain.nonzero = true;
                continue;
            }
            Relation::Greater => (&mut domain.lower, "lower", false),
            Relation::GreaterEqual => (&mut domain.lower, "lower", true),
            Relation::Less => (&mut domain.upper, "upper", false),
            Relation::LessEqual => (&mut domain.upper, "upper", true),
        };
        if side.replace((constant, value, included)).is_some() {
            report.error(bound.region, format!("a second {end} bound: expected one"));
        }
    }
    if let (Some((low, _, low_in)), Some((high, _, high_in))) = (&domain.lower, &domain.upper)
        && !(low < high || low == high && *low_in && *high_in && !(domain.nonzero && low.is_zero()))
    {
        let region = bounds.iter().map(|bound| bound.region).reduce(Region::to);
        if let Some(region) = region {
            let other = if domain.nonzero { ", or other values than 0" } else { "" };
            report.error(region, format!("an empty domain: expected a lower bound below the upper one{other}"));
        }
        return ExactDomain::default();
    }
    domain
}

impl ExactDomain {
    /// Whether no value is left out, as where no bound could be read.
    pub fn is_everything(&self) -> bool {
        self.lower.is_none() && self.upper.is_none() && !self.nonzero
    }

    /// Whether zero is a bound of it, or the value that is left out.
    pub fn ends_at_zero(&self) -> bool {
        self.nonzero || [&self.lower, &self.upper].into_iter().flatten().any(|(bound, ..)| bound.is_zero())
    }

    /// Whether a constant lies inside.
    pub fn contains(&self, value: &Constant) -> bool {
        let above = self.lower.as_ref().is_none_or(|(low, _, included)| value > low || *included && value == low);
        let below = self.upper.as_ref().is_none_or(|(high, _, included)| value < high || *included && value == high);
        above && below && !(self.nonzero && value.is_zero())
    }

    /// In the numbers of the generated code.
    pub fn to_model(&self) -> Domain {
        let bound = |side: &Option<(Constant, f64, bool)>| match side {
            None => Bound::Unbounded,
            Some((_, value, true)) => Bound::Closed(*value),
            Some((_, value, false)) => Bound::Open(*value),
        };
        Domain { lower: bound(&self.lower), upper: bound(&self.upper), nonzero: self.nonzero }
    }
}
