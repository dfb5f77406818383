//! Which mode each eigenvalue belongs to.

use core::fmt;

use nalgebra::Complex;

use super::along_speed::Characteristic;
use super::branches::{Stretch, stretches};
use crate::number::Scalar;
use crate::system::{Coefficients, SystemError, require_speed};

/// A mode of the uncontrolled bicycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Mode {
    /// The front frame swings into line: one eigenvalue.
    Castering,
    /// Slow leaning over: one eigenvalue.
    Capsize,
    /// Oscillation of lean and steer: two eigenvalues.
    Weave,
}

/// Reads `castering`, `capsize`, `weave`.
impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Castering => "castering",
            Self::Capsize => "capsize",
            Self::Weave => "weave",
        })
    }
}

/// One eigenvalue and the mode it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeValue {
    /// The mode.
    pub mode: Mode,
    /// The eigenvalue in 1/s.
    pub value: Complex<f64>,
}

/// The modes of a model with two coordinates, followed along speed.
///
/// Modes are named at the lowest speeds, just above zero, and keep to their eigenvalues from there:
///
/// - of four real eigenvalues the lowest is castering, the next one capsize, the upper two are weave;
/// - of two real ones and a pair the lower real one is castering, the other one capsize, and the pair is weave;
/// - of two pairs the one with the lower real part is castering and capsize, the other one weave.
///
/// Eigenvalues are continuous in the speed. Up to a double-root speed real ones keep their order and pairs stay pairs, so
/// that the names stay, too; two pairs may pass each other, at different real or imaginary parts. At a double-root speed
/// each name passes to the eigenvalue that continues its own. The two that meet are equal there, so that either order of
/// their names is continuous: of two real ones that merge the lower one passes its name to the half of the pair with the
/// negative imaginary part, which passes it to the lower one when the pair splits; real ones that only touch keep their
/// order. So no line jumps, and no eigenvalue is named twice while another one has no name.
///
/// A pair may carry two names: castering and capsize, for one, oscillate as one pair at low speeds of many bicycles.
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
/// let modes = Modes::new(&Coefficients::from_rows([m, zero, c1, zero, k0, k2]), 9.81)?;
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
    stretches: Vec<(Stretch, [Mode; 4])>,
}

impl Modes {
    /// Follows the modes along speed, at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// As [`Stability::new`](crate::Stability::new), and if there are no eigenvalues in the range of `f64` at a speed next
    /// to a double-root speed.
    pub fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        let characteristic = Characteristic::new(coefficients, gravity)?;
        let mut modes = Self { coefficients: coefficients.finite()?, gravity, stretches: Vec::new() };
        for stretch in stretches(&characteristic)? {
            let above = modes.ordered(stretch.near_lower_end(), &stretch)?;
            let names = match modes.stretches.last() {
                None => names_at_rest(above),
                Some((last, names)) => {
                    let below = modes.ordered(last.near_upper_end(), last)?;
                    pass_on(*names, below, above)
                }
            };
            modes.stretches.push((stretch, names));
        }
        Ok(modes)
    }

    /// The eigenvalues at a speed in m/s: castering, capsize, weave, weave.
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
        values.sort_by_key(|value| value.mode);
        Ok(values)
    }

    fn ordered(&self, speed: f64, stretch: &Stretch) -> Result<[Complex<f64>; 4], SystemError> {
        let factored = self.coefficients.at(speed, self.gravity)?.factored_eigenvalues()?;
        Ok(stretch.order.arrange(factored))
    }
}

/// The names in the lowest stretch, by place. Real eigenvalues are in order already; so is a single pair.
fn names_at_rest(ordered: [Complex<f64>; 4]) -> [Mode; 4] {
    use Mode::{Capsize, Castering, Weave};
    let two_pairs = ordered[0].im != 0.0;
    if two_pairs && ordered[2].re < ordered[0].re {
        [Weave, Weave, Castering, Capsize]
    } else {
        [Castering, Capsize, Weave, Weave]
    }
}

/// The names of eigenvalues above a speed from those below it, so that the distances between them sum to the least.
fn pass_on(names: [Mode; 4], below: [Complex<f64>; 4], above: [Complex<f64>; 4]) -> [Mode; 4] {
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
    let mut passed = names;
    for (name, place) in names.into_iter().zip(best.1) {
        passed[place] = name;
    }
    passed
}

/// The difference of distances, relative to them, up to which they count as equal.
const TIE: f64 = 1e-6;
