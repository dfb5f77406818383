//! What depends on the parameters alone is computed once.

use crate::program::{Instruction, Program, Value, passes};

/// Programs of which each reads what another one has computed before.
#[derive(Debug)]
pub struct Split {
    /// From the parameters.
    pub constants: Program,
    /// From what that computes, and behind it the other inputs.
    pub programs: Vec<Program>,
}

/// Splits the program of some outputs; of its inputs the first `parameters` are constant. The last `more` of the programs
/// have to do with what the others make of these, and with the parameters themselves.
pub fn split(program: &Program, parameters: usize, outputs: &[Vec<Value>], more: usize) -> Split {
    let mut varies: Vec<bool> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        varies.push(match instruction {
            Instruction::Parameter(index) => *index >= parameters,
            other => other.operands().any(|value| varies[value]),
        });
    }
    let is_number = |value: Value| matches!(program.instructions[value], Instruction::Constant(_));
    let is_constant = |value: Value| !varies[value] && !is_number(value);
    let (first, last) = outputs.split_at(outputs.len() - more);
    let mut needed: Vec<Vec<bool>> = first.iter().map(|outputs| find_needed(program, outputs, &varies)).collect();
    // What is read by what varies, or is a result itself.
    let mut read = vec![false; program.instructions.len()];
    first.iter().flatten().for_each(|value| read[*value] = true);
    for (user, instruction) in program.instructions.iter().enumerate() {
        if varies[user] && needed.iter().any(|needed| needed[user]) {
            instruction.operands().for_each(|value| read[value] = true);
        }
    }
    let computed: Vec<bool> = (0..read.len()).map(|value| varies[value] || !read[value]).collect();
    for outputs in last {
        let more = find_needed(program, outputs, &computed);
        for (value, instruction) in program.instructions.iter().enumerate() {
            read[value] |= more[value] && matches!(instruction, Instruction::Parameter(_));
        }
        needed.push(more);
    }
    let constants: Vec<Value> = (0..read.len()).filter(|value| is_constant(*value) && read[*value]).collect();
    let inputs = constants.len() + program.parameters - parameters;
    let run = outputs.iter().zip(&needed).map(|(outputs, needed)| {
        let mut run = Program::new(inputs);
        let mut new: Vec<Value> = vec![0; program.instructions.len()];
        for (value, instruction) in program.instructions.iter().enumerate() {
            if !needed[value] {
                continue;
            }
            let constant = constants.binary_search(&value).ok();
            new[value] = run.push(match (constant, instruction) {
                (Some(place), _) => Instruction::Parameter(place),
                (None, Instruction::Parameter(index)) => Instruction::Parameter(index - parameters + constants.len()),
                (None, other) => other.map(|operand| new[operand]),
            });
        }
        run.outputs = outputs.iter().map(|output| new[*output]).collect();
        passes::optimize(run)
    });
    let programs = run.collect();
    let mut first = Program { parameters, outputs: constants, ..program.clone() };
    // Beyond the constants there is nothing that it could read.
    let last = first.outputs.last().map_or(0, |last| last + 1);
    let kept = find_needed(&first, &first.outputs.clone(), &vec![true; first.instructions.len()]);
    let mut new: Vec<Value> = vec![0; last];
    let mut alone = Program::new(parameters);
    for (value, instruction) in first.instructions.drain(..).enumerate().take(last) {
        if kept[value] {
            new[value] = alone.push(instruction.map(|operand| new[operand]));
        }
    }
    alone.outputs = first.outputs.iter().map(|value| new[*value]).collect();
    Split { constants: passes::optimize(alone), programs }
}

/// The values that outputs need, down to those that do not vary.
fn find_needed(program: &Program, outputs: &[Value], varies: &[bool]) -> Vec<bool> {
    let mut needed = vec![false; program.instructions.len()];
    outputs.iter().for_each(|value| needed[*value] = true);
    for value in (0..needed.len()).rev() {
        if needed[value] && varies[value] {
            program.instructions[value].operands().for_each(|operand| needed[operand] = true);
        }
    }
    needed
}
