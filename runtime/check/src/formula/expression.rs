//! A formula as a tree, and its value. This is no computer algebra: nothing is rearranged.

use super::token::{Token, TokenKind};

/// A formula in parameters and definitions, which are known by their positions.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number.
    Number(f64),
    /// The parameter at this position.
    Parameter(usize),
    /// The definition at this position.
    Definition(usize),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Expression)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Expression)>),
    /// A whole power.
    Power(Box<Expression>, i32),
    /// A function of an argument.
    Call(Function, Box<Expression>),
}

/// The functions that formulas may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Square root.
    Sqrt,
}

impl Function {
    fn called(name: &str) -> Option<Self> {
        Some(match name {
            "sin" => Self::Sin,
            "cos" => Self::Cos,
            "tan" => Self::Tan,
            "sqrt" => Self::Sqrt,
            _ => return None,
        })
    }

    fn of(self, argument: f64) -> f64 {
        match self {
            Self::Sin => argument.sin(),
            Self::Cos => argument.cos(),
            Self::Tan => argument.tan(),
            Self::Sqrt => argument.sqrt(),
        }
    }
}

impl Expression {
    /// The formula of these tokens; `name` knows what a name stands for. `None` if they are no formula.
    pub fn parse(tokens: &[Token], name: &dyn Fn(&str) -> Option<Self>) -> Option<Self> {
        let mut reader = Reader { tokens, name };
        let sum = reader.sum()?;
        reader.tokens.is_empty().then_some(sum)
    }

    /// Its value; not finite where it has none.
    pub fn value(&self, parameters: &[f64], definitions: &[f64]) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Parameter(position) => parameters[*position],
            Self::Definition(position) => definitions[*position],
            Self::Sum(terms) => terms.iter().fold(0.0, |sum, (negative, term)| {
                let value = term.value(parameters, definitions);
                if *negative { sum - value } else { sum + value }
            }),
            Self::Product(factors) => factors.iter().fold(1.0, |product, (inverse, factor)| {
                let value = factor.value(parameters, definitions);
                if *inverse { product / value } else { product * value }
            }),
            Self::Power(base, exponent) => base.value(parameters, definitions).powi(*exponent),
            Self::Call(function, argument) => function.of(argument.value(parameters, definitions)),
        }
    }

    /// Tells each of the definitions that it uses.
    pub fn each_definition(&self, tell: &mut dyn FnMut(usize)) {
        match self {
            Self::Number(_) | Self::Parameter(_) => {}
            Self::Definition(position) => tell(*position),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().for_each(|(_, part)| part.each_definition(tell)),
            Self::Power(inner, _) | Self::Call(_, inner) => inner.each_definition(tell),
        }
    }
}

struct Reader<'a> {
    tokens: &'a [Token],
    name: &'a dyn Fn(&str) -> Option<Expression>,
}

impl Reader<'_> {
    /// Takes a sign that comes next.
    fn take(&mut self, sign: char) -> bool {
        let is_next = self.tokens.first().is_some_and(|token| token.is(sign));
        self.tokens = &self.tokens[usize::from(is_next)..];
        is_next
    }

    fn sum(&mut self) -> Option<Expression> {
        let parts = self.parts(['+', '-'], Self::product)?;
        Some(single_or(parts, Expression::Sum))
    }

    fn product(&mut self) -> Option<Expression> {
        let parts = self.parts(['*', '/'], Self::signed)?;
        Some(single_or(parts, Expression::Product))
    }

    /// Operands between two operators, each with whether the second one stands before it.
    fn parts(
        &mut self,
        [first, second]: [char; 2],
        operand: fn(&mut Self) -> Option<Expression>,
    ) -> Option<Vec<(bool, Expression)>> {
        let mut parts = vec![(false, operand(self)?)];
        loop {
            let inverse = self.take(second);
            if !inverse && !self.take(first) {
                return Some(parts);
            }
            parts.push((inverse, operand(self)?));
        }
    }

    fn signed(&mut self) -> Option<Expression> {
        if self.take('-') {
            return Some(Expression::Sum(vec![(true, self.signed()?)]));
        }
        let base = self.single()?;
        if !self.take('^') {
            return Some(base);
        }
        Some(Expression::Power(Box::new(base), self.exponent()?))
    }

    /// A whole number with or without a sign, or that in parentheses.
    fn exponent(&mut self) -> Option<i32> {
        let sign = if self.take('-') { -1 } else { 1 };
        let (first, rest) = self.tokens.split_first()?;
        self.tokens = rest;
        match &first.kind {
            TokenKind::Number(value) if value.fract() == 0.0 && value.abs() < 1e3 => Some(sign * *value as i32),
            TokenKind::Group(inner) => {
                let mut inner = Reader { tokens: inner, name: self.name };
                let exponent = inner.exponent()?;
                inner.tokens.is_empty().then_some(sign * exponent)
            }
            _ => None,
        }
    }

    fn single(&mut self) -> Option<Expression> {
        let (first, rest) = self.tokens.split_first()?;
        self.tokens = rest;
        match (&first.kind, rest) {
            (TokenKind::Number(value), _) => Some(Expression::Number(*value)),
            (TokenKind::Group(inner), _) => Expression::parse(inner, self.name),
            (TokenKind::Name(name), [Token { kind: TokenKind::Group(argument), .. }, rest @ ..]) => {
                self.tokens = rest;
                let argument = Expression::parse(argument, self.name)?;
                Some(Expression::Call(Function::called(name)?, Box::new(argument)))
            }
            (TokenKind::Name(name), _) if name == "pi" => Some(Expression::Number(std::f64::consts::PI)),
            (TokenKind::Name(name), _) => (self.name)(name),
            (TokenKind::Sign(_), _) => None,
        }
    }
}

/// A single part that has no sign is what it is of.
fn single_or(mut parts: Vec<(bool, Expression)>, many: fn(Vec<(bool, Expression)>) -> Expression) -> Expression {
    if parts.len() == 1 { parts.remove(0).1 } else { many(parts) }
}
