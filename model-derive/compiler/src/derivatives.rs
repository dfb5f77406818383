//! The derivatives of the matrices of a model with respect to its parameters.

use crate::equations::Equations;
use crate::matrix_name::MatrixName;
use crate::model::{AskedDerivatives, Model};
use crate::program::{Counts, Instruction, Program, Value, passes};
use crate::symbolic::{self, Differentiated, Failure, Found, Node, Wanted};

/// The program of values and derivatives, and what its outputs are.
#[derive(Debug)]
pub struct Derivatives {
    /// Computes the entries of the matrices, row by row, and then the values of the derivatives, each once.
    pub program: Program,
    /// All derivatives that are not zero for all parameters, by parameters.
    pub partials: Vec<Partial>,
    /// The names of values that are derivatives of definitions; labels beyond the definitions of the model mean them.
    pub names: Vec<String>,
}

/// One derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Partial {
    /// The position of the entry among those of all matrices, row by row.
    pub entry: usize,
    /// The position of the parameter.
    pub parameter: usize,
    /// The position of its value among those of the derivatives.
    pub value: usize,
    /// Whether it is the negative of that value.
    pub negative: bool,
}

/// The cheapest program found.
///
/// # Errors
/// If the engine cannot be had or fails.
pub fn compile(model: &Model, asked: &AskedDerivatives, matrices: &Program) -> Result<Derivatives, Failure> {
    let all = [Equations::of_matrices(model), Equations::of_program(model, matrices)];
    let all = all.into_iter().chain(Equations::of_matrices_by_bodies(model)).collect();
    let entries = model.coordinates.len().pow(2);
    let of_entries = model.matrices.iter().flat_map(|(matrix, _)| std::iter::repeat_n(asked.has(*matrix), entries));
    let wanted = Wanted { outputs: of_entries.collect(), parameters: asked.parameters.clone() };
    let differentiated = symbolic::derive(all, wanted, model.definitions.len())?;
    // The constants of a program are rounded, those of the formulas are not: what is zero is proved there.
    let exact = differentiated[0].partials.clone();
    let same: Vec<Differentiated> =
        differentiated.into_iter().filter(|differentiated| differentiated.partials == exact).collect();
    let found = symbolic::compile(same.iter().map(|differentiated| differentiated.equations.clone()).collect())?;
    let cost = |(differentiated, found): &(Differentiated, Found)| {
        Counts::of(&share_values(found.program().clone(), &differentiated.partials).0).cost()
    };
    let Some((differentiated, found)) = same.into_iter().zip(found).min_by_key(cost) else {
        unreachable!("the derivatives of the formulas are among them")
    };
    let program = symbolic::finish_derivatives(found)?;
    let (program, partials) = share_values(program, &differentiated.partials);
    let (program, partials) = place_values(passes::schedule(&program), partials, entries * model.matrices.len());
    Ok(name_values(model, differentiated, program, partials))
}

/// With each value once, of derivatives that are equal or opposite: those of the mirror image of an entry, for one.
fn share_values(mut program: Program, partials: &[(usize, usize)]) -> (Program, Vec<Partial>) {
    let derivatives = program.outputs.split_off(program.outputs.len() - partials.len());
    let mut values: Vec<Value> = Vec::new();
    let mut partial = |(&(entry, parameter), &output): (&(usize, usize), &Value)| {
        let (negative, stored) = match program.instructions[output] {
            Instruction::Neg(opposite) => (true, opposite),
            _ => (false, output),
        };
        let known = values.iter().position(|value| *value == stored);
        let value = known.unwrap_or_else(|| {
            values.push(stored);
            values.len() - 1
        });
        Partial { entry, parameter, value, negative }
    };
    let partials = partials.iter().zip(&derivatives).map(&mut partial).collect();
    program.outputs.extend(values);
    (passes::optimize(program), partials)
}

/// With the values of the derivatives in the order in which they are computed, which is that in which they are stored best.
fn place_values(mut program: Program, partials: Vec<Partial>, entries: usize) -> (Program, Vec<Partial>) {
    let mut order: Vec<usize> = (0..program.outputs.len() - entries).collect();
    order.sort_by_key(|value| program.outputs[entries + value]);
    let mut places = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, value)| places[*value] = place);
    let outputs: Vec<Value> = order.iter().map(|value| program.outputs[entries + value]).collect();
    program.outputs.splice(entries.., outputs);
    let partials = partials.into_iter().map(|partial| Partial { value: places[partial.value], ..partial });
    (program, partials.collect())
}

/// A name for each entry of the matrices, row by row: `C1_12` stands in the first row and the second column of C1.
pub fn entry_names(model: &Model) -> Vec<String> {
    let size = model.coordinates.len();
    let places = (1..=size).flat_map(|row| (1..=size).map(move |column| (row, column)));
    let matrices = model.matrices.iter();
    let name = |(matrix, _): &(MatrixName, _), (row, column)| format!("{}_{row}{column}", matrix.identifier());
    matrices.flat_map(|matrix| places.clone().map(move |place| name(matrix, place))).collect()
}

/// With a name for each value that is the derivative of something with a name: `mu_c` for that of `mu` by `c`.
fn name_values(
    model: &Model,
    differentiated: Differentiated,
    mut program: Program,
    partials: Vec<Partial>,
) -> Derivatives {
    let Differentiated { equations, definitions, .. } = differentiated;
    let entries = entry_names(model);
    let name = |node: &Node| match *node {
        Node::Parameter(index) => Some(model.parameters[index].name.to_string()),
        Node::Definition(index) => model.definitions.get(equations.origins[index]).map(|(name, _)| name.to_string()),
        Node::Output(index) => entries.get(index).cloned(),
    };
    let mut names = Vec::new();
    let mut labels = Vec::new();
    for (value, origin) in program.labels {
        if origin < model.definitions.len() {
            labels.push((value, origin));
        } else if let Some([of, with]) = definitions.get(&origin)
            && let (Some(of), Some(with)) = (name(of), name(with))
        {
            labels.push((value, model.definitions.len() + names.len()));
            names.push(format!("{of}_{with}"));
        }
    }
    program.labels = labels;
    Derivatives { program, partials, names }
}
