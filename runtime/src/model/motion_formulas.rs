//! The nonlinear equations of motion of a mechanism as text.

/// What accelerations at a state take, by the attributes of a mechanism, as statements: `T0=A1*A2;R0=sin(Q2)*T0`.
///
/// Each line has statements with `;` between them, and each of these gives a name to a formula in names before it. Names are a letter
/// and a number from zero:
///
/// | letter | what it is |
/// | --- | --- |
/// | `A` | an attribute, as they follow each other in [`ModelInfo::attributes`](crate::ModelInfo::attributes) |
/// | `P` | a parameter, as the gravitational field strength |
/// | `C` | one of [`constants`](Self::constants) |
/// | `Q`, `U`, `F` | a position, a speed and an applied force, in the order of [`MotionInfo`](crate::motion::MotionInfo) |
/// | `R` | a result |
/// | `T` | anything else, known in the same text alone |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MotionFormulas {
    /// What does not depend on the state.
    pub constants: &'static [&'static str],
    /// How far the lowest points of the wheels behind the first are below the ground, in m, and then as many steps of Newton's method
    /// for the positions that they determine.
    pub closure: &'static [&'static str],
    /// The rates of all positions, and then their second derivatives.
    pub accelerations: &'static [&'static str],
}
