//! What a declaration says, as it is written and with where it stands: nothing here is resolved or checked.

mod declaration;
mod display;
mod expression;
mod mechanism;
mod unit;

pub use self::declaration::{
    AskedDerivatives, Assertion, Bound, Compared, Coordinate, Declaration, Definition, Direction, Feedback, Matrix,
    Parameter, ParameterSet, Printed, Published, Relation, Requirement, RustAttribute, SetValue, Value,
};
pub use self::expression::{Expression, Factor, Kind, Term};
pub use self::mechanism::{
    Axis, Body, Force, Free, Freedom, Inertia, Joint, JointKind, Link, Mechanism, Slip, Vector, Wheel,
};
pub use self::unit::Unit;
