//! Tokens to a syntax tree, spans kept: afterwards the declaration parses, and nothing is resolved.
//!
//! `tree` is what there is, and `parse` how it is read.

mod parse;
mod tree;

pub use self::parse::{constant, parse, reserved};
pub use self::tree::{
    Assertion, Axis, Body, Bound, Compared, Coordinate, Declaration, Direction, Expression, Factor, Feedback, Freedom,
    Inertia, Joint, JointKind, Kind, Link, Matrix, Mechanism, Parameter, ParameterSet, Printed, Published, Relation,
    Requirement, RustAttribute, Slip, Term, Unit, Value, Vector, Wheel,
};
// Declarations write the names of matrices.
