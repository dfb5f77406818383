//! Placeholders, values that stand for results of the same program, are replaced by those results.

use crate::program::{Program, Value};

/// Replaces each of the `placeholders`, which stands for the definition at a position, by the one of `results`, labels
/// it with that position, and puts the instructions in an order that allows it.
///
/// # Panics
/// If a result depends on its own placeholder.
pub fn substitute(program: Program, placeholders: &[(usize, Value)], results: &[Value]) -> Program {
    let mut replace: Vec<Value> = (0..program.instructions.len()).collect();
    for ((_, placeholder), result) in placeholders.iter().zip(results) {
        replace[*placeholder] = *result;
    }
    // A definition that is another's name, or a parameter's, makes a chain.
    let resolve = |mut value: Value| {
        for _ in 0..=placeholders.len() {
            if replace[value] == value {
                return value;
            }
            value = replace[value];
        }
        panic!("a definition depends on itself");
    };

    let mut substituted = Program::new(program.parameters);
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
            new[value] = Some(substituted.push(instruction.map(|operand| new[operand].unwrap_or_default())));
            stack.pop();
            continue;
        }
        assert!(!std::mem::replace(&mut entered[value], true), "a definition depends on itself");
        stack.extend(missing.into_iter().rev());
    }
    substituted.labels =
        placeholders.iter().filter_map(|(index, value)| Some((new[resolve(*value)]?, *index))).collect();
    substituted.outputs = outputs.iter().map(|value| new[*value].unwrap_or_default()).collect();
    substituted
}
