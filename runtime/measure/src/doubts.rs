//! Periods that no pendulum of a bicycle has, as where times are in other units than it is said, and wheels that are too small.

use carvallo_design::number::shortest;

use crate::names::known;

/// In s: parts of a bicycle swing in a second or some.
const USUAL: [f64; 2] = [0.05, 60.0];

/// Periods of one part on one wire differ by no more than this factor: its moments of inertia by its square.
const FARTHEST: f64 = 8.0;

/// In m: no wheel is smaller.
const SMALLEST: f64 = 0.05;

/// What is to be said of measurements, in SI units by their names.
pub fn doubts(measurements: &[(&str, f64)]) -> Vec<String> {
    let is_period = |name: &str| known(name).is_some_and(|info| info.unit == "s");
    let periods: Vec<(&str, f64)> = measurements.iter().copied().filter(|(name, _)| is_period(name)).collect();
    let shown = |period: f64| shortest(format!("{period:.3e}").parse().unwrap_or(period));
    let [least, most] = USUAL;
    let is_usual = |&(_, period): &(&str, f64)| (least..=most).contains(&period);
    let unusual = periods.iter().filter(|own| !is_usual(own)).map(|(name, period)| {
        format!(
            "`{name}` is {} s, and parts of a bicycle swing in {least} to {most} s; are its times in another unit, or samples, and \
             not periods, counted?",
            shown(*period)
        )
    });
    let mut found: Vec<String> = unusual.collect();
    for part in ["B", "H", "S", "G"] {
        let is_own = |name: &str| name.strip_prefix("Tt").is_some_and(|rest| rest.starts_with(part));
        let own = || periods.iter().filter(|own| is_usual(own) && is_own(own.0));
        let [short, long] = [own().min_by(|a, b| a.1.total_cmp(&b.1)), own().max_by(|a, b| a.1.total_cmp(&b.1))];
        if let (Some(short), Some(long)) = (short, long)
            && long.1 > FARTHEST * short.1
        {
            found.push(format!(
                "`{}` is {} s and `{}` {} s: of one part they differ by less; is one of them in another unit, or at another rate?",
                short.0,
                shown(short.1),
                long.0,
                shown(long.1)
            ));
        }
    }
    for wheel in ["R", "F"] {
        let value = |letter: &str| measurements.iter().find(|(name, _)| *name == format!("{letter}{wheel}"));
        let (Some((_, distance)), Some((_, turns))) = (value("d"), value("n")) else { continue };
        let radius = distance / (std::f64::consts::TAU * turns);
        if radius < SMALLEST {
            found.push(format!(
                "the radius `r{wheel}` is {} m by `d{wheel}` and `n{wheel}`, too small for a bicycle; is `d{wheel}` the distance of \
                 all turns?",
                shown(radius)
            ));
        }
    }
    found
}
