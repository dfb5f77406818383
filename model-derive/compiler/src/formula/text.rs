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
    /// What begins with a sign, which is that of a whole product as well as of its first factor.
    Negative,
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
        let (mut text, mut outermost) = (String::new(), Outermost::Sum);
        for (index, Term { negative, value }) in terms.into_iter().enumerate() {
            outermost = if index == 0 && negative { Outermost::Negative } else { Outermost::Sum };
            text.push_str(match (index, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            let begins = index == 0 && !negative;
            text.push_str(&value.enclosed(if begins {
                &[Outermost::Sum]
            } else {
                &[Outermost::Sum, Outermost::Negative]
            }));
        }
        Self { text, outermost }
    }

    /// A product.
    pub fn product(factors: impl IntoIterator<Item = Factor<Self>>) -> Self {
        let (mut text, mut outermost) = (String::new(), Outermost::Product);
        for (index, Factor { inverse, value }) in factors.into_iter().enumerate() {
            text.push_str(match (index, inverse) {
                (0, false) => "",
                (0, true) => "1/",
                (_, false) => "*",
                (_, true) => "/",
            });
            if (index, inverse, value.outermost) == (0, false, Outermost::Negative) {
                outermost = Outermost::Negative;
                text.push_str(&value.text);
                continue;
            }
            text.push_str(&value.enclosed(&[Outermost::Sum, Outermost::Negative, Outermost::Product]));
        }
        Self { text, outermost }
    }

    /// A power.
    pub fn power(self, exponent: i32) -> Self {
        let base = self.enclosed(&[Outermost::Sum, Outermost::Negative, Outermost::Product, Outermost::Power]);
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

    /// A formula of the engine's as text in the order in which people write: the signs of products before them, what is
    /// added before what is subtracted, and what multiplies before what divides.
    pub fn text_in_order(&self, formula: &Formula) -> Text {
        self.text(&in_order(formula))
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

/// The same formula in the order in which people write.
fn in_order(formula: &Formula) -> Formula {
    let product = |factors: &[Factor]| {
        let (above, below): (Vec<&Factor>, Vec<&Factor>) = factors.iter().partition(|factor| !factor.inverse);
        let is_one = |factor: &&Factor| factor.value == Formula::one();
        // A reciprocal begins with its one.
        let above: Vec<&Factor> =
            if above.len() > 1 { above.into_iter().filter(|f| !is_one(f)).collect() } else { above };
        above.into_iter().chain(below).map(|factor| factor.map(in_order)).collect()
    };
    match formula {
        Formula::Product(factors) => match negated(factors) {
            Some(positive) => Formula::Sum(vec![Term::minus(Formula::Product(product(&positive)))]),
            None => Formula::Product(product(factors)),
        },
        Formula::Sum(terms) => {
            let terms = terms.iter().map(|term| match (term.negative, in_order(&term.value)) {
                // The sign of a product is that of the term.
                (negative, Formula::Sum(mut inner)) if inner.len() == 1 => {
                    let Term { negative: other, value } = inner.remove(0);
                    Term { negative: negative != other, value }
                }
                (negative, value) => Term { negative, value },
            });
            let (added, subtracted): (Vec<Term>, Vec<Term>) = terms.partition(|term| !term.negative);
            Formula::Sum(added.into_iter().chain(subtracted).collect())
        }
        Formula::Power(base, exponent) => Formula::Power(Box::new(in_order(base)), *exponent),
        Formula::Call(function, argument) => Formula::Call(*function, Box::new(in_order(argument))),
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
