//! Stability along a parameter other than the speed.

use core::fmt;

use nalgebra::Complex;

use super::critical::{Change, CriticalKind};
use super::general::{Found, search};
use super::verdict::Verdict;
use crate::number::Scalar;
use crate::numeric::Square;
use crate::system::{Matrix, System, SystemError};

/// The critical values and the stable ranges of a parameter of the equations of motion, at a fixed speed and gravity, over a
/// range.
///
/// As along the speed, critical values are not scanned for: the matrices M, C and K are interpolated by polynomials of the
/// parameter, and the search of [`Stability`](crate::Stability) for any number of coordinates finds where an eigenvalue is
/// zero or a pair is on the imaginary axis.
///
/// - Whether the matrices are polynomials is not assumed: each polynomial is held against the matrices at points that it was
///   not made from, to 1e-13 of their entries. Where that fails for a degree of 24, the range is halved, up to six times.
/// - That no critical value is missing is checked at values at which eigenvalues were computed by the way: as many of them
///   are unstable as the critical values say. What cannot be decided is in [`undecided`](Self::undecided). Two crossings
///   that undo each other and leave no trace in the interpolated conditions would not be seen; nothing proves that there are
///   none, as nothing proves from finitely many values what a function is between them.
///
/// The rotor of a shaft with internal damping, whose whirl becomes unstable at `1 + c_e / c_i` times its natural frequency:
///
/// ```
/// use carvallo::{CriticalKind, Matrix, ParameterStability, System};
///
/// // z'' + (c_e + c_i) z' + (1 - i c_i w) z = 0 for z = x + i y, and the speed of rotation w for the parameter.
/// let (external, internal) = (0.06, 0.02);
/// let one = Matrix::<f64, 2>::identity();
/// let skew = Matrix::<f64, 2>::new(0.0, 1.0, -1.0, 0.0);
/// let rotor = |w: f64| Ok(System::new(one, one * (external + internal), one + skew * (internal * w)));
/// let along = ParameterStability::new([0.0, 10.0], rotor)?;
///
/// let critical = &along.critical_values[0];
/// assert_eq!(critical.kind, CriticalKind::Weave);
/// assert!((critical.value - (1.0 + external / internal)).abs() < 1e-12);
/// # Ok::<(), carvallo::ParameterStabilityError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterStability {
    /// The critical values inside the range, ascending.
    pub critical_values: Vec<CriticalValue>,
    /// The ranges in which every eigenvalue has a negative real part, ascending: open, but where they end with the range.
    pub stable_ranges: Vec<ParameterRange>,
    /// The ranges in which a critical value may be missing, ascending: none, but where rounding decides or the search ended
    /// at its bound.
    pub undecided: Vec<ParameterRange>,
    range: [f64; 2],
    stretches: Vec<ParameterStretch>,
}

/// A value of a parameter at which the kind of motion changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalValue {
    /// What happens there: [`Capsize`](CriticalKind::Capsize) for any divergence, [`Weave`](CriticalKind::Weave) for any
    /// flutter.
    pub kind: CriticalKind,
    /// The value, in the unit of the parameter.
    pub value: f64,
    /// An estimate of the absolute error of the value: what the rounding of the matrix entries may do to it, and its own.
    pub error: f64,
    /// The eigenvalue in 1/s: zero, or i omega with omega > 0.
    pub eigenvalue: Complex<f64>,
    /// What changes as the parameter grows.
    pub change: Change,
}

/// A range of values of a parameter, in its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterRange {
    /// The lower end.
    pub from: f64,
    /// The upper end.
    pub to: f64,
}

/// The values from one on, up to the next stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ParameterStretch {
    pub(super) value: f64,
    pub(super) at: Verdict,
    pub(super) above: Verdict,
    pub(super) is_critical: bool,
}

/// Why there is no stability along a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ParameterStabilityError<E = SystemError> {
    /// The ends of the range are not finite, or do not ascend.
    Range {
        /// The lower end.
        from: f64,
        /// The upper end.
        to: f64,
    },
    /// There are no equations of motion at a value.
    System {
        /// The value.
        value: f64,
        /// Why there are none.
        error: E,
    },
    /// What is a state is not the same at all values.
    States {
        /// A value at which it is another one than at the lower end.
        value: f64,
    },
    /// The matrices are no piecewise polynomials of the parameter, as far as was tried.
    NotSmooth {
        /// The lower end of a piece in which they are none.
        from: f64,
        /// Its upper end.
        to: f64,
    },
    /// The mass matrix is singular at a value in the range.
    Singular {
        /// The value, to a few digits.
        value: f64,
    },
    /// Eigenvalues could not be computed.
    Analysis {
        /// The lower end of the range in which that was.
        from: f64,
        /// Its upper end.
        to: f64,
        /// Why.
        error: SystemError,
    },
}

impl<E: fmt::Display> fmt::Display for ParameterStabilityError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range { from, to } => {
                write!(f, "the range is from {from} to {to}; its ends must be finite and ascend")
            }
            Self::System { value, error } => write!(f, "at {value}: {error}"),
            Self::States { value } => {
                write!(f, "at {value} other positions and rates are states than at the lower end")
            }
            Self::NotSmooth { from, to } => write!(
                f,
                "between {from} and {to} the matrices are no polynomials of the parameter of a degree of up to 24; they \
                 must be smooth"
            ),
            Self::Singular { value } => write!(f, "near {value} the mass matrix M is singular; it must be invertible"),
            Self::Analysis { from, to, error } => write!(f, "between {from} and {to}: {error}"),
        }
    }
}

impl<E: core::error::Error> core::error::Error for ParameterStabilityError<E> {}

impl ParameterStability {
    /// Over a range of a parameter, from the equations of motion at each of its values, those at the ends among them.
    ///
    /// # Errors
    /// If the ends are not finite or do not ascend, if there are no equations of motion at some value, if these are not
    /// smooth, if their mass matrix is singular somewhere, or if eigenvalues cannot be computed.
    pub fn new<T: Scalar, const N: usize, E>(
        range: [f64; 2],
        mut system: impl FnMut(f64) -> Result<System<N, T>, E>,
    ) -> Result<Self, ParameterStabilityError<E>> {
        let [from, to] = range;
        if !(from.is_finite() && to.is_finite() && from < to && (to - from).is_finite()) {
            return Err(ParameterStabilityError::Range { from, to });
        }
        let states = system(from).map_err(|error| ParameterStabilityError::System { value: from, error })?.states;
        let mut other_states = None;
        let square = |matrix: &Matrix<T, N>| Square::from_fn(N, |row, column| matrix[(row, column)].to_f64());
        let mut at = |value: f64| {
            let System { m, c, k, states: at_value } = system(value)?;
            if at_value != states {
                other_states = Some(value);
            }
            Ok([&m, &c, &k].map(square))
        };
        let mut found = Found::default();
        let done = search(range, 0, &states, &mut at, &mut found);
        match other_states {
            Some(value) => Err(ParameterStabilityError::States { value }),
            None => done.map(|()| Self::from_found(range, found)),
        }
    }

    /// Not generic, so that it is compiled once.
    fn from_found(range: [f64; 2], found: Found) -> Self {
        let mut stretches: Vec<ParameterStretch> = Vec::new();
        for next in found.stretches {
            // Where one piece ends and another one begins nothing need happen.
            let goes_on = stretches.last().is_some_and(|last| last.above == next.above && next.at == next.above);
            if next.is_critical || !goes_on {
                stretches.push(next);
            }
        }
        stretches.extend(found.last);
        let mut stable_ranges: Vec<ParameterRange> = Vec::new();
        for pair in stretches.windows(2).filter(|pair| pair[0].above == Verdict::Stable) {
            let (from, to) = (pair[0].value, pair[1].value);
            match stable_ranges.last_mut() {
                Some(last) if last.to == from && pair[0].at == Verdict::Stable => last.to = to,
                _ => stable_ranges.push(ParameterRange { from, to }),
            }
        }
        let undecided = found.undecided.into_iter().map(|[from, to]| ParameterRange { from, to }).collect();
        Self { critical_values: found.critical, stable_ranges, undecided, range, stretches }
    }

    /// Whether the motion is stable at a value; `None` outside of the range.
    pub fn verdict(&self, value: f64) -> Option<Verdict> {
        let [from, to] = self.range;
        if !(from..=to).contains(&value) {
            return None;
        }
        let above = self.stretches.partition_point(|stretch| stretch.value <= value);
        let stretch = self.stretches.get(above.checked_sub(1)?)?;
        Some(if stretch.value == value { stretch.at } else { stretch.above })
    }

    /// Whether the motion is stable just below and just above one of the critical values.
    pub fn verdicts_around(&self, critical: &CriticalValue) -> [Verdict; 2] {
        let first = self.stretches.partition_point(|stretch| stretch.value < critical.value);
        let last = self.stretches.partition_point(|stretch| stretch.value <= critical.value);
        [first, last].map(|next| self.stretches.get(next.max(1) - 1).map_or(Verdict::Marginal, |at| at.above))
    }
}

#[cfg(test)]
mod tests;
