//! The limits of a picture: `LOW:HIGH`.

use std::str::FromStr;

use carvallo_design::Problem;
use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Reason, check_units, no_names};
use carvallo_design::speeds::{self, CONTEXT as SPEED};

use crate::options::problem;

const EIGENVALUE: Context = Context { unit: "1/s", names: &no_names };

/// The speeds that a picture shows, in m/s, the second above the first.
#[derive(Clone, Copy, Debug)]
pub struct SpeedLimits(pub f64, pub f64);

/// The eigenvalues that a picture shows, in 1/s, the second above the first.
#[derive(Clone, Copy, Debug)]
pub struct EigenvalueLimits(pub f64, pub f64);

impl FromStr for SpeedLimits {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        let (low, high) = limits(text, "0:10", SPEED, |text| speeds::number(text, "a speed")).map_err(problem)?;
        Ok(Self(low, high))
    }
}

impl FromStr for EigenvalueLimits {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        let (low, high) = limits(text, "-10:10", EIGENVALUE, eigenvalue).map_err(problem)?;
        Ok(Self(low, high))
    }
}

fn limits(
    text: &str,
    example: &str,
    context: Context,
    number: fn(&str) -> Result<f64, String>,
) -> Result<(f64, f64), String> {
    let [low, high] = text.split(':').collect::<Vec<_>>()[..] else {
        return Err(format!("expected two limits LOW:HIGH, such as {example}"));
    };
    check_units(&[low, high], context)?;
    let (low, high) = (number(low)?, number(high)?);
    let is_wide = high - low > 4.0 * f64::EPSILON * high.abs().max(low.abs()) && (high - low).is_finite();
    if !is_wide {
        let (low, high) = (shortest(low), shortest(high));
        return Err(format!("the limits are {low} and {high}; the second must be above the first"));
    }
    Ok((low, high))
}

fn eigenvalue(text: &str) -> Result<f64, String> {
    quantity::number(text, EIGENVALUE).map_err(|mistake| match mistake.reason {
        Reason::Unit(unit) => {
            format!("a limit is `{}`; `{unit}` is no unit for it: eigenvalues are in 1/s", text.trim())
        }
        Reason::Other(reason) => format!("a limit is `{}`; it must be a finite number: {reason}", text.trim()),
    })
}
