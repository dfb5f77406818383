//! Axes that are not divided at round numbers.

use super::axes::Scale;

/// Ticks between powers of ten stand where there are no more decades than this.
const DETAILED: f64 = 6.0;
/// The most steps of an axis in turns.
const MOST_TURNS: f64 = 9.0;

/// The ticks in a range, each with what stands at it, if anything does.
pub fn ticks(scale: Scale, range: (f64, f64)) -> Vec<(f64, String)> {
    match scale {
        Scale::Turns => turns(range),
        Scale::Even | Scale::Decades => decades(range),
    }
}

/// Of logarithms: labels at powers of ten.
fn decades((low, high): (f64, f64)) -> Vec<(f64, String)> {
    let is_inside = |(tick, _): &(f64, String)| (low - 1e-9..=high + 1e-9).contains(tick);
    let each = ((high - low) / 12.0).ceil().max(1.0) as i32;
    let powers = (low - 1e-9).floor() as i32..=high.ceil() as i32;
    let text = |power: i32| if power % each == 0 { label(power) } else { String::new() };
    let whole = powers.clone().map(|power| (f64::from(power), text(power)));
    let between = powers
        .filter(|_| high - low <= DETAILED)
        .flat_map(|power| (2..10).map(move |digit| (f64::from(power) + f64::from(digit).log10(), String::new())));
    whole.chain(between).filter(is_inside).collect()
}

/// A power of ten.
fn label(power: i32) -> String {
    match power {
        -4..0 => format!("{:.*}", power.unsigned_abs() as usize, 10_f64.powi(power)),
        0..5 => format!("{:.0}", 10_f64.powi(power)),
        _ => format!("1e{power}").replace('-', "−"),
    }
}

/// Of degrees: at parts or multiples of a right angle.
fn turns((low, high): (f64, f64)) -> Vec<(f64, String)> {
    let steps = [1.0, 5.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0, 720.0];
    let step = steps.into_iter().find(|step| (high - low) / step <= MOST_TURNS).unwrap_or(1440.0);
    let (first, last) = ((low / step - 1e-9).ceil() as i32, (high / step + 1e-9).floor() as i32);
    let ticks = (first..=last).map(|place| f64::from(place) * step);
    ticks.map(|tick| (tick, format!("{tick:.0}").replace('-', "−"))).collect()
}

#[cfg(test)]
mod tests {
    use super::{Scale, ticks};

    #[test]
    fn decades_have_labels_and_what_is_between_has_none() {
        let found = ticks(Scale::Decades, (-2.0, 1.0));
        let labels: Vec<&str> = found.iter().map(|(_, text)| text.as_str()).filter(|text| !text.is_empty()).collect();
        assert_eq!((labels, found.len()), (vec!["0.01", "0.1", "1", "10"], 4 + 3 * 8));
        assert!(found.iter().any(|(tick, _)| (tick - 5_f64.log10()).abs() < 1e-12));
    }

    #[test]
    fn turns_are_parts_of_right_angles() {
        let labels = |range| ticks(Scale::Turns, range).into_iter().map(|(_, text)| text).collect::<Vec<_>>();
        assert_eq!(labels((-190.0, 10.0)), ["−180", "−150", "−120", "−90", "−60", "−30", "0"]);
        assert_eq!(labels((-400.0, 10.0)).len(), 5);
    }
}
