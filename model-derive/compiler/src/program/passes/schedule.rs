//! The order of a program that has many results, for processors that have few registers.

use rustc_hash::FxHashMap;

use crate::program::{Instruction, Program, Value};

/// Time is counted in fifths of a cycle.
const CYCLE: u32 = 5;
/// Five of two operations begin in a cycle.
const OPERATION: u32 = 2;
/// Sine and cosine are some twenty operations, and their results come late.
const FUNCTION: u32 = 20 * OPERATION;
/// What waits no longer than this for its operands may begin: meanwhile the processor finds other work by itself.
const PATIENCE: u32 = 9 * CYCLE;
/// So many values may wait for their uses; registers are 16.
const REGISTERS: usize = 10;
/// Before there are so many, those of the values that wait least are preferred.
const CAREFUL: usize = REGISTERS - 4;

/// The same instructions in an order in which functions of angles begin first, nothing waits long for its operands, and few
/// values wait for their uses.
///
/// Each value that another one alone uses is computed directly before that.
pub fn schedule(program: &Program) -> Program {
    let steps = steps(program);
    let mut new: Vec<Option<Value>> = vec![None; program.instructions.len()];
    let mut scheduled = Program::new(program.parameters);
    let mut append = |value: Value, scheduled: &mut Program| {
        let operand = |value: Value| new[value].unwrap_or_else(|| unreachable!("operands come before their use"));
        let appended = scheduled.push(program.instructions[value].map(operand));
        new[value] = Some(appended);
    };
    // What is read comes first, in the order in which it is stored.
    let is_read = |value: &Value| !is_computed(program.instructions[*value]);
    let mut read: Vec<Value> = (0..program.instructions.len()).filter(is_read).collect();
    read.sort_by_key(|value| match program.instructions[*value] {
        Instruction::Parameter(index) => index,
        _ => program.parameters,
    });
    read.into_iter().for_each(|value| append(value, &mut scheduled));
    for step in order(&steps) {
        steps[step].instructions.iter().for_each(|value| append(*value, &mut scheduled));
    }
    let moved = |value: Value| new[value].unwrap_or_else(|| unreachable!("every value is computed"));
    scheduled.outputs = program.outputs.iter().map(|value| moved(*value)).collect();
    scheduled.labels = program.labels.iter().map(|(value, label)| (moved(*value), *label)).collect();
    scheduled
}

/// Instructions that stay together.
struct Step {
    /// The last one makes a value that others use or that is a result.
    instructions: Vec<Value>,
    /// The steps whose values are used.
    needs: Vec<usize>,
    /// The steps that use the value.
    users: Vec<usize>,
    is_function: bool,
    /// For how long it keeps the processor from beginning other work.
    work: u32,
    /// How long after all operands its value is there.
    latency: u32,
}

fn is_computed(instruction: Instruction) -> bool {
    !matches!(instruction, Instruction::Parameter(_) | Instruction::Constant(_))
}

fn is_function(instruction: Instruction) -> bool {
    matches!(instruction, Instruction::Sin(_) | Instruction::Cos(_) | Instruction::Tan(_))
}

fn latency(instruction: Instruction) -> u32 {
    match instruction {
        Instruction::Sin(_) | Instruction::Cos(_) | Instruction::Tan(_) => 40 * CYCLE,
        Instruction::Div(..) | Instruction::Reciprocal(_) | Instruction::Sqrt(_) => 11 * CYCLE,
        _ => 4 * CYCLE,
    }
}

/// The steps of a program, in its order.
fn steps(program: &Program) -> Vec<Step> {
    let uses = program.uses();
    let mut stands = vec![false; uses.len()];
    program.outputs.iter().for_each(|value| stands[*value] = true);
    let mut steps: Vec<Step> = Vec::new();
    // Of each value: what makes it, which is a step or will be part of one.
    let mut makers: Vec<Option<Step>> = Vec::new();
    let mut step_of: Vec<Option<usize>> = Vec::new();
    let mut functions: FxHashMap<Value, usize> = FxHashMap::default();
    for (value, instruction) in program.instructions.iter().enumerate() {
        if !is_computed(*instruction) {
            makers.push(None);
            step_of.push(None);
            continue;
        }
        // Sine and cosine of an angle come from one call.
        let beside = instruction.operands().next().and_then(|angle| functions.get(&angle).copied());
        let is_function = is_function(*instruction);
        if let (true, Some(step)) = (is_function, beside) {
            steps[step].instructions.push(value);
            makers.push(None);
            step_of.push(Some(step));
            continue;
        }
        let work = if is_function { FUNCTION } else { OPERATION };
        let mut step = Step {
            instructions: Vec::new(),
            needs: Vec::new(),
            users: Vec::new(),
            is_function,
            work,
            latency: latency(*instruction),
        };
        for operand in instruction.operands() {
            if let Some(part) = makers[operand].take() {
                step.latency = step.latency.max(part.latency + latency(*instruction));
                step.work += part.work;
                step.instructions.extend(part.instructions);
                step.needs.extend(part.needs);
            } else {
                step.needs.extend(step_of[operand]);
            }
        }
        step.instructions.push(value);
        step.needs.sort_unstable();
        step.needs.dedup();
        if uses[value] == 1 && !stands[value] && !is_function {
            makers.push(Some(step));
            step_of.push(None);
        } else {
            if let (true, Some(angle)) = (is_function, instruction.operands().next()) {
                functions.insert(angle, steps.len());
            }
            for need in &step.needs {
                let user = steps.len();
                steps[*need].users.push(user);
            }
            makers.push(None);
            step_of.push(Some(steps.len()));
            steps.push(step);
        }
    }
    steps
}

/// The order of the steps.
fn order(steps: &[Step]) -> Vec<usize> {
    // How many steps have yet to use a value, or to come before one.
    let mut uses: Vec<usize> = steps.iter().map(|step| step.users.len()).collect();
    let mut missing: Vec<usize> = steps.iter().map(|step| step.needs.len()).collect();
    let mut there: Vec<u32> = vec![0; steps.len()];
    let mut ready: Vec<usize> = (0..steps.len()).filter(|step| missing[*step] == 0).collect();
    let mut order = Vec::with_capacity(steps.len());
    let (mut now, mut waiting) = (0, 0_usize);
    while !ready.is_empty() {
        // By how many fewer values wait afterwards, and when all operands are there.
        let freed = |step: usize| steps[step].needs.iter().filter(|need| uses[**need] == 1).count();
        let gain = |step: usize| freed(step) as i32 - i32::from(!steps[step].users.is_empty());
        let begin = |step: usize| steps[step].needs.iter().map(|need| there[*need]).max().unwrap_or(0);
        let preference = |step: usize| match waiting {
            REGISTERS.. => gain(step),
            CAREFUL.. => gain(step).signum(),
            _ => 0,
        };
        let function = ready.iter().position(|step| steps[*step].is_function);
        let place = function.unwrap_or_else(|| {
            let possible = (0..ready.len()).filter(|place| begin(ready[*place]) <= now + PATIENCE);
            let best = possible.max_by_key(|place| (preference(ready[*place]), std::cmp::Reverse(ready[*place])));
            let soonest = || (0..ready.len()).min_by_key(|place| (begin(ready[*place]), ready[*place]));
            best.or_else(soonest).unwrap_or_default()
        });
        let step = ready.swap_remove(place);
        order.push(step);
        waiting = waiting + usize::from(!steps[step].users.is_empty()) - freed(step);
        there[step] = now.max(begin(step)) + steps[step].latency;
        now += steps[step].work;
        steps[step].needs.iter().for_each(|need| uses[*need] -= 1);
        for user in &steps[step].users {
            missing[*user] -= 1;
            if missing[*user] == 0 {
                ready.push(*user);
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Instruction::{Add, Cos, Mul, Parameter, Sin, Square};

    fn program(instructions: &[Instruction], outputs: &[Value]) -> Program {
        let mut program = Program::new(3);
        [Parameter(2), Parameter(0), Parameter(1)].into_iter().chain(instructions.iter().copied()).for_each(|next| {
            program.push(next);
        });
        program.outputs = outputs.to_vec();
        program
    }

    /// The same values, of the same operations.
    fn scheduled(before: &Program) -> Vec<Instruction> {
        let after = schedule(before);
        after.assert_invariants();
        assert_eq!(after.instructions.len(), before.instructions.len());
        for parameters in [[1.5, 0.25, -3.0], [0.125, 7.0, 2.0]] {
            assert_eq!(after.interpret(&parameters), before.interpret(&parameters));
        }
        after.instructions
    }

    #[test]
    fn what_is_read_comes_in_declared_order_and_functions_begin_first() {
        let before = program(&[Square(1), Mul(3, 0), Sin(2), Mul(4, 5), Cos(2)], &[6, 7, 3]);
        let after = scheduled(&before);
        assert_eq!(after[..5], [Parameter(0), Parameter(1), Parameter(2), Sin(1), Cos(1)]);
    }

    #[test]
    fn a_result_that_waits_for_nothing_is_not_put_off() {
        // Fifteen products, and then the sums of each with a parameter: each product waits for one sum.
        let mut instructions = vec![Mul(0, 1)];
        instructions.extend((3..17).map(|product| Mul(product, 1)));
        instructions.extend((3..18).map(|product| Add(product, 2)));
        let before = program(&instructions, &(18..33).collect::<Vec<_>>());
        let after = scheduled(&before);
        let first_sum = after.iter().position(|instruction| matches!(instruction, Add(..)));
        let last_product = after.iter().rposition(|instruction| matches!(instruction, Mul(..)));
        assert!(first_sum < last_product, "{after:?}");
    }

    #[test]
    fn what_one_value_alone_uses_is_computed_directly_before_it() {
        // (z x + y) y, between others that could come in between.
        let before = program(&[Mul(0, 1), Square(1), Add(3, 2), Square(2), Mul(5, 2)], &[4, 6, 7]);
        let after = scheduled(&before);
        let place = after.iter().position(|instruction| *instruction == Mul(2, 0)).expect("it is there");
        assert_eq!(after[place + 1..place + 3], [Add(place, 1), Mul(place + 1, 1)]);
    }

    #[test]
    fn many_results_leave_few_values_waiting() {
        // A chain of thirty values, and two results of each: done in turns, never more than a few of the chain wait.
        let mut instructions = vec![Mul(0, 1)];
        instructions.extend((3..32).map(|link| Mul(link, 1)));
        let mut outputs = Vec::new();
        for link in 3..33 {
            instructions.push(Square(link));
            instructions.push(Add(link, 2));
            outputs.extend([3 + instructions.len() - 2, 3 + instructions.len() - 1]);
        }
        let before = program(&instructions, &outputs);
        assert!(waiting(&before) >= 29);
        assert!(waiting(&schedule(&before)) <= REGISTERS + 2);
    }

    /// How many computed values wait for a use at most.
    fn waiting(program: &Program) -> usize {
        let uses = |value, user: &Instruction| user.operands().any(|used| used == value);
        let last = |value| program.instructions.iter().rposition(|user| uses(value, user)).unwrap_or(0);
        let at = |now| (3..now).filter(|value| last(*value) >= now).count();
        (3..program.instructions.len()).map(at).max().unwrap_or(0)
    }
}
