//! Frequency responses.

use std::f64::consts::PI;

use carvallo::Complex;

use crate::transfer::TransferFunction;

/// What a transfer function is at one frequency: an input `sin(w t)` comes out as `gain sin(w t + phase)`, once what else the motion
/// has has died away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyResponse {
    /// In rad/s.
    pub frequency: f64,
    /// The size of the output by that of the input, in their units.
    pub gain: f64,
    /// By how much the output leads the input, in rad; without jumps along the frequency, but for those of half a turn at poles
    /// and zeros on the imaginary axis.
    pub phase: f64,
}

impl FrequencyResponse {
    /// The gain in decibels, 20 log10 of it.
    pub fn decibels(&self) -> f64 {
        20.0 * self.gain.log10()
    }

    /// The gain and the phase as a complex number.
    pub fn value(&self) -> Complex<f64> {
        Complex::from_polar(self.gain, self.phase)
    }
}

/// How far beyond the slowest and the fastest pole a graph goes, and to zeros at most.
const BEYOND: f64 = 10.0;
/// Zeros farther from the poles than this are of no interest.
const FAR: f64 = 30.0;
/// Points of a graph for each decade.
const PER_DECADE: f64 = 100.0;
/// Points on either side of a root that is near the imaginary axis.
const NEAR_ROOT: i32 = 40;

impl TransferFunction {
    /// The response at frequencies above zero, in rad/s.
    ///
    /// The phase at low frequencies is that of the integrals, a quarter of a turn back for each, and half a turn where the rest is
    /// negative: ahead for a negative gain, back for an unstable pole.
    pub fn frequency_response(&self, frequencies: &[f64]) -> Vec<FrequencyResponse> {
        let minimal = self.minimal();
        let at = |&frequency: &f64| {
            let gain = minimal.at(Complex::new(0.0, frequency)).norm();
            FrequencyResponse { frequency, gain, phase: minimal.phase(frequency) }
        };
        frequencies.iter().map(at).collect()
    }

    /// Frequencies in rad/s that show all of a response: as densely as its poles and zeros ask for, from well below the slowest
    /// to well above the fastest pole, or between two that are given.
    pub fn frequencies(&self, range: Option<[f64; 2]>) -> Vec<f64> {
        let minimal = self.minimal();
        let [low, high] = range.unwrap_or_else(|| minimal.range());
        // The quotient of the ends themselves may be beyond the largest double.
        let decades = high.log10() - low.log10();
        let steps = (decades * PER_DECADE).ceil().max(1.0);
        let between = |step: u32| {
            let half = 10_f64.powf(0.5 * decades * f64::from(step) / steps);
            low * half * half
        };
        let mut frequencies = vec![low, high];
        frequencies.extend((1..steps as u32).map(between));
        for root in minimal.poles.iter().chain(&minimal.zeros).filter(|root| root.im > 0.0) {
            // Evenly along the circle that a response is in the complex plane near its pole.
            let near =
                (-NEAR_ROOT..=NEAR_ROOT).map(|step| (PI / 2.0 * f64::from(step) / f64::from(NEAR_ROOT + 1)).tan());
            frequencies.extend(near.map(|share| root.im + share * root.re).filter(|near| (low..=high).contains(near)));
        }
        frequencies.sort_by(f64::total_cmp);
        frequencies.dedup();
        frequencies
    }

    /// From a power of ten to another one.
    fn range(&self) -> [f64; 2] {
        let sizes = |roots: &[Complex<f64>]| -> Vec<f64> {
            roots.iter().map(|root| root.norm()).filter(|size| *size > 0.0).collect()
        };
        let extent = |sizes: &[f64]| {
            let extremes = (f64::INFINITY, 0.0_f64);
            sizes.iter().fold(extremes, |(low, high), size| (low.min(*size), high.max(*size)))
        };
        let (slowest, fastest) = match extent(&sizes(&self.poles)) {
            (_, 0.0) => (1.0, 1.0),
            extent => extent,
        };
        let mut near = sizes(&self.zeros);
        near.retain(|size| (slowest / FAR..=fastest * FAR).contains(size));
        near.extend([slowest, fastest]);
        let (low, high) = extent(&near);
        [(low / BEYOND).log10().floor(), (high * BEYOND).log10().ceil()].map(|power| 10_f64.powf(power))
    }

    /// In rad, continuous from low frequencies on.
    fn phase(&self, frequency: f64) -> f64 {
        let is_unstable = |root: &&Complex<f64>| root.im == 0.0 && root.re > 0.0;
        let unstable = |roots: &[Complex<f64>]| roots.iter().filter(is_unstable).count() as i32;
        // What is negative at low frequencies: two of them are half a turn each way, or none.
        let halves = i32::from(self.gain < 0.0) + unstable(&self.zeros) - unstable(&self.poles);
        let turned = |roots: &[Complex<f64>]| roots.iter().map(|root| turned(*root, frequency)).sum::<f64>();
        f64::from(halves % 2) * PI + turned(&self.zeros) - turned(&self.poles)
    }
}

/// By how much `i frequency - root` has turned since frequency zero, for pairs together.
fn turned(root: Complex<f64>, frequency: f64) -> f64 {
    // Adding zero turns -0 into 0.
    let angle = (frequency - root.im).atan2(root.re.abs() + 0.0);
    if root.re > 0.0 { -angle } else { angle }
}
