//! The dimension of a formula, and mistakes on the way to it.

use super::declared::{Dimensions, Quantity};
use super::dimension::Dimension;
use crate::check::feedback::RATE;
use crate::check::names::{Meaning, Scope};
use crate::formula::Function;
use crate::report::{Region, Report};
use crate::syntax::{Assertion, Declaration, Expression, Kind, Term};

/// What stands before a wheel in parentheses for its steady load.
pub const LOAD: &str = "load";

/// What the names in formulas are in.
pub struct Analysis<'a> {
    pub declaration: &'a Declaration,
    pub scope: &'a Scope,
    pub dimensions: &'a Dimensions,
    /// By position among the definitions; none for those not yet known.
    pub definitions: Vec<Option<Dimension>>,
    /// What moves, where formulas may say of it where it is and how fast.
    pub motions: Vec<(String, Option<Dimension>)>,
}

impl Analysis<'_> {
    /// The dimension of a formula; none for zero, which has any, and where a mistake hides it.
    pub fn dimension(&self, formula: &Expression, report: &mut Report) -> Option<Dimension> {
        let beyond = |report: &mut Report| {
            report.error(formula.region, "a unit beyond all use here: expected smaller powers and fewer nested roots");
        };
        let result = match &formula.kind {
            Kind::Number(number) if number.is_zero() => return None,
            Kind::Number(_) => Some(Dimension::NUMBER),
            Kind::Quantity(_, unit) => return Quantity::new(unit).ok().map(|quantity| quantity.dimension),
            Kind::Name(name) => return self.of_name(name),
            Kind::Sum(terms) => return self.sum(terms, report),
            Kind::Product(factors) => {
                // All factors are looked at, for the mistakes inside them.
                let parts: Vec<_> = factors.iter().map(|f| (f.inverse, self.dimension(&f.value, report))).collect();
                let mut product = Some(Dimension::NUMBER);
                for (inverse, part) in parts {
                    let part = part?;
                    let part = if inverse { part.power(-1) } else { Some(part) };
                    product = product.zip(part).and_then(|(product, part)| product.times(part));
                }
                product
            }
            Kind::Power(_, 0) => Some(Dimension::NUMBER),
            Kind::Power(base, exponent) => self.dimension(base, report)?.power(*exponent),
            // A force; elsewhere it is a mistake of its own.
            Kind::Call(name, _) if name == LOAD && self.scope.get(name).is_none() => {
                return Some(Dimension::new([1, 1, -2]));
            }
            Kind::Call(name, argument) => {
                let inner = self.dimension(argument, report);
                if name == RATE && !self.motions.is_empty() {
                    // The rate of what does not move is a mistake of its own.
                    let mut moves = false;
                    argument.names(&mut |name| moves |= self.motions.iter().any(|(known, _)| name == known));
                    return inner.filter(|_| moves)?.times(Dimension::new([0, 0, -1]));
                }
                // Another function is a mistake of its own.
                let function = Function::from_name(&name.to_string())?;
                // Whatever unit a zero has, its cosine is one.
                let Some(inner) = inner else { return (function == Function::Cos).then_some(Dimension::NUMBER) };
                return self.call(function, inner, argument, report);
            }
        };
        if result.is_none() {
            beyond(report);
        }
        result
    }

    fn of_name(&self, name: &proc_macro2::Ident) -> Option<Dimension> {
        match self.scope.get(name) {
            Some(Meaning::Parameter(index) | Meaning::Speed(index)) => self.dimensions.parameters[index],
            Some(Meaning::Definition(index)) => self.definitions[index],
            Some(Meaning::Refused) => None,
            Some(Meaning::Coordinate) | None => match self.motions.iter().find(|(known, _)| name == known) {
                Some((_, dimension)) => *dimension,
                None => (name == "pi").then_some(Dimension::NUMBER),
            },
        }
    }

    /// All terms of a sum are in one unit and mirror alike; those that differ from most of them are reported.
    fn sum(&self, terms: &[Term], report: &mut Report) -> Option<Dimension> {
        let found: Vec<_> = terms.iter().map(|term| self.dimension(&term.value, report)).collect();
        // What most terms have, the first of equally many: with its first term, and how many there are.
        let mut kinds: Vec<(Dimension, usize, usize)> = Vec::new();
        for (index, found) in found.iter().enumerate() {
            let Some(found) = *found else { continue };
            match kinds.iter_mut().find(|(kind, ..)| self.alike(*kind, found)) {
                Some((.., count)) => *count += 1,
                None => kinds.push((found, index, 1)),
            }
        }
        let (dimension, usual, _) = kinds.into_iter().rev().max_by_key(|(.., count)| *count)?;
        let mut right = true;
        for (index, term) in terms.iter().enumerate() {
            let Some(other) = found[index].filter(|other| !self.alike(*other, dimension)) else { continue };
            let this = (&term.value, other);
            let usual = (&terms[usual].value, dimension);
            let message =
                if other.same_unit(dimension) { self.two_mirrors(this, usual) } else { self.two_units(this, usual) };
            // The first term of a sum mostly has no sign: then the one behind it is meant.
            let operator = term.operator.or_else(|| terms.get(index + 1).and_then(|next| next.operator));
            report.error(operator.map_or(term.value.region, Region::from), message);
            right = false;
        }
        right.then_some(dimension)
    }

    /// Both sides of an assertion are in one unit and mirror alike.
    pub fn check_equal(&self, Assertion { left, right, .. }: &Assertion, report: &mut Report) {
        let sides = self.dimension(left, report).zip(self.dimension(right, report));
        let Some((one, other)) = sides.filter(|(one, other)| !self.alike(*one, *other)) else { return };
        let (this, that) = ((right, other), (left, one));
        let message = if one.same_unit(other) { self.two_mirrors(this, that) } else { self.two_units(this, that) };
        report.error(left.region.to(right.region), message);
    }

    fn alike(&self, one: Dimension, other: Dimension) -> bool {
        if self.dimensions.mirrored { one == other } else { one.same_unit(other) }
    }

    fn two_units(&self, this: (&Expression, Dimension), usual: (&Expression, Dimension)) -> String {
        let origins = self.units([this.0, usual.0]);
        let (a, b) = (short(this.0), short(usual.0));
        format!("`{a}` is {}, but `{b}` {}: expected the same unit{origins}", this.1.place(), usual.1.place())
    }

    fn two_mirrors(&self, this: (&Expression, Dimension), usual: (&Expression, Dimension)) -> String {
        let origins = self.mirrors([this.0, usual.0]);
        let (a, b) = (short(this.0), short(usual.0));
        format!("`{a}` {}, but `{b}` {}: expected them to mirror alike{origins}", this.1.sign(), usual.1.sign())
    }

    /// Where the units of formulas come from, unless it is plain.
    fn units<const N: usize>(&self, formulas: [&Expression; N]) -> String {
        self.origins(formulas, |name, dimension| Some(format!("`{name}` {}", dimension.place())))
    }

    /// Where the mirrors of formulas come from, unless it is plain.
    fn mirrors<const N: usize>(&self, formulas: [&Expression; N]) -> String {
        self.origins(formulas, |name, dimension| {
            dimension.is_odd().then(|| format!("`{name}` mirrors with {}", dimension.axes().join(" and ")))
        })
    }

    /// An entry for each name in some formulas, unless each of them is a name itself.
    fn origins<const N: usize>(
        &self,
        formulas: [&Expression; N],
        entry: impl Fn(&str, Dimension) -> Option<String>,
    ) -> String {
        if formulas.iter().all(|formula| matches!(formula.kind, Kind::Name(_))) {
            return String::new();
        }
        let mut entries: Vec<String> = Vec::new();
        for formula in formulas {
            formula.names(&mut |name| {
                let dimension = self.of_name(name).filter(|_| name != "pi");
                if let Some(entry) = dimension.and_then(|dimension| entry(&name.to_string(), dimension))
                    && !entries.contains(&entry)
                {
                    entries.push(entry);
                }
            });
        }
        if entries.is_empty() { String::new() } else { format!(" ({})", entries.join(", ")) }
    }

    fn call(
        &self,
        function: Function,
        inner: Dimension,
        argument: &Expression,
        report: &mut Report,
    ) -> Option<Dimension> {
        match function {
            Function::Sqrt if self.dimensions.mirrored && inner.is_odd() => {
                let sign = inner.sign();
                let origins = self.mirrors([argument]);
                let message = format!("this square root is of what {sign}: expected what no mirror changes{origins}");
                report.error(argument.region, message);
                None
            }
            Function::Sqrt => {
                let root = inner.root();
                if root.is_none() {
                    report.error(argument.region, "a unit beyond all use here: expected fewer nested roots");
                }
                root
            }
            Function::Sin | Function::Cos | Function::Tan if !inner.is_number() => {
                let origins = self.units([argument]);
                let name = function.name();
                let message = format!("`{name}` of what is in {inner}: expected a pure number or an angle{origins}");
                report.error(argument.region, message);
                None
            }
            Function::Cos => Some(Dimension::NUMBER),
            Function::Sin | Function::Tan => Some(inner),
        }
    }
}

/// A formula as text for a message, which a long one would bury.
pub fn short(formula: &Expression) -> String {
    let text = formula.to_string();
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

const LONGEST: usize = 60;
