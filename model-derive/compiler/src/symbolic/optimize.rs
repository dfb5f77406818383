//! The search for the cheapest program among equivalent ones.

use symbolica::atom::{Atom, AtomCore, AtomView};
use symbolica::evaluate::OptimizationSettings;

use super::door::{Failure, enter};
use super::form::{Engine, Form};
use super::import::append;
use crate::equations::Equations;
use crate::model::Expr;
use crate::program::{Counts, Instruction, Program, passes};

/// The cheapest program found for each set of equations.
///
/// # Errors
/// If the engine cannot be had or fails.
pub fn compile(equations: Vec<Equations>) -> Result<Vec<Program>, Failure> {
    enter(move |engine| equations.iter().map(|equations| cheapest(engine, equations)).collect())
}

fn cheapest(engine: &Engine, equations: &Equations) -> Program {
    let candidates = candidates(engine, equations);
    // The first of several equally cheap ones, so that the choice is the same on every run.
    let best = candidates.into_iter().map(passes::optimize).min_by_key(|program| Counts::of(program).cost());
    best.unwrap_or_default()
}

/// Which definitions disappear into the formulas that use them. Never all: that grows exponentially with their depth.
#[derive(Clone, Copy)]
enum Inline {
    None,
    UsedOnce,
}

fn candidates(engine: &Engine, equations: &Equations) -> Vec<Program> {
    let mut programs = Vec::new();
    for inline in [Inline::None, Inline::UsedOnce] {
        let system = System::new(engine, equations, inline);
        for simplify in [false, true] {
            let system = if simplify { system.simplest() } else { system.clone() };
            for direct in [true, false] {
                programs.push(system.program(engine, equations.parameters, direct));
            }
        }
    }
    programs
}

/// Formulas in parameters and in the definitions that are kept.
#[derive(Clone)]
struct System {
    /// For each definition its formula, if it is kept.
    kept: Vec<Option<Form>>,
    outputs: Vec<Form>,
}

impl System {
    fn new(engine: &Engine, equations: &Equations, inline: Inline) -> Self {
        let mut uses = vec![0; equations.definitions.len()];
        for expr in equations.definitions.iter().chain(&equations.outputs) {
            expr.walk(&mut |part| {
                if let Expr::Definition(index) = part {
                    uses[*index] += 1;
                }
            });
        }
        let mut kept = Vec::new();
        let mut values = Vec::new();
        for (index, expr) in equations.definitions.iter().enumerate() {
            let form = engine.form(expr, &values);
            let keep = match inline {
                Inline::None => true,
                Inline::UsedOnce => uses[index] > 1,
            };
            values.push(if keep { engine.definition(index) } else { form.clone() });
            kept.push(keep.then_some(form));
        }
        let outputs = equations.outputs.iter().map(|expr| engine.form(expr, &values)).collect();
        Self { kept, outputs }
    }

    fn simplest(&self) -> Self {
        Self {
            kept: self.kept.iter().map(|form| form.as_ref().map(Form::simplest)).collect(),
            outputs: self.outputs.iter().map(Form::simplest).collect(),
        }
    }

    /// One program for all formulas: those of the kept definitions first, then the outputs.
    fn program(&self, engine: &Engine, parameters: usize, direct: bool) -> Program {
        let kept: Vec<(usize, &Form)> =
            self.kept.iter().enumerate().filter_map(|(index, form)| Some((index, form.as_ref()?))).collect();
        let symbols = (0..parameters).map(|index| engine.parameter(index)).chain([engine.pi()]);
        let symbols: Vec<Atom> =
            symbols.chain(kept.iter().map(|(index, _)| engine.definition(*index))).map(|form| form.0).collect();
        let formulas: Vec<AtomView<'_>> =
            kept.iter().map(|(_, form)| *form).chain(&self.outputs).map(|form| form.0.as_view()).collect();
        let settings = OptimizationSettings::new().cores(1).direct_translation(direct);
        let evaluator = Atom::evaluator_multiple(&formulas, &symbols).optimization_settings(settings).build();
        let exported = evaluator.unwrap_or_else(|error| panic!("{error}")).export_instructions();

        // The definitions enter as inputs whose values come out of the same program: open ends that are then tied.
        let mut program = Program::new(parameters);
        let mut inputs: Vec<usize> = (0..parameters).map(|index| program.push(Instruction::Parameter(index))).collect();
        inputs.push(program.push(Instruction::Constant(std::f64::consts::PI)));
        let open: Vec<usize> = kept.iter().map(|_| program.push(Instruction::Constant(0.0))).collect();
        inputs.extend(&open);
        let results = append(&mut program, &exported, &inputs);
        let (definitions, outputs) = results.split_at(kept.len());
        program.outputs = outputs.to_vec();
        passes::tie(program, &open, definitions)
    }
}
