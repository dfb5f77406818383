//! Transfer functions.

use carvallo::{Complex, SystemError};

use crate::balance::Channel;
use crate::rest::poles;
use crate::signal::Signal;
use crate::state_space::StateSpace;
use crate::zeros::zeros;

/// The transfer function from one input to one output of a state space,
///
/// ```text
/// G(s) = gain Π (s - zero) / Π (s - pole)
/// ```
///
/// with a pole for each state between the two, also where a zero cancels it: [`cancelled`](Self::cancelled) tells which. States
/// that the output needs nothing of, as integrals for other outputs, count for nothing.
///
/// ```
/// use carvallo_control::{Ports, StateSpace, TransferFunction};
/// use carvallo_design::input::{self, Request};
///
/// let bicycle = input::load(&Request::default())?;
/// let ports = Ports::of(&bicycle);
/// let (torque, lean) = (ports.input("Tdelta").unwrap(), ports.output("phi").unwrap());
/// let steered = StateSpace::new(&bicycle, 5.0, &[torque], &[lean])?;
/// let lean = TransferFunction::new(&steered, 0, 0).unwrap();
/// // To lean to the right, steer to the left first: the lean begins the wrong way, and a torque to the right leans it left.
/// assert!(lean.gain < 0.0 && lean.zeros.len() == 2);
/// # Ok::<(), carvallo_design::Failure>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TransferFunction {
    /// The input.
    pub input: Signal,
    /// The output.
    pub output: Signal,
    /// In 1/s, sorted by real part, then by imaginary part.
    pub zeros: Vec<Complex<f64>>,
    /// In 1/s, sorted likewise.
    pub poles: Vec<Complex<f64>>,
    /// The leading coefficient of the numerator, that of the denominator being one; zero where the output does not depend on the
    /// input.
    pub gain: f64,
}

/// A pole and a zero that differ by less, relative to the largest pole, cancel each other.
const EQUAL: f64 = 1e-9;

impl TransferFunction {
    /// From an input to an output, by their places in the state space.
    ///
    /// # Errors
    /// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
    ///
    /// # Panics
    /// If there is no such input or output.
    pub fn new(space: &StateSpace, input: usize, output: usize) -> Result<Self, SystemError> {
        let channel = Channel::of(space, input, output);
        let poles = poles(&channel.a)?;
        let (zeros, gain) = zeros(channel)?;
        Ok(Self { input: space.inputs[input].clone(), output: space.outputs[output].clone(), zeros, poles, gain })
    }

    /// The value at a complex frequency in 1/s; not finite at a pole.
    pub fn at(&self, s: Complex<f64>) -> Complex<f64> {
        // Zeros and poles in turns, since the products of many may leave the range.
        let factor = |place: usize| {
            let numerator = self.zeros.get(place).map_or(Complex::new(1.0, 0.0), |zero| s - zero);
            self.poles.get(place).map_or(numerator, |pole| numerator / (s - pole))
        };
        let count = self.poles.len().max(self.zeros.len());
        (0..count).fold(Complex::new(self.gain, 0.0), |product, place| product * factor(place))
    }

    /// What a constant input of one comes to where the motion is stable, the value at zero; nothing where a pole is there.
    pub fn static_gain(&self) -> Option<f64> {
        let zero = Complex::new(0.0, 0.0);
        let minimal = self.minimal();
        (!minimal.poles.contains(&zero)).then(|| minimal.at(zero).re + 0.0)
    }

    /// The same function without the poles and zeros that cancel each other. Those poles are modes that the input does not excite,
    /// or that the output does not show.
    #[must_use]
    pub fn minimal(&self) -> Self {
        let (mut zeros, mut poles) = (self.zeros.clone(), Vec::new());
        let bound = EQUAL * self.poles.iter().map(|pole| pole.norm()).fold(0.0, f64::max);
        for pole in &self.poles {
            let distance = |place: &usize| (zeros[*place] - pole).norm();
            let nearest = (0..zeros.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            match nearest.filter(|place| distance(place) <= bound) {
                Some(place) => drop(zeros.remove(place)),
                None => poles.push(*pole),
            }
        }
        Self { zeros, poles, ..self.clone() }
    }

    /// The poles that zeros cancel.
    pub fn cancelled(&self) -> Vec<Complex<f64>> {
        let mut kept = self.minimal().poles;
        let is_cancelled = |pole: &&Complex<f64>| {
            let place = kept.iter().position(|other| other == *pole);
            place.map(|place| kept.remove(place)).is_none()
        };
        self.poles.iter().filter(is_cancelled).copied().collect()
    }

    /// The coefficients of the numerator, from the highest power of s down.
    pub fn numerator(&self) -> Vec<f64> {
        polynomial(&self.zeros).into_iter().map(|coefficient| self.gain * coefficient).collect()
    }

    /// The coefficients of the denominator, from the highest power of s down, which is one.
    pub fn denominator(&self) -> Vec<f64> {
        polynomial(&self.poles)
    }
}

/// The coefficients of the polynomial with these roots, whose pairs are conjugate, from the highest power down, which is one. What
/// is no more than the rounding of the terms that were added to form it is zero.
fn polynomial(roots: &[Complex<f64>]) -> Vec<f64> {
    let mut coefficients = vec![Complex::new(1.0, 0.0)];
    let mut sizes = vec![1.0];
    for root in roots {
        coefficients.push(Complex::new(0.0, 0.0));
        sizes.push(0.0);
        for place in (1..coefficients.len()).rev() {
            let (before, size) = (coefficients[place - 1], sizes[place - 1]);
            coefficients[place] -= root * before;
            sizes[place] += root.norm() * size;
        }
    }
    let rounding = 4.0 * f64::EPSILON * roots.len() as f64;
    let rounded = |(coefficient, size): (Complex<f64>, f64)| {
        if coefficient.re.abs() <= rounding * size { 0.0 } else { coefficient.re }
    };
    coefficients.into_iter().zip(sizes).map(rounded).collect()
}
