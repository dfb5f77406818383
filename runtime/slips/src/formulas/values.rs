//! The values of formulas, as they are and with other texts.

use carvallo::{Expression, FormulaNumber, MatrixName};

use super::{Formulas, Subject, definitions_of};
use crate::places::index;

/// The values of all formulas.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values<T = f64> {
    definitions: Vec<T>,
    /// Of all eight matrices, in the order of [`MatrixName::ALL`], row by row.
    pub entries: Vec<T>,
}

/// Formulas that have another text, all of them the same one.
pub type Change<'a> = (&'a [usize], &'a Expression);

impl Values {
    /// That of a definition.
    pub fn definition(&self, at: usize) -> f64 {
        self.definitions[at]
    }

    /// That of one of the formulas.
    pub fn of_formula(&self, formulas: &Formulas, at: usize) -> f64 {
        match formulas.formulas[at].subject {
            Subject::Entry(matrix, row, column) => self.entries[index(matrix, row, column, formulas.count)],
            Subject::Definition(_) | Subject::OfMechanism(_) | Subject::Attribute(_) => self.definitions[at],
        }
    }

    /// That of a formula in parameters and these definitions.
    pub fn of(&self, formula: &Expression, parameters: &[f64]) -> f64 {
        formula.evaluate(parameters, &self.definitions).unwrap_or(f64::NAN)
    }
}

impl Formulas {
    /// The values for parameters in declared order; NaN where there is none.
    pub fn values(&self, parameters: &[f64]) -> Values {
        let mut values = self.start(f64::NAN, 0.0);
        self.needed().for_each(|at| self.evaluate_or_nan(at, None, parameters, &mut values));
        values
    }

    /// The same in any numbers; `None` where a formula has no value.
    pub fn values_of<T: FormulaNumber>(&self, parameters: &[T]) -> Option<Values<T>> {
        let zero = T::decimal("0", 0.0);
        let mut values = self.start(zero, zero);
        self.needed().try_for_each(|at| self.evaluate(at, None, parameters, &mut values))?;
        Some(values)
    }

    /// The definitions, and what makes each entry once.
    fn needed(&self) -> impl Iterator<Item = usize> + '_ {
        let is_needed = |at: &usize| *at < self.definitions || !self.formulas[*at].is_of_mechanism;
        (0..self.formulas.len()).filter(is_needed)
    }

    /// The entries by the attributes of the mechanism, with their values for parameters in declared order; none where there are no
    /// attributes.
    pub fn entries_of_mechanism(&self, parameters: &[f64]) -> Option<Vec<f64>> {
        let mut values = self.values(parameters);
        values.entries.fill(0.0);
        let entries = (self.definitions..self.formulas.len()).filter(|at| self.formulas[*at].is_of_mechanism);
        let entries: Vec<usize> = entries.collect();
        entries.iter().for_each(|&at| self.evaluate_or_nan(at, None, parameters, &mut values));
        (!entries.is_empty()).then_some(values.entries)
    }

    fn start<T: Copy>(&self, definition: T, entry: T) -> Values<T> {
        Values {
            definitions: vec![definition; self.definitions],
            entries: vec![entry; MatrixName::ALL.len() * self.count * self.count],
        }
    }

    /// Makes the values into those where some formulas have another text, which
    /// [is not circular](Self::is_circular): `values` are those of the formulas as they are.
    pub fn change(&self, formulas: &[usize], text: &Expression, parameters: &[f64], values: &mut Values) {
        for &formula in formulas {
            self.evaluate_or_nan(formula, Some(text), parameters, values);
            for &dependent in self.dependents(formula) {
                self.evaluate_or_nan(dependent, None, parameters, values);
            }
        }
    }

    /// The formulas whose values change with those of some, in an order in which they can be evaluated: for [`Self::change_both`].
    pub fn affected(&self, changed: impl IntoIterator<Item = usize>) -> Vec<usize> {
        let changed = changed.into_iter();
        let mut all: Vec<usize> = changed.flat_map(|formula| [&[formula], self.dependents(formula)].concat()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The same with two changes, which together are not circular either, of those formulas that are `affected`, or of some of
    /// these with all that they are made of.
    pub fn change_both(&self, both: [Change; 2], affected: &[usize], parameters: &[f64], values: &mut Values) {
        // A formula with a slip may use a later one: the other one, which has to be there before.
        let uses_later = |(formulas, text): &Change| {
            definitions_of(text).iter().any(|used| formulas.iter().all(|formula| used > formula))
        };
        for _ in 0..=both.iter().filter(|change| uses_later(change)).count() {
            for &at in affected {
                let text = both.iter().find(|(formulas, _)| formulas.contains(&at)).map(|(_, text)| *text);
                self.evaluate_or_nan(at, text, parameters, values);
            }
        }
    }

    fn evaluate_or_nan(&self, at: usize, text: Option<&Expression>, parameters: &[f64], values: &mut Values) {
        if self.evaluate(at, text, parameters, values).is_none() {
            self.set(at, f64::NAN, values);
        }
    }

    fn evaluate<T: FormulaNumber>(
        &self,
        at: usize,
        text: Option<&Expression>,
        parameters: &[T],
        values: &mut Values<T>,
    ) -> Option<()> {
        let text = text.unwrap_or(&self.formulas[at].expression);
        let value = text.evaluate(parameters, &values.definitions)?;
        self.set(at, value, values);
        Some(())
    }

    fn set<T>(&self, at: usize, value: T, values: &mut Values<T>) {
        match self.formulas[at].subject {
            Subject::Entry(matrix, row, column) => values.entries[index(matrix, row, column, self.count)] = value,
            Subject::Definition(_) | Subject::OfMechanism(_) | Subject::Attribute(_) => values.definitions[at] = value,
        }
    }
}
