//! The definitions that a derivation leaves behind: each intermediate result once, by name.

use std::cell::RefCell;
use std::collections::HashMap;

use crate::constant::{Constant, Constants, NoValue};
use crate::formula::Formula;
use crate::symbolic::{Engine, Form, Sample};

/// The definitions of the model, and behind them those of the derivation.
pub struct Formulas<'e> {
    engine: &'e Engine,
    parameters: usize,
    /// What each definition stands for.
    values: Vec<Form>,
    /// What stands for each.
    stand_ins: Vec<Form>,
    /// The names of those that the derivation made.
    names: Vec<String>,
    /// Some values of the parameters, and those of the definitions for them: what is clearly not zero there needs no
    /// attempt to prove that it is.
    sample: (Vec<Sample>, Vec<Sample>),
    /// The same where parameters stand for what depends on others: with the values that they have by these.
    dependent: Option<(Vec<Sample>, Vec<Sample>)>,
    /// Forms that were simplified before.
    simplest: RefCell<HashMap<Form, Form>>,
}

/// Formulas that take more operations than this with what their names stand for keep the names.
const MAX_OPENED: usize = 40;

impl<'e> Formulas<'e> {
    /// With the definitions of the model, each in those before it.
    pub fn new(engine: &'e Engine, parameters: usize, values: Vec<Form>) -> Self {
        let mut formulas = Self {
            engine,
            parameters,
            values: Vec::new(),
            stand_ins: Vec::new(),
            names: Vec::new(),
            sample: (Sample::spread(0, parameters), Vec::new()),
            dependent: None,
            simplest: RefCell::default(),
        };
        values.into_iter().for_each(|value| formulas.push(value));
        formulas
    }

    /// The last parameters stand for these formulas in the others and in definitions, and no relation between them is used:
    /// but by what these formulas make zero nothing is divided.
    pub fn standing_for(mut self, attributes: &[Formula]) -> Self {
        let (mut parameters, definitions) = self.sample.clone();
        parameters.truncate(self.parameters - attributes.len());
        let values = attributes.iter().map(|attribute| Sample::of(attribute, &self.sample.0, &definitions));
        parameters.extend(values);
        self.dependent = Some((parameters, definitions));
        self
    }

    fn push(&mut self, value: Form) {
        let at_sample = self.at_sample(&value);
        if let Some((parameters, definitions)) = &mut self.dependent {
            definitions.push(Sample::of(&value.to_formula(self.parameters), parameters, definitions));
        }
        self.sample.1.push(at_sample);
        self.stand_ins.push(self.engine.definition(self.parameters, self.values.len()));
        self.values.push(value);
    }

    /// A parameter, as a formula.
    pub fn parameter(&self, index: usize) -> Form {
        self.engine.parameter(index)
    }

    /// The value of a formula for some values of the parameters.
    pub fn at_sample(&self, form: &Form) -> Sample {
        Sample::of(&form.to_formula(self.parameters), &self.sample.0, &self.sample.1)
    }

    /// Values of the parameters, others on each turn, and those of the definitions for them, with many digits.
    ///
    /// # Errors
    /// If a definition has no value there.
    pub fn constants(&self, turn: usize) -> Result<Constants, NoValue> {
        let count = self.parameters;
        let parameters = Sample::spread(turn * count, count).into_iter().map(Sample::to_constant);
        let mut constants = Constants { parameters: parameters.collect::<Result<_, _>>()?, definitions: Vec::new() };
        for value in &self.values {
            let value = self.at(value, &constants)?;
            constants.definitions.push(value);
        }
        Ok(constants)
    }

    /// The value of a formula for such values.
    ///
    /// # Errors
    /// If it has none.
    pub fn at(&self, form: &Form, constants: &Constants) -> Result<Constant, NoValue> {
        constants.of(&form.to_formula(self.parameters))
    }

    /// A stand-in for a formula, under a name; zero, and what is too short for a name, stays as it is.
    pub fn name(&mut self, name: impl Into<String>, form: &Form) -> Form {
        if self.is_zero(form) {
            return Form::number(0);
        }
        let form = self.shortest(form);
        if form.is_short() {
            return form;
        }
        if let Some(index) = self.values.iter().position(|known| *known == form) {
            return self.stand_ins[index].clone();
        }
        // What no other is opposite to at some values has no need to be written the other way round.
        let at_sample = self.at_sample(&form);
        if self.sample.1.iter().any(|known| known.is_perhaps_opposite_to(at_sample)) {
            let opposite = self.simplest(&-&form);
            if let Some(index) = self.values.iter().position(|known| *known == opposite) {
                return -&self.stand_ins[index];
            }
        }
        self.push(form);
        self.names.push(name.into());
        self.stand_ins[self.values.len() - 1].clone()
    }

    /// The shortest form of a formula that is found as it stands, or with what its names stand for: names hide what cancels.
    pub fn shortest(&self, form: &Form) -> Form {
        let mut shortest = self.simplest(form);
        if self.dependent.is_some() {
            return shortest;
        }
        let mut open = form.clone();
        let first = self.values.len() - self.names.len();
        for index in (first..self.values.len()).rev() {
            if shortest.is_short() {
                break;
            }
            let name = &self.stand_ins[index];
            if !open.mentions(name) {
                continue;
            }
            open = open.replace(name, &self.values[index]);
            if open.operations() > MAX_OPENED {
                break;
            }
            let simplest = self.simplest(&open);
            if simplest.operations() < shortest.operations() {
                shortest = simplest;
            }
        }
        shortest
    }

    fn simplest(&self, form: &Form) -> Form {
        if let Some(known) = self.simplest.borrow().get(form) {
            return known.clone();
        }
        let simplest = form.simplest();
        self.simplest.borrow_mut().insert(form.clone(), simplest.clone());
        simplest
    }

    /// Whether a formula is proved to be zero for all parameters.
    pub fn is_zero(&self, form: &Form) -> bool {
        if form.is_nothing() {
            return true;
        }
        let sample = self.at_sample(form);
        if sample.is_not_zero() {
            return false;
        }
        // Of what only explains numbers no proof is needed: the values have no pattern.
        if self.dependent.is_some() && sample.is_finite() {
            return true;
        }
        if form.is_zero() {
            return true;
        }
        let mut form = form.clone();
        for (name, value) in self.stand_ins.iter().zip(&self.values).rev() {
            if form.mentions(name) {
                form = form.replace(name, value);
                if form.is_zero() {
                    return true;
                }
            }
        }
        false
    }

    /// Whether a formula may be divided by: one that is neither proved to be zero nor clearly not zero may not.
    pub fn is_divisor(&self, form: &Form) -> bool {
        let sample = self.at_sample(form);
        let is_known = |(parameters, definitions): &(Vec<Sample>, Vec<Sample>)| {
            Sample::of(&form.to_formula(self.parameters), parameters, definitions).is_not_zero()
        };
        self.dependent.as_ref().is_none_or(is_known)
            && (sample.is_not_zero() || !sample.is_finite() && !self.is_zero(form))
    }

    /// A formula without the definitions that the derivation made.
    pub fn opened(&self, form: &Form) -> Form {
        let first = self.values.len() - self.names.len();
        let made = self.stand_ins.iter().zip(&self.values).skip(first).rev();
        let open = made.fold(form.clone(), |form, (name, value)| form.replace(name, value));
        self.simplest(&open)
    }

    /// The same without the engine.
    pub fn inserted(&self, form: &Form) -> Formula {
        self.opened(form).to_formula(self.parameters)
    }

    /// The names and values of the definitions that the derivation made, without the engine.
    pub fn export(self) -> Vec<(String, Formula)> {
        let first = self.values.len() - self.names.len();
        let values = self.values.into_iter().skip(first).map(|value| value.to_formula(self.parameters));
        self.names.into_iter().zip(values).collect()
    }
}
