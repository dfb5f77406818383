//! Every slip that a formula has room for.

use std::ops::Range;

use crate::slip::{Kind, Slip};
use crate::token::{Token, TokenKind, tokens};

/// All slips of a formula, in its order: names become any other of these names, those of parameters and definitions. Of a
/// text that is no formula there are none.
pub fn slips(formula: &str, names: &[impl AsRef<str>]) -> Vec<Slip> {
    let names = names.iter().map(AsRef::as_ref).collect();
    let mut slips = Slips { text: formula, names, found: Vec::new() };
    if let Some(tokens) = tokens(formula).filter(|tokens| !tokens.is_empty()) {
        slips.sum(&tokens);
    }
    slips.found
}

struct Slips<'a> {
    text: &'a str,
    names: Vec<&'a str>,
    found: Vec<Slip>,
}

/// An operand, and the operator before it unless it is the first.
struct Operand<'a> {
    operator: Option<&'a Token>,
    tokens: &'a [Token],
}

impl Operand<'_> {
    fn is(&self, operator: char) -> bool {
        self.operator.is_some_and(|token| token.is(operator))
    }

    /// Where it stands, with its operator.
    fn place(&self) -> Range<usize> {
        let own = place(self.tokens);
        self.operator.map_or(own.start, |operator| operator.place.start)..own.end
    }
}

impl Slips<'_> {
    fn push(&mut self, kind: Kind, place: Range<usize>, replacement: impl Into<String>) {
        self.found.push(Slip { kind, place, replacement: replacement.into() });
    }

    fn sum(&mut self, tokens: &[Token]) {
        let terms = operands(tokens, ['+', '-']);
        self.operators(&terms);
        if let Some(first) = terms.first().filter(|first| first.tokens.first().is_some_and(|token| !token.is('-'))) {
            let own = place(first.tokens);
            let changed = format!("-{}", &self.text[own.clone()]);
            self.push(Kind::Negative, own, changed);
        }
        if let [first, second, rest @ ..] = &terms[..] {
            // `a - b` without its first term is `-b`.
            let operator = second.operator.map_or(0..0, |token| token.place.clone());
            let end = if second.is('+') { operator.end } else { operator.start };
            self.push(Kind::Term, place(first.tokens).start..end, "");
            for term in [second].into_iter().chain(rest) {
                self.push(Kind::Term, term.place(), "");
            }
        }
        terms.iter().for_each(|term| self.product(term.tokens));
    }

    fn product(&mut self, tokens: &[Token]) {
        let tokens = self.minus(tokens);
        let factors = operands(tokens, ['*', '/']);
        self.operators(&factors);
        self.factor_of_two(tokens, &factors);
        if let [first, second, rest @ ..] = &factors[..] {
            let operator = second.operator.map_or(0..0, |token| token.place.clone());
            match second.is('*') {
                true => self.push(Kind::Factor, place(first.tokens).start..operator.end, ""),
                false => self.push(Kind::Factor, place(first.tokens), "1"),
            }
            for factor in [second].into_iter().chain(rest) {
                self.push(Kind::Factor, factor.place(), "");
            }
        }
        factors.iter().for_each(|factor| self.power(factor.tokens));
    }

    fn power(&mut self, tokens: &[Token]) {
        let tokens = self.minus(tokens);
        let Some(caret) = tokens.iter().position(|token| token.is('^')) else {
            if let [Token { kind: TokenKind::Name(name), place }] = tokens
                && self.names.contains(&name.as_str())
            {
                self.push(Kind::Square, place.clone(), format!("{name}^2"));
            }
            return self.primary(tokens);
        };
        let (base, power) = tokens.split_at(caret);
        if let Some(exponent) = whole(&power[1..]) {
            for changed in [exponent + 1, exponent - 1] {
                let replacement = if changed == 1 { String::new() } else { format!("^{changed}") };
                self.push(Kind::Exponent, place(power), replacement);
            }
            if exponent > 1 {
                self.push(Kind::PowerAsProduct, place(power), format!("*{exponent}"));
            }
        }
        self.primary(base);
    }

    fn primary(&mut self, tokens: &[Token]) {
        let Some(Token { kind, place }) = tokens.first() else { return };
        match (kind, tokens.get(1).map(|token| &token.kind)) {
            (TokenKind::Name(function), Some(TokenKind::Group(argument))) => {
                let (other, others) = match function.as_str() {
                    "sin" => (Some("cos"), &["tan", ""][..]),
                    "cos" => (Some("sin"), &["tan", ""][..]),
                    "tan" => (None, &["sin", "cos", ""][..]),
                    _ => (None, &[""][..]),
                };
                other.iter().for_each(|other| self.push(Kind::Function, place.clone(), *other));
                others.iter().for_each(|other| self.push(Kind::OtherFunction, place.clone(), *other));
                self.sum(argument);
            }
            (TokenKind::Group(group), _) => self.sum(group),
            (TokenKind::Name(name), _) => self.name(name, place),
            (TokenKind::Number(value), _) => {
                self.push(Kind::Number, place.clone(), (value + 1.0).to_string());
                self.push(Kind::Number, place.clone(), (value - 1.0).to_string());
            }
            (TokenKind::Sign(_), _) => {}
        }
    }

    fn name(&mut self, name: &str, place: &Range<usize>) {
        if !self.names.contains(&name) {
            return;
        }
        for other in self.names.clone().into_iter().filter(|other| *other != name) {
            let kind = if is_similar(name, other) { Kind::SimilarName } else { Kind::OtherName };
            self.push(kind, place.clone(), other);
        }
    }

    /// Twice and half of a product, unless a factor of two is lost or written the other way in it by another slip.
    fn factor_of_two(&mut self, tokens: &[Token], factors: &[Operand<'_>]) {
        let own = place(tokens);
        let is_two = |divides: bool| {
            let is = |factor: &Operand| matches!(factor.tokens, [Token { kind: TokenKind::Number(value), .. }] if *value == 2.0);
            factors.iter().any(|factor| factor.is('/') == divides && is(factor))
        };
        let text = &self.text[own.clone()];
        let [double, half] = [format!("2*{text}"), format!("{text}/2")];
        if !matches!(factors, [Operand { tokens: [Token { kind: TokenKind::Number(_), .. }], .. }]) {
            for (known, changed) in [(is_two(true), double), (is_two(false), half)] {
                if !known {
                    self.push(Kind::FactorOfTwo, own.clone(), changed);
                }
            }
        }
    }

    /// Drops each minus before an operand, and leaves what stands behind them.
    fn minus<'a>(&mut self, mut tokens: &'a [Token]) -> &'a [Token] {
        while let [minus, rest @ ..] = tokens
            && minus.is('-')
        {
            self.push(Kind::Minus, minus.place.clone(), "");
            tokens = rest;
        }
        tokens
    }

    /// Each operator by each of the other three.
    fn operators(&mut self, operands: &[Operand<'_>]) {
        for operator in operands.iter().filter_map(|operand| operand.operator) {
            for other in ['+', '-', '*', '/'].into_iter().filter(|other| !operator.is(*other)) {
                let is_sum = |operator| operator == '+' || operator == '-';
                let kind = match (operator.is('+') || operator.is('-'), is_sum(other)) {
                    (true, true) => Kind::SignOfTerm,
                    (false, false) => Kind::ProductOrQuotient,
                    _ => Kind::SumOrProduct,
                };
                self.push(kind, operator.place.clone(), other);
            }
        }
    }
}

/// From the first of some tokens to the last.
fn place(tokens: &[Token]) -> Range<usize> {
    match (tokens.first(), tokens.last()) {
        (Some(first), Some(last)) => first.place.start..last.place.end,
        _ => 0..0,
    }
}

/// The operands between operators of one rank: a sign behind another operator, or at the start, is not between two.
fn operands(tokens: &[Token], operators: [char; 2]) -> Vec<Operand<'_>> {
    let mut operands = Vec::new();
    let (mut operator, mut start) = (None, 0);
    for (index, token) in tokens.iter().enumerate() {
        let between = index > start && !matches!(tokens[index - 1].kind, TokenKind::Sign(_));
        if between && operators.iter().any(|operator| token.is(*operator)) {
            operands.push(Operand { operator, tokens: &tokens[start..index] });
            (operator, start) = (Some(token), index + 1);
        }
    }
    operands.push(Operand { operator, tokens: &tokens[start..] });
    operands
}

/// A whole number with or without a sign, or that in parentheses.
fn whole(tokens: &[Token]) -> Option<i32> {
    match tokens {
        [minus, rest @ ..] if minus.is('-') => whole(rest).map(|value| -value),
        [Token { kind: TokenKind::Group(inner), .. }] => whole(inner),
        [Token { kind: TokenKind::Number(value), .. }] if value.fract() == 0.0 => Some(*value as i32),
        _ => None,
    }
}

/// Whether two names have the same length and differ in one letter.
fn is_similar(a: &str, b: &str) -> bool {
    a.chars().count() == b.chars().count() && a.chars().zip(b.chars()).filter(|(a, b)| a != b).count() == 1
}

#[cfg(test)]
mod tests {
    use super::slips as all;
    use crate::slip::Kind;

    /// The formulas that one makes, by kind, in a model with parameters a1, a2, bb.
    fn slips(formula: &str, kind: Kind) -> Vec<String> {
        let slips = all(formula, &["a1", "a2", "bb"]).into_iter().filter(|slip| slip.kind == kind);
        slips.map(|slip| slip.apply(formula)).collect()
    }

    #[test]
    fn operators_become_each_other() {
        assert_eq!(slips("a1 - a2*bb", Kind::SignOfTerm), ["a1 + a2*bb"]);
        assert_eq!(slips("a1 - a2*bb", Kind::ProductOrQuotient), ["a1 - a2/bb"]);
        assert_eq!(slips("a1 - a2*bb", Kind::SumOrProduct), ["a1 * a2*bb", "a1 / a2*bb", "a1 - a2+bb", "a1 - a2-bb"]);
        assert_eq!(slips("(a1/a2)", Kind::ProductOrQuotient), ["(a1*a2)"]);
    }

    #[test]
    fn signs_before_an_operand_are_no_operators() {
        assert_eq!(slips("-a1*-a2^-2", Kind::Minus), ["a1*-a2^-2", "-a1*a2^-2"]);
        assert_eq!(slips("-a1*-a2^-2", Kind::SignOfTerm), [""; 0]);
        assert_eq!(slips("-(a1 + a2)", Kind::Minus), ["(a1 + a2)"]);
        assert_eq!(slips("a1*sin(bb) + a2", Kind::Negative), ["-a1*sin(bb) + a2", "a1*sin(-bb) + a2"]);
        assert_eq!(slips("-(a1 + a2)", Kind::Negative), ["-(-a1 + a2)"]);
    }

    #[test]
    fn exponents_change_by_one() {
        assert_eq!(slips("a1^2", Kind::Exponent), ["a1^3", "a1"]);
        assert_eq!(slips("(a1 + a2)^(-1)", Kind::Exponent), ["(a1 + a2)^0", "(a1 + a2)^-2"]);
        assert_eq!(slips("a1^2", Kind::Number), [""; 0]);
    }

    #[test]
    fn names_become_all_others() {
        assert_eq!(slips("a1*pi", Kind::SimilarName), ["a2*pi"]);
        assert_eq!(slips("a1*sin(bb)", Kind::OtherName), ["bb*sin(bb)", "a1*sin(a1)", "a1*sin(a2)"]);
    }

    #[test]
    fn terms_and_factors_are_lost() {
        assert_eq!(slips("a1 + a2 - bb", Kind::Term), [" a2 - bb", "a1  - bb", "a1 + a2 "]);
        assert_eq!(slips("a1 - bb", Kind::Term), ["- bb", "a1 "]);
        assert_eq!(slips("-a1*a2/bb", Kind::Factor), ["-a2/bb", "-a1/bb", "-a1*a2"]);
        assert_eq!(slips("a1/bb", Kind::Factor), ["1/bb", "a1"]);
    }

    #[test]
    fn functions_and_numbers_change() {
        assert_eq!(slips("sin(bb)*cos(bb)", Kind::Function), ["cos(bb)*cos(bb)", "sin(bb)*sin(bb)"]);
        let others = ["tan(bb)*cos(bb)", "(bb)*cos(bb)", "sin(bb)*tan(bb)", "sin(bb)*(bb)"];
        assert_eq!(slips("sin(bb)*cos(bb)", Kind::OtherFunction), others);
        assert_eq!(slips("sqrt(a1)", Kind::OtherFunction), ["(a1)"]);
        assert_eq!(slips("2*a1 + 0.5", Kind::Number), ["3*a1 + 0.5", "1*a1 + 0.5", "2*a1 + 1.5", "2*a1 + -0.5"]);
    }

    #[test]
    fn terms_are_twice_or_half_as_large() {
        let both = ["2*a1 - a2*bb", "a1/2 - a2*bb", "a1 - 2*a2*bb", "a1 - a2*bb/2"];
        assert_eq!(slips("a1 - a2*bb", Kind::FactorOfTwo), both);
        // Half of what has a factor of two is the factor that is lost.
        assert_eq!(slips("-2*a1", Kind::FactorOfTwo), ["-2*2*a1"]);
        assert_eq!(slips("a1*sin(bb)^2", Kind::FactorOfTwo)[2..], ["a1*sin(2*bb)^2", "a1*sin(bb/2)^2"]);
    }

    #[test]
    fn powers_are_too_many_or_products() {
        assert_eq!(slips("a1*a2^2", Kind::Square), ["a1^2*a2^2"]);
        assert_eq!(slips("a1*a2^2", Kind::PowerAsProduct), ["a1*a2*2"]);
    }
}
