//! The text of a formula to its parts, and back.

use std::fmt;

/// A formula in its parts, as the text of a [`FormulaInfo`](crate::FormulaInfo) has them. Sums and products are flat, as
/// they are written.
///
/// Available with feature `std`.
///
/// ```
/// use carvallo::Formula;
///
/// let square = Formula::Power(Box::new(Formula::Name("l".into())), "2".into());
/// let product = Formula::Product(vec![(false, Formula::Name("m".into())), (false, square)]);
/// assert_eq!(Formula::parse("m*l^2"), Some(product));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// A number, with a unit where one is written.
    Number(String, Option<String>),
    /// A parameter, a definition or pi.
    Name(String),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Formula)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Formula)>),
    /// A whole power.
    Power(Box<Formula>, String),
    /// A function of an argument.
    Call(String, Box<Formula>),
}

impl Formula {
    /// The parts of a formula; nothing if the text is none.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let mut reader = Reader { rest: text.trim() };
        let formula = reader.sum()?;
        reader.rest.is_empty().then_some(formula)
    }
}

/// Reads as a declaration has it, in parentheses where its parts need them: what is written is read as the same formula.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number, None) => f.write_str(number),
            Self::Number(number, Some(unit)) => write!(f, "{number} [{unit}]"),
            Self::Name(name) => f.write_str(name),
            Self::Sum(terms) => terms.iter().enumerate().try_for_each(|(index, (negative, term))| {
                f.write_str(match (index, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                })?;
                // The sign of a first term stands by itself.
                let is_signed =
                    index == 0 && !negative && matches!(term, Self::Sum(terms) if matches!(terms[..], [(true, _)]));
                term.write(f, matches!(term, Self::Sum(_)) && !is_signed)
            }),
            Self::Product(factors) => factors.iter().enumerate().try_for_each(|(index, (inverse, factor))| {
                f.write_str(match (index, inverse) {
                    (0, false) => "",
                    (0, true) => "1/",
                    (_, false) => "*",
                    (_, true) => "/",
                })?;
                factor.write(f, matches!(factor, Self::Sum(_) | Self::Product(_)))
            }),
            Self::Power(base, exponent) => {
                base.write(f, !matches!(**base, Self::Name(_) | Self::Number(_, None) | Self::Call(..)))?;
                write!(f, "^{exponent}")
            }
            Self::Call(function, argument) => write!(f, "{function}({argument})"),
        }
    }
}

impl Formula {
    fn write(&self, f: &mut fmt::Formatter<'_>, in_parentheses: bool) -> fmt::Result {
        if in_parentheses { write!(f, "({self})") } else { write!(f, "{self}") }
    }
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    /// Takes a sign that comes next, with what is blank behind it.
    fn take(&mut self, sign: char) -> bool {
        let found = self.rest.strip_prefix(sign);
        self.rest = found.map_or(self.rest, str::trim_start);
        found.is_some()
    }

    /// Takes as much as belongs together.
    fn take_while(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        taken
    }

    fn sum(&mut self) -> Option<Formula> {
        let mut terms = vec![(false, self.product()?)];
        loop {
            let negative = match self.rest.chars().next() {
                Some('+') => false,
                Some('-') => true,
                _ => break,
            };
            self.take(if negative { '-' } else { '+' });
            terms.push((negative, self.product()?));
        }
        Some(if terms.len() == 1 { terms.remove(0).1 } else { Formula::Sum(terms) })
    }

    fn product(&mut self) -> Option<Formula> {
        let mut factors = vec![(false, self.signed()?)];
        loop {
            let inverse = match self.rest.chars().next() {
                Some('*') => false,
                Some('/') => true,
                _ => break,
            };
            self.take(if inverse { '/' } else { '*' });
            factors.push((inverse, self.signed()?));
        }
        if factors.len() == 1 {
            return Some(factors.remove(0).1);
        }
        // The sign of the first factor is that of the product.
        match factors[0].1.clone() {
            Formula::Sum(terms) if matches!(terms[..], [(true, _)]) => {
                factors[0].1 = terms.into_iter().next()?.1;
                Some(Formula::Sum(vec![(true, Formula::Product(factors))]))
            }
            _ => Some(Formula::Product(factors)),
        }
    }

    fn signed(&mut self) -> Option<Formula> {
        if self.take('-') {
            return Some(Formula::Sum(vec![(true, self.signed()?)]));
        }
        let base = self.single()?;
        if !self.take('^') {
            return Some(base);
        }
        let sign = if self.take('-') { "-" } else { "" };
        let digits = self.take_while(|c| c.is_ascii_digit());
        (!digits.is_empty()).then(|| Formula::Power(Box::new(base), format!("{sign}{digits}")))
    }

    fn single(&mut self) -> Option<Formula> {
        if self.take('(') {
            let inner = self.sum()?;
            return self.take(')').then_some(inner);
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            return self.number();
        }
        let name = self.take_while(|c| c.is_alphanumeric() || c == '_');
        if name.is_empty() {
            return None;
        }
        if !self.take('(') {
            return Some(Formula::Name(name.into()));
        }
        let argument = self.sum()?;
        self.take(')').then(|| Formula::Call(name.into(), Box::new(argument)))
    }

    fn number(&mut self) -> Option<Formula> {
        let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let mut end = digits(self.rest);
        if let Some(power) = self.rest[end..].strip_prefix('e') {
            let unsigned = power.strip_prefix('-').unwrap_or(power);
            end += 1 + power.len() - unsigned.len() + digits(unsigned);
        }
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        let unit = if self.take('[') {
            let unit = self.take_while(|c| c != ']');
            self.take(']').then(|| Some(unit.into()))?
        } else {
            None
        };
        Some(Formula::Number(number.into(), unit))
    }
}
