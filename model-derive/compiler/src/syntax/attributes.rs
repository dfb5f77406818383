//! What a part of a mechanism has, behind its name: `mass mB, at (xB, 0, zB)`.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::declaration::{Inertia, Vector};
use super::expression::{Expression, expression};
use super::items::list;
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
pub enum Attribute {
    Word,
    Formula(Expression),
    Vector(Vector),
    Inertia(Inertia),
}

/// The attributes that a part is given.
#[derive(Debug)]
pub struct Attributes {
    /// What they are of.
    owner: Ident,
    pub given: Vec<(Ident, Attribute)>,
}

/// `: mass mB, at (xB, 0, zB);`
pub fn attributes(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Attributes> {
    if !input.peek(Token![:]) || input.peek(Token![::]) {
        return Err(expected(input, &format!("`:` and what `{owner}` has: {}", words(known))));
    }
    input.parse::<Token![:]>()?;
    let mut attributes = Attributes { owner: owner.clone(), given: Vec::new() };
    attributes.read(input, known)?;
    Ok(attributes)
}

fn words(known: &[(&str, Shape)]) -> String {
    let words: Vec<String> = known.iter().map(|(word, _)| format!("`{word}`")).collect();
    words.join(", ")
}

impl Attributes {
    /// `, through (0, 0, 0), along (1, 0, 0);`
    pub fn after_comma(input: ParseStream<'_>, owner: &Ident, known: &[(&str, Shape)]) -> syn::Result<Self> {
        if input.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(input, &format!("`,` and where the joint is: {}", words(known))));
        }
        let mut attributes = Self { owner: owner.clone(), given: Vec::new() };
        attributes.read(input, known)?;
        Ok(attributes)
    }

    fn read(&mut self, input: ParseStream<'_>, known: &[(&str, Shape)]) -> syn::Result<()> {
        loop {
            let what = format!("one of {}", words(known));
            let word: Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, &what)) };
            let text = word.to_string();
            let Some((_, shape)) = known.iter().find(|(known, _)| *known == text) else {
                let meant = nearest(&text, known.iter().map(|(word, _)| *word));
                let hint = meant.map(|meant| format!("; did you mean `{meant}`?")).unwrap_or_default();
                return Err(error(&word, format!("found `{word}`: expected {what}{hint}")));
            };
            if self.given.iter().any(|(known, _)| *known == word) {
                return Err(error(&word, format!("a second `{word}` of `{}`: expected one", self.owner)));
            }
            let attribute = match shape {
                Shape::Word => Attribute::Word,
                Shape::Formula => Attribute::Formula(expression(input)?),
                Shape::Vector => Attribute::Vector(vector(input, &word)?),
                Shape::Inertia => Attribute::Inertia(inertia(input)?),
            };
            self.given.push((word, attribute));
            if input.parse::<Option<Token![,]>>()?.is_none() {
                return semicolon(input, "`,` or `;`", &format!("what `{}` has", self.owner));
            }
        }
    }

    /// An attribute, if it is given.
    pub fn take(&mut self, word: &str) -> Option<(Ident, Attribute)> {
        let position = self.given.iter().position(|(given, _)| given == word)?;
        Some(self.given.remove(position))
    }

    /// The error of an attribute that is not given.
    pub fn missing(&self, what: &str) -> syn::Error {
        error(&self.owner, format!("`{}` lacks an attribute: expected {what}", self.owner))
    }
}

/// `(x, y, z)`
fn vector(input: ParseStream<'_>, word: &Ident) -> syn::Result<Vector> {
    let what = format!("three components behind `{word}`: `(x, y, z)`");
    if !input.peek(syn::token::Paren) {
        return Err(expected(input, &what));
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
    let found = components.len();
    let components =
        components.try_into().map_err(|_| error(region, format!("{found} components: expected {what}")))?;
    Ok(Vector { components, region })
}

fn inertia(input: ParseStream<'_>) -> syn::Result<Inertia> {
    if !input.peek(syn::token::Bracket) {
        let value = expression(input)?;
        return match &value.kind {
            super::Kind::Number(number) if number.is_zero() => Ok(Inertia::None),
            _ => Err(error(value.region, "expected `[[…], […], […]]`, `[Ixx, Iyy, Izz]`, or `0` for a point mass")),
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
    let message = "expected 3 rows of 3 entries, `[[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]]`";
    let rows: Option<Vec<[Expression; 3]>> = rows.into_iter().map(|(_, row)| row.try_into().ok()).collect();
    match rows.and_then(|rows| <[[Expression; 3]; 3]>::try_from(rows).ok()) {
        Some(rows) => Ok(Inertia::Full(Box::new(rows), region)),
        None => Err(error(region, format!("an inertia matrix of another shape: {message}"))),
    }
}
