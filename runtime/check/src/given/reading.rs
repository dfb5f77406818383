//! A number with the digits to which it was given.

/// A number as somebody gave it.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The number.
    pub value: f64,
    /// How far another number may be from it and still agree: half a unit of its last digit unless something else is said.
    pub tolerance: f64,
    /// How many significant digits it was given to; 0 where that is not known.
    pub digits: usize,
    /// As it was written.
    pub written: String,
}

/// From this many digits on a number is what a program printed, with all that it had.
const FULL: usize = 13;

impl Reading {
    /// A number with all of its digits.
    pub fn exact(value: f64) -> Self {
        Self::printed(format!("{value:.16e}"), value)
    }

    /// A number rounded to so many significant digits, at least one.
    pub fn rounded(value: f64, digits: usize) -> Self {
        let text = format!("{value:.*e}", digits.max(1) - 1);
        let rounded = text.parse().unwrap_or(value);
        Self::printed(text, rounded)
    }

    /// A number that agrees with all that are not farther from it than a tolerance.
    pub fn within(value: f64, tolerance: f64) -> Self {
        Self { value, tolerance, digits: 0, written: value.to_string() }
    }

    /// A number by its text: `2.32` agrees with all that are not farther from it than 0.005.
    pub fn printed(written: String, value: f64) -> Self {
        let (tolerance, digits) = last_digit(&written);
        Self { value, tolerance: tolerance / 2.0, digits, written }
    }

    /// The same where digits were cut off and nothing was rounded: `-0.322` agrees with all from -0.322 to -0.323. `None` for
    /// what says its tolerance itself, and for a single digit, which many numbers begin with.
    pub fn cut_off(&self) -> Option<Self> {
        let is_printed = self.digits > 1 && self.value != 0.0 && self.tolerance > 0.0;
        let value = self.value + self.tolerance.copysign(self.value);
        is_printed.then(|| Self { value, ..self.clone() })
    }

    /// A number with the decimals of this one, rounded.
    pub fn rounding(&self, value: f64) -> String {
        let decimals = (-(2.0 * self.tolerance).log10()).round().clamp(0.0, 17.0) as usize;
        format!("{value:.decimals$}")
    }

    /// Trusts no more than so many significant digits.
    pub fn limit(&mut self, digits: usize) {
        if self.value != 0.0 {
            let place = self.value.abs().log10().floor() as i32 + 1 - digits as i32;
            self.tolerance = self.tolerance.max(0.5 * 10f64.powi(place));
            self.digits = self.digits.min(digits);
        }
    }
}

/// A unit of the last digit of a text, and how many significant digits it has; 0 for what is no plain number.
fn last_digit(text: &str) -> (f64, usize) {
    let text = text.trim().replace('−', "-").to_lowercase();
    let unsigned = text.trim_start_matches(['+', '-']);
    let (mantissa, power) = unsigned.split_once(['e', 'd']).unwrap_or((unsigned, "0"));
    let is_plain = mantissa.chars().all(|c| c.is_ascii_digit() || c == '.') && !mantissa.is_empty();
    let Some(power) = power.parse::<i32>().ok().filter(|_| is_plain) else { return (0.0, 0) };
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len()) as i32;
    let digits = mantissa.replace('.', "").trim_start_matches('0').len();
    // 10^-2 as 1e-2 is nearer to it than the inverse of 100 may be.
    (format!("1e{}", power.saturating_sub(decimals)).parse().unwrap_or(0.0), digits)
}

/// Numbers that were printed together lend each other digits: a zero has the decimals of the finest beside it, and where one
/// has all digits of a double, the others do, with zeros at the end left out.
pub fn level<'a>(readings: impl IntoIterator<Item = &'a mut Reading>) {
    let mut readings: Vec<&mut Reading> = readings.into_iter().collect();
    let printed = || readings.iter().filter(|reading| reading.digits > 0 && reading.value != 0.0);
    let finest = printed().map(|reading| reading.tolerance).fold(f64::INFINITY, f64::min);
    let is_full = printed().any(|reading| reading.digits >= FULL);
    for reading in &mut readings {
        let is_printed = reading.tolerance > 0.0 && (reading.digits > 0 || reading.value == 0.0);
        if is_printed && (is_full || reading.value == 0.0) {
            reading.tolerance = reading.tolerance.min(finest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Reading, level};

    fn of(text: &str) -> Reading {
        Reading::printed(text.to_owned(), text.parse().unwrap_or(f64::NAN))
    }

    #[test]
    fn digits_are_those_that_were_written() {
        let all = ["2.32", "2.320", "-81", "1.5e-3", "0.00708", "0", "0.00", "pi/10"].map(of);
        let tolerances = [0.005, 0.0005, 0.5, 0.00005, 0.000_005, 0.5, 0.005, 0.0];
        assert_eq!(all.each_ref().map(|reading| reading.tolerance), tolerances);
        assert_eq!(all.map(|reading| reading.digits), [3, 4, 2, 2, 3, 0, 0, 0]);
    }

    #[test]
    fn rounding_keeps_so_many_digits() {
        let reading = Reading::rounded(76.597_345_895_732_2, 4);
        assert_eq!((reading.value, reading.tolerance, reading.digits), (76.6, 0.005, 4));
    }

    #[test]
    fn zeros_have_the_decimals_beside_them() {
        let mut matrix = ["0", "76.597", "0.0", "2.7"].map(of);
        level(&mut matrix);
        assert_eq!(matrix.map(|reading| reading.tolerance), [0.0005, 0.0005, 0.0005, 0.05]);
    }

    #[test]
    fn beside_all_digits_zeros_at_the_end_are_left_out() {
        let mut matrix = ["-80.95", "-2.59951685249872"].map(of);
        level(&mut matrix);
        assert_eq!(matrix.map(|reading| reading.tolerance), [5e-15, 5e-15]);
    }
}
