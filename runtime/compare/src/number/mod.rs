//! Numbers in which generated code, formulas and functions by hand are evaluated to learn something of them.

mod counted;
mod exact;
mod operations;
mod real;

pub use counted::{Counted, count};
pub use exact::Exact;
pub use operations::Operations;
pub use real::Real;
