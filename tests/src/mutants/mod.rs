//! Slips in the formulas of a declaration, one at a time, and what the compiler makes of each.
//!
//! A slip here is the change of one sign, operator, exponent, name, function or number, or the loss of one term or
//! factor; [`all`] makes every one of them that a declaration has room for, and an [`Original`] says which check catches
//! it. A check that was weakened lets more of them through.

mod formulas;
mod slips;
mod tally;
mod verdict;

use std::fmt;

/// The kinds of slips, and a declaration with one of them: the slips that `carvallo check` knows too.
pub use carvallo_slips::{Kind, Slip as Mutant};
pub use slips::all;
pub use tally::Tally;
pub use verdict::{Check, Original, Verdict};

/// What a declaration gives the compiler to check its formulas against, each with all before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// The units of parameters and coordinates, and which matrices are symmetric.
    Units,
    /// How parameters and coordinates lie in the axes.
    Directions,
    /// Parameter sets, and matrices that were published for them.
    Sets,
}

impl Evidence {
    /// All of it.
    pub const ALL: [Self; 3] = [Self::Units, Self::Directions, Self::Sets];
}

impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Units => "units and symmetry",
            Self::Directions => "units, symmetry and directions",
            Self::Sets => "units, symmetry, directions and published matrices",
        })
    }
}

/// The declaration of the Whipple bicycle, with so much of its evidence: what stands between the braces of its source.
///
/// # Panics
/// If the source is not laid out as it is today.
pub fn whipple(evidence: Evidence) -> String {
    let source = include_str!("../../../generated/models/whipple.rs");
    let body = source.split_once('{').and_then(|(_, rest)| rest.rsplit_once('}'));
    let (body, _) = body.expect("a call of the macro with braces");
    if evidence == Evidence::Sets {
        return body.to_string();
    }
    let (formulas, _) = body.split_once("#[default]").expect("a parameter set behind the formulas");
    let mut declaration = format!("{formulas}}}");
    if evidence == Evidence::Units {
        for direction in ["along x*z", "along x", "along z", "about x", "about y", "about z"] {
            declaration = declaration.replace(&format!(", {direction};"), ";");
        }
    }
    declaration
}
