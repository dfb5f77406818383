//! Proofs of what a declaration claims.

use nanoserde::{DeBin, SerBin};

use super::door::ask;
use super::engine::Engine;
use super::failure::{EngineFailure, Place, Undefined};
use super::form::Form;
use super::identity::Sign;
use super::sample::Sample;
use crate::equations::Equations;

/// How hard to try.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, SerBin)]
pub enum Depth {
    /// With definitions as they stand, whatever their values: quick, and enough for most claims that are true.
    Names,
    /// With definitions put in one by one, the last first, until it is proved or grows beyond bounds.
    Formulas,
}

/// What came of an attempt.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, SerBin)]
pub enum Proof {
    /// It holds for all parameters.
    Found,
    /// No proof in the algebra that is known.
    NotFound,
    /// The formulas grow beyond bounds.
    TooLong,
    /// A formula has no value.
    Undefined(Place, Undefined),
}

/// Attempts to prove of each pair of outputs that both are equal for all parameters.
///
/// # Errors
/// If the engine cannot be had or stops.
pub fn prove_equal(pairs: Vec<Equations>, depth: Depth) -> Result<Vec<Proof>, EngineFailure> {
    ask("proofs", (pairs, depth), |engine, (pairs, depth)| {
        let proof = |pair| prove(engine, pair, *depth).unwrap_or_else(|(place, why)| Proof::Undefined(place, why));
        Ok(pairs.iter().map(proof).collect())
    })
}

pub(super) fn prove(engine: &Engine, pair: &Equations, depth: Depth) -> Result<Proof, (Place, Undefined)> {
    let system = NamedForms::new(engine, pair)?;
    let [left, right] = &system.outputs[..] else { unreachable!("a claim has two sides") };
    let mut difference = left.minus(right);
    let mut names = system.definitions.iter().rev();
    // A name that is left stands for any value: what is not zero at some values of all names is not zero for all.
    let parameters = Sample::spread(0, pair.parameters);
    let definitions = Sample::spread(pair.parameters, system.definitions.len());
    let maybe_zero =
        |form: &Form| !Sample::of(&form.to_formula(pair.parameters), &parameters, &definitions).is_not_zero();
    loop {
        if maybe_zero(&difference) && difference.is_zero() {
            return Ok(Proof::Found);
        }
        if difference.operations() > MAX_OPERATIONS {
            return Ok(Proof::TooLong);
        }
        let next = names.find(|(name, _)| depth == Depth::Formulas && difference.mentions(name));
        let Some((name, value)) = next else {
            // On the way it is not asked, which would take longer than the next replacement, and no harm is done there.
            let is_too_long = depth == Depth::Formulas && difference.is_too_long();
            return Ok(if is_too_long { Proof::TooLong } else { Proof::NotFound });
        };
        difference = difference.replace(name, value);
    }
}

/// Formulas with more operations than this are not put into others.
pub(super) const MAX_OPERATIONS: usize = 5_000;

/// For each output after the first whether the first is a multiple of it by a number that is not zero, and by which sign.
/// A sign is a proof.
///
/// # Errors
/// If the engine cannot be had or stops.
pub fn find_multiples(equations: Equations) -> Result<Vec<Option<Sign>>, EngineFailure> {
    ask("multiples", equations, |engine, equations| {
        let Ok(system) = NamedForms::new(engine, equations) else { return Ok(Vec::new()) };
        let mut outputs = system.outputs;
        for (name, value) in system.definitions.iter().rev() {
            outputs = outputs.iter().map(|output| output.replace(name, value)).collect();
            if outputs.iter().any(|output| output.operations() > MAX_OPERATIONS) {
                return Ok(Vec::new());
            }
        }
        let Some((first, others)) = outputs.split_first() else { return Ok(Vec::new()) };
        Ok(others.iter().map(|other| first.multiple_of(other)).collect())
    })
}

/// Formulas in parameters and in the names of definitions.
struct NamedForms {
    /// Names and what they stand for.
    definitions: Vec<(Form, Form)>,
    outputs: Vec<Form>,
}

impl NamedForms {
    fn new(engine: &Engine, equations: &Equations) -> Result<Self, (Place, Undefined)> {
        let names = engine.definitions(equations.parameters, equations.definitions.len());
        let definition = |(index, formula)| {
            engine.form(formula, &names).map_err(|why| (Place::Definition(equations.origins[index]), why))
        };
        let values: Vec<Form> = equations.definitions.iter().enumerate().map(definition).collect::<Result<_, _>>()?;
        let output = |(index, formula)| engine.form(formula, &names).map_err(|why| (Place::Output(index), why));
        let outputs = equations.outputs.iter().enumerate().map(output).collect::<Result<_, _>>()?;
        Ok(Self { definitions: names.into_iter().zip(values).collect(), outputs })
    }
}
