//! Every slip that the formulas of a declaration have room for.

use carvallo_slips::slips;
use proc_macro2::TokenStream;

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
    let mut mutants = Vec::new();
    for formula in formulas {
        let [first, last] =
            [formula.first(), formula.last()].map(|token| token.expect("a formula").span().byte_range());
        let (start, end) = (first.start - origin, last.end - origin);
        let found = slips(&declaration[start..end], &names).into_iter();
        let found = found.filter(|slip| Kind::PLAIN.contains(&slip.kind));
        mutants.extend(found.map(|slip| Mutant { place: start + slip.place.start..start + slip.place.end, ..slip }));
    }
    mutants
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(Kind::PLAIN.map(|kind| (kind, count(kind))), expected);
        let texts: std::collections::BTreeSet<String> =
            mutants.iter().map(|mutant| mutant.apply(declaration)).collect();
        assert_eq!(texts.len(), mutants.len());
        assert!(!texts.contains(declaration));
    }
}
