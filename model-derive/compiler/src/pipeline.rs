//! The stages of the compiler in their order, each with a type of its own: data flows one way.

use proc_macro2::TokenStream;

use crate::derivatives::{self, Derivatives};
use crate::equations::Equations;
use crate::model::Model;
use crate::nonlinear::{self, AccelerationPrograms, MotionPrograms};
use crate::program::{Counts, Program};
use crate::report::{self, Region, Report};
use crate::symbolic::{self, Failure, Place};
use crate::{check, derivation, evidence, syntax};

/// A model and the programs that were compiled for it.
#[derive(Debug)]
pub struct Compiled {
    /// The model.
    pub model: Model,
    /// What it computes.
    pub programs: Programs,
}

/// The programs of a model.
#[derive(Debug)]
pub struct Programs {
    /// Computes the entries of the matrices, row by row.
    pub matrices: Program,
    /// Computes the left-hand sides of the requirements.
    pub requirements: Program,
    /// Computes the rates and forces that follow from a mechanism, if the model is one.
    pub kinematics: Option<Program>,
    /// The nonlinear equations of motion, if the model asks for them.
    pub motion: Option<MotionPrograms>,
    /// Accelerations by the attributes of the mechanism, if it does.
    pub by_attributes: Option<AccelerationPrograms>,
    /// Computes the entries of the matrices together with their derivatives, if the model asks for them.
    pub derivatives: Option<Derivatives>,
}

/// A declaration that is refused.
#[derive(Debug)]
pub struct Refusal {
    /// All its mistakes, each at its span.
    pub error: syn::Error,
    /// What is known of the model all the same.
    pub model: Option<Box<Model>>,
}

/// From a declaration to its model.
pub fn read(tokens: TokenStream) -> Result<Model, Refusal> {
    let mut report = Report::default();
    let declaration = syntax::parse(tokens, &mut report);
    // After this point what is there parses. Each stage notes its mistakes in the report and goes on, so that all are
    // told at once.
    let model = declaration.map(|declaration| {
        let checked = check::check(&declaration, &mut report);
        // After this point every name is resolved, and shapes, units and domains are right.
        let derived = derivation::derive(&checked, &mut report);
        // After this point there are only formulas in the parameters, whether they were written or derived.
        evidence::weigh(checked, derived, &mut report)
        // After this point claims are proved, published numbers come out, and what could have no value is a requirement.
    });
    match (report.finish(), model) {
        (Ok(()), Some(model)) => Ok(model),
        (Ok(()), None) => unreachable!("a declaration without a model is reported"),
        (Err(error), model) => Err(Refusal { error, model: model.map(Box::new) }),
    }
}

/// From a declaration to its model and programs.
pub fn compile(tokens: TokenStream) -> Result<Compiled, Refusal> {
    let model = read(tokens)?;
    // After this point nothing of the user's is wrong: what fails now fails in the engine.
    match build_programs(&model) {
        // After this point there is straight-line code in single assignment, whose every value is used.
        Ok(programs) => Ok(Compiled { model, programs }),
        Err((region, failure)) => Err(Refusal { error: report::error(region, failure), model: Some(Box::new(model)) }),
    }
}

fn build_programs(model: &Model) -> Result<Programs, (Region, Failure)> {
    let equations = [Equations::of_matrices(model), Equations::of_requirements(model)].into_iter();
    let by_bodies = Equations::of_matrices_by_bodies(model);
    let is_by_bodies = by_bodies.is_some();
    let equations = equations.chain(Equations::of_kinematics(model)).chain(by_bodies).collect();
    let mut found =
        symbolic::compile(equations).map_err(|failure| (find_region(model, &failure), failure))?.into_iter();
    let mut next = || found.next().unwrap_or_else(|| unreachable!("a program for each"));
    let mut chosen = vec![next(), next()];
    chosen.extend(model.kinematics.as_ref().map(|_| next()));
    if is_by_bodies {
        let by_bodies = next();
        let [cost, of_formulas] = [&by_bodies, &chosen[0]].map(|found| Counts::of(found.program()).cost());
        if cost < of_formulas {
            chosen[0] = by_bodies;
        }
    }
    let programs = symbolic::finish(chosen).map_err(|failure| (find_region(model, &failure), failure))?;
    let mut programs = programs.into_iter();
    let mut next = || programs.next().unwrap_or_else(|| unreachable!("a program for each"));
    let (matrices, requirements) = (next(), next());
    let kinematics = model.kinematics.as_ref().map(|_| next());
    let derivatives = model
        .derivatives
        .as_ref()
        .map(|asked| derivatives::compile(model, asked, &matrices).map_err(|why| (Region::from(asked.span), why)));
    let motion = model.motion.as_ref();
    let with_derivatives = model.derivatives.as_ref().is_some_and(|asked| asked.is_all(model));
    let by_attributes = motion.and_then(|motion| {
        let machine = motion.by_attributes.as_ref()?;
        Some(nonlinear::compile_accelerations(machine, &motion.layout))
    });
    let motion = motion.map(|motion| nonlinear::compile(&motion.machine, &motion.layout, with_derivatives));
    Ok(Programs { matrices, requirements, kinematics, motion, by_attributes, derivatives: derivatives.transpose()? })
}

/// Where in the declaration a failure belongs.
fn find_region(model: &Model, failure: &Failure) -> Region {
    match *failure {
        Failure::Undefined { place: Place::Definition(index), .. } => Region::from(&model.definitions[index].0),
        Failure::Undefined { equations: 0, place: Place::Output(index), .. } => model.entries[index],
        Failure::Undefined { equations: 1, place: Place::Output(index), .. } => model.requirements[index].region,
        Failure::Undefined { place: Place::Output(_), .. } => Region::from(&model.name),
        Failure::Engine(_) => Region::from(&model.name),
    }
}
