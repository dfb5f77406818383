//! Critical speeds and stable ranges of two coordinates, in fixed room.

use arrayvec::ArrayVec;

use super::critical::CriticalSpeed;
use super::fast;
use super::ranges::StableRange;
use super::verdict::Verdict;
use super::verdicts::{Stretch, Verdicts};
use crate::number::Scalar;
use crate::system::{Coefficients, States, SystemError, require_speed};

/// As many critical speeds as the conditions have positive roots at most: 4, 6 and 12.
pub(super) const MOST: usize = 22;

/// The critical speeds and the stable ranges of two coordinates without allocation, and so without feature `std`: where
/// they are certain in `f64`, which they are for all but designs at the edge of something.
///
/// They are those of [`Stability`](crate::Stability), to the last bit, which looks further where this one does not know. It
/// does not where two critical speeds agree in ten digits, where a condition for them is zero at all speeds (as without
/// damping, or without gravity) or only touches zero, and where entries that are not zero are beyond 1e-15 or 1e15.
///
/// ```
/// use carvallo::{CertainStability, Coefficients, Verdict};
///
/// let zero = [[0.0; 2]; 2];
/// let m = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
/// let c1 = [[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
/// let k0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
/// let k2 = [[0.0, 76.59734589573222], [0.0, 2.65431523794604]];
/// let benchmark = Coefficients::<f64, 2>::from_rows([m, zero, zero, c1, zero, k0, zero, k2]);
/// let stability = CertainStability::new(&benchmark, 9.81)?;
///
/// let range = stability.stable_ranges().next().unwrap();
/// assert!((range.from - 4.292_382_536_341).abs() < 1e-11);
/// assert!((range.to.unwrap() - 6.024_262_015_388).abs() < 1e-11);
/// assert_eq!(stability.verdict(5.0)?, Verdict::Stable);
/// # Ok::<(), carvallo::SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CertainStability {
    pub(super) critical_speeds: ArrayVec<CriticalSpeed, MOST>,
    pub(super) verdicts: Verdicts<ArrayVec<Stretch, { MOST + 1 }>>,
}

impl CertainStability {
    /// Not yet anything: to be filled in its place, since all of its room would be copied.
    pub(super) const EMPTY: Self =
        Self { critical_speeds: ArrayVec::new_const(), verdicts: Verdicts { stretches: ArrayVec::new_const() } };

    /// At a gravitational field strength in N/kg. All is computed in `f64`, of matrices in `f32` as well.
    ///
    /// # Errors
    /// If gravity or an entry is not finite; if there is a C-1 or a K1, or a coordinate of which only the position or the rate
    /// is a state; or if something is not certain, with a singular mass matrix among the reasons.
    pub fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        let coefficients = coefficients.widen();
        coefficients.require_finite()?;
        if !gravity.is_finite() {
            return Err(SystemError::NotFinite { quantity: "gravity", value: gravity });
        }
        if coefficients.has_odd_powers() || coefficients.states != [States::Both; 2] {
            return Err(SystemError::OddPowers);
        }
        let mut found = Self::EMPTY;
        fast::find_stability(&coefficients, gravity, &mut found).ok_or(SystemError::NotCertain)?;
        Ok(found)
    }

    /// All critical speeds above zero, ascending.
    #[must_use]
    pub fn critical_speeds(&self) -> &[CriticalSpeed] {
        &self.critical_speeds
    }

    /// The ranges of speed in which the motion is stable, ascending.
    pub fn stable_ranges(&self) -> impl Iterator<Item = StableRange> {
        self.verdicts.stable_ranges()
    }

    /// Whether the motion is stable at a speed in m/s: stable inside of the stable ranges, and at their ends, which are critical
    /// speeds, marginal.
    ///
    /// # Errors
    /// If the speed is negative or not finite.
    pub fn verdict(&self, speed: f64) -> Result<Verdict, SystemError> {
        require_speed(speed)?;
        self.verdicts.at(speed).ok_or(SystemError::AtRest)
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use proptest::prelude::*;

    use super::CertainStability;
    use crate::stability::Stability;
    use crate::system::{Coefficients, SystemError};

    type Rows = [[f64; 2]; 2];

    const ZERO: Rows = [[0.0; 2]; 2];
    const ONE: Rows = [[1.0, 0.0], [0.0, 1.0]];

    fn rows() -> impl Strategy<Value = Rows> {
        prop::array::uniform2(prop::array::uniform2(-10.0..10.0f64))
    }

    proptest! {
        /// The careful search is of other code: polynomials of any degree in double-double.
        #[test]
        fn is_what_the_careful_search_finds(c0 in rows(), c1 in rows(), k0 in rows(), k2 in rows()) {
            let coefficients = Coefficients::from_rows([ONE, ZERO, c0, c1, ZERO, k0, ZERO, k2]);
            let certain = CertainStability::new(&coefficients, 9.81);
            prop_assume!(certain != Err(SystemError::NotCertain));
            let (certain, careful) = (certain.unwrap(), Stability::careful(&coefficients, 9.81).unwrap());
            let speeds = |critical: &[super::CriticalSpeed]| critical.iter().map(|c| (c.kind, c.change)).collect::<Vec<_>>();
            prop_assert_eq!(speeds(certain.critical_speeds()), speeds(&careful.critical_speeds));
            for (x, y) in certain.critical_speeds().iter().zip(&careful.critical_speeds) {
                prop_assert!((x.speed - y.speed).abs() <= 4.0 * f64::EPSILON * y.speed, "{x:?} {y:?}");
                let beside = 1.01 * x.speed;
                prop_assert_eq!(certain.verdict(beside), careful.verdict(beside));
            }
            prop_assert_eq!(certain.stable_ranges().count(), careful.stable_ranges.len());
        }
    }

    #[test]
    fn says_what_it_cannot_answer() {
        let new = |c0: Rows, k1: Rows, k2: Rows, gravity: f64| {
            CertainStability::new(&Coefficients::<f64, 2>::from_rows([ONE, ZERO, c0, ONE, ONE, ONE, k1, k2]), gravity)
        };
        assert!(new([[3.0, 1.0], [2.0, 5.0]], ZERO, [[-2.0, 1.0], [4.0, 7.0]], 9.81).is_ok());
        // det(K) is (1 - v^2)^2, which touches zero.
        let negative = [[-1.0, 0.0], [0.0, -1.0]];
        assert_eq!(new(ONE, ZERO, negative, 0.0), Err(SystemError::NotCertain));
        assert_eq!(new(ONE, ONE, ONE, 9.81), Err(SystemError::OddPowers));
        assert_eq!(
            new(ONE, ZERO, ONE, f64::INFINITY),
            Err(SystemError::NotFinite { quantity: "gravity", value: f64::INFINITY })
        );
        assert!(matches!(new([[f64::NAN; 2]; 2], ZERO, ONE, 9.81), Err(SystemError::NotFinite { quantity: "C0", .. })));
        let negative_speed = new([[3.0, 1.0], [2.0, 5.0]], ZERO, [[-2.0, 1.0], [4.0, 7.0]], 9.81)
            .and_then(|stability| stability.verdict(-1.0));
        assert_eq!(negative_speed, Err(SystemError::NegativeSpeed { speed: -1.0 }));
    }
}
