//! Everything about stability along speed, of any model.

use core::any::Any;

use super::along_speed::Characteristic;
use super::certain::CertainStability;
use super::critical::CriticalSpeed;
use super::general::{self, Answer};
use super::ranges::{MarginalRange, StableRange, UndecidedRange};
use super::verdict::Verdict;
use super::verdicts::{Stretch, Verdicts};
use super::{careful, fast};
use crate::number::Scalar;
use crate::system::{Coefficients, States, SystemError, require_speed};

/// The critical speeds and the stable ranges of a model, of any number of coordinates.
///
/// Critical speeds are not scanned for. They are all the positive zeros of functions of the speed alone, which are zero
/// where an eigenvalue is (capsize, or divergence) or where two sum to zero (weave, or flutter, if both are imaginary).
///
/// Of two coordinates, whose positions and rates are all states, with C0, C1, Kc, K0 and K2, these are polynomials with
/// coefficients that are known exactly, made from those of the characteristic polynomial
/// `p_4 s^4 + ... + p_0 = det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`:
///
/// - capsize: p_0 = 0, of degree 4;
/// - weave: the Hurwitz determinant `p_1 p_2 p_3 - p_1^2 p_4 - p_0 p_3^2` = 0, of degree 6, with an imaginary pair;
/// - double roots: the discriminant = 0, of degree 12.
///
/// Of any other number N, with C-1 and K1, and for coordinates of which only the position or the rate is a state, they are
/// the product of all eigenvalues and that of all sums of two of them, polynomials in the speed as well, up to a power of it,
/// of a degree that is measured. Of three and four coordinates whose positions and rates are all states they are multiplied out, from
/// the coefficients of the characteristic polynomial, with bounds on rounding. Where that does not make their zeros certain, and of
/// all others, they are interpolated; where the coefficients in an interval do not tell how often one is
/// zero there, anew in a smaller one. Each critical speed is then found to all digits from the equations themselves. That
/// none is missing is checked: at every speed at which eigenvalues were computed by the way, as many of them are
/// unstable as the critical speeds say. Where not, the search goes on by bisection, and what cannot be decided is in
/// [`undecided`](Stability::undecided). Double roots are found where they decide about stability: where without damping
/// imaginary pairs meet.
///
/// Eigenvalues that are zero at all speeds, as without gravity, are set aside first; then the same holds for the
/// others. Eigenvalues that coincide at all speeds make no double-root speed, and a pair that is imaginary at all
/// speeds makes no weave speed.
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
/// let stability = Stability::new(&Coefficients::from_rows([m, zero, zero, c1, zero, k0, zero, k2]), 9.81)?;
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
    /// The ranges of speed in which a critical speed is missing, ascending: none, but where eigenvalues are so close to the
    /// imaginary axis that rounding decides. Always empty for two coordinates with C0, C1, Kc, K0 and K2 alone.
    pub undecided: Vec<UndecidedRange>,
    verdicts: Verdicts<Vec<Stretch>>,
}

impl Stability {
    /// Everything about stability along speed, at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If gravity or an entry is not finite, if the mass matrix is singular, if a critical speed or an eigenvalue leaves the
    /// range of `f64`, or if an iteration does not converge within its bound.
    pub fn new<T: Scalar, const N: usize>(
        coefficients: &Coefficients<T, N>,
        gravity: f64,
    ) -> Result<Self, SystemError> {
        let coefficients = coefficients.widen();
        let has_quartic = !coefficients.has_odd_powers() && coefficients.states == [States::Both; N];
        match (&coefficients as &dyn Any).downcast_ref() {
            Some(two) if has_quartic => Self::of_two(two, gravity),
            _ => Self::general(&coefficients, gravity),
        }
    }

    /// Not generic, so that it is compiled with this crate, as a whole, and not with each that uses it.
    fn of_two(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<Self, SystemError> {
        match Self::fast(coefficients, gravity) {
            Some(stability) => Ok(stability),
            None => Self::careful(coefficients, gravity),
        }
    }

    /// What [`Stability::new`] gives for other than two coordinates, for other powers of the speed, and for coordinates of
    /// which only the position or the rate is a state.
    #[doc(hidden)]
    pub fn general<const N: usize>(coefficients: &Coefficients<f64, N>, gravity: f64) -> Result<Self, SystemError> {
        let Answer { critical_speeds, verdicts, undecided } = general::find_stability(&coefficients.into(), gravity)?;
        Ok(Self { undecided, ..Self::from_verdicts((critical_speeds, verdicts)) })
    }

    /// What [`Stability::new`] gives where it is certain in `f64`.
    ///
    /// Nobody has to choose between this and [`Stability::careful`]. Both are public, but hidden, for the tests that hold
    /// them against each other and against exact arithmetic: these need crates that depend on this one.
    #[doc(hidden)]
    pub fn fast(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Option<Self> {
        let mut found = CertainStability::EMPTY;
        fast::find_stability(coefficients, gravity, &mut found)?;
        Some(Self::from_certain(&found))
    }

    /// What these conditions give where it is certain in `f64`.
    #[cfg(feature = "batch")]
    pub(crate) fn of_conditions<const P: usize, const H: usize, const D: usize>(
        conditions: &fast::conditions::Conditions<P, H, D>,
    ) -> Option<Self> {
        let mut found = CertainStability::EMPTY;
        conditions.find_stability(&mut found)?;
        Some(Self::from_certain(&found))
    }

    fn from_certain(found: &CertainStability) -> Self {
        let stretches = found.verdicts.stretches.to_vec();
        Self::from_verdicts((found.critical_speeds.to_vec(), Verdicts { stretches }))
    }

    /// What [`Stability::new`] gives where `f64` is not enough.
    #[doc(hidden)]
    pub fn careful(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<Self, SystemError> {
        let characteristic = Characteristic::new(coefficients, gravity)?;
        careful::find_stability(&characteristic).map(Self::from_verdicts)
    }

    fn from_verdicts((critical_speeds, verdicts): (Vec<CriticalSpeed>, Verdicts<Vec<Stretch>>)) -> Self {
        let stable_ranges = verdicts.stable_ranges().collect();
        Self { critical_speeds, stable_ranges, undecided: Vec::new(), verdicts }
    }

    /// Whether the motion is stable at a speed in m/s.
    ///
    /// It agrees with the stable ranges at every number: stable inside, and at their ends, which are critical speeds,
    /// marginal.
    ///
    /// # Errors
    /// If the speed is negative or not finite, or if it is zero and there is a C-1.
    pub fn verdict(&self, speed: f64) -> Result<Verdict, SystemError> {
        require_speed(speed)?;
        self.verdicts.at(speed).ok_or(SystemError::AtRest)
    }

    /// The ranges of speed in which the motion is marginal, ascending.
    pub fn marginal_ranges(&self) -> Vec<MarginalRange> {
        self.verdicts.marginal_ranges()
    }

    /// Whether the motion is stable just below and just above one of the critical speeds: the same, unless it is one at which
    /// that changes. An eigenvalue may change sides while another one keeps the motion unstable.
    pub fn verdicts_around(&self, critical: &CriticalSpeed) -> [Verdict; 2] {
        self.verdicts.around(critical.speed)
    }
}

#[cfg(test)]
mod tests {
    use super::Stability;
    use crate::characteristic::determinant::Rows;
    use crate::stability::{Change, CriticalKind, CriticalSpeed, MarginalRange, Modes, StableRange, Verdict};
    use crate::system::{Coefficients, SystemError};

    const ZERO: Rows = [[0.0; 2]; 2];
    const ONE: Rows = diagonal(1.0, 1.0);

    const fn diagonal(x: f64, y: f64) -> Rows {
        [[x, 0.0], [0.0, y]]
    }

    /// M q'' + (C0 + v C1) q' + (Kc + v^2 K2) q with M = 1.
    fn stability(c0: Rows, c1: Rows, kc: Rows, k2: Rows) -> Stability {
        let coefficients = Coefficients::<f64, 2>::from_rows([ONE, ZERO, c0, c1, kc, ZERO, ZERO, k2]);
        Modes::new(&coefficients, 0.0).expect("modes of a regular system");
        Stability::new(&coefficients, 0.0).expect("stability of a regular system")
    }

    fn assert_speeds(stability: &Stability, expected: &[(CriticalKind, f64, Change)]) {
        let found = stability.critical_speeds.iter().map(|critical| (critical.kind, critical.speed, critical.change));
        let found: Vec<_> = found.collect();
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!(found.0 == expected.0 && found.2 == expected.2, "{found:?}");
            assert!((found.1 - expected.1).abs() <= 1e-14 * expected.1, "{found:?}");
        }
    }

    /// s^2 + (v - 1) s + 4 and s^2 + 3 s + 5 - v^2, uncoupled.
    #[test]
    fn uncoupled_coordinates_are_critical_each_on_its_own() {
        let stability = stability(diagonal(-1.0, 3.0), diagonal(1.0, 0.0), diagonal(4.0, 5.0), diagonal(0.0, -1.0));
        assert_eq!(stability.stable_ranges, [StableRange { from: 1.0, to: Some(5f64.sqrt()) }]);
        let kinds = stability.critical_speeds.iter().filter(|critical| critical.kind != CriticalKind::DoubleRoot);
        let kinds: Vec<_> = kinds.map(|critical| (critical.kind, critical.change, critical.eigenvalue.im)).collect();
        let weave = (CriticalKind::Weave, Change::Stabilizes, 2.0);
        assert_eq!(kinds, [weave, (CriticalKind::Capsize, Change::Destabilizes, 0.0)]);
        // Discriminants: 9 - 4 (5 - v^2) and (v - 1)^2 - 16.
        for (speed, change) in [(11f64.sqrt() / 2.0, Change::Splits), (5.0, Change::Splits)] {
            let is_there = |critical: &CriticalSpeed| (critical.speed - speed).abs() < 1e-14 * speed;
            assert!(stability.critical_speeds.iter().any(|critical| is_there(critical) && critical.change == change));
        }
    }

    /// Without damping the eigenvalues are symmetric: s^4 + 5 s^2 + 4 + v^4. Two imaginary pairs meet at v^4 = 9/4.
    #[test]
    fn undamped_motion_is_marginal_up_to_flutter() {
        let stability = stability(ZERO, ZERO, diagonal(1.0, 4.0), [[0.0, 1.0], [-1.0, 0.0]]);
        let flutter = 2.25f64.sqrt().sqrt();
        assert_speeds(&stability, &[(CriticalKind::DoubleRoot, flutter, Change::Destabilizes)]);
        assert!((stability.critical_speeds[0].eigenvalue.im - 2.5f64.sqrt()).abs() < 1e-7);
        assert!(stability.stable_ranges.is_empty());
        let marginal = stability.marginal_ranges();
        assert!(marginal.len() == 1 && marginal[0].from == 0.0, "{marginal:?}");
        assert!((marginal[0].to.unwrap() - flutter).abs() <= 1e-14 * flutter, "{marginal:?}");
        let verdicts = [0.0, 1.0, flutter + 0.1].map(|speed| stability.verdict(speed));
        assert_eq!(verdicts, [Ok(Verdict::Marginal), Ok(Verdict::Marginal), Ok(Verdict::Unstable)]);
    }

    /// Undamped, s^2 + 1 - v^2 and s^2 + 4: an imaginary pair becomes a real one, +-s, through zero.
    #[test]
    fn undamped_motion_capsizes_through_a_double_zero() {
        let stability = stability(ZERO, ZERO, diagonal(1.0, 4.0), diagonal(-1.0, 0.0));
        let capsize = (CriticalKind::Capsize, 1.0, Change::Destabilizes);
        assert_speeds(&stability, &[capsize, (CriticalKind::DoubleRoot, 1.0, Change::Splits)]);
        assert_eq!([0.5, 1.5].map(|speed| stability.verdict(speed)), [Ok(Verdict::Marginal), Ok(Verdict::Unstable)]);
    }

    /// Damping (v - 1) of both coordinates: both pairs cross the axis at once, and the determinant keeps its sign.
    #[test]
    fn pairs_that_cross_together_are_both_found() {
        let stability = stability(diagonal(-1.0, -1.0), ONE, diagonal(1.0, 4.0), ZERO);
        let weave = stability.critical_speeds.iter().filter(|critical| critical.kind == CriticalKind::Weave);
        let mut frequencies: Vec<f64> = weave.map(|critical| critical.eigenvalue.im).collect();
        frequencies.sort_by(f64::total_cmp);
        assert_eq!(frequencies, [1.0, 2.0]);
        assert_eq!(stability.stable_ranges, [StableRange { from: 1.0, to: None }]);
        assert_eq!(stability.verdict(1.0), Ok(Verdict::Marginal));
        let around = stability.verdicts_around(&stability.critical_speeds[0]);
        assert_eq!(around, [Verdict::Unstable, Verdict::Stable]);
    }

    /// A free coordinate has an eigenvalue that is zero at all speeds: the motion is marginal at best.
    #[test]
    fn a_zero_eigenvalue_at_all_speeds_is_set_aside() {
        let stability = stability(diagonal(1.0, -1.0), diagonal(0.0, 1.0), diagonal(0.0, 4.0), ZERO);
        let weave = (CriticalKind::Weave, 1.0, Change::Stabilizes);
        assert!(stability.critical_speeds.iter().any(|found| (found.kind, found.speed, found.change) == weave));
        assert!(stability.critical_speeds.iter().all(|critical| critical.kind != CriticalKind::Capsize));
        assert_eq!([0.5, 1.0, 2.0].map(|speed| stability.verdict(speed).unwrap()), {
            [Verdict::Unstable, Verdict::Marginal, Verdict::Marginal]
        });
        assert_eq!(stability.marginal_ranges(), [MarginalRange { from: 1.0, to: None }]);
    }

    #[test]
    fn motion_that_does_not_depend_on_the_speed_has_no_critical_speed() {
        let damped = stability(ONE, ZERO, ONE, ZERO);
        assert!(damped.critical_speeds.is_empty());
        assert_eq!(damped.stable_ranges, [StableRange { from: 0.0, to: None }]);
        assert_eq!(damped.verdict(0.0), Ok(Verdict::Stable));
        assert!(damped.marginal_ranges().is_empty());
        let free = stability(ZERO, ZERO, ZERO, ZERO);
        assert!(free.critical_speeds.is_empty() && free.stable_ranges.is_empty());
        assert_eq!(free.verdict(3.0), Ok(Verdict::Marginal));
        assert_eq!(free.marginal_ranges(), [MarginalRange { from: 0.0, to: None }]);
    }

    #[test]
    fn errors_name_what_is_wrong() {
        let stability = stability(ONE, ZERO, ONE, ZERO);
        assert_eq!(stability.verdict(-1.0), Err(SystemError::NegativeSpeed { speed: -1.0 }));
        let singular =
            Coefficients::<f64, 2>::from_rows([[[1.0, 2.0], [2.0, 4.0]], ZERO, ZERO, ONE, ONE, ZERO, ZERO, ZERO]);
        assert_eq!(Stability::new(&singular, 0.0), Err(SystemError::SingularMass));
        let infinite =
            Coefficients::<f64, 2>::from_rows([ONE, ZERO, ZERO, ONE, diagonal(f64::INFINITY, 1.0), ZERO, ZERO, ZERO]);
        let error = SystemError::NotFinite { quantity: "Kc", value: f64::INFINITY };
        assert_eq!(Stability::new(&infinite, 0.0), Err(error));
    }
}
