//! Ties open ends: values that stand for results of the same program are replaced by those results.

use crate::program::{Program, Value};

/// Replaces each value of `open`, which stands for a definition, by the one of `results`, labels it with the position of
/// the definition, and puts the instructions in an order that allows it.
///
/// # Panics
/// If a result depends on its own open end.
pub fn tie(program: Program, open: &[(usize, Value)], results: &[Value]) -> Program {
    let mut replace: Vec<Value> = (0..program.instructions.len()).collect();
    for ((_, open), result) in open.iter().zip(results) {
        replace[*open] = *result;
    }
    // A definition that is another's name, or a parameter's, makes a chain.
    let resolve = |mut value: Value| {
        for _ in 0..=open.len() {
            if replace[value] == value {
                return value;
            }
            value = replace[value];
        }
        panic!("a definition depends on itself");
    };

    let mut tied = Program::new(program.parameters);
    let mut new: Vec<Option<Value>> = vec![None; program.instructions.len()];
    let mut entered = vec![false; program.instructions.len()];
    let outputs: Vec<Value> = program.outputs.iter().map(|value| resolve(*value)).collect();
    // Depth first with a stack of our own: long programs must not exhaust the thread's.
    let mut stack: Vec<Value> = outputs.iter().rev().copied().collect();
    while let Some(&value) = stack.last() {
        if new[value].is_some() {
            stack.pop();
            continue;
        }
        let instruction = program.instructions[value].map(resolve);
        let missing: Vec<Value> = instruction.operands().filter(|operand| new[*operand].is_none()).collect();
        if missing.is_empty() {
            new[value] = Some(tied.push(instruction.map(|operand| new[operand].unwrap_or_default())));
            stack.pop();
            continue;
        }
        assert!(!std::mem::replace(&mut entered[value], true), "a definition depends on itself");
        stack.extend(missing.into_iter().rev());
    }
    tied.labels = open.iter().filter_map(|(index, value)| Some((new[resolve(*value)]?, *index))).collect();
    tied.outputs = outputs.iter().map(|value| new[*value].unwrap_or_default()).collect();
    tied
}
