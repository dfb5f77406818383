//! The formulas of a model, all of them compiled to trees, and what becomes of the matrices when one is changed.

use carvallo::{Expression, FormulaSubject, MatrixName, ModelInfo};

/// What a formula is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The definition of this name.
    Definition(&'static str),
    /// An entry of a matrix, with its row and column from zero.
    Entry(MatrixName, usize, usize),
}

/// One formula of a model.
#[derive(Clone, Debug)]
pub struct Formula {
    /// What it is of.
    pub subject: Subject,
    /// As `carvallo equations` prints it.
    pub text: &'static str,
    /// The entries that have the same formula, this one among them; empty for definitions.
    pub shared: Vec<usize>,
    expression: Expression,
}

/// The formulas of a model: the definitions, each in those before it, then every entry of the matrices that it has.
#[derive(Clone, Debug)]
pub struct Formulas {
    /// All of them.
    pub formulas: Vec<Formula>,
    /// Parameters and definitions, as they are declared.
    pub names: Vec<&'static str>,
    /// How many coordinates there are.
    pub count: usize,
    parameters: usize,
    definitions: usize,
    /// Of each definition the formulas that depend on it, in their order.
    dependents: Vec<Vec<usize>>,
}

/// The values of all formulas.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    definitions: Vec<f64>,
    /// Of all eight matrices, in the order of [`MatrixName::ALL`], row by row.
    pub entries: Vec<f64>,
}

/// Where an entry is among those of all matrices.
pub fn index(matrix: MatrixName, row: usize, column: usize, count: usize) -> usize {
    let at = MatrixName::ALL.iter().position(|name| *name == matrix).unwrap_or_default();
    (at * count + row) * count + column
}

impl Values {
    /// That of a definition.
    pub fn definition(&self, at: usize) -> f64 {
        self.definitions[at]
    }

    /// That of a formula in parameters and these definitions.
    pub fn of(&self, formula: &Expression, parameters: &[f64]) -> f64 {
        formula.evaluate(parameters, &self.definitions).unwrap_or(f64::NAN)
    }
}

impl Formulas {
    /// Those of a model.
    ///
    /// # Errors
    /// That it has none, or the one that cannot be read.
    pub fn new(info: &ModelInfo) -> Result<Self, String> {
        if info.formulas.is_empty() {
            return Err(format!("the model {} has no formulas", info.name));
        }
        let (count, parameters) = (info.coordinates.len(), info.parameters.len());
        let mut names: Vec<&'static str> = info.parameters.iter().map(|parameter| parameter.name).collect();
        names.extend(info.formulas.iter().filter_map(|formula| match formula.of {
            FormulaSubject::Definition(name) => Some(name),
            FormulaSubject::Entry(_) => None,
        }));
        let definitions = names.len() - parameters;
        let mut own = Self { formulas: Vec::new(), names, count, parameters, definitions, dependents: Vec::new() };
        let mut texts = vec![None; MatrixName::ALL.len() * count * count];
        for (at, formula) in info.formulas.iter().enumerate() {
            match formula.of {
                FormulaSubject::Definition(name) => own.push(Subject::Definition(name), formula.text)?,
                FormulaSubject::Entry(entry) => {
                    entry.places.iter().for_each(|&(matrix, row, column)| {
                        texts[index(matrix, row, column, count)] = Some((at, formula.text));
                    });
                }
            }
        }
        // In the order of the matrices, with the entries that are zero, which may be mistaken, too.
        let mut groups: Vec<(usize, Vec<usize>)> = Vec::new();
        for &matrix in info.matrices {
            for (row, column) in (0..count * count).map(|place| (place / count, place % count)) {
                let text = texts[index(matrix, row, column, count)];
                own.push(Subject::Entry(matrix, row, column), text.map_or("0", |(_, text)| text))?;
                let last = own.formulas.len() - 1;
                match (text, groups.iter_mut().find(|(group, _)| Some(*group) == text.map(|(at, _)| at))) {
                    (Some(_), Some((_, members))) => members.push(last),
                    (Some((at, _)), None) => groups.push((at, vec![last])),
                    (None, _) => own.formulas[last].shared.push(last),
                }
            }
        }
        for (_, members) in groups {
            members.iter().for_each(|&member| own.formulas[member].shared.clone_from(&members));
        }
        own.dependents = own.find_dependents();
        Ok(own)
    }

    fn push(&mut self, subject: Subject, text: &'static str) -> Result<(), String> {
        let expression = self.parse(text).ok_or_else(|| format!("`{text}` is no formula"))?;
        self.formulas.push(Formula { subject, text, shared: Vec::new(), expression });
        Ok(())
    }

    /// The tree of a formula in these names; `None` if it is none.
    pub fn parse(&self, text: &str) -> Option<Expression> {
        let name = |name: &str| {
            let position = self.names.iter().position(|known| *known == name)?;
            Some(match position.checked_sub(self.parameters) {
                None => Expression::Parameter(position),
                Some(definition) => Expression::Definition(definition),
            })
        };
        Expression::new(&carvallo::Formula::parse(text)?, &name)
    }

    fn find_dependents(&self) -> Vec<Vec<usize>> {
        let uses: Vec<Vec<usize>> = self.formulas.iter().map(|formula| definitions_of(&formula.expression)).collect();
        let dependents = |definition: usize| {
            let mut found: Vec<usize> = Vec::new();
            for (at, uses) in uses.iter().enumerate().skip(definition + 1) {
                if uses.contains(&definition) || uses.iter().any(|used| found.contains(used)) {
                    found.push(at);
                }
            }
            found
        };
        (0..self.definitions).map(dependents).collect()
    }

    /// The formulas that depend on one, without it.
    pub fn dependents(&self, formula: usize) -> &[usize] {
        self.dependents.get(formula).map_or(&[], Vec::as_slice)
    }

    /// The values for parameters in declared order.
    pub fn values(&self, parameters: &[f64]) -> Values {
        let mut values = Values {
            definitions: vec![f64::NAN; self.definitions],
            entries: vec![0.0; MatrixName::ALL.len() * self.count * self.count],
        };
        for at in 0..self.formulas.len() {
            self.evaluate(at, None, parameters, &mut values);
        }
        values
    }

    /// Whether one formula is another, or depends on it.
    pub fn feeds(&self, formula: usize, other: usize) -> bool {
        formula == other || self.dependents(formula).contains(&other)
    }

    /// The formula of an entry.
    pub fn entry(&self, matrix: MatrixName, row: usize, column: usize) -> Option<usize> {
        self.formulas.iter().position(|own| own.subject == Subject::Entry(matrix, row, column))
    }

    /// Whether one of some formulas would depend on itself if it had this text.
    pub fn is_circular(&self, formulas: &[usize], text: &Expression) -> bool {
        let uses = definitions_of(text);
        formulas.iter().any(|&formula| uses.iter().any(|&used| self.feeds(formula, used)))
    }

    /// Makes the values into those where some formulas have another text, which all have the same one and which
    /// [is not circular](Self::is_circular): `values` are those of the formulas as they are.
    pub fn change(&self, formulas: &[usize], text: &Expression, parameters: &[f64], values: &mut Values) {
        for &formula in formulas {
            self.evaluate(formula, Some(text), parameters, values);
            for &dependent in self.dependents(formula) {
                self.evaluate(dependent, None, parameters, values);
            }
        }
    }

    fn evaluate(&self, at: usize, text: Option<&Expression>, parameters: &[f64], values: &mut Values) {
        let formula = &self.formulas[at];
        let value = text.unwrap_or(&formula.expression);
        let value = value.evaluate(parameters, &values.definitions).unwrap_or(f64::NAN);
        match formula.subject {
            Subject::Definition(_) => values.definitions[at] = value,
            Subject::Entry(matrix, row, column) => values.entries[index(matrix, row, column, self.count)] = value,
        }
    }
}

fn definitions_of(expression: &Expression) -> Vec<usize> {
    let mut found = Vec::new();
    expression.each_definition(&mut |definition| found.push(definition));
    found
}

#[cfg(test)]
mod tests {
    use super::Formulas;
    use carvallo::MatrixName;
    use carvallo_design::MODELS;

    /// The formulas that are printed make the matrices that were compiled: for every model and all of its sets.
    #[test]
    fn formulas_make_the_matrices_of_every_model() {
        for model in MODELS {
            let formulas = Formulas::new(model.info).expect("formulas that can be read");
            for set in model.info.sets {
                let values = formulas.values(set.values);
                let equations = model.equations(set.values).expect("a set that holds");
                let count = formulas.count;
                for (at, (name, rows)) in equations.matrices().into_iter().enumerate() {
                    assert_eq!(name, MatrixName::ALL[at]);
                    let largest = rows.iter().flatten().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
                    for (place, expected) in rows.iter().flatten().enumerate() {
                        let found = values.entries[at * count * count + place];
                        let is_same = (found - expected).abs() <= 1e-12 * largest;
                        assert!(is_same, "{} {}: {name} {place}: {found} {expected}", model.info.name, set.name);
                    }
                }
            }
        }
    }
}
