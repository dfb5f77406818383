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
use std::ops::Range;

pub use slips::all;
pub use tally::Tally;
pub use verdict::{Check, Original, Verdict};

/// A declaration with one slip.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// What kind of slip it is.
    pub kind: Kind,
    /// The bytes of the declaration that it replaces.
    pub place: Range<usize>,
    /// What it puts in their place.
    pub replacement: String,
}

impl Mutant {
    /// The declaration with the slip.
    pub fn apply(&self, declaration: &str) -> String {
        format!("{}{}{}", &declaration[..self.place.start], self.replacement, &declaration[self.place.end..])
    }

    /// The line of the slip as it was, with the change in braces: `{old -> new}`.
    pub fn show(&self, declaration: &str) -> String {
        let Range { start, end } = self.place;
        let from = declaration[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let to = declaration[end..].find('\n').map_or(declaration.len(), |newline| end + newline);
        let [before, old, after] = [from..start, start..end, end..to].map(|range| &declaration[range]);
        format!("{}{{{old} -> {}}}{after}", before.trim_start(), self.replacement)
    }
}

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

/// The kinds of slips.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A sum for a difference, or the other way round.
    SignOfTerm,
    /// A product for a quotient, or the other way round.
    ProductOrQuotient,
    /// A sum or difference for a product or quotient, or the other way round.
    SumOrProduct,
    /// A minus sign that has no left side, lost.
    Minus,
    /// An exponent larger or smaller by one.
    Exponent,
    /// Another parameter or definition whose name differs in one letter.
    SimilarName,
    /// Another parameter or definition.
    OtherName,
    /// A factor or divisor lost.
    Factor,
    /// A term lost.
    Term,
    /// A sine for a cosine, or the other way round.
    Function,
    /// A number larger or smaller by one.
    Number,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::SignOfTerm,
        Self::ProductOrQuotient,
        Self::SumOrProduct,
        Self::Minus,
        Self::Exponent,
        Self::SimilarName,
        Self::OtherName,
        Self::Factor,
        Self::Term,
        Self::Function,
        Self::Number,
    ];
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::SignOfTerm => "sign of a term",
            Self::ProductOrQuotient => "product or quotient",
            Self::SumOrProduct => "sum or product",
            Self::Minus => "minus lost",
            Self::Exponent => "exponent off by one",
            Self::SimilarName => "name, one letter off",
            Self::OtherName => "another name",
            Self::Factor => "factor lost",
            Self::Term => "term lost",
            Self::Function => "sine or cosine",
            Self::Number => "number off by one",
        })
    }
}
