//! The eigenvalues of any number of coordinates, followed one by one along speed.

mod assign;
mod follow;
mod names;
#[cfg(test)]
mod tests;

use core::fmt;

use nalgebra::Complex;

use self::assign::{cleaned, closest};
use self::follow::{Eigenvalues, Node, follow};
use self::names::Named;
use super::critical::CriticalSpeed;
use super::mode::Mode;
use super::modes::ModeValue;
use crate::number::Scalar;
use crate::numeric::sort_by;
use crate::system::{Coefficients, SystemError, require_speed};

pub use self::follow::Meeting;

/// The eigenvalues of any number of coordinates along speed, one branch for each, of which each is continuous.
///
/// They are followed from speed to speed, in steps so short that each moves little beside its distance from the others; so
/// pairs that pass each other keep apart, however close they come. Where two coincide, as where two real ones become a pair,
/// nothing tells which goes on as which: that is a [`Meeting`], behind which a branch goes on as one of them. Unlike critical
/// speeds meetings are found by steps: what begins and ends between two of them is not seen.
///
/// At a critical speed the branch that is on the imaginary axis is called by what happens there, as
/// [`CriticalSpeed::mode`] has it, and so it is from the meeting before to the one behind, of several such speeds by the
/// first. Stretches of a branch without a critical speed take the name of the nearest that has one; a branch that has none
/// anywhere is [`Real`](Mode::Real) or [`Oscillatory`](Mode::Oscillatory), as it comes. For bicycles with two coordinates
/// [`Modes`](super::Modes) tells more.
///
/// ```
/// use carvallo::{Branches, Coefficients, Mode, Stability};
///
/// // Two oscillators, of which the slower one, s^2 + (1 - v) s + 4, flutters at v = 1, and the other is s^2 + s + 9.
/// let zero = [[0.0; 2]; 2];
/// let diagonal = |x: f64, y: f64| [[x, 0.0], [0.0, y]];
/// let (damping, stiffness) = (diagonal(1.0, 1.0), diagonal(4.0, 9.0));
/// let matrices = [diagonal(1.0, 1.0), zero, damping, diagonal(-1.0, 0.0), stiffness, zero, zero, zero];
/// let coefficients = Coefficients::<f64, 2>::from_rows(matrices);
///
/// let critical_speeds = Stability::new(&coefficients, 0.0)?.critical_speeds;
/// let branches = Branches::new(&coefficients, 0.0, &critical_speeds, [0.0, 2.0], false)?;
/// let modes: Vec<Mode> = branches.at(0.5)?.iter().map(|value| value.mode).collect();
/// assert_eq!(modes, [Mode::Flutter, Mode::Flutter, Mode::Oscillatory, Mode::Oscillatory]);
/// # Ok::<(), carvallo::SystemError>(())
/// ```
pub struct Branches {
    eigenvalues: Box<Eigenvalues>,
    /// Ascending by speed.
    nodes: Vec<Node>,
    meetings: Vec<Meeting>,
    names: Vec<Vec<Named>>,
}

/// So many steps are made at least.
const STEPS: u32 = 64;

impl Branches {
    /// Follows them over a range of speeds in m/s, the first not above the second, at a gravitational field strength in N/kg.
    ///
    /// The critical speeds are those of [`Stability`](super::Stability) for the same; of those in the range the branches have
    /// their names, and `is_bicycle` says whether these are the names of bicycles and motorcycles, machines that lean and
    /// steer.
    ///
    /// # Errors
    /// If a speed is negative or not finite, if there is a C-1 and the first one is zero, or if there are no eigenvalues at
    /// some speed in the range.
    pub fn new<T: Scalar, const N: usize>(
        coefficients: &Coefficients<T, N>,
        gravity: f64,
        critical_speeds: &[CriticalSpeed],
        [from, to]: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Self, SystemError> {
        let coefficients = coefficients.widen();
        let eigenvalues = move |speed: f64| coefficients.at(speed, gravity)?.eigenvalues();
        Self::of(Box::new(eigenvalues), critical_speeds, [from, to], is_bicycle)
    }

    /// Follows eigenvalues that depend on anything else as those of a system depend on the speed, such as on a parameter: over a
    /// range of what they are a function of, from zero or above, as speeds are.
    ///
    /// The critical ones have their places in the range for speeds, and names come from them as from critical speeds.
    ///
    /// ```
    /// use carvallo::{Branches, Complex};
    ///
    /// // An oscillator, s^2 + 2 d s + 1 with the damping d for the parameter, which goes on without oscillating from d = 1 on.
    /// let eigenvalues = |d: f64| {
    ///     let root = Complex::new(d * d - 1.0, 0.0).sqrt();
    ///     Ok(vec![-d - root, -d + root])
    /// };
    /// let branches = Branches::follow(eigenvalues, &[], [0.0, 3.0], false)?;
    /// assert!((branches.meetings()[0].speed - 1.0).abs() < 1e-5);
    /// # Ok::<(), carvallo::SystemError>(())
    /// ```
    ///
    /// # Errors
    /// If an end of the range is negative or not finite, or if the function has an error somewhere in it.
    pub fn follow(
        eigenvalues: impl Fn(f64) -> Result<Vec<Complex<f64>>, SystemError> + Send + Sync + 'static,
        critical: &[CriticalSpeed],
        range: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Self, SystemError> {
        Self::of(Box::new(eigenvalues), critical, range, is_bicycle)
    }

    fn of(
        eigenvalues: Box<Eigenvalues>,
        critical_speeds: &[CriticalSpeed],
        [from, to]: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Self, SystemError> {
        require_speed(from)?;
        require_speed(to)?;
        let even = (0..=STEPS).map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS));
        let mut speeds: Vec<f64> = even.collect();
        speeds.dedup();
        let (nodes, meetings) = follow(&eigenvalues, &speeds)?;
        let mut branches = Self { eigenvalues, nodes, meetings, names: Vec::new() };
        branches.names = branches.find_names(critical_speeds, is_bicycle)?;
        Ok(branches.ordered())
    }

    /// In the order that they are told in.
    fn ordered(mut self) -> Self {
        let Self { nodes, meetings, names, .. } = &mut self;
        let order = order(nodes, names);
        for node in nodes {
            node.values = order.iter().map(|&branch| node.values[branch]).collect();
        }
        for branch in meetings.iter_mut().flat_map(|meeting| &mut meeting.branches) {
            *branch = order.iter().position(|other| other == branch).unwrap_or(*branch);
        }
        meetings.iter_mut().for_each(|meeting| sort_by(&mut meeting.branches, usize::cmp));
        *names = order.iter().map(|&branch| core::mem::take(&mut names[branch])).collect();
        self
    }

    /// The eigenvalues at a speed in m/s, one for each [state](crate::States), in the order of the branches: those with names
    /// first, in the order of [`Mode`], then by their size at the lowest speed.
    ///
    /// They are those of [`System::eigenvalues`](crate::System::eigenvalues). Beyond the range that was followed they are
    /// followed from its end.
    ///
    /// # Errors
    /// If the speed is negative or not finite, or if there are no eigenvalues there.
    pub fn at(&self, speed: f64) -> Result<Vec<ModeValue>, SystemError> {
        require_speed(speed)?;
        let values = self.values(speed)?;
        let value = |(branch, value): (usize, Complex<f64>)| ModeValue { mode: self.mode(branch, speed, value), value };
        Ok(values.into_iter().enumerate().map(value).collect())
    }

    /// Where branches meet, ascending.
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings
    }

    fn values(&self, speed: f64) -> Result<Vec<Complex<f64>>, SystemError> {
        let above = self.nodes.partition_point(|node| node.speed < speed);
        let (below, above) = (above.checked_sub(1).map(|below| &self.nodes[below]), self.nodes.get(above));
        let near = match (below, above) {
            (_, Some(above)) if above.speed == speed => return Ok(above.values.clone()),
            (Some(below), Some(above)) => {
                let values = (self.eigenvalues)(speed)?;
                // Between two that meet there are as many real ones as at one of both ends.
                let count = |values: &[Complex<f64>]| values.iter().filter(|value| value.im == 0.0).count();
                let fits = count(&cleaned(&below.values)) == count(&cleaned(&values));
                return Ok(arranged(if fits { below } else { above }, &values));
            }
            (Some(end), None) | (None, Some(end)) => end,
            (None, None) => return Ok(Vec::new()),
        };
        let step = |step: u32| near.speed + (speed - near.speed) * f64::from(step) / f64::from(STEPS);
        let mut node = near.clone();
        for speed in (1..=STEPS).map(step) {
            node.values = arranged(&node, &(self.eigenvalues)(speed)?);
        }
        Ok(node.values)
    }

    fn name(&self, branch: usize, speed: f64) -> Option<Mode> {
        let stretches = &self.names[branch];
        stretches[stretches.partition_point(|(from, _)| *from <= speed).max(1) - 1].1
    }

    fn mode(&self, branch: usize, speed: f64, value: Complex<f64>) -> Mode {
        let plain = if value.im == 0.0 { Mode::Real } else { Mode::Oscillatory };
        self.name(branch, speed).unwrap_or(plain)
    }
}

impl fmt::Debug for Branches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Branches").field("meetings", &self.meetings).field("names", &self.names).finish_non_exhaustive()
    }
}

/// The eigenvalues in the places of the nearest ones of a node.
fn arranged(node: &Node, values: &[Complex<f64>]) -> Vec<Complex<f64>> {
    closest(&cleaned(&node.values), &cleaned(values)).into_iter().map(|place| values[place]).collect()
}

/// The order of the branches.
fn order(nodes: &[Node], names: &[Vec<Named>]) -> Vec<usize> {
    let Some(first) = nodes.first() else { return Vec::new() };
    let name = |branch: usize| names[branch].iter().find_map(|(_, name)| *name);
    let key = |branch: usize| (name(branch).is_none(), name(branch));
    let mut order: Vec<usize> = (0..first.values.len()).collect();
    sort_by(&mut order, |&i, &j| {
        let sizes = [i, j].map(|branch| first.values[branch].norm());
        // The halves of a pair stand together, that with the negative imaginary part first.
        key(i).cmp(&key(j)).then(sizes[0].total_cmp(&sizes[1])).then(first.values[i].im.total_cmp(&first.values[j].im))
    });
    order
}
