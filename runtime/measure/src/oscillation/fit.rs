//! Least squares by Gauss and Newton, with the exact derivatives and the damping of Levenberg and Marquardt.

use std::f64::consts::TAU;
use std::fmt;

use nalgebra::{SMatrix, SVector};

use super::guess::guess;

/// The offset, the parts of sine and cosine, the decay in 1/s and the angular frequency in rad/s.
type Unknowns = SVector<f64, 5>;

/// So many steps are enough, unless there is no such oscillation.
const MOST_STEPS: usize = 200;

/// A change of the sum of squares, in parts of it, that is rounding.
const NOTHING: f64 = 1e-14;

/// A step, in parts of the unknowns, behind which nothing changes.
const SMALL: f64 = 1e-13;

/// Fewer samples say nothing of their scatter.
const FEWEST: usize = 10;

/// What was fitted to a signal: `y = a + exp(-d t) (b sin(w t) + c cos(w t))`, with t from the first sample on.
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

/// Fits a decaying sine with an offset to a signal of any unit, at times in s.
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
    let [decay, frequency] = guess(&scaled).ok_or(FitError::NoOscillation)?;
    let (unknowns, normal, left) = search(&scaled, linear(&scaled, decay, frequency)).ok_or(FitError::NoOscillation)?;
    let [offset, sine, cosine, decay, frequency] = unknowns.into();
    let frequency = frequency.abs();
    let period = span * TAU / frequency;
    if frequency < 1.5 * TAU {
        return Err(FitError::TooShort(period));
    }
    let variance = left / (samples - 5) as f64;
    let inverse = normal.try_inverse().ok_or(FitError::NoOscillation)?;
    let deviation = period * (variance * inverse[(4, 4)]).max(0.0).sqrt() / frequency;
    let scatter: f64 = scaled.iter().map(|[_, value]| value * value).sum();
    Ok(Oscillation {
        period,
        deviation,
        decay: decay / span,
        offset: mean + size * offset,
        amplitude: size * sine.hypot(cosine),
        r_squared: 1.0 - left / scatter,
        samples,
        periods: frequency / TAU,
    })
}

/// The value at a time, and its derivatives by the unknowns.
fn model([offset, sine, cosine, decay, frequency]: [f64; 5], time: f64) -> (f64, Unknowns) {
    let (s, c) = (frequency * time).sin_cos();
    let envelope = (-decay * time).exp();
    let swing = envelope * (sine * s + cosine * c);
    let turned = envelope * (sine * c - cosine * s);
    (offset + swing, Unknowns::from([1.0, envelope * s, envelope * c, -time * swing, time * turned]))
}

/// The normal equations: their matrix, the right side, and the sum of squares.
fn equations(scaled: &[[f64; 2]], unknowns: Unknowns) -> (SMatrix<f64, 5, 5>, Unknowns, f64) {
    let (mut matrix, mut right, mut sum) = (SMatrix::zeros(), Unknowns::zeros(), 0.0);
    for &[time, value] in scaled {
        let (found, slopes) = model(unknowns.into(), time);
        let left = value - found;
        matrix += slopes * slopes.transpose();
        right += slopes * left;
        sum += left * left;
    }
    (matrix, right, sum)
}

/// The best offset, sine and cosine for a decay and a frequency.
fn linear(scaled: &[[f64; 2]], decay: f64, frequency: f64) -> Unknowns {
    let start = Unknowns::from([0.0, 0.0, 0.0, decay, frequency]);
    let (matrix, right, _) = equations(scaled, start);
    let solved = matrix.fixed_view::<3, 3>(0, 0).into_owned().lu().solve(&right.fixed_rows::<3>(0).into_owned());
    let solved = solved.unwrap_or_default();
    Unknowns::from([solved[0], solved[1], solved[2], decay, frequency])
}

/// The unknowns with the least sum of squares, with the matrix of the normal equations there and the sum; `None` if the search
/// leaves what an oscillation can be.
fn search(scaled: &[[f64; 2]], start: Unknowns) -> Option<(Unknowns, SMatrix<f64, 5, 5>, f64)> {
    let mut at = start;
    let (mut matrix, mut right, mut sum) = equations(scaled, at);
    let (mut damping, mut before) = (1e-3, f64::INFINITY);
    for _ in 0..MOST_STEPS {
        let mut damped = matrix;
        (0..5).for_each(|k| damped[(k, k)] *= 1.0 + damping);
        let step = damped.cholesky()?.solve(&right);
        let next = at + step;
        let found = equations(scaled, next);
        // The sum is flat where it is least: there the steps tell, as long as they become smaller.
        let is_flat = (sum - found.2).abs() <= NOTHING * sum;
        let size = step.norm();
        if size <= SMALL * at.norm() || is_flat && size > 0.5 * before || damping > 1e12 {
            return Some((at, matrix, sum));
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
