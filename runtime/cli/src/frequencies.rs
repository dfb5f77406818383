//! The frequencies of a response: `0.1:100`, `1,2,5` or `0.1 Hz:10 Hz`.

use std::f64::consts::TAU;
use std::str::FromStr;

use carvallo_design::Problem;
use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Reason, no_names};
use carvallo_plot::analysis::transfer::Frequencies;

use crate::options::problem;

const CONTEXT: Context = Context { unit: "rad/s", names: &no_names };
const PURE: Context = Context { unit: "1", names: &no_names };

/// Frequencies above zero.
#[derive(Clone, Debug)]
pub struct Given(pub Frequencies);

impl FromStr for Given {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        // `0.1 Hz:10` could be up to 10 Hz or 10 rad/s.
        let is_bare = |part: &&str| quantity::number(part, PURE).is_ok();
        if let Some(bare) = text.split([':', ',']).map(str::trim).find(is_bare)
            && text.contains("Hz")
        {
            return Err(problem(format!("`{bare}` has no unit, but others are in Hz: write Hz or rad/s behind each")));
        }
        match text.split(':').collect::<Vec<_>>()[..] {
            [list] => list.split(',').map(number).collect::<Result<_, _>>().map(Frequencies::List).map(Self),
            [low, high] => {
                let (low, high) = (number(low)?, number(high)?);
                if low < high {
                    return Ok(Self(Frequencies::Range([low, high])));
                }
                let (low, high) = (shortest(low), shortest(high));
                Err(problem(format!("the range goes from {low} to {high} rad/s; it must ascend")))
            }
            _ => Err(problem("expected a list such as 1,2,5 or a range LOW:HIGH such as 0.1:100")),
        }
    }
}

/// In rad/s.
fn number(text: &str) -> Result<f64, Problem> {
    let text = text.trim();
    let (inner, unit) = match text.strip_suffix("Hz") {
        Some(cycles) => (cycles, TAU),
        None => (text, 1.0),
    };
    match quantity::number(inner, CONTEXT) {
        Ok(value) if value > 0.0 => Ok(unit * value),
        Ok(value) => Err(problem(format!("a frequency is {}; it must be > 0", shortest(value)))),
        Err(mistake) => Err(problem(match mistake.reason {
            Reason::Unit(unit) => format!("`{unit}` is no unit for a frequency: it is in rad/s, or in Hz"),
            Reason::Other(reason) => format!("a frequency is `{text}`; it must be a finite number: {reason}"),
        })),
    }
}
