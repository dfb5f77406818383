//! The search for the cheapest program among equivalent ones.

use std::collections::HashSet;

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::evaluate::OptimizationSettings;

use super::door::{Failure, enter};
use super::form::{Engine, Form, Undefined};
use super::import::append;
use crate::equations::Equations;
use crate::model::Expr;
use crate::program::{Counts, Instruction, Program, Value, passes};

/// The cheapest program found for each set of equations.
///
/// # Errors
/// If the engine cannot be had or fails, or if a formula has no value.
pub fn compile(equations: Vec<Equations>) -> Result<Vec<Program>, Failure> {
    enter(move |engine| {
        let numbered = equations.iter().enumerate();
        let programs = numbered.map(|(index, equations)| {
            cheapest(engine, equations).map_err(|(place, why)| Failure::Undefined { equations: index, place, why })
        });
        programs.collect()
    })?
}

/// A formula among equations: the definition of the model, or the output, at a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The definition at a position of the model.
    Definition(usize),
    /// The output at a position of the equations.
    Output(usize),
}

/// In models with more definitions than this one program is built, and nothing is tried: of models with hundreds of
/// definitions the programs that are compared here differ by less than a hundredth, each takes as long as the first,
/// and trying quotients one by one takes a time that grows with the square of the number of definitions.
const MAX_TRIED: usize = 100;

fn cheapest(engine: &Engine, equations: &Equations) -> Result<Program, (Place, Undefined)> {
    let run = |inline: &[bool], simplest: bool| -> Result<Program, (Place, Undefined)> {
        let system = System::new(engine, equations, inline)?;
        let system = if simplest { system.simplest() } else { system };
        Ok(passes::optimize(system.program(engine, equations)))
    };
    let cost = |program: &Program| Counts::of(program).cost();

    // Definitions never all disappear into the formulas that use them: that grows exponentially with their depth.
    let none = vec![false; equations.definitions.len()];
    let used_once: Vec<bool> = uses(equations).iter().map(|uses| *uses == 1).collect();
    let starts = [(&none, false), (&none, true), (&used_once, false), (&used_once, true)];
    let starts = if none.len() > MAX_TRIED { &starts[3..] } else { &starts[..] };
    let mut programs = Vec::new();
    for &(inline, simplest) in starts {
        programs.push((run(inline, simplest)?, inline.clone(), simplest));
    }
    // The first of several equally cheap ones, so that the choice is the same on every run.
    let Some((mut best, mut inline, simplest)) = programs.into_iter().min_by_key(|(program, ..)| cost(program)) else {
        return Ok(Program::default());
    };
    if inline.len() > MAX_TRIED {
        return Ok(best);
    }
    // A quotient whose divisor the formulas multiply by, such as a centre of mass, costs nothing once inside them.
    for (index, expr) in equations.definitions.iter().enumerate() {
        if inline[index] || !is_quotient(expr) {
            continue;
        }
        inline[index] = true;
        let program = run(&inline, simplest)?;
        inline[index] = cost(&program) < cost(&best);
        if inline[index] {
            best = program;
        }
    }
    Ok(best)
}

/// Longer formulas keep their names: a chain of thousands of definitions, each used once, would nest into one formula
/// that exhausts the stack.
const MAX_INLINED: usize = 250;

/// The engine looks for common parts in all formulas that it is given together, in a time that grows with a power of 1.5
/// of their number; so it gets them in blocks. Parts that several blocks compute alike are found by the passes.
const BLOCK: usize = 250;

fn is_quotient(expr: &Expr) -> bool {
    matches!(expr, Expr::Product(factors) if factors.iter().any(|(inverse, _)| *inverse))
}

/// How often each definition is used.
fn uses(equations: &Equations) -> Vec<usize> {
    let mut uses = vec![0; equations.definitions.len()];
    for expr in equations.definitions.iter().chain(&equations.outputs) {
        expr.walk(&mut |part| {
            if let Expr::Definition(index) = part {
                uses[*index] += 1;
            }
        });
    }
    uses
}

/// Formulas in parameters and in the definitions that are kept.
#[derive(Clone)]
struct System {
    /// A symbol for each definition.
    names: Vec<Form>,
    /// For each definition its formula, if it is kept.
    kept: Vec<Option<Form>>,
    outputs: Vec<Form>,
}

impl System {
    fn new(engine: &Engine, equations: &Equations, inline: &[bool]) -> Result<Self, (Place, Undefined)> {
        let names = engine.definitions(equations.parameters, equations.definitions.len());
        let mut kept = Vec::new();
        let mut values = Vec::new();
        for (index, expr) in equations.definitions.iter().enumerate() {
            let form = engine.form(expr, &values).map_err(|why| (Place::Definition(equations.origins[index]), why))?;
            let keep = !form.is_trivial() && (!inline[index] || form.operations() > MAX_INLINED);
            values.push(if keep { names[index].clone() } else { form.clone() });
            kept.push(keep.then_some(form));
        }
        let output = |(index, expr)| engine.form(expr, &values).map_err(|why| (Place::Output(index), why));
        let outputs = equations.outputs.iter().enumerate().map(output).collect::<Result<_, _>>()?;
        Ok(Self { names, kept, outputs })
    }

    fn simplest(&self) -> Self {
        Self {
            names: self.names.clone(),
            kept: self.kept.iter().map(|form| form.as_ref().map(Form::simplest)).collect(),
            outputs: self.outputs.iter().map(Form::simplest).collect(),
        }
    }

    /// One program for all formulas: those of the kept definitions first, then the outputs.
    fn program(&self, engine: &Engine, equations: &Equations) -> Program {
        let parameters = equations.parameters;
        let kept: Vec<(usize, &Form)> =
            self.kept.iter().enumerate().filter_map(|(index, form)| Some((index, form.as_ref()?))).collect();
        let symbols = (0..parameters).map(|index| engine.parameter(index)).chain([engine.pi()]);
        let symbols: Vec<Symbol> = symbols
            .chain(kept.iter().map(|(index, _)| self.names[*index].clone()))
            .filter_map(|form| form.0.as_view().get_symbol())
            .collect();
        let formulas: Vec<Form> =
            kept.iter().map(|(_, form)| *form).chain(&self.outputs).map(Form::without_tangents_of_numbers).collect();
        let formulas: Vec<AtomView<'_>> = formulas.iter().map(|form| form.0.as_view()).collect();

        // The definitions enter as inputs whose values come out of the same program: open ends that are then tied.
        let mut program = Program::new(parameters);
        let mut inputs: Vec<usize> = (0..parameters).map(|index| program.push(Instruction::Parameter(index))).collect();
        inputs.push(program.push(Instruction::Constant(std::f64::consts::PI)));
        let open: Vec<(usize, Value)> = kept
            .iter()
            .map(|(index, _)| (equations.origins[*index], program.push(Instruction::Constant(0.0))))
            .collect();
        inputs.extend(open.iter().map(|(_, value)| value));
        let mut results = Vec::with_capacity(formulas.len());
        for block in formulas.chunks(BLOCK) {
            let used: HashSet<Symbol> = block.iter().flat_map(|formula| formula.get_all_symbols(false)).collect();
            let used: Vec<usize> = (0..symbols.len()).filter(|index| used.contains(&symbols[*index])).collect();
            let arguments: Vec<Atom> = used.iter().map(|index| symbols[*index].to_atom()).collect();
            let inputs: Vec<Value> = used.iter().map(|index| inputs[*index]).collect();
            let settings = OptimizationSettings::new().cores(1).direct_translation(false);
            let evaluator = Atom::evaluator_multiple(block, &arguments).optimization_settings(settings).build();
            let exported = evaluator.unwrap_or_else(|error| panic!("{error}")).export_instructions();
            results.extend(append(&mut program, &exported, &inputs));
        }
        let (definitions, outputs) = results.split_at(kept.len());
        program.outputs = outputs.to_vec();
        passes::tie(program, &open, definitions)
    }
}
