//! Formulas by number: what was made or found out of one is not made again, and equal ones are told by their numbers.

use std::collections::HashMap;

use super::super::engine::Engine;
use super::super::failure::{Place, Undefined};
use super::super::form::Form;
use super::shapes::{Rewritten, Shape, cost, shapes_of};
use crate::equations::Equations;
use crate::formula::Formula;

/// The number of a formula: equal ones have the same.
pub type FormId = usize;

/// The formulas of all systems so far, and their shapes.
pub struct Forms<'a> {
    engine: &'a Engine,
    equations: &'a Equations,
    /// For each definition and then for each output the definitions that it uses, each once.
    uses: Vec<Vec<usize>>,
    known: Vec<Known>,
    ids: HashMap<Form, FormId>,
    /// What each formula is with some values of the definitions that it uses.
    made: HashMap<(usize, Vec<FormId>), FormId>,
    /// A place for the values of all definitions.
    values: Vec<Form>,
    rewritten: Rewritten,
}

struct Known {
    form: Form,
    operations: usize,
    /// The shapes that it can have, the cheapest first, once someone asked for them.
    shapes: Option<Vec<Shaped>>,
}

#[derive(Clone, Copy)]
struct Shaped {
    shape: Shape,
    form: FormId,
    /// What it takes by itself.
    cost: usize,
}

/// A shape that takes so many operations more than another by itself is not tried in its place.
const MAX_WORSE: usize = 3;

impl<'a> Forms<'a> {
    pub fn new(engine: &'a Engine, equations: &'a Equations) -> Self {
        Self {
            engine,
            equations,
            uses: equations.definitions.iter().chain(&equations.outputs).map(find_used).collect(),
            known: Vec::new(),
            ids: HashMap::new(),
            made: HashMap::new(),
            values: engine.definitions(equations.parameters, equations.definitions.len()),
            rewritten: Rewritten::default(),
        }
    }

    /// What stands for the definitions.
    pub fn names(&mut self) -> Vec<FormId> {
        let names = self.engine.definitions(self.equations.parameters, self.equations.definitions.len());
        names.into_iter().map(|name| self.insert(name)).collect()
    }

    /// The definitions that a formula uses, each once.
    pub fn uses(&self, formula: usize) -> &[usize] {
        &self.uses[formula]
    }

    /// How many formulas there are: definitions and outputs.
    pub fn count(&self) -> usize {
        self.uses.len()
    }

    /// A formula as it is written, definitions first and then outputs, with the given values of the definitions.
    pub fn make(&mut self, formula: usize, values: &[FormId]) -> Result<FormId, (Place, Undefined)> {
        let key = (formula, self.uses[formula].iter().map(|index| values[*index]).collect());
        if let Some(made) = self.made.get(&key) {
            return Ok(*made);
        }
        for index in &self.uses[formula] {
            self.values[*index].clone_from(&self.known[values[*index]].form);
        }
        let Equations { definitions, origins, outputs, .. } = self.equations;
        let (written, place) = match formula.checked_sub(definitions.len()) {
            None => (&definitions[formula], Place::Definition(origins[formula])),
            Some(output) => (&outputs[output], Place::Output(output)),
        };
        let form = self.engine.form(written, &self.values).map_err(|why| (place, why))?;
        let made = self.insert(form);
        self.made.insert(key, made);
        Ok(made)
    }

    fn insert(&mut self, form: Form) -> FormId {
        if let Some(id) = self.ids.get(&form) {
            return *id;
        }
        let id = self.known.len();
        self.ids.insert(form.clone(), id);
        self.known.push(Known { operations: form.operations(), form, shapes: None });
        id
    }

    pub fn form(&self, id: FormId) -> &Form {
        &self.known[id].form
    }

    /// The number of operations that a formula takes as it stands.
    pub fn operations(&self, id: FormId) -> usize {
        self.known[id].operations
    }

    /// A formula in a shape; without one, or if it has no such shape of its own, in the one that is cheapest by itself.
    pub fn shaped(&mut self, id: FormId, shape: Option<Shape>) -> FormId {
        if shape == Some(Shape::Written) {
            return id;
        }
        let shapes = self.shapes(id);
        let found = shape.and_then(|shape| shapes.iter().find(|other| other.shape == shape));
        found.unwrap_or(&shapes[0]).form
    }

    /// The shapes of a formula that may be worth a try.
    pub fn worthwhile(&mut self, id: FormId) -> Vec<Shape> {
        let shapes = self.shapes(id);
        let most = shapes[0].cost + MAX_WORSE;
        shapes.iter().filter(|shaped| shaped.cost <= most).map(|shaped| shaped.shape).collect()
    }

    /// Whether a formula into which a definition is put takes fewer operations than both.
    pub fn merges(&mut self, formula: FormId, definition: FormId, merged: FormId) -> bool {
        let [formula, merged] = [formula, merged].map(|id| {
            let cheapest = self.shapes(id)[0].form;
            self.operations(cheapest)
        });
        merged < formula + self.operations(definition)
    }

    fn shapes(&mut self, id: FormId) -> &[Shaped] {
        if self.known[id].shapes.is_none() {
            let shapes = shapes_of(&self.known[id].form, &self.rewritten);
            let shaped = |(shape, form): (Shape, Form)| Shaped { shape, cost: cost(&form.0), form: self.insert(form) };
            let shapes = shapes.into_iter().map(shaped).collect();
            self.known[id].shapes = Some(shapes);
        }
        self.known[id].shapes.as_deref().unwrap_or_default()
    }
}

/// The definitions that a formula uses, each once.
pub fn find_used(formula: &Formula) -> Vec<usize> {
    let mut used = formula.find_definitions();
    used.sort_unstable();
    used.dedup();
    used
}
