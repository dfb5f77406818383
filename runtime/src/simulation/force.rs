//! Forces that are piecewise linear in time.

use core::fmt;

use crate::numeric::sort_by;

/// A force or torque by time, linear between points; before the first and after the last of them it stays as it is there.
///
/// Of two points at one time the second holds from that time on: the force jumps.
///
/// ```
/// use carvallo::simulation::Force;
///
/// // A push of 5 N m between 1 s and 1.2 s.
/// let push = Force::through(&[(0.0, 0.0), (1.0, 0.0), (1.0, 5.0), (1.2, 5.0), (1.2, 0.0)])?;
/// assert_eq!([push.at(0.9), push.at(1.0), push.at(1.1), push.at(1.2)], [0.0, 5.0, 5.0, 0.0]);
///
/// let ramp = Force::through(&[(0.0, 0.0), (2.0, 6.0)])?;
/// assert_eq!([ramp.at(0.5), ramp.at(3.0)], [1.5, 6.0]);
/// # Ok::<(), carvallo::simulation::ForceError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Force {
    /// Times in s that ascend, each with the force there; at least one.
    points: Vec<(f64, f64)>,
}

impl Force {
    /// A force that is always the same.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self { points: vec![(0.0, value)] }
    }

    /// A force through points: times in s, and the force at each.
    ///
    /// # Errors
    /// If there is no point, if a number is not finite, if the times do not ascend, or if more than two are equal.
    pub fn through(points: &[(f64, f64)]) -> Result<Self, ForceError> {
        if points.is_empty() {
            return Err(ForceError::Empty);
        }
        for (index, &(time, force)) in points.iter().enumerate() {
            if let Some(value) = [time, force].into_iter().find(|value| !value.is_finite()) {
                return Err(ForceError::NotFinite { index, value });
            }
            if index > 0 && time < points[index - 1].0 {
                return Err(ForceError::Unsorted { index, before: points[index - 1].0, time });
            }
            if index > 1 && time == points[index - 2].0 {
                return Err(ForceError::Repeated { index, time });
            }
        }
        Ok(Self { points: points.to_vec() })
    }

    /// The force at a time in s; where it jumps, what it jumps to.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        self.line_from(time).0
    }

    /// The force just after a time, and by how much it grows in a second there.
    pub(super) fn line_from(&self, time: f64) -> (f64, f64) {
        match self.points.partition_point(|point| point.0 <= time) {
            0 => (self.points[0].1, 0.0),
            next if next == self.points.len() => (self.points[next - 1].1, 0.0),
            next => {
                let ((from, force), (to, then)) = (self.points[next - 1], self.points[next]);
                let slope = (then - force) / (to - from);
                (force + (time - from) * slope, slope)
            }
        }
    }

    /// The force just before a time.
    pub(super) fn until(&self, time: f64) -> f64 {
        match self.points.partition_point(|point| point.0 < time) {
            0 => self.points[0].1,
            next if next == self.points.len() => self.points[next - 1].1,
            next => {
                let ((from, force), (to, then)) = (self.points[next - 1], self.points[next]);
                if time == to { then } else { force + (time - from) / (to - from) * (then - force) }
            }
        }
    }

    /// The times between two, without these, at which a line ends.
    pub(super) fn knots(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        let (first, end) =
            (self.points.partition_point(|point| point.0 <= from), self.points.partition_point(|point| point.0 < to));
        self.points[first.min(end)..end].iter().map(|point| point.0)
    }
}

/// The times behind one and up to another at which a force has a knot, with the latter: between them all forces are linear.
pub(super) fn pieces(forces: &[Force], from: f64, to: f64) -> Vec<f64> {
    let mut times: Vec<f64> = forces.iter().flat_map(|force| force.knots(from, to)).collect();
    times.push(to);
    sort_by(&mut times, f64::total_cmp);
    times.dedup();
    times
}

/// Why points are no force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ForceError {
    /// There is no point.
    Empty,
    /// A time or a force is infinite or not a number.
    NotFinite {
        /// The place of the point, from 0.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A time is before the one that it follows.
    Unsorted {
        /// The place of the point, from 0.
        index: usize,
        /// The time before it, in s.
        before: f64,
        /// Its time in s.
        time: f64,
    },
    /// More than two points are at one time.
    Repeated {
        /// The place of the third of them, from 0.
        index: usize,
        /// Their time in s.
        time: f64,
    },
}

impl fmt::Display for ForceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("there is no point; a force needs at least one"),
            Self::NotFinite { index, value } => write!(f, "point {}: {value} is not finite", index + 1),
            Self::Unsorted { index, before, time } => {
                write!(f, "point {}: the time {time} s comes behind {before} s; times must ascend", index + 1)
            }
            Self::Repeated { index, time } => {
                write!(f, "point {}: it is the third at {time} s; a jump has two", index + 1)
            }
        }
    }
}

impl core::error::Error for ForceError {}
