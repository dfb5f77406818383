//! Formulas in the languages of typesetters.

use super::formula::Formula;
use super::symbol::{Part, Symbol};

/// How a language writes the parts of a formula.
pub trait Markup {
    /// Between two factors of which the second would run into the first, as a number does.
    const TIMES: &'static str;
    /// Between two indices.
    const BETWEEN: &'static str;
    /// q'', q' and q.
    const DERIVATIVES: [&'static str; 3];

    fn fraction(&self, above: &str, below: &str) -> String;
    fn index(&self, base: &str, index: &str) -> String;
    fn power(&self, base: &str, exponent: &str) -> String;
    fn root(&self, inner: &str) -> String;
    fn function(&self, name: &str) -> String;
    /// In parentheses that are as high as what is in them.
    fn enclosed(&self, inner: &str) -> String;
    fn greek(&self, name: &str) -> String;
    fn letters(&self, letters: &str) -> String;
    fn word(&self, word: &str) -> String;
    fn number(&self, number: &str) -> String;
    fn unit(&self, unit: &str) -> String;
    /// The equation of motion of a model, with its coordinates, and before it what the rest needs.
    fn head(&self, model: &str, equation: &str, coordinates: &str) -> String;
    /// What an equation is of, its lines, and its unit.
    fn row(&self, of: &str, lines: &[String], unit: Option<&str>) -> String;
    /// Equations below each other.
    fn block(&self, rows: &[String]) -> String;
}

/// Writes formulas in a language; `symbol` has the symbols of parameters that have others than their names.
pub struct Writer<'a, M> {
    pub markup: M,
    pub symbol: &'a dyn Fn(&str) -> Option<&'static str>,
}

impl<M: Markup> Writer<'_, M> {
    /// A name as a symbol.
    pub fn name(&self, name: &str) -> String {
        let Symbol { base, indices } = self.symbol_of(name);
        let part = |part: &Part| match part {
            Part::Greek(name) => self.markup.greek(name),
            Part::Letters(letters) => self.markup.letters(letters),
            Part::Word(word) => self.markup.word(word),
        };
        let indices: Vec<String> = indices.iter().map(part).collect();
        if indices.is_empty() { part(&base) } else { self.markup.index(&part(&base), &indices.join(M::BETWEEN)) }
    }

    /// A formula in lines: a long sum has several, each but the first of which begins with a sign.
    pub fn lines(&self, formula: &Formula) -> Vec<String> {
        let Formula::Sum(terms) = formula else { return vec![self.formula(formula)] };
        let mut lines: Vec<String> = vec![String::new()];
        let mut width = 0;
        for (index, (negative, value)) in terms.iter().enumerate() {
            let own = length(value);
            if width > 0 && width + own > WIDEST {
                lines.push(String::new());
                width = 0;
            }
            width += own + 2;
            let term = self.term(index == 0, *negative, value);
            let line = lines.last_mut().unwrap_or_else(|| unreachable!("there is a first line"));
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(&term);
        }
        lines
    }

    fn term(&self, is_first: bool, negative: bool, value: &Formula) -> String {
        let sign = match (is_first, negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => "+ ",
            (false, true) => "- ",
        };
        let begins = is_first && !negative;
        let text = match value {
            Formula::Sum(_) if !begins => self.markup.enclosed(&self.formula(value)),
            _ => self.formula(value),
        };
        format!("{sign}{text}")
    }

    fn formula(&self, formula: &Formula) -> String {
        match formula {
            Formula::Number(number, None) => self.markup.number(number),
            Formula::Number(number, Some(unit)) => {
                format!("{}{}{}", self.markup.number(number), M::BETWEEN, self.markup.unit(unit))
            }
            Formula::Name(name) => self.name(name),
            Formula::Sum(terms) => {
                let term =
                    |(index, (negative, value)): (usize, &(bool, Formula))| self.term(index == 0, *negative, value);
                terms.iter().enumerate().map(term).collect::<Vec<String>>().join(" ")
            }
            Formula::Product(factors) => self.product(factors),
            Formula::Power(base, exponent) => match &**base {
                // The square of a sine has its exponent at the function.
                Formula::Call(name, argument) if name != "sqrt" && !exponent.starts_with('-') => {
                    self.call(&self.markup.power(&self.markup.function(name), exponent), argument)
                }
                Formula::Name(_) | Formula::Number(_, None) => self.markup.power(&self.formula(base), exponent),
                _ => self.markup.power(&self.markup.enclosed(&self.formula(base)), exponent),
            },
            Formula::Call(name, argument) if name == "sqrt" => self.markup.root(&self.formula(argument)),
            Formula::Call(name, argument) => self.call(&self.markup.function(name), argument),
        }
    }

    fn call(&self, function: &str, argument: &Formula) -> String {
        let inner = self.formula(argument);
        match argument {
            Formula::Name(_) | Formula::Number(_, None) => format!("{function} {inner}"),
            _ => format!("{function} {}", self.markup.enclosed(&inner)),
        }
    }

    /// What divides is below one line.
    fn product(&self, factors: &[(bool, Formula)]) -> String {
        let side = |below: bool| {
            let factors: Vec<&Formula> =
                factors.iter().filter(|(inverse, _)| *inverse == below).map(|(_, f)| f).collect();
            match factors[..] {
                [] => String::new(),
                [factor] => self.formula(factor),
                _ => self.factors(&factors),
            }
        };
        match (side(false), side(true)) {
            (above, below) if below.is_empty() => above,
            (above, below) if above.is_empty() => self.markup.fraction("1", &below),
            (above, below) => self.markup.fraction(&above, &below),
        }
    }

    /// Whether it is a word, which runs into letters beside it.
    fn is_word(&self, factor: &Formula) -> bool {
        matches!(factor, Formula::Name(name) if matches!(self.symbol_of(name).base, Part::Word(_)))
    }

    fn symbol_of(&self, name: &str) -> Symbol {
        Symbol::of((self.symbol)(name).unwrap_or(name))
    }

    fn factors(&self, factors: &[&Formula]) -> String {
        let mut text = String::new();
        let (mut after_number, mut after_word) = (false, false);
        for factor in factors {
            let own = match factor {
                Formula::Sum(_) => self.markup.enclosed(&self.formula(factor)),
                _ => self.formula(factor),
            };
            let is_quotient = matches!(factor, Formula::Product(inner) if inner.iter().any(|(inverse, _)| *inverse));
            let runs = own.starts_with(|c: char| c.is_ascii_digit()) || after_number && is_quotient;
            if !text.is_empty() {
                text.push_str(match () {
                    () if runs => M::TIMES,
                    () if after_word || self.is_word(factor) => M::BETWEEN,
                    () => " ",
                });
            }
            after_word = self.is_word(factor);
            after_number = matches!(factor, Formula::Number(..));
            text.push_str(&own);
        }
        text
    }
}

/// The length of a formula, in its letters and signs.
fn length(formula: &Formula) -> usize {
    match formula {
        Formula::Number(number, unit) => number.len() + unit.as_ref().map_or(0, String::len),
        Formula::Name(name) => name.len().min(5),
        Formula::Sum(terms) => terms.iter().map(|(_, term)| length(term) + 2).sum::<usize>() + 2,
        Formula::Product(factors) => factors.iter().map(|(_, factor)| length(factor)).sum(),
        Formula::Power(base, exponent) => length(base) + exponent.len(),
        Formula::Call(_, argument) => 3 + length(argument),
    }
}

/// What has a place on a page beside what it is of, and its unit.
const WIDEST: usize = 50;
