//! Gain and phase margins.

use std::f64::consts::PI;

use carvallo::{Complex, SystemError, Verdict, matrix_eigenvalues};
use nalgebra::DMatrix;

use crate::balance::Channel;
use crate::state_space::StateSpace;
use crate::transfer::TransferFunction;
use crate::zeros::zeros;

/// How far a transfer function is from -1, at which the loop `u = -y` is about to become unstable or stable.
#[derive(Clone, Debug, PartialEq)]
pub struct Margins {
    /// Where the response is real and negative, ascending in frequency.
    pub gain: Vec<GainMargin>,
    /// Where the gain is one, ascending in frequency.
    pub phase: Vec<PhaseMargin>,
    /// Whether every motion of the closed loop `u = -y` dies away.
    pub closed_loop: Verdict,
}

/// By what factor the gain may change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GainMargin {
    /// In rad/s; zero where the static gain is negative.
    pub frequency: f64,
    /// Times this, the gain is one: above one it may grow, below it may shrink.
    pub factor: f64,
}

/// By what angle the phase may change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseMargin {
    /// In rad/s.
    pub frequency: f64,
    /// In rad, above -π and up to π: above zero the phase may lag by so much more.
    pub angle: f64,
}

/// Roots whose real part is a smaller share of them are on the imaginary axis, until the response itself is looked at.
const ON_AXIS: f64 = 1e-5;
/// Angles that are no larger are none, in rad: what the rounding of undamped roots leaves.
const ROUNDING: f64 = 1e-13;
/// A pole or zero that is as near to a frequency, in parts of it, is there.
const AT_ROOT: f64 = 1e-9;
/// How far the frequency is from that of the root at most.
const NEAR: f64 = 1e-4;

impl Margins {
    /// Of an input and an output, by their places in a state space.
    ///
    /// No frequency is scanned for: where the gain is one, `1 - G(s) G(-s)` has a zero on the imaginary axis, and where the
    /// response is real, `G(s) - G(-s)` has one. Both have state spaces of twice as many states.
    ///
    /// # Errors
    /// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
    pub fn new(space: &StateSpace, input: usize, output: usize) -> Result<Self, SystemError> {
        let function = TransferFunction::new(space, input, output)?.minimal();
        let channel = Channel::of(space, input, output);
        let response = |frequency: f64| function.at(Complex::new(0.0, frequency));
        let mut gain = Vec::new();
        let crossings = on_axis(parallel(&channel), |frequency| {
            let value = response(frequency);
            // The sine of the angle to the negative half of the axis.
            -value.im / value.norm()
        })?;
        let at_rest = function.static_gain().filter(|gain| *gain < 0.0).map(|_| 0.0);
        for frequency in at_rest.into_iter().chain(crossings) {
            let value = response(frequency);
            if value.re < 0.0 && value.norm().is_finite() && !is_at_root(&function, frequency) {
                gain.push(GainMargin { frequency, factor: 1.0 / value.norm() });
            }
        }
        let crossings = on_axis(series(&channel), |frequency| response(frequency).norm().ln())?;
        let phase = crossings
            .into_iter()
            .map(|frequency| PhaseMargin { frequency, angle: angle_from_minus_one(response(frequency)) });
        Ok(Self { gain, phase: phase.collect(), closed_loop: closed_loop(space, input, output)? })
    }

    /// The gain margin whose factor is nearest to one.
    pub fn nearest_gain(&self) -> Option<GainMargin> {
        self.gain.iter().copied().min_by(|a, b| a.factor.ln().abs().total_cmp(&b.factor.ln().abs()))
    }

    /// The phase margin whose angle is nearest to zero.
    pub fn nearest_phase(&self) -> Option<PhaseMargin> {
        self.phase.iter().copied().min_by(|a, b| a.angle.abs().total_cmp(&b.angle.abs()))
    }
}

/// Whether a pole or a zero is on the imaginary axis at a frequency: there the response is infinite or zero, and its sign is rounding.
fn is_at_root(function: &TransferFunction, frequency: f64) -> bool {
    let mut roots = function.poles.iter().chain(&function.zeros);
    roots.any(|root| (root - Complex::new(0.0, frequency)).norm() <= AT_ROOT * frequency)
}

/// The angle from -1 to a number, which without damping is zero or half a turn but for rounding; half a turn is ahead.
fn angle_from_minus_one(value: Complex<f64>) -> f64 {
    let angle = (-value).arg();
    if angle.abs() <= ROUNDING {
        0.0
    } else if angle.abs() >= PI - ROUNDING {
        PI
    } else {
        angle
    }
}

/// By the eigenvalues of `A - B (1 + D)^-1 C`; where 1 + D is zero the loop has no motion at all.
fn closed_loop(space: &StateSpace, input: usize, output: usize) -> Result<Verdict, SystemError> {
    let Channel { a, b, c, d } = Channel::of(space, input, output);
    let loop_gain = 1.0 + d[(0, 0)];
    if loop_gain == 0.0 {
        return Ok(Verdict::Unstable);
    }
    Ok(Verdict::of(&matrix_eigenvalues(&(a - b * c / loop_gain))?))
}

/// `G(s) - G(-s)`.
fn parallel(Channel { a, b, c, .. }: &Channel) -> Channel {
    Channel { a: diagonal(a, &-a), b: stacked(b, b), c: beside(c, c), d: DMatrix::zeros(1, 1) }
}

/// `1 - G(s) G(-s)`.
fn series(Channel { a, b, c, d }: &Channel) -> Channel {
    let states = a.nrows();
    let mut both = diagonal(a, &-a);
    both.view_mut((states, 0), (states, states)).copy_from(&(b * c));
    let through = d[(0, 0)];
    let own = DMatrix::from_element(1, 1, 1.0 - through * through);
    Channel { a: both, b: stacked(b, &(b * through)), c: beside(&(c * -through), c), d: own }
}

fn diagonal(first: &DMatrix<f64>, second: &DMatrix<f64>) -> DMatrix<f64> {
    let states = first.nrows();
    let mut both = DMatrix::zeros(2 * states, 2 * states);
    both.view_mut((0, 0), (states, states)).copy_from(first);
    both.view_mut((states, states), (states, states)).copy_from(second);
    both
}

fn stacked(above: &DMatrix<f64>, below: &DMatrix<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(above.nrows() + below.nrows(), 1, |row, _| {
        if row < above.nrows() { above[(row, 0)] } else { below[(row - above.nrows(), 0)] }
    })
}

fn beside(left: &DMatrix<f64>, right: &DMatrix<f64>) -> DMatrix<f64> {
    stacked(&left.transpose(), &right.transpose()).transpose()
}

/// The frequencies above zero at which a channel has a zero on the imaginary axis and a function of the frequency changes its sign.
fn on_axis(channel: Channel, function: impl Fn(f64) -> f64) -> Result<Vec<f64>, SystemError> {
    let (roots, gain) = zeros(channel)?;
    if gain == 0.0 {
        return Ok(Vec::new());
    }
    let roots = roots.into_iter().filter(|root| root.im > 0.0 && root.re.abs() <= ON_AXIS * root.im);
    let mut frequencies: Vec<f64> = roots.filter_map(|root| change_of_sign(root.im, &function)).collect();
    frequencies.sort_by(f64::total_cmp);
    // Of a pair about the axis both halves are near it.
    frequencies.dedup_by(|a, b| (*a - *b).abs() <= NEAR * *b * 1e-3);
    Ok(frequencies)
}

/// Where near a frequency a function changes its sign, to rounding.
fn change_of_sign(frequency: f64, function: &impl Fn(f64) -> f64) -> Option<f64> {
    let (mut low, mut high) = (frequency * (1.0 - NEAR), frequency * (1.0 + NEAR));
    let below = function(low);
    let changes = below * function(high) < 0.0;
    if !changes {
        return None;
    }
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return Some(middle);
        }
        if function(middle) * below > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
}
