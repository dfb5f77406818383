//! Formulas without a source to formulas as if they were written in the declaration.

use proc_macro2::{Ident, Span};

use crate::check::resolve;
use crate::model::Expr;
use crate::report::Region;
use crate::syntax::{Expression, Factor, Kind, Term};

/// What parameters and definitions are called.
pub struct Names {
    pub parameters: Vec<Ident>,
    pub definitions: Vec<Ident>,
    /// Where the formulas are said to stand.
    pub span: Span,
}

impl Names {
    /// A formula as text, for messages.
    pub fn text(&self, expr: &Expr) -> String {
        resolve::text(&self.expression(&signs_first(expr)))
    }

    pub fn expression(&self, expr: &Expr) -> Expression {
        let inner = |expr: &Expr| self.expression(expr);
        let kind = match expr {
            Expr::Number(number) => Kind::Number(number.clone()),
            Expr::Pi => Kind::Name(Ident::new("pi", self.span)),
            Expr::Parameter(index) => Kind::Name(self.parameters[*index].clone()),
            Expr::Definition(index) => Kind::Name(self.definitions[*index].clone()),
            Expr::Sum(terms) => {
                let term =
                    |(negative, term): &(bool, Expr)| Term { negative: *negative, operator: None, value: inner(term) };
                Kind::Sum(terms.iter().map(term).collect())
            }
            Expr::Product(factors) => {
                let factor = |(inverse, factor): &(bool, Expr)| Factor { inverse: *inverse, value: inner(factor) };
                Kind::Product(factors.iter().map(factor).collect())
            }
            Expr::Power(base, exponent) => Kind::Power(Box::new(inner(base)), *exponent),
            Expr::Call(function, argument) => {
                Kind::Call(Ident::new(function.name(), self.span), Box::new(inner(argument)))
            }
        };
        Expression { kind, region: Region::from(self.span) }
    }
}

/// The same formula with the signs of products before them.
fn signs_first(expr: &Expr) -> Expr {
    let all = |parts: &[(bool, Expr)]| parts.iter().map(|(is, part)| (*is, signs_first(part))).collect();
    match expr {
        Expr::Product(factors) => match negated(factors) {
            Some(positive) => Expr::Sum(vec![(true, Expr::Product(all(&positive)))]),
            None => Expr::Product(all(factors)),
        },
        Expr::Sum(terms) => Expr::Sum(all(terms)),
        Expr::Power(base, exponent) => Expr::Power(Box::new(signs_first(base)), *exponent),
        Expr::Call(function, argument) => Expr::Call(*function, Box::new(signs_first(argument))),
        Expr::Number(_) | Expr::Pi | Expr::Parameter(_) | Expr::Definition(_) => expr.clone(),
    }
}

/// The factors without the sign of a negative number among them, which reads better before all of them.
fn negated(factors: &[(bool, Expr)]) -> Option<Vec<(bool, Expr)>> {
    let number = |factor: &Expr| match factor {
        Expr::Sum(terms) => match &terms[..] {
            [(true, number)] => Some(number.clone()),
            _ => None,
        },
        _ => None,
    };
    let (at, number) = factors.iter().enumerate().find_map(|(at, (_, factor))| Some((at, number(factor)?)))?;
    let mut positive = factors.to_vec();
    positive[at].1 = number;
    if positive.len() > 1 {
        positive.retain(|(_, factor)| *factor != Expr::one());
    }
    Some(positive)
}
