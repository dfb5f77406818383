//! Formulas in parameters and in the definitions that are kept, and the program that computes them.

use std::collections::HashSet;

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::evaluate::OptimizationSettings;

use super::super::engine::Engine;
use super::super::failure::{Place, Undefined};
use super::super::form::Form;
use super::super::instructions::append;
use super::forms::{FormId, Forms};
use super::shapes::Shape;
use crate::equations::Equations;
use crate::program::{Instruction, Program, Value, passes};

/// What is chosen for each formula.
#[derive(Clone, Debug, Default)]
pub struct Choices {
    /// For each definition whether it disappears into the formulas that use it.
    pub inline: Vec<bool>,
    /// For each definition and then for each output the definitions that disappear into this formula alone.
    pub opened: Vec<Vec<usize>>,
    /// For each definition and then for each output its shape, or none for the one that is cheapest by itself.
    pub shapes: Vec<Option<Shape>>,
}

impl Choices {
    /// Whether a formula is that of a definition that disappears.
    pub fn is_inside(&self, formula: usize) -> bool {
        self.inline.get(formula).is_some_and(|inline| *inline)
    }
}

/// Longer formulas keep their names: a chain of thousands of definitions, each used once, would nest into one formula
/// that exhausts the stack.
const MAX_INLINED: usize = 250;

/// Longer definitions do not disappear into single formulas: rewriting those takes longer than it gains.
const MAX_OPENED: usize = 12;

/// The engine looks for common parts in all formulas that it is given together, in a time that grows with a power of 1.5
/// of their number; so it gets them in blocks. Parts that several blocks compute alike are found by the passes.
const BLOCK: usize = 250;

/// Formulas in parameters and in the definitions that are kept.
#[derive(Clone, Default)]
pub struct System {
    /// What stands for each definition in the formulas that use it: a symbol, or what is in it.
    values: Vec<FormId>,
    /// What is in each definition.
    insides: Vec<FormId>,
    /// For each definition its formula, if it is kept, and for each output its formula: they make the program.
    formulas: Vec<Option<FormId>>,
}

impl System {
    pub fn new(forms: &mut Forms<'_>, choices: &Choices) -> Result<Self, (Place, Undefined)> {
        let mut system = Self::default();
        for (index, name) in forms.names().iter().enumerate() {
            let form = system.form(forms, index, &choices.opened[index])?;
            let inside = forms.form(form);
            let keep = !inside.is_trivial() && (!choices.inline[index] || Self::keeps(inside));
            system.values.push(if keep { *name } else { form });
            system.formulas.push(keep.then(|| forms.shaped(form, choices.shapes[index])));
            system.insides.push(form);
        }
        for formula in system.insides.len()..forms.count() {
            let form = system.form(forms, formula, &choices.opened[formula])?;
            system.formulas.push(Some(forms.shaped(form, choices.shapes[formula])));
        }
        Ok(system)
    }

    /// A formula as it is written, definitions first and then outputs, into which some of its definitions are put.
    pub fn form(&self, forms: &mut Forms<'_>, formula: usize, opened: &[usize]) -> Result<FormId, (Place, Undefined)> {
        let short = |index: &&usize| forms.operations(self.insides[**index]) <= MAX_OPENED;
        let opened: Vec<usize> = opened.iter().filter(short).copied().collect();
        if opened.is_empty() {
            return forms.make(formula, &self.values);
        }
        let mut values = self.values.clone();
        opened.into_iter().for_each(|index| values[index] = self.insides[index]);
        forms.make(formula, &values)
    }

    /// What is in a definition.
    pub fn inside(&self, definition: usize) -> FormId {
        self.insides[definition]
    }

    /// Whether a definition keeps its name even if it is to disappear.
    pub fn keeps(form: &Form) -> bool {
        form.operations() > MAX_INLINED
    }

    /// The formulas of all kept definitions and outputs, which make the program.
    pub fn formulas(&self) -> &[Option<FormId>] {
        &self.formulas
    }

    /// The operations of all these formulas, each by itself.
    pub fn operations(&self, forms: &Forms<'_>) -> usize {
        self.formulas.iter().flatten().map(|form| forms.operations(*form)).sum()
    }

    /// One program for all formulas: those of the kept definitions first, then the outputs.
    ///
    /// The engine nests it anew, in the best of so many orders of the symbols, and looks for common pairs.
    pub fn program(&self, engine: &Engine, equations: &Equations, forms: &Forms<'_>, orders: usize) -> Program {
        let parameters = equations.parameters;
        let (definitions, outputs) = self.formulas.split_at(self.insides.len());
        let kept: Vec<(usize, FormId)> =
            definitions.iter().enumerate().filter_map(|(index, form)| Some((index, (*form)?))).collect();
        let symbols = (0..parameters).map(|index| engine.parameter(index)).chain([engine.pi()]);
        let symbols: Vec<Symbol> = symbols
            .chain(kept.iter().map(|(index, _)| forms.form(self.values[*index]).clone()))
            .filter_map(|form| form.0.as_view().get_symbol())
            .collect();
        let formulas = kept.iter().map(|(_, form)| *form).chain(outputs.iter().copied().flatten());
        let formulas: Vec<Form> = formulas.map(|form| forms.form(form).without_tangents_of_numbers()).collect();
        let formulas: Vec<AtomView<'_>> = formulas.iter().map(|form| form.0.as_view()).collect();

        // The definitions enter as inputs whose values come out of the same program, and are then put in their place.
        let mut program = Program::new(parameters);
        let mut inputs: Vec<usize> = (0..parameters).map(|index| program.push(Instruction::Parameter(index))).collect();
        inputs.push(program.push(Instruction::Constant(std::f64::consts::PI)));
        let placeholders: Vec<(usize, Value)> = kept
            .iter()
            .map(|(index, _)| (equations.origins[*index], program.push(Instruction::Constant(0.0))))
            .collect();
        inputs.extend(placeholders.iter().map(|(_, value)| value));
        let mut results = Vec::with_capacity(formulas.len());
        for block in formulas.chunks(BLOCK) {
            let used: HashSet<Symbol> = block.iter().flat_map(|formula| formula.get_all_symbols(false)).collect();
            let used: Vec<usize> = (0..symbols.len()).filter(|index| used.contains(&symbols[*index])).collect();
            let arguments: Vec<Atom> = used.iter().map(|index| symbols[*index].to_atom()).collect();
            let inputs: Vec<Value> = used.iter().map(|index| inputs[*index]).collect();
            let settings = OptimizationSettings::new().cores(1).direct_translation(false).horner_iterations(orders);
            let evaluator = Atom::evaluator_multiple(block, &arguments).optimization_settings(settings).build();
            let exported = evaluator.unwrap_or_else(|error| panic!("{error}")).export_instructions();
            results.extend(append(&mut program, &exported, &inputs));
        }
        let (definitions, outputs) = results.split_at(kept.len());
        program.outputs = outputs.to_vec();
        passes::substitute(program, &placeholders, definitions)
    }
}
