//! Stability along speed, for models with two coordinates.

mod branches;
mod characteristic;
mod critical;
mod double_root;
mod imaginary;
mod modes;
mod ranges;
mod search;
mod verdict;

use characteristic::Characteristic;
use ranges::Verdicts;

use crate::{Coefficients, Scalar, SystemError};

pub use critical::{Change, CriticalKind, CriticalSpeed};
pub use modes::{Mode, ModeValue, Modes};
pub use ranges::StableRange;
pub use verdict::Verdict;

/// The critical speeds and the stable ranges of a model with two coordinates.
///
/// Critical speeds are not scanned for: they are all the positive roots of polynomials in the speed, made from the
/// coefficients of the characteristic polynomial `p_4 s^4 + ... + p_0 = det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`:
///
/// - capsize: p_0 = 0, of degree 4;
/// - weave: the Hurwitz determinant `p_1 p_2 p_3 - p_1^2 p_4 - p_0 p_3^2` = 0, of degree 6, with an imaginary pair;
/// - double roots: the discriminant = 0, of degree 12.
///
/// Eigenvalues that are zero at all speeds, as without gravity, are set aside first; then the same holds for the
/// polynomial of lower degree that is left. Eigenvalues that coincide at all speeds make no double-root speed, and a pair
/// that is imaginary at all speeds makes no weave speed. All of this is for two coordinates; for any other number
/// [`System::eigenvalues`](crate::System::eigenvalues) is what there is.
///
/// The benchmark bicycle of Meijaard, Papadopoulos, Ruina & Schwab (2007):
///
/// ```
/// use carvallo::{Coefficients, CriticalKind, Stability, Verdict};
///
/// let zero = [[0.0; 2]; 2];
/// let m = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
/// let c1 = [[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
/// let k0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
/// let k2 = [[0.0, 76.59734589573222], [0.0, 2.65431523794604]];
/// let stability = Stability::new(&Coefficients::from_rows([m, zero, c1, zero, k0, k2]), 9.81)?;
///
/// let range = stability.stable_ranges[0];
/// assert!((range.from - 4.292_382_536_341).abs() < 1e-11);
/// assert!((range.to.unwrap() - 6.024_262_015_388).abs() < 1e-11);
/// assert_eq!(stability.critical_speeds[1].kind, CriticalKind::Weave);
/// assert_eq!(stability.verdict(5.0)?, Verdict::Stable);
/// # Ok::<(), carvallo::SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// All critical speeds above zero, ascending.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// The ranges of speed in which the motion is stable, ascending.
    pub stable_ranges: Vec<StableRange>,
    verdicts: Verdicts,
}

impl Stability {
    /// Everything about stability along speed, at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If gravity or an entry is not finite, if the mass matrix is singular, or if a critical speed leaves the range of
    /// `f64`.
    pub fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        let characteristic = Characteristic::new(coefficients, gravity)?;
        let found = search::search(&characteristic)?;
        let verdicts = Verdicts::new(&characteristic, &found);
        Ok(Self {
            critical_speeds: found.iter().map(|found| found.critical).collect(),
            stable_ranges: verdicts.stable_ranges(),
            verdicts,
        })
    }

    /// Whether the motion is stable at a speed in m/s.
    ///
    /// It agrees with the stable ranges at every number: stable inside, and at their ends, which are critical speeds,
    /// marginal.
    ///
    /// # Errors
    /// If the speed is negative or not finite.
    pub fn verdict(&self, speed: f64) -> Result<Verdict, SystemError> {
        require_speed(speed)?;
        Ok(self.verdicts.at(speed))
    }
}

fn require_speed(speed: f64) -> Result<(), SystemError> {
    crate::system::require_finite("speed", speed)?;
    if speed < 0.0 { Err(SystemError::NegativeSpeed { speed }) } else { Ok(()) }
}
