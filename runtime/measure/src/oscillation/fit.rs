//! Least squares by Gauss and Newton, with the exact derivatives and the damping of Levenberg and Marquardt.

use std::f64::consts::TAU;
use std::fmt;

use nalgebra::{SMatrix, SVector};

use super::guess::guess;

/// The offset, the parts of sine and cosine, the decay, the angular frequency and the drift.
type Unknowns = SVector<f64, MOST>;
type Normal = SMatrix<f64, MOST, MOST>;

/// How many unknowns there are, the last of which is the drift, ...
const MOST: usize = 6;
/// ... and without it.
const EVEN: usize = 5;

/// A drift of so many standard deviations is no scatter.
const CLEAR: f64 = 6.0;

/// So many steps are enough, unless there is no such oscillation.
const MOST_STEPS: usize = 200;

/// A change of the sum of squares, in parts of it, that is rounding.
const NOTHING: f64 = 1e-14;

/// A step, in parts of the unknowns, behind which nothing changes.
const SMALL: f64 = 1e-13;

/// Fewer samples say nothing of their scatter.
const FEWEST: usize = 10;

/// What was fitted to a signal: `y = a + e t + exp(-d t) (b sin(w t) + c cos(w t))`, with t from the first sample on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation {
    /// T = 2 pi/w, of the damped oscillation, in s.
    pub period: f64,
    /// The standard deviation of the period, in s: by the scatter about the fit, of samples that are independent of each other.
    pub deviation: f64,
    /// d, in 1/s.
    pub decay: f64,
    /// a, in the unit of the signal.
    pub offset: f64,
    /// e, in the unit of the signal by s: how the zero of the sensor drifts. It is 0 where there is none beyond the scatter.
    pub drift: f64,
    /// The amplitude sqrt(b^2 + c^2) at the first sample, in the unit of the signal.
    pub amplitude: f64,
    /// The part of the scatter of the signal that the fit explains.
    pub r_squared: f64,
    /// How many samples there are.
    pub samples: usize,
    /// How many periods they cover.
    pub periods: f64,
}

/// Why there is no period.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// Fewer samples than are needed.
    TooFew(usize),
    /// A time that does not come after the one before, in s.
    NotAscending(f64),
    /// A sample that is no number, by its place.
    NotFinite(usize),
    /// The signal is the same all the time.
    Constant,
    /// Less than one and a half periods, of this length in s.
    TooShort(f64),
    /// The signal is none, or the search did not end.
    NoOscillation,
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew(count) => write!(f, "there are {count} samples; there must be {FEWEST} at least"),
            Self::NotAscending(time) => write!(f, "the time {time} s does not come after the one before"),
            Self::NotFinite(place) => write!(f, "sample {} is no finite number", place + 1),
            Self::Constant => f.write_str("the signal is the same all the time"),
            Self::TooShort(period) => {
                write!(f, "it covers less than one and a half periods of {period:.3} s; record several")
            }
            Self::NoOscillation => f.write_str("the signal is no decaying oscillation"),
        }
    }
}

impl std::error::Error for FitError {}

/// Fits a decaying sine with an offset to a signal of any unit, at times in s; and where there is clearly one, a drift of the
/// offset.
///
/// ```
/// use carvallo_measure::oscillation::fit;
///
/// let times: Vec<f64> = (0..500).map(|sample| f64::from(sample) / 50.0).collect();
/// let signal = times.iter().map(|t| 2.5 - 0.8 * (-0.01 * t).exp() * (4.0 * t).sin());
/// let found = fit(&times, &signal.collect::<Vec<f64>>())?;
/// assert!((found.period - std::f64::consts::TAU / 4.0).abs() < 1e-12);
/// # Ok::<(), carvallo_measure::oscillation::FitError>(())
/// ```
///
/// # Errors
/// If it is none, or too short for one.
pub fn fit(times: &[f64], signal: &[f64]) -> Result<Oscillation, FitError> {
    let samples = times.len().min(signal.len());
    let (times, signal) = (&times[..samples], &signal[..samples]);
    if samples < FEWEST {
        return Err(FitError::TooFew(samples));
    }
    if let Some(place) = (0..samples).find(|&at| !times[at].is_finite() || !signal[at].is_finite()) {
        return Err(FitError::NotFinite(place));
    }
    if let Some(pair) = times.windows(2).find(|pair| pair[1] <= pair[0]) {
        return Err(FitError::NotAscending(pair[1]));
    }
    let mean = signal.iter().sum::<f64>() / samples as f64;
    let size = signal.iter().fold(0.0, |size: f64, value| size.max((value - mean).abs()));
    if size == 0.0 {
        return Err(FitError::Constant);
    }
    // With the span and the largest value for units, all unknowns and their derivatives are of a like size.
    let span = times[samples - 1] - times[0];
    let scaled: Vec<[f64; 2]> =
        times.iter().zip(signal).map(|(time, value)| [(time - times[0]) / span, (value - mean) / size]).collect();
    let even = guess(&scaled).and_then(|[decay, frequency]| search(&scaled, linear(&scaled, decay, frequency), EVEN));
    let drifting = drifting(&scaled).filter(|fitted| {
        let drift = fitted.unknowns[EVEN].abs();
        fitted.deviation(EVEN, samples).is_some_and(|deviation| drift > CLEAR * deviation)
    });
    let fitted = drifting.or(even).ok_or(FitError::NoOscillation)?;
    let [offset, sine, cosine, decay, frequency, drift] = fitted.unknowns.into();
    let frequency = frequency.abs();
    let period = span * TAU / frequency;
    if frequency < 1.5 * TAU {
        return Err(FitError::TooShort(period));
    }
    let of_frequency = fitted.deviation(4, samples).ok_or(FitError::NoOscillation)?;
    let deviation = period * of_frequency / frequency;
    let scatter: f64 = scaled.iter().map(|[_, value]| value * value).sum();
    Ok(Oscillation {
        period,
        deviation,
        decay: decay / span,
        offset: mean + size * offset,
        drift: size * drift / span,
        amplitude: size * sine.hypot(cosine),
        r_squared: 1.0 - fitted.left / scatter,
        samples,
        periods: frequency / TAU,
    })
}

/// The value at a time, and its derivatives by the unknowns.
fn model([offset, sine, cosine, decay, frequency, drift]: [f64; MOST], time: f64) -> (f64, Unknowns) {
    let (s, c) = (frequency * time).sin_cos();
    let envelope = (-decay * time).exp();
    let swing = envelope * (sine * s + cosine * c);
    let turned = envelope * (sine * c - cosine * s);
    let slopes = [1.0, envelope * s, envelope * c, -time * swing, time * turned, time];
    (offset + drift * time + swing, Unknowns::from(slopes))
}

/// The normal equations of the first so many unknowns: their matrix, the right side, and the sum of squares.
fn equations(scaled: &[[f64; 2]], unknowns: Unknowns, count: usize) -> (Normal, Unknowns, f64) {
    let (mut matrix, mut right, mut sum) = (Normal::zeros(), Unknowns::zeros(), 0.0);
    for &[time, value] in scaled {
        let (found, mut slopes) = model(unknowns.into(), time);
        slopes.iter_mut().skip(count).for_each(|slope| *slope = 0.0);
        let left = value - found;
        matrix += slopes * slopes.transpose();
        right += slopes * left;
        sum += left * left;
    }
    // What is held has an equation of its own.
    (count..MOST).for_each(|held| matrix[(held, held)] = 1.0);
    (matrix, right, sum)
}

/// The best offset, sine and cosine for a decay and a frequency.
fn linear(scaled: &[[f64; 2]], decay: f64, frequency: f64) -> Unknowns {
    let start = Unknowns::from([0.0, 0.0, 0.0, decay, frequency, 0.0]);
    let (matrix, right, _) = equations(scaled, start, EVEN);
    let solved = matrix.fixed_view::<3, 3>(0, 0).into_owned().lu().solve(&right.fixed_rows::<3>(0).into_owned());
    let solved = solved.unwrap_or_default();
    Unknowns::from([solved[0], solved[1], solved[2], decay, frequency, 0.0])
}

/// The fit with a drift, from what is left beside a straight line.
fn drifting(scaled: &[[f64; 2]]) -> Option<Fitted> {
    let count = scaled.len() as f64;
    let mean = |part: &dyn Fn(&[f64; 2]) -> f64| scaled.iter().map(part).sum::<f64>() / count;
    let [time, value] = [0, 1].map(|part| mean(&|sample| sample[part]));
    let slope = mean(&|[t, y]| (t - time) * (y - value)) / mean(&|[t, _]| (t - time).powi(2));
    let left: Vec<[f64; 2]> = scaled.iter().map(|&[t, y]| [t, y - value - slope * (t - time)]).collect();
    let [decay, frequency] = guess(&left)?;
    let mut start = linear(&left, decay, frequency);
    start[0] += value - slope * time;
    start[EVEN] = slope;
    search(scaled, start, MOST)
}

/// The unknowns with the least sum of squares.
struct Fitted {
    unknowns: Unknowns,
    /// The matrix of the normal equations there.
    normal: Normal,
    /// The sum of squares.
    left: f64,
    /// How many of the unknowns were free.
    count: usize,
}

impl Fitted {
    /// The standard deviation of an unknown, by the scatter of so many samples.
    fn deviation(&self, unknown: usize, samples: usize) -> Option<f64> {
        let variance = self.left / (samples - self.count) as f64;
        let inverse = self.normal.try_inverse()?;
        Some((variance * inverse[(unknown, unknown)]).max(0.0).sqrt())
    }
}

/// The first so many unknowns with the least sum of squares, while the others are held; `None` if the search leaves what an
/// oscillation can be.
fn search(scaled: &[[f64; 2]], start: Unknowns, count: usize) -> Option<Fitted> {
    let mut at = start;
    let (mut matrix, mut right, mut sum) = equations(scaled, at, count);
    let (mut damping, mut before) = (1e-3, f64::INFINITY);
    for _ in 0..MOST_STEPS {
        let mut damped = matrix;
        (0..MOST).for_each(|k| damped[(k, k)] *= 1.0 + damping);
        let step = damped.cholesky()?.solve(&right);
        let next = at + step;
        let found = equations(scaled, next, count);
        // The sum is flat where it is least: there the steps tell, as long as they become smaller.
        let is_flat = (sum - found.2).abs() <= NOTHING * sum;
        let size = step.norm();
        if size <= SMALL * at.norm() || is_flat && size > 0.5 * before || damping > 1e12 {
            return Some(Fitted { unknowns: at, normal: matrix, left: sum, count });
        }
        if is_flat || found.2 < sum {
            before = if is_flat { size } else { f64::INFINITY };
            at = next;
            (matrix, right, sum) = found;
            damping *= 0.1;
        } else {
            damping *= 10.0;
        }
    }
    None
}
