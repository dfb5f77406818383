//! What a part of a mechanism has, behind its name: `mass mB, at (xB, 0, zB)`.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::expressions::parse_expression;
use super::names::parse_name;
use super::tokens::{expected, parse_colon, parse_semicolon};
use super::vectors::{parse_inertia, parse_vector};
use crate::nearest::{ask_for, find_nearest};
use crate::report::error;
use crate::syntax::tree::{Expression, Inertia, Vector};

/// What stands behind the word of an attribute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Nothing.
    Word,
    Formula,
    /// `(x, y, z)`.
    Vector,
    /// `[[…], […], […]]`, `[Ixx, Iyy, Izz]` or `0`.
    Inertia,
    /// The name of a coordinate.
    Name,
}

#[derive(Debug)]
enum Attribute {
    Word,
    Formula(Expression),
    Vector(Box<Vector>),
    Inertia(Inertia),
    Name(Ident),
}

/// The attributes that a part is given, until they are taken.
#[derive(Debug)]
pub struct Attributes {
    /// What they are of.
    owner: Ident,
    given: Vec<(Ident, Attribute)>,
}

impl Attributes {
    /// `: mass mB, at (xB, 0, zB);`
    pub fn after_colon(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Self> {
        parse_colon(input, &format!("`:` and what `{owner}` has: {}", list_words(known)))?;
        Self::read(input, owner, known)
    }

    /// `, through (0, 0, 0), along (1, 0, 0);`
    pub fn after_comma(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Self> {
        if input.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(input, &format!("`,` and where the joint is: {}", list_words(known))));
        }
        Self::read(input, owner, known)
    }

    fn read(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Self> {
        let mut given: Vec<(Ident, Attribute)> = Vec::new();
        loop {
            let what = format!("one of {}", list_words(known));
            let word: Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, &what)) };
            let text = word.to_string();
            let Some((_, shape)) = known.iter().find(|(known, _)| *known == text) else {
                let meant = find_nearest(&text, known.iter().map(|(word, _)| *word));
                let hint = meant.map(ask_for).unwrap_or_default();
                return Err(error(&word, format!("found `{word}`: expected {what}{hint}")));
            };
            if given.iter().any(|(known, _)| *known == word) {
                return Err(error(&word, format!("a second `{word}` of `{owner}`: expected one")));
            }
            let attribute = match shape {
                Shape::Word => Attribute::Word,
                Shape::Formula => Attribute::Formula(parse_expression(input)?),
                Shape::Vector => Attribute::Vector(Box::new(parse_vector(input, &word)?)),
                Shape::Inertia => Attribute::Inertia(parse_inertia(input)?),
                Shape::Name => Attribute::Name(parse_name(input, "the name of a coordinate")?),
            };
            given.push((word, attribute));
            if input.parse::<Option<Token![,]>>()?.is_none() {
                parse_semicolon(input, "`,` or `;`", &format!("what `{owner}` has"))?;
                return Ok(Self { owner: owner.clone(), given });
            }
        }
    }

    /// The word of an attribute that is still there.
    pub fn first(&self) -> Option<&Ident> {
        self.given.first().map(|(word, _)| word)
    }

    /// Whether a word is given that stands alone.
    pub fn word(&mut self, word: &str) -> bool {
        self.take(word).is_some()
    }

    /// A formula that must be given; `what` says what is expected.
    pub fn formula(&mut self, word: &str, what: &str) -> syn::Result<Expression> {
        self.optional(word).ok_or_else(|| self.missing(word, what))
    }

    /// A formula that may be given.
    pub fn optional(&mut self, word: &str) -> Option<Expression> {
        match self.take(word)? {
            Attribute::Formula(value) => Some(value),
            _ => None,
        }
    }

    /// A name that may be given.
    pub fn name(&mut self, word: &str) -> Option<Ident> {
        match self.take(word)? {
            Attribute::Name(name) => Some(name),
            _ => None,
        }
    }

    /// A vector that must be given.
    pub fn vector(&mut self, word: &str, what: &str) -> syn::Result<Vector> {
        match self.take(word) {
            Some(Attribute::Vector(value)) => Ok(*value),
            _ => Err(self.missing(word, what)),
        }
    }

    /// A vector that may be given.
    pub fn optional_vector(&mut self, word: &str) -> Option<Vector> {
        match self.take(word)? {
            Attribute::Vector(value) => Some(*value),
            _ => None,
        }
    }

    /// A moment of inertia that must be given.
    pub fn inertia(&mut self, word: &str, what: &str) -> syn::Result<Inertia> {
        match self.take(word) {
            Some(Attribute::Inertia(value)) => Ok(value),
            _ => Err(self.missing(word, what)),
        }
    }

    fn take(&mut self, word: &str) -> Option<Attribute> {
        let position = self.given.iter().position(|(given, _)| given == word)?;
        Some(self.given.remove(position).1)
    }

    pub fn missing(&self, word: &str, what: &str) -> syn::Error {
        error(&self.owner, format!("`{}` has no `{word}`: expected {what}", self.owner))
    }
}

/// The words of attributes, for a message.
fn list_words(known: &[(&str, Shape)]) -> String {
    let words: Vec<String> = known.iter().map(|(word, _)| format!("`{word}`")).collect();
    words.join(", ")
}
