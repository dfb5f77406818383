//! The speeds of an analysis: `4`, `3,4.5,6` or `0:10:0.1`.

use crate::number::shortest;

/// More than this many points is taken for a slip in the step.
const MAX_POINTS: f64 = 100_000.0;

/// The speeds that `text` stands for, in m/s.
///
/// # Errors
/// What is wrong, if anything.
pub fn parse(text: &str) -> Result<Vec<f64>, String> {
    match text.split(':').collect::<Vec<_>>()[..] {
        [list] => list.split(',').map(|speed| number(speed, "a speed")).collect(),
        [low, high, step] => range(low, high, step),
        _ => Err("expected a speed, a list such as 3,4.5,6 or a range LOW:HIGH:STEP such as 0:10:0.1".to_owned()),
    }
}

fn range(low: &str, high: &str, step: &str) -> Result<Vec<f64>, String> {
    let decimals = decimals(low).zip(decimals(step)).map(|(low, step)| low.max(step));
    let (low, high) = (number(low, "a speed")?, number(high, "a speed")?);
    if low > high {
        let (low, high) = (shortest(low), shortest(high));
        return Err(format!("the range ends at {high}, before it begins at {low}; it must ascend"));
    }
    let step = match step.trim().parse::<f64>() {
        Ok(step) if step.is_finite() && step > 0.0 => step,
        _ => return Err(format!("the step is `{}`; it must be a finite number > 0", step.trim())),
    };
    // The end belongs to the range also if the division falls just short of it.
    let steps = ((high - low) / step + 1e-9).floor();
    if steps >= MAX_POINTS {
        return Err(format!("the range has more than {MAX_POINTS} points"));
    }
    let at = |index: u32| {
        let speed = low + f64::from(index) * step;
        // Back to the decimals that were written: 0.3 rather than 0.30000000000000004.
        decimals.and_then(|decimals| format!("{speed:.decimals$}").parse().ok()).unwrap_or(speed)
    };
    Ok((0..=steps as u32).map(at).collect())
}

fn number(text: &str, what: &str) -> Result<f64, String> {
    let text = text.trim();
    let mantissa = text.split(['e', 'E']).next().unwrap_or_default();
    match text.parse::<f64>() {
        _ if text.is_empty() => Err(format!("{what} is empty; it must be a finite number")),
        Ok(0.0) if mantissa.contains(|c: char| ('1'..='9').contains(&c)) => {
            Err(format!("{what} is `{text}`, too small to tell from zero"))
        }
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value.abs()),
        Ok(value) if value.is_finite() => Err(format!("{what} is {}; it must be >= 0", shortest(value))),
        _ => Err(format!("{what} is `{text}`; it must be a finite number")),
    }
}

/// The number of decimals, where the text is a plain decimal number.
fn decimals(text: &str) -> Option<usize> {
    let (_, decimals) = text.trim().split_once('.').unwrap_or((text, ""));
    (decimals.len() <= 15 && !text.contains(['e', 'E'])).then_some(decimals.len())
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
            ("0:10", "expected a speed, a list such as 3,4.5,6 or a range LOW:HIGH:STEP such as 0:10:0.1"),
        ] {
            assert_eq!(parse(text), Err(message.to_owned()), "{text}");
        }
    }
}
