//! What the motion of a mechanism is described by: names, units, kinds.

/// The description of a mechanism that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MotionInfo {
    /// The name of the model.
    pub model: &'static str,
    /// All positions, in the order of the arrays.
    pub positions: &'static [PositionInfo],
    /// For each speed the position whose rate it is.
    pub speeds: &'static [usize],
    /// The positions that the heights of the wheels determine.
    pub dependent: &'static [usize],
    /// The forces and torques that may be applied, in their order.
    pub forces: &'static [AppliedInfo],
    /// The wheels, in their order; the first is the one whose contact point is at x, y.
    pub wheels: &'static [WheelInfo],
}

impl MotionInfo {
    /// The place of the position called `name`.
    #[must_use]
    pub fn position(&self, name: &str) -> Option<usize> {
        self.positions.iter().position(|position| position.name == name)
    }

    /// The place among the speeds of the rate of a position, if it is one of them.
    #[must_use]
    pub fn speed_of(&self, position: usize) -> Option<usize> {
        self.speeds.iter().position(|speed| *speed == position)
    }

    /// The place of the applied force called `name`.
    #[must_use]
    pub fn force(&self, name: &str) -> Option<usize> {
        self.forces.iter().position(|force| force.name == name)
    }
}

/// A position: an angle or a displacement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PositionInfo {
    /// The name of the coordinate. What has no name in the declaration is called as in the paper: `x`, `y`, `psi` (yaw),
    /// `phi` (lean), `pitch`, and `theta` with the name of the wheel for its angle.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
    /// `rad` or `m`; that of its rate is this by second.
    pub unit: &'static str,
    /// What the equations have to do with it.
    pub kind: PositionKind,
}

/// What the equations have to do with a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionKind {
    /// It is free to choose, and the motion depends on it.
    Free,
    /// The heights of the wheels determine it.
    Dependent,
    /// The motion does not depend on it: the place on the ground, the heading, the angle of a wheel.
    Ignorable,
}

/// A force or torque that is applied to a joint or a wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AppliedInfo {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
    /// `N` or `N*m`.
    pub unit: &'static str,
    /// The name of the position that it acts on, as that of a [`PositionInfo`]: a coordinate, or the angle of a wheel.
    pub position: &'static str,
}

/// A wheel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WheelInfo {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
}
