//! Formulas with one slip, as people make them.

use carvallo::{Expression, Formula};

use super::Equations;

/// One of the formulas of a model with a slip in one place.
#[derive(Clone, Debug)]
pub struct Slip {
    /// Which of the equations.
    pub equation: usize,
    /// What is other, as the end of a sentence: `the term `mu*ITxz` has the other sign`.
    pub what: String,
    /// The formula with the slip.
    pub formula: Formula,
    pub expression: Expression,
}

/// All single slips of the equations: a sign, a factor of two, what is missing, what divides and should multiply, a power,
/// a function, and one name in the place of another with the same unit.
pub fn slips(equations: &Equations) -> impl Iterator<Item = Slip> + '_ {
    equations.all.iter().enumerate().flat_map(move |(index, equation)| {
        let alike = |name: &str| names_alike(equations, index, name);
        let slips = Slips { alike: &alike };
        // What is done to all of an entry is no slip of its formula.
        let varied = match equation.definition {
            Some(name) => slips.whole(&format!("`{name}`"), &equation.formula),
            None => slips.inside(&equation.formula),
        };
        varied.into_iter().filter_map(move |(what, formula)| {
            let expression = Expression::new(&formula, &|name| equations.name(name, index))?;
            Some(Slip { equation: index, what, formula, expression })
        })
    })
}

/// The other parameters, and definitions before the equation at an index, that have the unit of a name.
fn names_alike(equations: &Equations, index: usize, name: &str) -> Vec<&'static str> {
    let definitions = equations.all[..index].iter().filter_map(|equation| Some((equation.definition?, equation.unit)));
    let parameters = equations.info.parameters.iter().map(|parameter| (parameter.name, parameter.unit));
    let known: Vec<_> = parameters.chain(definitions).collect();
    let Some((_, unit)) = known.iter().rev().find(|(known, _)| *known == name).copied() else { return Vec::new() };
    let is_alike = |other: &&(&str, &str)| other.0 != name && other.1 == unit && !unit.is_empty();
    known.iter().filter(is_alike).map(|(other, _)| *other).collect()
}

/// What is other, and the formula with it.
type Varied = Vec<(String, Formula)>;

struct Slips<'a> {
    alike: &'a dyn Fn(&str) -> Vec<&'static str>,
}

impl Slips<'_> {
    /// The slips of a formula that stands by itself; `name` is what to call it.
    fn whole(&self, name: &str, formula: &Formula) -> Varied {
        let mut all = match formula {
            Formula::Sum(_) => Vec::new(),
            term => sizes(name, term),
        };
        all.extend(self.inside(formula));
        all
    }

    fn inside(&self, formula: &Formula) -> Varied {
        match formula {
            Formula::Number(..) => Vec::new(),
            Formula::Name(name) => self.named(name),
            Formula::Sum(terms) => self.terms(terms),
            Formula::Product(factors) => self.factors(factors),
            Formula::Power(base, exponent) => {
                let power = |exponent: &str| Formula::Power(base.clone(), exponent.into());
                let mut all = vec![(format!("`{base}` stands for `{formula}`"), (**base).clone())];
                all.extend(
                    ["2", "3"]
                        .into_iter()
                        .filter(|other| other != exponent)
                        .map(|other| (format!("`{}` stands for `{formula}`", power(other)), power(other))),
                );
                // As one types it who forgets what a power is.
                let product =
                    Formula::Product(vec![(false, (**base).clone()), (false, Formula::Number(exponent.clone(), None))]);
                all.push((format!("`{product}` stands for `{formula}`"), product));
                let inner = self.inside(base);
                all.extend(
                    inner.into_iter().map(|(what, base)| (what, Formula::Power(Box::new(base), exponent.clone()))),
                );
                all
            }
            Formula::Call(function, argument) => {
                let call = |function: &str| Formula::Call(function.into(), argument.clone());
                let others = ["sin", "cos", "tan"].into_iter().filter(|other| function != "sqrt" && other != function);
                let mut all: Varied =
                    others.map(|other| (format!("`{}` stands for `{formula}`", call(other)), call(other))).collect();
                all.push((format!("`{argument}` stands for `{formula}`"), (**argument).clone()));
                let inner = self.whole("the argument", argument);
                all.extend(
                    inner
                        .into_iter()
                        .map(|(what, argument)| (what, Formula::Call(function.clone(), Box::new(argument)))),
                );
                all
            }
        }
    }

    fn named(&self, name: &str) -> Varied {
        let other = |other: &str| (format!("`{other}` stands for `{name}`"), Formula::Name(other.into()));
        let mut all: Varied = (self.alike)(name).into_iter().map(other).collect();
        if name != "pi" {
            let square = Formula::Power(Box::new(Formula::Name(name.into())), "2".into());
            all.push((format!("`{square}` stands for `{name}`"), square));
        }
        all
    }

    fn terms(&self, terms: &[(bool, Formula)]) -> Varied {
        let mut all = Vec::new();
        for (index, (negative, term)) in terms.iter().enumerate() {
            let with = |negative: bool, term: Formula| {
                let mut terms = terms.to_vec();
                terms[index] = (negative, term);
                Formula::Sum(terms)
            };
            all.push((format!("the term `{term}` has the other sign"), with(!negative, term.clone())));
            if terms.len() > 1 {
                let mut rest = terms.to_vec();
                rest.remove(index);
                all.push((format!("the term `{term}` is missing"), Formula::Sum(rest)));
                let name = format!("the term `{term}`");
                all.extend(sizes(&name, term).into_iter().map(|(what, term)| (what, with(*negative, term))));
            }
            all.extend(self.inside(term).into_iter().map(|(what, term)| (what, with(*negative, term))));
        }
        all
    }

    fn factors(&self, factors: &[(bool, Formula)]) -> Varied {
        let mut all = Vec::new();
        for (index, (inverse, factor)) in factors.iter().enumerate() {
            let with = |inverse: bool, factor: Formula| {
                let mut factors = factors.to_vec();
                factors[index] = (inverse, factor);
                Formula::Product(factors)
            };
            let does = |inverse: bool| if inverse { "divides" } else { "multiplies" };
            let mut rest = factors.to_vec();
            rest.remove(index);
            all.push((
                format!("the {} `{factor}` is missing", if *inverse { "divisor" } else { "factor" }),
                Formula::Product(rest),
            ));
            all.push((format!("`{factor}` {}", does(!inverse)), with(!inverse, factor.clone())));
            all.extend(self.inside(factor).into_iter().map(|(what, factor)| (what, with(*inverse, factor))));
        }
        all
    }
}

/// Something twice and half as large.
fn sizes(name: &str, formula: &Formula) -> Varied {
    let times =
        |inverse: bool| Formula::Product(vec![(false, formula.clone()), (inverse, Formula::Number("2".into(), None))]);
    vec![(format!("{name} is twice as large"), times(false)), (format!("{name} is half as large"), times(true))]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Vec<String> {
        let alike = |name: &str| if name == "a" { vec!["b"] } else { Vec::new() };
        let formula = Formula::parse(text).expect("a formula");
        Slips { alike: &alike }
            .whole("the formula", &formula)
            .into_iter()
            .map(|(what, formula)| format!("{formula}: {what}"))
            .collect()
    }

    #[test]
    fn every_place_has_its_slips() {
        assert_eq!(
            of("a*c^2"),
            [
                "(a*c^2)*2: the formula is twice as large",
                "(a*c^2)/2: the formula is half as large",
                "c^2: the factor `a` is missing",
                "1/a*c^2: `a` divides",
                "b*c^2: `b` stands for `a`",
                "a^2*c^2: `a^2` stands for `a`",
                "a: the factor `c^2` is missing",
                "a/c^2: `c^2` divides",
                "a*c: `c` stands for `c^2`",
                "a*c^3: `c^3` stands for `c^2`",
                "a*(c*2): `c*2` stands for `c^2`",
                "a*(c^2)^2: `c^2` stands for `c`",
            ]
        );
        let signs = of("c - sin(d)/f");
        for expected in [
            "-c - sin(d)/f: the term `c` has the other sign",
            "c + sin(d)/f: the term `sin(d)/f` has the other sign",
            "c: the term `sin(d)/f` is missing",
            "c - cos(d)/f: `cos(d)` stands for `sin(d)`",
            "c - sin(d*2)/f: the argument is twice as large",
            "c - sin(d)*f: `f` multiplies",
            "c - sin(d): the divisor `f` is missing",
        ] {
            assert!(signs.iter().any(|found| found == expected), "{expected}: {signs:#?}");
        }
    }
}
