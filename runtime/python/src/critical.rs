//! The critical speeds of one design, with all that there is to tell of them.

use carvallo::{Complex, CriticalSpeed, ModelInfo, Stability};
use carvallo_plot::analysis::name;

/// What it is called, the speed and its error in m/s, the eigenvalue in 1/s, what changes, and the verdicts below and above.
pub type Speed = (&'static str, f64, f64, Complex<f64>, String, String, String);

/// All of them, the stable ranges, the marginal ones, and those in which a speed may be missing.
pub type Critical = (Vec<Speed>, Vec<(f64, Option<f64>)>, Vec<(f64, Option<f64>)>, Vec<(f64, f64)>);

/// Of one stability.
pub fn of(stability: &Stability, info: &ModelInfo) -> Critical {
    let speed = |speed: &CriticalSpeed| {
        let [below, above] = stability.verdicts_around(speed).map(|verdict| verdict.to_string());
        (name(speed, info), speed.speed, speed.error, speed.eigenvalue, speed.change.to_string(), below, above)
    };
    let speeds = stability.critical_speeds.iter().map(speed).collect();
    let stable = stability.stable_ranges.iter().map(|range| (range.from, range.to)).collect();
    let marginal = stability.marginal_ranges().iter().map(|range| (range.from, range.to)).collect();
    (speeds, stable, marginal, stability.undecided.iter().map(|range| (range.from, range.to)).collect())
}
