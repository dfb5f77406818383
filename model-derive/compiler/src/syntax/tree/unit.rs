//! A unit as it is written.

use proc_macro2::Ident;

use crate::report::Region;

/// A product of powers of named units.
#[derive(Clone, Debug)]
pub struct Unit {
    /// As it was written, without spaces.
    pub text: String,
    /// The names, each with its exponent; none for a pure number.
    pub factors: Vec<(Ident, i32)>,
    pub region: Region,
}
