//! Which of the position and the rate of a coordinate are states.

/// What the motion goes on from, of one coordinate.
///
/// Of N coordinates of which the positions and the rates are states there are 2N states, and as many eigenvalues; each
/// coordinate of which only one is makes that one less.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum States {
    /// Its position and its rate.
    #[default]
    Both,
    /// Its position alone: a coordinate of first order, such as the deflection of a tyre or what a filter holds. Its column
    /// of M is zero: no acceleration of it matters.
    Position,
    /// Its rate alone, as those of lateral and yaw motion on slipping tyres. Its column of every stiffness matrix is zero: no
    /// position of it matters.
    Rate,
}
