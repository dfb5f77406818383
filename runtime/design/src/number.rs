//! Numbers and units for people to read and for programs to read back.

/// The fewest digits that read back to the same double, with an exponent only where there would be many zeros.
pub fn shortest(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

/// So many decimals, or an exponent where they would be too long or leave less than two digits.
pub fn fixed(value: f64, decimals: usize) -> String {
    // Adding zero turns -0 into 0.
    let value = value + 0.0;
    let least = 10_f64.powi(1 - decimals as i32);
    if value == 0.0 || (least..1e7).contains(&value.abs()) {
        format!("{value:.decimals$}")
    } else {
        format!("{value:.*e}", decimals.max(2) - 1)
    }
}

/// A unit for people: `kg m²` for `kg*m^2`, and nothing for pure numbers.
pub fn unit(declared: &str) -> String {
    match declared {
        "1" => String::new(),
        declared => declared.replace('*', " ").replace("^2", "²").replace("^3", "³"),
    }
}

/// `value` followed by its unit, where it has one.
pub fn with_unit(value: f64, declared: &str) -> String {
    match unit(declared) {
        unit if unit.is_empty() => shortest(value),
        unit => format!("{} {unit}", shortest(value)),
    }
}

/// The unit of a rate of what is in a unit, or with `power` 2 of an acceleration.
pub fn by_time(unit: &str, power: u32) -> String {
    let unit = if unit.is_empty() { "1" } else { unit };
    if power == 1 { format!("{unit}/s") } else { format!("{unit}/s^{power}") }
}

#[cfg(test)]
mod tests {
    use super::{fixed, shortest};

    #[test]
    fn zeros_do_not_pile_up() {
        assert_eq!([1.0, 0.1, -2.5, 1e300, 1e-9].map(shortest), ["1", "0.1", "-2.5", "1e300", "1e-9"]);
    }

    #[test]
    fn exponents_stand_where_decimals_say_nothing() {
        let six = [0.0, -0.0, 1.5, -0.000_02, 2e-6, 1e300].map(|value| fixed(value, 6));
        assert_eq!(six, ["0.000000", "0.000000", "1.500000", "-0.000020", "2.00000e-6", "1.00000e300"]);
        assert_eq!([3.782_904, -1e-300].map(|value| fixed(value, 4)), ["3.7829", "-1.000e-300"]);
    }
}
