//! Formulas without a source to formulas as if they were written in the declaration.

use proc_macro2::{Ident, Span};

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
                if let Some(positive) = negated(factors) {
                    return self.expression(&Expr::Sum(vec![(true, Expr::Product(positive))]));
                }
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
