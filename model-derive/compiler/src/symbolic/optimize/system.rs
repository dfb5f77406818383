//! Formulas in parameters and in the definitions that are kept, and the program that computes them.

use std::borrow::Cow;
use std::collections::HashSet;

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::evaluate::OptimizationSettings;

use super::super::engine::Engine;
use super::super::failure::{Place, Undefined};
use super::super::form::Form;
use super::super::instructions::append;
use super::shapes::{Shape, Shapes};
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
    values: Vec<Form>,
    /// What is in each definition.
    insides: Vec<Form>,
    /// For each definition its formula, if it is kept.
    kept: Vec<Option<Form>>,
    outputs: Vec<Form>,
}

impl System {
    pub fn new(
        engine: &Engine,
        equations: &Equations,
        choices: &Choices,
        shapes: &mut Shapes,
    ) -> Result<Self, (Place, Undefined)> {
        let names = engine.definitions(equations.parameters, equations.definitions.len());
        let mut system = Self::default();
        for (index, name) in names.into_iter().enumerate() {
            let form = system.form(engine, equations, index, &choices.opened[index])?;
            let keep = !form.is_trivial() && (!choices.inline[index] || Self::keeps(&form));
            system.values.push(if keep { name } else { form.clone() });
            system.kept.push(keep.then(|| shapes.shaped(&form, choices.shapes[index])));
            system.insides.push(form);
        }
        for formula in system.kept.len()..system.kept.len() + equations.outputs.len() {
            let form = system.form(engine, equations, formula, &choices.opened[formula])?;
            system.outputs.push(shapes.shaped(&form, choices.shapes[formula]));
        }
        Ok(system)
    }

    /// A formula as it is written, definitions first and then outputs, into which some of its definitions are put.
    pub fn form(
        &self,
        engine: &Engine,
        equations: &Equations,
        formula: usize,
        opened: &[usize],
    ) -> Result<Form, (Place, Undefined)> {
        let mut values = Cow::Borrowed(&self.values);
        for index in opened {
            if self.insides[*index].operations() <= MAX_OPENED {
                values.to_mut()[*index] = self.insides[*index].clone();
            }
        }
        let definitions = equations.definitions.len();
        let (formula, place) = match formula.checked_sub(definitions) {
            None => (&equations.definitions[formula], Place::Definition(equations.origins[formula])),
            Some(output) => (&equations.outputs[output], Place::Output(output)),
        };
        engine.form(formula, &values).map_err(|why| (place, why))
    }

    /// What is in a definition.
    pub fn inside(&self, definition: usize) -> &Form {
        &self.insides[definition]
    }

    /// Whether a definition keeps its name even if it is to disappear.
    pub fn keeps(form: &Form) -> bool {
        form.operations() > MAX_INLINED
    }

    /// The formulas of all kept definitions and outputs, which make the program.
    pub fn formulas(&self) -> Vec<Form> {
        let kept = self.kept.iter().map(|form| form.clone().unwrap_or_else(|| Form::number(0)));
        kept.chain(self.outputs.iter().cloned()).collect()
    }

    /// One program for all formulas: those of the kept definitions first, then the outputs.
    ///
    /// The engine nests it anew, in the best of so many orders of the symbols, and looks for common pairs.
    pub fn program(&self, engine: &Engine, equations: &Equations, orders: usize) -> Program {
        let parameters = equations.parameters;
        let kept: Vec<(usize, &Form)> =
            self.kept.iter().enumerate().filter_map(|(index, form)| Some((index, form.as_ref()?))).collect();
        let symbols = (0..parameters).map(|index| engine.parameter(index)).chain([engine.pi()]);
        let symbols: Vec<Symbol> = symbols
            .chain(kept.iter().map(|(index, _)| self.values[*index].clone()))
            .filter_map(|form| form.0.as_view().get_symbol())
            .collect();
        let formulas: Vec<Form> =
            kept.iter().map(|(_, form)| *form).chain(&self.outputs).map(Form::without_tangents_of_numbers).collect();
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
