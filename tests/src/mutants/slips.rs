//! Every slip that the formulas of a declaration have room for.

use std::ops::Range;

use proc_macro2::{TokenStream, TokenTree};

use super::formulas::{Formulas, find};
use super::{Kind, Mutant};

/// All mutants of a declaration, in the order of its formulas.
///
/// # Panics
/// If the text is no declaration.
pub fn all(declaration: &str) -> Vec<Mutant> {
    let tokens: TokenStream = declaration.parse().expect("tokens");
    // Spans count from the start of all that was read before.
    let Some(first) = tokens.clone().into_iter().next() else { return Vec::new() };
    let origin = first.span().byte_range().start - (declaration.len() - declaration.trim_start().len());
    let Formulas { names, formulas } = find(tokens);
    let mut slips = Slips { names, origin, mutants: Vec::new() };
    formulas.iter().for_each(|formula| slips.sum(formula));
    slips.mutants
}

struct Slips {
    names: Vec<String>,
    origin: usize,
    mutants: Vec<Mutant>,
}

/// An operand, and the operator before it unless it is the first.
struct Operand<'a> {
    operator: Option<&'a TokenTree>,
    tokens: &'a [TokenTree],
}

impl Slips {
    fn push(&mut self, kind: Kind, place: Range<usize>, replacement: impl Into<String>) {
        self.mutants.push(Mutant { kind, place, replacement: replacement.into() });
    }

    fn place(&self, tokens: &[TokenTree]) -> Range<usize> {
        let [start, end] = [tokens.first(), tokens.last()].map(|token| token.expect("an operand").span().byte_range());
        start.start - self.origin..end.end - self.origin
    }

    fn sum(&mut self, tokens: &[TokenTree]) {
        let terms = operands(tokens, ['+', '-']);
        self.operators(&terms);
        if let [first, second, rest @ ..] = &terms[..] {
            // `a - b` without its first term is `-b`.
            let (first, operator) = (self.place(first.tokens), self.operator(second));
            let end = if is(second.operator, '+') { operator.end } else { operator.start };
            self.push(Kind::Term, first.start..end, "");
            for term in [second].into_iter().chain(rest) {
                let place = self.operator(term).start..self.place(term.tokens).end;
                self.push(Kind::Term, place, "");
            }
        }
        terms.iter().for_each(|term| self.product(term.tokens));
    }

    fn product(&mut self, tokens: &[TokenTree]) {
        let tokens = self.minus(tokens);
        let factors = operands(tokens, ['*', '/']);
        self.operators(&factors);
        if let [first, second, rest @ ..] = &factors[..] {
            let (first, operator) = (self.place(first.tokens), self.operator(second));
            match is(second.operator, '*') {
                true => self.push(Kind::Factor, first.start..operator.end, ""),
                false => self.push(Kind::Factor, first, "1"),
            }
            for factor in [second].into_iter().chain(rest) {
                let place = self.operator(factor).start..self.place(factor.tokens).end;
                self.push(Kind::Factor, place, "");
            }
        }
        factors.iter().for_each(|factor| self.power(factor.tokens));
    }

    fn power(&mut self, tokens: &[TokenTree]) {
        let tokens = self.minus(tokens);
        let Some(caret) = tokens.iter().position(|token| is(Some(token), '^')) else {
            return self.primary(tokens);
        };
        let (base, power) = tokens.split_at(caret);
        let text: String = power[1..].iter().map(ToString::to_string).collect();
        let digits: String = text.chars().filter(|c| !matches!(c, '(' | ')' | ' ')).collect();
        let exponent: i32 = digits.parse().expect("a whole exponent");
        for changed in [exponent + 1, exponent - 1] {
            let replacement = if changed == 1 { String::new() } else { format!("^{changed}") };
            self.push(Kind::Exponent, self.place(power), replacement);
        }
        self.primary(base);
    }

    fn primary(&mut self, tokens: &[TokenTree]) {
        let place = self.place(&tokens[..1]);
        match tokens {
            [TokenTree::Ident(function), TokenTree::Group(argument)] => {
                match function.to_string().as_str() {
                    "sin" => self.push(Kind::Function, place, "cos"),
                    "cos" => self.push(Kind::Function, place, "sin"),
                    _ => {}
                }
                self.sum(&argument.stream().into_iter().collect::<Vec<_>>());
            }
            [TokenTree::Group(group)] => self.sum(&group.stream().into_iter().collect::<Vec<_>>()),
            [TokenTree::Ident(name)] => self.name(&name.to_string(), &place),
            [TokenTree::Literal(literal)] => {
                let value: f64 = literal.to_string().parse().expect("a decimal number");
                self.push(Kind::Number, place.clone(), (value + 1.0).to_string());
                self.push(Kind::Number, place, (value - 1.0).to_string());
            }
            _ => panic!("no operand: {tokens:?}"),
        }
    }

    fn name(&mut self, name: &str, place: &Range<usize>) {
        if !self.names.iter().any(|known| known == name) {
            return;
        }
        for other in self.names.clone().into_iter().filter(|other| other != name) {
            let kind = if is_similar(name, &other) { Kind::SimilarName } else { Kind::OtherName };
            self.push(kind, place.clone(), other);
        }
    }

    /// Drops each minus before an operand, and leaves what stands behind them.
    fn minus<'a>(&mut self, mut tokens: &'a [TokenTree]) -> &'a [TokenTree] {
        while is(tokens.first(), '-') {
            self.push(Kind::Minus, self.place(&tokens[..1]), "");
            tokens = &tokens[1..];
        }
        tokens
    }

    /// Each operator by each of the other three.
    fn operators(&mut self, operands: &[Operand<'_>]) {
        for operand in &operands[1..] {
            for other in ['+', '-', '*', '/'].into_iter().filter(|other| !is(operand.operator, *other)) {
                let is_sum = |operator| operator == '+' || operator == '-';
                let kind = match (is(operand.operator, '+') || is(operand.operator, '-'), is_sum(other)) {
                    (true, true) => Kind::SignOfTerm,
                    (false, false) => Kind::ProductOrQuotient,
                    _ => Kind::SumOrProduct,
                };
                self.push(kind, self.operator(operand), other);
            }
        }
    }

    fn operator(&self, operand: &Operand<'_>) -> Range<usize> {
        self.place(std::slice::from_ref(operand.operator.expect("an operand that is not the first")))
    }
}

/// The operands between operators of one rank: a sign behind another operator, or at the start, is not between two.
fn operands(tokens: &[TokenTree], operators: [char; 2]) -> Vec<Operand<'_>> {
    let mut operands = Vec::new();
    let (mut operator, mut start) = (None, 0);
    for (index, token) in tokens.iter().enumerate() {
        let between = index > start && !matches!(tokens[index - 1], TokenTree::Punct(_));
        if between && operators.iter().any(|operator| is(Some(token), *operator)) {
            operands.push(Operand { operator, tokens: &tokens[start..index] });
            (operator, start) = (Some(token), index + 1);
        }
    }
    operands.push(Operand { operator, tokens: &tokens[start..] });
    operands
}

fn is(token: Option<&TokenTree>, character: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == character)
}

/// Whether two names have the same length and differ in one letter.
fn is_similar(a: &str, b: &str) -> bool {
    a.chars().count() == b.chars().count() && a.chars().zip(b.chars()).filter(|(a, b)| a != b).count() == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formulas that one makes, by kind, in a model with parameters a1, a2, bb.
    fn slips(formula: &str, kind: Kind) -> Vec<String> {
        let declaration =
            format!("model X {{ parameters {{ /// A\n a1: m; a2: m, > 0; bb: rad; }} M = [[{formula}]]; }}");
        let mutants = all(&declaration).into_iter().filter(|mutant| mutant.kind == kind);
        let formula = |text: String| {
            let (_, text) = text.split_once("[[")?;
            let (text, _) = text.split_once("]]")?;
            Some(text.to_string())
        };
        mutants.map(|mutant| formula(mutant.apply(&declaration)).expect("a matrix")).collect()
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
        assert_eq!(slips("2*a1 + 0.5", Kind::Number), ["3*a1 + 0.5", "1*a1 + 0.5", "2*a1 + 1.5", "2*a1 + -0.5"]);
    }

    /// Counted by hand. `let s`: 5 uses of a name that has 4 others, 3 of them similar to a1 and a2 and none to bb or s
    /// (a1, a2: one each); the operators `* - *`; two factors each in two products; 2 terms. `M`: a name, a sign, `/`.
    #[test]
    fn every_slip_is_made_once() {
        let declaration = "model X {
            parameters { a1: m; a2: m; bb: rad; }
            let s = a1*a2 - 2*sin(bb)^2;
            require a1 + a2 > 0;
            coordinates { q: rad; }
            M = [[-s/a1]];
            set one { a1 = 1 + 1; a2 = 2*3; bb = -1; }
        }";
        let mutants = all(declaration);
        let count = |kind| mutants.iter().filter(|mutant| mutant.kind == kind).count();
        let expected = [
            (Kind::SignOfTerm, 1),
            (Kind::ProductOrQuotient, 3),
            (Kind::SumOrProduct, 2 + 3 * 2),
            (Kind::Minus, 1),
            (Kind::Exponent, 2),
            (Kind::SimilarName, 3),
            (Kind::OtherName, 5 * 3 - 3),
            (Kind::Factor, 6),
            (Kind::Term, 2),
            (Kind::Function, 1),
            (Kind::Number, 2),
        ];
        assert_eq!(Kind::ALL.map(|kind| (kind, count(kind))), expected);
        let texts: std::collections::BTreeSet<String> =
            mutants.iter().map(|mutant| mutant.apply(declaration)).collect();
        assert_eq!(texts.len(), mutants.len());
        assert!(!texts.contains(declaration));
    }
}
