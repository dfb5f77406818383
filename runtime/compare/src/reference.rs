//! What all sides are held against.

use carvallo::{Evaluator, Formula, Model};
use carvallo_slips::{Formulas, Subject, place};
use serde::Serialize;

use crate::number::Exact;

/// What gives the exact entries of a model.
pub struct Reference {
    formulas: Option<Formulas>,
    program: fn(&[f64]) -> Vec<Exact>,
}

/// What exact entries come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ReferenceKind {
    /// The formulas that the model tells.
    Formulas,
    /// The generated program, since a formula needs more than parameters and definitions, or the model tells none.
    Program,
}

impl Reference {
    pub fn of<const N: usize, M: Model<N, Scalar = f64>>() -> Self {
        Self { formulas: Formulas::new(M::INFO).ok(), program: program::<N, M> }
    }

    pub fn kind(&self) -> ReferenceKind {
        if self.formulas.is_some() { ReferenceKind::Formulas } else { ReferenceKind::Program }
    }

    pub fn formulas(&self) -> Option<&Formulas> {
        self.formulas.as_ref()
    }

    /// The entries of all matrices, with 320 bits.
    pub fn entries(&self, parameters: &[f64]) -> Vec<Exact> {
        let exact: Vec<Exact> = parameters.iter().copied().map(Exact::from).collect();
        // A valid design has a value in every formula.
        let values = self.formulas.as_ref().and_then(|formulas| formulas.values_of(&exact));
        values.map_or_else(|| (self.program)(parameters), |values| values.entries)
    }

    /// The formula of an entry, as the model tells it, with the definitions that it names; `0` where it tells none.
    pub fn formula(&self, entry: usize) -> String {
        let Some(formulas) = &self.formulas else { return String::new() };
        let (matrix, row, column) = place(entry, formulas.count);
        let Some(own) = formulas.entry(matrix, row, column) else { return "0".to_owned() };
        let text = formulas.formulas[own].text;
        let parsed = Formula::parse(text);
        let mut names = Vec::new();
        parsed.iter().for_each(|formula| collect_names(formula, &mut names));
        let named = formulas.formulas.iter().filter_map(|other| match other.subject {
            Subject::Definition(name) if names.contains(&name) => Some(format!("{name} = {}", other.text)),
            _ => None,
        });
        let definitions: Vec<String> = named.collect();
        let with = if definitions.is_empty() { "" } else { ", where " };
        format!("{text}{with}{}", definitions.join(", "))
    }
}

/// The names in a formula.
fn collect_names<'a>(formula: &'a Formula, names: &mut Vec<&'a str>) {
    match formula {
        Formula::Number(..) => {}
        Formula::Name(name) => names.push(name),
        Formula::Sum(parts) | Formula::Product(parts) => parts.iter().for_each(|(_, part)| collect_names(part, names)),
        Formula::Power(inner, _) | Formula::Call(_, inner) => collect_names(inner, names),
    }
}

/// The same by the generated program.
fn program<const N: usize, M: Model<N, Scalar = f64>>(parameters: &[f64]) -> Vec<Exact> {
    let model = M::Over::<Exact>::from_parameters(|position| Exact::from(parameters[position]));
    model.rows().as_flattened().as_flattened().to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::designs::designs;
    use carvallo_models::each_model;

    /// Two ways to the same entries: what the compiler made of a model, and what it tells of it.
    fn check<const N: usize, M: Model<N, Scalar = f64>>() {
        let reference = Reference::of::<N, M>();
        assert_eq!(reference.kind(), ReferenceKind::Formulas, "{}", M::INFO.name);
        for design in designs::<N, M>(2, 1).expect("designs") {
            let (told, made) = (reference.entries(&design.parameters), program::<N, M>(&design.parameters));
            for (entry, (told, made)) in told.iter().zip(&made).enumerate() {
                let difference = (told.value - made.value).abs().to_f64();
                // Constants of programs are rounded to `f64`.
                let formula = reference.formula(entry);
                assert!(difference <= 1e-15 * told.size, "{}, {}: {formula}", M::INFO.name, design.name);
            }
        }
    }

    #[test]
    fn the_formulas_of_every_model_are_those_of_its_program() {
        each_model!(check);
    }
}
