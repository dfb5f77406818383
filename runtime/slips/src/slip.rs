//! A slip in a formula, and its kinds.

use std::fmt;
use std::ops::Range;

/// One slip in the text of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slip {
    /// What kind of slip it is.
    pub kind: Kind,
    /// The bytes of the formula that it replaces.
    pub place: Range<usize>,
    /// What it puts in their place.
    pub replacement: String,
}

impl Slip {
    /// The formula, or the text that it is part of, with the slip.
    pub fn apply(&self, formula: &str) -> String {
        format!("{}{}{}", &formula[..self.place.start], self.replacement, &formula[self.place.end..])
    }

    /// The line of the slip as it was, with the change in braces: `{old -> new}`.
    pub fn show(&self, formula: &str) -> String {
        let Range { start, end } = self.place;
        let from = formula[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let to = formula[end..].find('\n').map_or(formula.len(), |newline| end + newline);
        let [before, old, after] = [from..start, start..end, end..to].map(|range| &formula[range]);
        format!("{}{{{old} -> {}}}{after}", before.trim_start(), self.replacement)
    }
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
    /// A term, or what stands for itself, twice or half as large.
    FactorOfTwo,
    /// A first term that is subtracted.
    Negative,
    /// A name squared.
    Square,
    /// A product with the exponent in the place of the power: `l*2` for `l^2`.
    PowerAsProduct,
    /// A tangent for a sine or cosine or one of these for it, or the argument without the function.
    OtherFunction,
}

impl Kind {
    /// The changes of one token, and what is lost: what the checks of the compiler and of the command line are measured on.
    pub const PLAIN: [Self; 11] = [
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

    /// How unlikely it is, of a slip that makes sense by its units.
    pub fn rank(self) -> u32 {
        match self {
            Self::SignOfTerm | Self::Minus | Self::SimilarName | Self::Factor | Self::Function => 2,
            Self::Term | Self::Exponent | Self::FactorOfTwo | Self::Negative => 2,
            Self::Number | Self::ProductOrQuotient | Self::PowerAsProduct | Self::OtherFunction | Self::Square => 3,
            Self::OtherName => 5,
            Self::SumOrProduct => 6,
        }
    }

    /// How much unlikelier it is where it makes none: who forgets a factor changes the unit, too, but takes no mass for a length.
    pub fn rank_without_sense(self) -> u32 {
        match self {
            Self::OtherName | Self::SimilarName | Self::SumOrProduct => self.rank() + 6,
            _ => self.rank() + 1,
        }
    }
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
            Self::FactorOfTwo => "twice or half",
            Self::Negative => "first term negative",
            Self::Square => "name squared",
            Self::PowerAsProduct => "power as product",
            Self::OtherFunction => "another function",
        })
    }
}
