//! The formulas of a model, as it tells them.

mod slips;

use carvallo::{Expression, Formula, FormulaNumber, FormulaSubject, MatrixName, ModelInfo};

pub use slips::{Slip, slips};

/// The matrices, of which one entry after the other makes the entries of a machine.
const MATRICES: [MatrixName; 8] = MatrixName::ALL;

/// The number of entries of all matrices with `n` coordinates.
pub fn count(n: usize) -> usize {
    MATRICES.len() * n * n
}

/// The position of an entry among those of all matrices with `n` coordinates, matrix by matrix and row by row.
pub fn position(n: usize, (matrix, row, column): (MatrixName, usize, usize)) -> usize {
    let matrix = MATRICES.iter().position(|name| *name == matrix).unwrap_or_default();
    (matrix * n + row) * n + column
}

/// The place of the entry at a position.
pub fn place(n: usize, position: usize) -> (MatrixName, usize, usize) {
    (MATRICES[position / (n * n)], position / n % n, position % n)
}

/// A definition or an entry.
#[derive(Clone, Debug)]
pub struct Equation {
    /// The name of a definition; of an entry, none.
    pub definition: Option<&'static str>,
    /// The positions of the entries that have it.
    pub positions: Vec<usize>,
    pub unit: &'static str,
    pub formula: Formula,
    expression: Expression,
}

/// The definitions of a model, each in those before it, and then its entries.
#[derive(Clone, Debug)]
pub struct Equations {
    pub info: &'static ModelInfo,
    /// The number of coordinates.
    pub n: usize,
    pub all: Vec<Equation>,
}

impl Equations {
    /// Those that a model tells; nothing if there is one among them that is no formula of parameters and definitions.
    pub fn of(info: &'static ModelInfo) -> Option<Self> {
        let n = info.coordinates.len();
        let mut all: Vec<Equation> = Vec::new();
        for told in info.formulas {
            let formula = Formula::parse(told.text)?;
            let definitions: Vec<_> = all.iter().filter_map(|equation| equation.definition).collect();
            let expression = Expression::new(&formula, &|name| find(info, &definitions, name))?;
            let (definition, positions) = match told.of {
                FormulaSubject::Definition(name) => (Some(name), Vec::new()),
                FormulaSubject::Entry(entry) => (None, entry.places.iter().map(|at| position(n, *at)).collect()),
            };
            all.push(Equation { definition, positions, unit: told.unit, formula, expression });
        }
        (!all.is_empty()).then_some(Self { info, n, all })
    }

    /// The entries of all matrices at parameters; nothing where a formula has no value.
    pub fn entries<T: FormulaNumber>(&self, parameters: &[T]) -> Option<Vec<T>> {
        self.entries_but(parameters, usize::MAX, None)
    }

    /// The same with a slip in one of the formulas.
    pub fn entries_with<T: FormulaNumber>(
        &self,
        parameters: &[T],
        Slip { equation, expression, .. }: &Slip,
    ) -> Option<Vec<T>> {
        self.entries_but(parameters, *equation, Some(expression))
    }

    fn entries_but<T: FormulaNumber>(
        &self,
        parameters: &[T],
        at: usize,
        instead: Option<&Expression>,
    ) -> Option<Vec<T>> {
        let mut definitions = Vec::new();
        let mut entries = vec![T::decimal("0", 0.0); count(self.n)];
        for (index, equation) in self.all.iter().enumerate() {
            let expression = instead.filter(|_| index == at).unwrap_or(&equation.expression);
            let value = expression.evaluate(parameters, &definitions)?;
            match equation.definition {
                Some(_) => definitions.push(value),
                None => equation.positions.iter().for_each(|position| entries[*position] = value),
            }
        }
        Some(entries)
    }

    /// What a name stands for in the equation at an index.
    pub fn name(&self, name: &str, index: usize) -> Option<Expression> {
        let definitions: Vec<_> = self.all[..index].iter().filter_map(|equation| equation.definition).collect();
        find(self.info, &definitions, name)
    }

    /// The equation of the entry at a position; none for an entry that is zero.
    pub fn equation_of(&self, position: usize) -> Option<&Equation> {
        self.all.iter().find(|equation| equation.positions.contains(&position))
    }
}

fn find(info: &ModelInfo, definitions: &[&str], name: &str) -> Option<Expression> {
    let definition = definitions.iter().rposition(|known| *known == name).map(Expression::Definition);
    definition.or_else(|| info.position(name).map(Expression::Parameter))
}
