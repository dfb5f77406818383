//! The speeds of an analysis: `4`, `3,4.5,6`, `0:10:0.1` or `20 km/h:220 km/h:5 km/h`.

use crate::number::shortest;
use crate::quantity::{self, Context, Mistake, Reason, Steps, TOO_SMALL, check_commas, check_units, no_names};

/// More than this many points is taken for a slip in the step.
const MAX_POINTS: f64 = 100_000.0;

/// What a speed may be written as, other than in m/s: `20 km/h`, `20/3.6`.
pub const CONTEXT: Context = Context { unit: "m/s", names: &no_names };

/// The speeds that `text` stands for, in m/s.
///
/// # Errors
/// What is wrong, if anything.
pub fn parse(text: &str) -> Result<Vec<f64>, String> {
    match text.split(':').collect::<Vec<_>>()[..] {
        [list] => {
            let list: Vec<&str> = list.split(',').collect();
            let speeds = list.iter().map(|speed| number(speed, "a speed")).collect();
            check_commas(&list)?;
            check_units(&list, CONTEXT).and(speeds)
        }
        [low, high, step] => range(low, high, step),
        _ => Err("expected a speed, a list such as 3,4.5,6 or a range LOW:HIGH:STEP such as 0:10:0.1".to_owned()),
    }
}

fn range(low: &str, high: &str, step: &str) -> Result<Vec<f64>, String> {
    check_units(&[low, high, step], CONTEXT)?;
    let written = Steps::new(low, step);
    let (low, high) = (number(low, "a speed")?, number(high, "a speed")?);
    if low > high {
        let (low, high) = (shortest(low), shortest(high));
        return Err(format!("the range ends at {high}, before it begins at {low}; it must ascend"));
    }
    let step = match quantity::number(step, CONTEXT) {
        Ok(step) if step > 0.0 => step,
        _ => return Err(format!("the step is `{}`; it must be a finite number > 0", step.trim())),
    };
    if step > high - low && high > low {
        return Err(format!("the step is {} m/s, longer than the range", shortest(step)));
    }
    // The end belongs to the range also if the division falls just short of it.
    let steps = ((high - low) / step + 1e-9).floor();
    if steps >= MAX_POINTS {
        return Err(format!("the range has more than {MAX_POINTS} points"));
    }
    let at = |index: u32| {
        let text = written.as_ref().and_then(|steps| steps.text(index));
        let speed = text.and_then(|text| quantity::number(&text, CONTEXT).ok());
        speed.unwrap_or(low + f64::from(index) * step)
    };
    Ok((0..=steps as u32).map(at).collect())
}

/// One speed in m/s; `what` is what it is called.
///
/// # Errors
/// What is wrong with it.
pub fn number(text: &str, what: &str) -> Result<f64, String> {
    let text = text.trim();
    if text.is_empty() {
        return Err(format!("{what} is empty; it must be a finite number"));
    }
    match quantity::number(text, CONTEXT) {
        Ok(value) if value >= 0.0 => Ok(value.abs()),
        Ok(value) => Err(format!("{what} is {}; it must be >= 0", shortest(value))),
        Err(Mistake { reason: Reason::Unit(unit), .. }) => {
            Err(format!("{what} is `{text}`; `{unit}` is no unit for it: speeds are in m/s, or for example in km/h"))
        }
        Err(Mistake { reason: Reason::Other(reason), .. }) if reason.ends_with(TOO_SMALL) => {
            Err(format!("{what} is `{text}`, {TOO_SMALL}"))
        }
        // Of `nan` and other words there is nothing to add.
        Err(_) if text.trim_start_matches('-').chars().all(char::is_alphabetic) => {
            Err(format!("{what} is `{text}`; it must be a finite number"))
        }
        Err(Mistake { reason: Reason::Other(reason), .. }) => {
            Err(format!("{what} is `{text}`; it must be a finite number: {reason}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn ranges_keep_their_decimals_and_their_end() {
        assert_eq!(parse("0:0.5:0.1"), Ok(vec![0.0, 0.1, 0.2, 0.3, 0.4, 0.5]));
        assert_eq!(parse("1:2:0.3"), Ok(vec![1.0, 1.3, 1.6, 1.9]));
        assert_eq!(parse("5:5:1"), Ok(vec![5.0]));
        assert_eq!(parse("0:10:0.1").map(|speeds| (speeds.len(), speeds[100])), Ok((101, 10.0)));
        assert_eq!(parse("0:2e-3:1e-3"), Ok(vec![0.0, 0.001, 0.002]));
    }

    #[test]
    fn speeds_and_lists() {
        assert_eq!(parse("4.5"), Ok(vec![4.5]));
        assert_eq!(parse("3, 4.5,6"), Ok(vec![3.0, 4.5, 6.0]));
        assert_eq!(parse("-0").map(|speeds| speeds[0].is_sign_positive()), Ok(true));
    }

    /// 1 km/h is 1/3.6 m/s.
    #[test]
    fn speeds_are_values_like_others() {
        let kmh = |speeds: &[f64]| Ok(speeds.iter().map(|speed| speed / 3.6).collect::<Vec<f64>>());
        assert_eq!(parse("20 km/h:35 km/h:5 km/h"), kmh(&[20.0, 25.0, 30.0, 35.0]));
        assert_eq!(parse("20 km/h:220 km/h:5 km/h").map(|speeds| speeds.len()), Ok(41));
        assert_eq!(parse("0:10 km/h:5 km/h"), kmh(&[0.0, 5.0, 10.0]));
        assert_eq!(parse("18 km/h, 36 km/h, 10 m/s"), Ok(vec![5.0, 10.0, 10.0]));
        assert_eq!(parse("18/3.6:36/3.6:18/3.6"), Ok(vec![5.0, 10.0]));
        assert_eq!(parse("sqrt(9)"), Ok(vec![3.0]));
        assert_eq!(parse("10 mph"), Ok(vec![4.4704]));
    }

    #[test]
    fn mistakes_are_named() {
        for (text, message) in [
            ("0:10:0", "the step is `0`; it must be a finite number > 0"),
            ("0:10:-1", "the step is `-1`; it must be a finite number > 0"),
            ("5:1:1", "the range ends at 1, before it begins at 5; it must ascend"),
            ("10:0:-1", "the range ends at 0, before it begins at 10; it must ascend"),
            ("0:10:1e-9", "the range has more than 100000 points"),
            ("-1:2:1", "a speed is -1; it must be >= 0"),
            ("nan", "a speed is `nan`; it must be a finite number"),
            ("1,,2", "a speed is empty; it must be a finite number"),
            ("1e-400", "a speed is `1e-400`, too small to tell from zero"),
            ("0:inf:1", "a speed is `inf`; it must be a finite number"),
            ("fast", "a speed is `fast`; it must be a finite number"),
            ("5+-1", "a speed is `5+-1`; it must be a finite number: a standard deviation has no place here"),
            ("20:220:5 km/h", "`20` has no unit, but others have: write it behind each"),
            ("20, 30 km/h", "`20` has no unit, but others have: write it behind each"),
            ("5 kg", "a speed is `5 kg`; `kg` is no unit for it: speeds are in m/s, or for example in km/h"),
            ("0:10", "expected a speed, a list such as 3,4.5,6 or a range LOW:HIGH:STEP such as 0:10:0.1"),
        ] {
            assert_eq!(parse(text), Err(message.to_owned()), "{text}");
        }
    }
}
