//! Which mode each eigenvalue belongs to.

use core::ops::Range;

use nalgebra::Complex;

use super::along_speed::Characteristic;
use super::mode::Mode;
use super::naming::{self, Course, Names};
use super::stretches::{Stretch, stretches};
use super::{CriticalKind, CriticalSpeed, Stability};
use crate::number::Scalar;
use crate::numeric::sort_by;
use crate::system::{Coefficients, States, SystemError, require_speed};

/// One eigenvalue and the mode it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct ModeValue {
    /// The mode.
    pub mode: Mode,
    /// The eigenvalue in 1/s.
    #[cfg_attr(feature = "serde", serde(with = "super::complex::Parts"))]
    pub value: Complex<f64>,
}

/// The modes of a bicycle, a model whose two coordinates are lean and steer, followed along speed.
///
/// Eigenvalues are continuous in the speed. They lose themselves at double-root speeds only: two real eigenvalues that
/// meet become a pair, or a pair becomes two real ones, and which is which on the other side is nothing that the equations
/// tell. Between double-root speeds real eigenvalues keep their order and pairs stay pairs; two pairs may pass each other,
/// at different real or imaginary parts. So a name holds from one double-root speed to the next, and is given by these
/// rules:
///
/// 1. *Crossing.* A pair on the imaginary axis is weave and an eigenvalue that is zero is capsize, from the double-root
///    speed before to the one after: that is what weave and capsize speeds are
///    ([`CriticalKind`](super::CriticalKind)). This rule has no exception, so that kinds and modes cannot contradict.
/// 2. *One pair.* At the highest speeds with one pair and two real eigenvalues the pair is weave. Of the two real ones
///    that which is zero at a capsize speed is capsize, or else the slower one, of the smaller size toward the upper end
///    of these speeds, and the other one is castering.
/// 3. *Continuity.* From there names pass down, and up, through double roots. Either order of the names of two that meet
///    is continuous; the lower real eigenvalue corresponds to the half of the pair with the negative imaginary part, or
///    the higher one where only that agrees with rule 1. So castering and capsize may be one pair, which bears two names.
/// 4. *Where continuity would contradict rule 1* at the next lower speeds with one pair or on the way there, those are
///    named by rule 2, anew. On the way, an eigenvalue bears a name that continues both sides. If there is none it has no
///    name, and is called [`Real`](Mode::Real) or [`Oscillatory`](Mode::Oscillatory); so is each that has a name which
///    rule 1 gives to another one. Where there is one pair at no speed, all that do not cross are.
///
/// Most bicycles need no more than the first three. The fourth is for machines whose weave, once stable, splits into two
/// real eigenvalues of which one goes on as capsize.
/// None of the rules knows forward from backward: a bicycle that runs backwards has the negatives of its eigenvalues, and
/// the same names.
///
/// ```
/// use carvallo::{Coefficients, Mode, Modes};
///
/// // The benchmark bicycle, with its weave mode as a pair from 0.684 m/s on.
/// let zero = [[0.0; 2]; 2];
/// let m = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
/// let c1 = [[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
/// let k0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
/// let k2 = [[0.0, 76.59734589573222], [0.0, 2.65431523794604]];
/// let modes = Modes::new(&Coefficients::from_rows([m, zero, zero, c1, zero, k0, zero, k2]), 9.81)?;
///
/// let [castering, capsize, weave, other_half] = modes.at(5.0)?;
/// assert_eq!(weave.mode, Mode::Weave);
/// assert!((castering.value.re + 14.078389692798).abs() < 1e-10);
/// assert!((capsize.value.re + 0.322866429004).abs() < 1e-10);
/// assert!((weave.value.im + 4.464867713788).abs() < 1e-10);
/// assert_eq!(other_half.value, weave.value.conj());
/// # Ok::<(), carvallo::SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    coefficients: Coefficients<f64, 2>,
    gravity: f64,
    /// Ascending, the first one from zero; with each the names that belong to the places of its order.
    stretches: Vec<(Stretch, Names)>,
}

impl Modes {
    /// Follows the modes along speed, at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// As [`Stability::new`], with a C-1 or a K1, and if there are no eigenvalues in the range of `f64` at a speed next to a double-root speed.
    pub fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        Self::of(coefficients.widen(), gravity)
    }

    fn of(coefficients: Coefficients<f64, 2>, gravity: f64) -> Result<Self, SystemError> {
        if coefficients.has_odd_powers() || coefficients.states != [States::Both; 2] {
            return Err(SystemError::OddPowers);
        }
        let stretches = stretches(&Characteristic::new(&coefficients, gravity)?)?;
        let critical_speeds = Stability::new(&coefficients, gravity)?.critical_speeds;
        let mut modes = Self { coefficients, gravity, stretches: Vec::new() };
        let courses = modes.courses(&stretches, &critical_speeds)?;
        modes.stretches = stretches.into_iter().zip(naming::names(&courses)).collect();
        Ok(modes)
    }

    /// The four eigenvalues at a speed in m/s with their modes, in the order of [`Mode`].
    ///
    /// They are those of [`System::quartic_eigenvalues`](crate::System::quartic_eigenvalues), each of them once.
    ///
    /// # Errors
    /// If the speed is negative or not finite, or if the eigenvalues there leave the range of `f64`.
    pub fn at(&self, speed: f64) -> Result<[ModeValue; 4], SystemError> {
        require_speed(speed)?;
        let above = self.stretches.partition_point(|(stretch, _)| stretch.from <= speed);
        let (stretch, names) = &self.stretches[above.max(1) - 1];
        let ordered = self.ordered(speed, stretch)?;
        let mut values: [ModeValue; 4] = core::array::from_fn(|i| ModeValue { mode: names[i], value: ordered[i] });
        sort_by(&mut values, |x, y| x.mode.cmp(&y.mode));
        Ok(values)
    }

    /// The modes that there are at one speed or another, ascending: each as often as it has eigenvalues at most. Castering,
    /// capsize, and weave twice are always among them.
    pub fn all(&self) -> Vec<Mode> {
        let usual = [Mode::Castering, Mode::Capsize, Mode::Weave, Mode::Weave];
        let everywhere = || self.stretches.iter().map(|(_, names)| names).chain([&usual]);
        let most = |mode: Mode| everywhere().map(|names| names.iter().filter(|&&name| name == mode).count()).max();
        let modes = [Mode::Castering, Mode::Capsize, Mode::Weave, Mode::Real, Mode::Oscillatory];
        modes.into_iter().flat_map(|mode| core::iter::repeat_n(mode, most(mode).unwrap_or(0))).collect()
    }

    fn ordered(&self, speed: f64, stretch: &Stretch) -> Result<[Complex<f64>; 4], SystemError> {
        let factored = self.coefficients.at(speed, self.gravity)?.factored_eigenvalues()?;
        Ok(stretch.order.arrange(factored))
    }

    fn courses(&self, stretches: &[Stretch], critical_speeds: &[CriticalSpeed]) -> Result<Vec<Course>, SystemError> {
        let mut courses = Vec::with_capacity(stretches.len());
        for (i, stretch) in stretches.iter().enumerate() {
            let (pairs, near) = (stretch.order.pairs(), self.ordered(stretch.near_upper_end(), stretch)?);
            let (at_end, onward) = match stretches.get(i + 1) {
                Some(next) => (near, nearest(near, self.ordered(next.near_lower_end(), next)?)),
                // Where the speeds have no end.
                None => (self.ordered(FAR * stretch.to, stretch).unwrap_or(near), [0, 1, 2, 3]),
            };
            let mut crosses = [None; 4];
            let is_in = |critical: &&CriticalSpeed| {
                critical.speed >= stretch.from && stretches.get(i + 1).is_none_or(|next| critical.speed < next.from)
            };
            for critical in critical_speeds.iter().filter(is_in) {
                let mode = match critical.kind {
                    CriticalKind::Weave => Mode::Weave,
                    CriticalKind::Capsize => Mode::Capsize,
                    CriticalKind::DoubleRoot => continue,
                };
                for place in crossing(critical, self.ordered(critical.speed, stretch)?, pairs) {
                    crosses[place] = Some(mode);
                }
            }
            courses.push(Course { pairs, crosses, at_end, onward });
        }
        Ok(courses)
    }
}

/// The places of the eigenvalues that are on the imaginary axis at a critical speed: of a pair, or of a real one.
fn crossing(critical: &CriticalSpeed, ordered: [Complex<f64>; 4], pairs: usize) -> Vec<usize> {
    let distance = |&place: &usize| (ordered[place] - Complex::new(0.0, critical.eigenvalue.im)).norm();
    let first_of_pairs = 4 - 2 * pairs;
    let closest = |places: Range<usize>| places.min_by(|i, j| distance(i).total_cmp(&distance(j)));
    match critical.kind {
        CriticalKind::Weave => closest(first_of_pairs..4).into_iter().flat_map(|half| [half, half ^ 1]).collect(),
        _ => closest(0..first_of_pairs).into_iter().collect(),
    }
}

/// By place below a speed the place above it, so that the distances between them sum to the least.
fn nearest(below: [Complex<f64>; 4], above: [Complex<f64>; 4]) -> [usize; 4] {
    let orders = (0..256).map(|code| [code / 64, code / 16 % 4, code / 4 % 4, code % 4]);
    let permutations = orders.filter(|order| (0..4).all(|place| order.contains(&place)));
    let mut best = (f64::INFINITY, [0, 1, 2, 3]);
    for order in permutations {
        let distance: f64 = (0..4).map(|i| (below[i] - above[order[i]]).norm()).sum();
        // What merges or splits is as far from either half of a pair. Of such orders the first one keeps real parts and
        // imaginary parts ascending.
        if distance < best.0 * (1.0 - TIE) {
            best = (distance, order);
        }
    }
    best.1
}

/// How many times as high as the last double-root speed slow and fast modes are told apart.
const FAR: f64 = 64.0;

/// The difference of distances, relative to them, up to which they count as equal.
const TIE: f64 = 1e-6;
