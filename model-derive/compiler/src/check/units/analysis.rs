//! The dimension of a formula, and mistakes on the way to it.

use super::declared::{Dimensions, Quantity};
use super::dimension::Dimension;
use crate::check::names::{Meaning, Scope};
use crate::check::resolve::text;
use crate::report::{Region, Report};
use crate::syntax::{Declaration, Expression, Kind, Term};

/// What the names in formulas are in.
pub struct Analysis<'a> {
    pub declaration: &'a Declaration,
    pub scope: &'a Scope,
    pub dimensions: &'a Dimensions,
    /// By position in the declaration; none for those not yet known.
    pub definitions: Vec<Option<Dimension>>,
}

impl Analysis<'_> {
    /// The dimension of a formula; none for zero, which has any, and where a mistake hides it.
    pub fn dimension(&self, formula: &Expression, report: &mut Report) -> Option<Dimension> {
        let beyond = |report: &mut Report| {
            report.error(formula.region, "a unit beyond all use here: expected smaller powers and fewer nested roots");
        };
        let result = match &formula.kind {
            Kind::Number(number) if number.is_zero() => return None,
            Kind::Quantity(number, _) if number.is_zero() => return None,
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
            Kind::Power(base, exponent) => self.dimension(base, report)?.power(*exponent),
            Kind::Call(function, argument) => {
                let inner = self.dimension(argument, report)?;
                return self.call(&function.to_string(), inner, argument, report);
            }
        };
        if result.is_none() {
            beyond(report);
        }
        result
    }

    fn of_name(&self, name: &proc_macro2::Ident) -> Option<Dimension> {
        if name == "pi" {
            return Some(Dimension::NUMBER);
        }
        match self.scope.get(name)? {
            Meaning::Parameter(index) => self.dimensions.parameters[index],
            Meaning::Definition(index) => self.definitions[index],
            Meaning::Coordinate | Meaning::Unread => None,
        }
    }

    /// All terms of a sum are in one unit and mirror alike; those that differ from most of them are reported.
    fn sum(&self, terms: &[Term], report: &mut Report) -> Option<Dimension> {
        let found: Vec<_> = terms.iter().map(|term| self.dimension(&term.value, report)).collect();
        let alike = |one: Dimension, other: Dimension| {
            if self.dimensions.mirrored { one == other } else { one.same_unit(other) }
        };
        let count = |one: Dimension| found.iter().flatten().filter(|other| alike(one, **other)).count();
        // The last of the maxima in the reverse order is the first in the sum's own.
        let known = found.iter().enumerate().rev().filter_map(|(index, dimension)| Some((index, (*dimension)?)));
        let (usual, dimension) = known.max_by_key(|(_, dimension)| count(*dimension))?;
        let mut right = true;
        for (index, term) in terms.iter().enumerate() {
            let Some(other) = found[index].filter(|other| !alike(*other, dimension)) else { continue };
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

    fn two_units(&self, this: (&Expression, Dimension), usual: (&Expression, Dimension)) -> String {
        let origins = self.origins([this.0, usual.0], |name, dimension| format!("`{name}` in {dimension}"));
        let (this, usual) = ((short(this.0), this.1), (short(usual.0), usual.1));
        format!("`{}` is in {}, but `{}` in {}: expected terms in one unit{origins}", this.0, this.1, usual.0, usual.1)
    }

    fn two_mirrors(&self, this: (&Expression, Dimension), usual: (&Expression, Dimension)) -> String {
        let origins = self.origins([this.0, usual.0], |name, d| format!("`{name}` {}", d.mirrors()));
        format!(
            "`{}` changes its sign {}, but `{}` {}: expected terms that mirror alike{origins}",
            short(this.0),
            this.1.mirrors(),
            short(usual.0),
            usual.1.mirrors(),
        )
    }

    /// Where the dimensions of formulas come from: their names, unless each is a name itself.
    fn origins<const N: usize>(&self, formulas: [&Expression; N], entry: impl Fn(&str, Dimension) -> String) -> String {
        if formulas.iter().all(|formula| matches!(formula.kind, Kind::Name(_))) {
            return String::new();
        }
        let mut entries: Vec<String> = Vec::new();
        for formula in formulas {
            formula.names(&mut |name| {
                if let Some(dimension) = self.of_name(name).filter(|_| name != "pi") {
                    let entry = entry(&name.to_string(), dimension);
                    if !entries.contains(&entry) {
                        entries.push(entry);
                    }
                }
            });
        }
        if entries.is_empty() { String::new() } else { format!(" ({})", entries.join(", ")) }
    }

    fn call(&self, function: &str, inner: Dimension, argument: &Expression, report: &mut Report) -> Option<Dimension> {
        let in_unit = |name: &str, dimension: Dimension| format!("`{name}` in {dimension}");
        match function {
            "sqrt" if self.dimensions.mirrored && inner.is_odd() => {
                let message = format!(
                    "the square root of a quantity that changes its sign {}: expected one that no mirror changes{}",
                    inner.mirrors(),
                    self.origins([argument], |name, d| format!("`{name}` {}", d.mirrors())),
                );
                report.error(argument.region, message);
                None
            }
            "sqrt" => {
                let root = inner.root();
                if root.is_none() {
                    report.error(argument.region, "a unit beyond all use here: expected fewer nested roots");
                }
                root
            }
            "sin" | "cos" | "tan" if !inner.is_number() => {
                let origins = self.origins([argument], in_unit);
                let message =
                    format!("`{function}` of a quantity in {inner}: expected a pure number or an angle{origins}");
                report.error(argument.region, message);
                None
            }
            "cos" => Some(Dimension::NUMBER),
            "sin" | "tan" => Some(inner),
            // Another function is a mistake of its own.
            _ => None,
        }
    }
}

/// A formula as text for a message, which a long one would bury.
pub fn short(formula: &Expression) -> String {
    let text = text(formula);
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

const LONGEST: usize = 60;
