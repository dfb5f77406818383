//! How far the speeds go that are looked at unless others are asked for.

use carvallo::{Change, CriticalSpeed, Stability, Verdict};

/// What is looked at where nothing else is known, and of bicycles and motorcycles at least, in m/s.
const USUAL: f64 = 10.0;

/// How much more than the last critical speed is shown.
const BEYOND: f64 = 1.3;

/// A critical speed that is so many times as high as the one before it is another matter, beyond what is looked at.
const APART: f64 = 10.0;

/// The speed in m/s up to which there is something to see: a round number above the critical speeds at which eigenvalues
/// become unstable, or the motion stable.
pub fn reach(stability: &Stability, is_bicycle: bool) -> f64 {
    let matters = |critical: &&CriticalSpeed| match critical.change {
        Change::Destabilizes => true,
        Change::Stabilizes => stability.verdicts_around(critical)[1] != Verdict::Unstable,
        Change::Merges | Change::Splits | Change::Touches => false,
    };
    let critical = stability.critical_speeds.iter().filter(matters).map(|critical| critical.speed);
    above_all(critical, is_bicycle)
}

fn above_all(critical: impl Iterator<Item = f64>, is_bicycle: bool) -> f64 {
    let mut last = None;
    for speed in critical {
        match last {
            Some(last) if speed > APART * last => break,
            _ => last = Some(speed),
        }
    }
    let Some(last) = last else { return USUAL };
    let reach = above(BEYOND * last);
    if is_bicycle { reach.max(USUAL) } else { reach }
}

/// The speeds in m/s of a table up to such a reach, and ten times as many of what programs read.
pub fn speeds(reach: f64, is_coarse: bool) -> Vec<f64> {
    let [_, step] = round(reach);
    // As decimals are read, not as products are rounded.
    let decimals = if is_coarse { -step.log10().floor() } else { 1.0 - step.log10().floor() }.max(0.0) as usize;
    let step = if is_coarse { step } else { step / 10.0 };
    let count = (reach / step).round() as u32;
    let speed = |index: u32| {
        let speed = f64::from(index) * step;
        format!("{speed:.decimals$}").parse().unwrap_or(speed)
    };
    (0..=count).map(speed).collect()
}

/// The next round number above.
fn above(speed: f64) -> f64 {
    round(speed)[0]
}

/// The next round number that is not less, and a step by which it is reached in 8 to 15.
fn round(speed: f64) -> [f64; 2] {
    const ROUND: [[f64; 2]; 10] = [
        [1.0, 0.1],
        [1.2, 0.1],
        [1.5, 0.1],
        [2.0, 0.2],
        [3.0, 0.2],
        [4.0, 0.5],
        [5.0, 0.5],
        [6.0, 0.5],
        [8.0, 1.0],
        [10.0, 1.0],
    ];
    let power = 10_f64.powf(speed.log10().floor());
    // Rounding of the quotient is no reason for the next one.
    let found = ROUND.into_iter().find(|[number, _]| number * power >= speed * (1.0 - 1e-12));
    found.unwrap_or([10.0, 1.0]).map(|number| number * power)
}

#[cfg(test)]
mod tests {
    use super::{above_all, speeds};

    #[test]
    fn the_last_critical_speed_is_seen_and_something_behind_it() {
        let of = |speeds: &[f64]| above_all(speeds.iter().copied(), false);
        assert_eq!(of(&[]), 10.0);
        assert_eq!(of(&[7.5]), 10.0);
        assert_eq!(of(&[63.4]), 100.0);
        assert_eq!(of(&[1.84, 2.83]), 4.0);
        assert_eq!(of(&[6.0, 55.0]), 80.0);
        // Ten times as high is another matter.
        assert_eq!(of(&[5.6, 700.0]), 8.0);
        assert_eq!(above_all([0.9].into_iter(), true), 10.0);
    }

    #[test]
    fn speeds_are_round_decimals() {
        assert_eq!(speeds(10.0, true), (0..=10).map(f64::from).collect::<Vec<_>>());
        assert_eq!(speeds(10.0, false)[..4], [0.0, 0.1, 0.2, 0.3]);
        assert_eq!(speeds(10.0, false).len(), 101);
        assert_eq!(speeds(4.0, true)[..3], [0.0, 0.5, 1.0]);
        assert_eq!(speeds(80.0, true), (0..=8).map(|v| 10.0 * f64::from(v)).collect::<Vec<_>>());
        assert_eq!(speeds(0.03, true).last(), Some(&0.03));
        assert_eq!(speeds(30.0, false).len(), 151);
    }
}
