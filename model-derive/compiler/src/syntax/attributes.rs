//! What a part of a mechanism has, behind its name: `mass mB, at (xB, 0, zB)`.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::expression::{Expression, expression};
use super::items::list;
use super::parts::{Inertia, Vector};
use super::tokens::{expected, semicolon};
use crate::nearest::nearest;
use crate::report::{Region, error};

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
}

#[derive(Debug)]
enum Attribute {
    Word,
    Formula(Expression),
    Vector(Box<Vector>),
    Inertia(Inertia),
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
        if !input.peek(Token![:]) || input.peek(Token![::]) {
            return Err(expected(input, &format!("`:` and what `{owner}` has: {}", words(known))));
        }
        input.parse::<Token![:]>()?;
        Self::read(input, owner, known)
    }

    /// `, through (0, 0, 0), along (1, 0, 0);`
    pub fn after_comma(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Self> {
        if input.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(input, &format!("`,` and where the joint is: {}", words(known))));
        }
        Self::read(input, owner, known)
    }

    fn read(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Self> {
        let mut given: Vec<(Ident, Attribute)> = Vec::new();
        loop {
            let what = format!("one of {}", words(known));
            let word: Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, &what)) };
            let text = word.to_string();
            let Some((_, shape)) = known.iter().find(|(known, _)| *known == text) else {
                let meant = nearest(&text, known.iter().map(|(word, _)| *word));
                let hint = meant.map(|meant| format!("; did you mean `{meant}`?")).unwrap_or_default();
                return Err(error(&word, format!("found `{word}`: expected {what}{hint}")));
            };
            if given.iter().any(|(known, _)| *known == word) {
                return Err(error(&word, format!("a second `{word}` of `{owner}`: expected one")));
            }
            let attribute = match shape {
                Shape::Word => Attribute::Word,
                Shape::Formula => Attribute::Formula(expression(input)?),
                Shape::Vector => Attribute::Vector(Box::new(vector(input, &word)?)),
                Shape::Inertia => Attribute::Inertia(inertia(input)?),
            };
            given.push((word, attribute));
            if input.parse::<Option<Token![,]>>()?.is_none() {
                semicolon(input, "`,` or `;`", &format!("what `{owner}` has"))?;
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

    /// A vector that must be given.
    pub fn vector(&mut self, word: &str, what: &str) -> syn::Result<Vector> {
        match self.take(word) {
            Some(Attribute::Vector(value)) => Ok(*value),
            _ => Err(self.missing(word, what)),
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

    fn missing(&self, word: &str, what: &str) -> syn::Error {
        error(&self.owner, format!("`{}` has no `{word}`: expected {what}", self.owner))
    }
}

fn words(known: &[(&str, Shape)]) -> String {
    let words: Vec<String> = known.iter().map(|(word, _)| format!("`{word}`")).collect();
    words.join(", ")
}

/// `(x, y, z)`
fn vector(input: ParseStream<'_>, word: &Ident) -> syn::Result<Vector> {
    if !input.peek(syn::token::Paren) {
        return Err(expected(input, &format!("`(x, y, z)` after `{word}`")));
    }
    let content;
    let parentheses = syn::parenthesized!(content in input);
    let region = Region::from(parentheses.span.open()).to(parentheses.span.close().into());
    let mut components = Vec::new();
    while !content.is_empty() {
        components.push(expression(&content)?);
        if !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(&content, "`,` or `)`"));
        }
    }
    let message = format!("{} components of `{word}`: expected three, `(x, y, z)`", components.len());
    let components = components.try_into().map_err(|_| error(region, message))?;
    Ok(Vector { components, region })
}

fn inertia(input: ParseStream<'_>) -> syn::Result<Inertia> {
    if !input.peek(syn::token::Bracket) {
        let value = expression(input)?;
        return match &value.kind {
            super::Kind::Number(number) if number.is_zero() => Ok(Inertia::None),
            _ => {
                let message =
                    "an inertia of one moment: expected `[Ixx, Iyy, Izz]`, `[[…], […], […]]`, or `0` for a point mass";
                Err(error(value.region, message))
            }
        };
    }
    let is_full = {
        let fork = input.fork();
        let content;
        syn::bracketed!(content in fork);
        content.peek(syn::token::Bracket)
    };
    if !is_full {
        let (region, moments) = list(input, "the principal moments", expression)?;
        let found = moments.len();
        let message = format!("{found} moments of inertia: expected three, `[Ixx, Iyy, Izz]`");
        let moments = moments.try_into().map_err(|_| error(region, message))?;
        return Ok(Inertia::Principal(Box::new(moments)));
    }
    let (region, rows) = list(input, "the rows", |input| list(input, "a row `[…]`", expression))?;
    let rows: Option<Vec<[Expression; 3]>> = rows.into_iter().map(|(_, row)| row.try_into().ok()).collect();
    match rows.and_then(|rows| <[[Expression; 3]; 3]>::try_from(rows).ok()) {
        Some(rows) => Ok(Inertia::Full(Box::new(rows))),
        None => {
            let message = "an inertia matrix of another shape: expected 3 rows of 3 entries, `[[Ixx, Ixy, Ixz], [Ixy, Iyy, \
                           Iyz], [Ixz, Iyz, Izz]]`";
            Err(error(region, message))
        }
    }
}
