//! Formulas as text, for messages and documentation.

use std::convert::Infallible;
use std::fmt;

use proc_macro2::Ident;

use super::{Algebra, Decimal, Factor, Formula, Function, Term, Values};

/// A formula as text, with what its outermost operation is: on that depends where it needs parentheses.
#[derive(Clone, Debug)]
pub struct Text {
    text: String,
    outermost: Outermost,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outermost {
    Sum,
    Product,
    Power,
    /// A name, a number or a call.
    Single,
}

impl Text {
    /// A name or a number.
    pub fn single(text: impl fmt::Display) -> Self {
        Self { text: text.to_string(), outermost: Outermost::Single }
    }

    /// A sum.
    pub fn sum(terms: impl IntoIterator<Item = Term<Self>>) -> Self {
        let mut text = String::new();
        for (index, Term { negative, value }) in terms.into_iter().enumerate() {
            text.push_str(match (index, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            text.push_str(&value.enclosed(&[Outermost::Sum]));
        }
        Self { text, outermost: Outermost::Sum }
    }

    /// A product.
    pub fn product(factors: impl IntoIterator<Item = Factor<Self>>) -> Self {
        let mut text = String::new();
        for (index, Factor { inverse, value }) in factors.into_iter().enumerate() {
            text.push_str(match (index, inverse) {
                (0, false) => "",
                (0, true) => "1/",
                (_, false) => "*",
                (_, true) => "/",
            });
            text.push_str(&value.enclosed(&[Outermost::Sum, Outermost::Product]));
        }
        Self { text, outermost: Outermost::Product }
    }

    /// A power.
    pub fn power(self, exponent: i32) -> Self {
        let base = self.enclosed(&[Outermost::Sum, Outermost::Product, Outermost::Power]);
        Self { text: format!("{base}^{exponent}"), outermost: Outermost::Power }
    }

    /// A function of this.
    pub fn argument_of(self, function: impl fmt::Display) -> Self {
        Self::single(format_args!("{function}({})", self.text))
    }

    /// In parentheses if its outermost operation is one of these.
    fn enclosed(self, operations: &[Outermost]) -> String {
        if operations.contains(&self.outermost) { format!("({})", self.text) } else { self.text }
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// What the parameters and definitions of formulas are called.
#[derive(Clone, Debug)]
pub struct Names {
    /// By position.
    pub parameters: Vec<Ident>,
    /// By position.
    pub definitions: Vec<Ident>,
}

impl Names {
    /// A formula as text.
    pub fn text(&self, formula: &Formula) -> Text {
        let Ok(text) = formula.fold(self);
        text
    }

    /// A formula as text with the signs of products before them.
    pub fn text_with_signs_first(&self, formula: &Formula) -> Text {
        self.text(&signs_first(formula))
    }
}

impl Algebra for Names {
    type Value = Text;
    type Error = Infallible;

    fn number(&self, number: &Decimal) -> Result<Text, Infallible> {
        Ok(Text::single(number))
    }

    fn pi(&self) -> Text {
        Text::single("pi")
    }

    fn parameter(&self, index: usize) -> Text {
        Text::single(&self.parameters[index])
    }

    fn definition(&self, index: usize) -> Text {
        Text::single(&self.definitions[index])
    }

    fn sum(&self, terms: impl Values<Term<Text>, Infallible>) -> Result<Text, Infallible> {
        Ok(Text::sum(terms.map(|Ok(term)| term)))
    }

    fn product(&self, factors: impl Values<Factor<Text>, Infallible>) -> Result<Text, Infallible> {
        Ok(Text::product(factors.map(|Ok(factor)| factor)))
    }

    fn power(&self, base: Text, exponent: i32) -> Result<Text, Infallible> {
        Ok(base.power(exponent))
    }

    fn call(&self, function: Function, argument: Text) -> Result<Text, Infallible> {
        Ok(argument.argument_of(function.name()))
    }
}

/// The same formula with the signs of products before them.
fn signs_first(formula: &Formula) -> Formula {
    let all = |factors: &[Factor]| factors.iter().map(|factor| factor.map(signs_first)).collect();
    match formula {
        Formula::Product(factors) => match negated(factors) {
            Some(positive) => Formula::Sum(vec![Term::minus(Formula::Product(all(&positive)))]),
            None => Formula::Product(all(factors)),
        },
        Formula::Sum(terms) => Formula::Sum(terms.iter().map(|term| term.map(signs_first)).collect()),
        Formula::Power(base, exponent) => Formula::Power(Box::new(signs_first(base)), *exponent),
        Formula::Call(function, argument) => Formula::Call(*function, Box::new(signs_first(argument))),
        Formula::Number(_) | Formula::Pi | Formula::Parameter(_) | Formula::Definition(_) => formula.clone(),
    }
}

/// The factors without the sign of a negative number among them, which reads better before all of them.
fn negated(factors: &[Factor]) -> Option<Vec<Factor>> {
    let number = |factor: &Factor| match &factor.value {
        Formula::Sum(terms) => match &terms[..] {
            [Term { negative: true, value }] => Some(value.clone()),
            _ => None,
        },
        _ => None,
    };
    let (at, number) = factors.iter().enumerate().find_map(|(at, factor)| Some((at, number(factor)?)))?;
    let mut positive = factors.to_vec();
    positive[at].value = number;
    if positive.len() > 1 {
        positive.retain(|factor| factor.value != Formula::one());
    }
    Some(positive)
}
