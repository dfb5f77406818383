//! The times at which a motion is told.

use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Mistake, Reason, Steps, no_names};
use carvallo_design::{Place, Problem};

/// More rows than these are taken for a slip in the step.
const MOST_ROWS: f64 = 1_000_000.0;

/// Longer motions, in s, are taken for a slip where each second is integrated in some hundred steps.
const LONGEST: f64 = 1e6;

const TIME: Context = Context { unit: "s", names: &no_names };

/// From zero to the duration in equal steps, the last of which may be shorter.
///
/// # Errors
/// What is wrong with them.
pub fn times(duration: &str, step: Option<&str>, default_rows: u32) -> Result<Vec<f64>, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut read = |option: &str, text: &str, what: &str| {
        number(text, what).map_err(|message| problems.push(problem(option, text, message))).ok()
    };
    let length = read("--duration", duration, "the duration");
    let given = step.map(|step| (step, read("--step", step, "the step")));
    let of_range = match length {
        Some(length) if length < 0.0 => Some(">= 0"),
        // Beyond that steps of it cannot be counted.
        Some(length) if length > 1e300 => Some("at most 1e300 s"),
        _ => None,
    };
    if let (Some(length), Some(range)) = (length, of_range) {
        let message = format!("the duration is {} s; it must be {range}", shortest(length));
        problems.push(problem("--duration", duration, message));
    }
    if let Some((text, Some(step))) = given {
        let message = match length {
            _ if step <= 0.0 => Some(format!("the step is {} s; it must be > 0", shortest(step))),
            Some(length) if length > 0.0 && step > length => {
                let [step, length] = [step, length].map(shortest);
                Some(format!("the step is {step} s, longer than the duration of {length} s"))
            }
            Some(length) if length / step > MOST_ROWS => Some(format!("there are more than {MOST_ROWS} rows")),
            _ => None,
        };
        problems.extend(message.map(|message| problem("--step", text, message)));
    }
    let (Some(length), true) = (length, problems.is_empty()) else { return Err(problems) };
    if length == 0.0 {
        return Ok(vec![0.0]);
    }
    let Some((text, Some(step))) = given else {
        let share = |row: u32| length * f64::from(row) / f64::from(default_rows);
        return Ok((0..=default_rows).map(share).collect());
    };
    // The end belongs to the times also if the division falls just short of it.
    let steps = (length / step + 1e-9).floor() as u32;
    let written = Steps::new("0", text).or_else(|| Steps::new("0 s", text));
    let mut times: Vec<f64> = (0..=steps)
        .map(|index| {
            let text = written.as_ref().and_then(|steps| steps.text(index));
            let time = text.and_then(|text| quantity::number(&text, TIME).ok());
            time.unwrap_or(f64::from(index) * step).min(length)
        })
        .collect();
    if length - times[steps as usize] > 1e-9 * step {
        times.push(length);
    } else {
        times[steps as usize] = length;
    }
    Ok(times)
}

/// That equations which are integrated are not asked for more than they can be.
///
/// # Errors
/// A duration that is too long.
pub fn integrable(duration: &str, end: f64) -> Result<(), Problem> {
    if end <= LONGEST {
        return Ok(());
    }
    let message = format!(
        "the duration is {} s; by nonlinear equations, of which each second takes some hundred steps, it must be at most {LONGEST} \
         s; linear equations have none (--linear)",
        shortest(end)
    );
    Err(problem("--duration", duration, message))
}

fn number(text: &str, what: &str) -> Result<f64, String> {
    let text = text.trim();
    quantity::number(text, TIME).map_err(|Mistake { reason, .. }| match reason {
        Reason::Unit(unit) => {
            format!("{what} is `{text}`; `{unit}` is no unit for it: times are in s, or for example in min")
        }
        Reason::Other(reason) => format!("{what} is `{text}`; it must be a finite number: {reason}"),
    })
}

fn problem(option: &str, text: &str, message: String) -> Problem {
    Problem { place: Place::Option(format!("{option} {text}")), message }
}

#[cfg(test)]
mod tests {
    use super::{integrable, times};

    #[test]
    fn what_would_be_integrated_for_days_is_refused() {
        assert_eq!(integrable("10 h", 36_000.0), Ok(()));
        let message = "--duration 1e9: the duration is 1000000000 s; by nonlinear equations, of which each second takes some \
                       hundred steps, it must be at most 1000000 s; linear equations have none (--linear)";
        assert_eq!(integrable("1e9", 1e9).map_err(|problem| problem.to_string()), Err(message.to_owned()));
    }

    #[test]
    fn the_end_belongs_to_the_times() {
        assert_eq!(times("1", Some("0.3"), 20), Ok(vec![0.0, 0.3, 0.6, 0.9, 1.0]));
        assert_eq!(times("0.3", Some("0.1"), 20), Ok(vec![0.0, 0.1, 0.2, 0.3]));
        assert_eq!(times("1 min", Some("30 s"), 20), Ok(vec![0.0, 30.0, 60.0]));
        assert_eq!(times("10", None, 4), Ok(vec![0.0, 2.5, 5.0, 7.5, 10.0]));
        assert_eq!(times("0", Some("0.1"), 20), Ok(vec![0.0]));
        assert_eq!(times("10", Some("0.001"), 20).map(|times| (times.len(), times[2357])), Ok((10_001, 2.357)));
    }

    #[test]
    fn all_mistakes_are_told() {
        let messages = |duration: &str, step: &str| -> Vec<String> {
            times(duration, Some(step), 20).unwrap_err().into_iter().map(|problem| problem.message).collect()
        };
        assert_eq!(messages("-1", "0"), ["the duration is -1 s; it must be >= 0", "the step is 0 s; it must be > 0"]);
        assert_eq!(messages("1", "2"), ["the step is 2 s, longer than the duration of 1 s"]);
        assert_eq!(messages("1e308", "1e307"), ["the duration is 1e308 s; it must be at most 1e300 s"]);
        assert_eq!(messages("1", "1e-9"), ["there are more than 1000000 rows"]);
        assert_eq!(
            messages("5 m", "nan"),
            [
                "the duration is `5 m`; `m` is no unit for it: times are in s, or for example in min",
                "the step is `nan`; it must be a finite number: `nan` is not known"
            ]
        );
    }
}
