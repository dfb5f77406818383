//! Sums and products are put together in other ways, as long as that takes no more operations.
//!
//! What is computed stays the same by the laws of association, commutation and distribution, and pairs that are there
//! already are used again. Which of the many ways takes the fewest operations is hard to say, and greedy choices end where
//! none of them alone helps any more; so small changes are tried at random, also those that leave the count as it is, and
//! at first a few that make it worse (threshold accepting: Dueck & Scheuer 1990). The numbers are the same on every run
//! and machine.

mod conversion;
mod known;
mod network;
mod terms;

use self::conversion::Rearranged;
use self::network::{Network, Node, Signed};
use self::terms::{Other, Rearrangement};
use super::{cse, quotients, signs};
use crate::program::{Counts, Program};
use crate::random::Random;

/// How much is tried.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Changes for each sum and product, and so many at most.
    tried: usize,
    most: usize,
    /// Short programs are rearranged so many times at most, each time by other numbers.
    times: usize,
    /// Where the numbers begin.
    first: u64,
}

impl Effort {
    /// Tells which of several programs comes out cheaper.
    pub const COMPARE: Self = Self { tried: 125, most: 25_000, times: 1, first: FIRST };
    /// For the one that is chosen.
    pub const FINISH: Self = Self { tried: 500, most: 100_000, times: 2, first: FIRST };
    /// For the one with derivatives that is chosen: hundreds of results have much in common, and it takes long to find it.
    /// Of nine beginnings the one whose programs take the least time for the bicycle from formulas and from bodies.
    pub const DERIVATIVES: Self = Self { tried: 3_000, most: 1_000_000, times: 1, first: FIRST + 8 };
}

/// Of five beginnings that give the bicycle the same operations the one with the smallest rounding errors (`cargo bench -p
/// carvallo-bench --bench summary -- errors`).
const FIRST: u64 = 28;

/// What saves no more than this part stays as it was found in the formulas, where sums are as people write them.
const LITTLE: usize = 50;

/// Out of a thousand changes so many may make it worse at first, by one or two operations, and towards the end none.
const WORSE: usize = 30;

/// Afterwards the program is the same as before, or cheaper than what was found in the formulas. It has to be without whole
/// powers.
pub fn rearrange(program: Program, found: usize, Effort { tried, most, times, first }: Effort) -> Program {
    let steps = (tried * Counts::of(&program).total()).min(most);
    let times = (most / steps.max(1)).min(times);
    let others = (0..times).map(|time| rearrange_once(&program, steps, Random(first + time as u64)));
    let cost = |program: &Program| Counts::of(program).cost();
    // Of equally cheap ones the first stays.
    match others.min_by_key(cost) {
        Some(cheapest) if cost(&cheapest) < cost(&program) && cost(&cheapest) + found / LITTLE < found => cheapest,
        _ => program,
    }
}

fn rearrange_once(program: &Program, steps: usize, mut random: Random) -> Program {
    let mut rearranged = Rearranged::new(program);
    for step in 0..steps {
        let worse = if random.below(1_000) < WORSE * (steps - step) / steps { 1 + random.below(2) } else { 0 };
        let node = random.below(rearranged.network.len());
        rearranged.change(node, worse, &mut random);
    }
    cse::eliminate(quotients::divide(signs::choose(rearranged.into_program())))
}

impl Rearranged {
    /// Changes a node, if that makes it no more than so many operations worse.
    fn change(&mut self, node: Node, worse: usize, random: &mut Random) {
        let Self { network, is_number, .. } = self;
        if network.users(node) == 0 || network.operation(node).0.operands().is_none() {
            return;
        }
        let most = network.cost() + worse;
        network.forget(node);
        match (Rearrangement { network, random, is_number }).find_other(node) {
            Some(Other::Operation(operation, minus)) => match network.find(operation) {
                Some(equal) => {
                    let minus = minus != network.operation(equal).1;
                    self.merge(node, Signed { node: equal, minus }, most);
                }
                None => {
                    network.redefine(node, operation, minus);
                    keep(network, network.cost() <= most);
                }
            },
            Some(Other::Value(value)) => self.merge(node, value, most),
            None => network.undo(),
        }
    }

    /// Puts a value in the place of a node, which saves at least the operation that computes it.
    fn merge(&mut self, node: Node, value: Signed, most: usize) {
        self.network.add_user(value.node);
        self.network.sweep();
        let kept = self.network.cost() <= most + 1;
        keep(&mut self.network, kept);
        if kept {
            self.put(node, value);
            self.network.drop_user(value.node);
            self.network.commit();
        }
    }
}

fn keep(network: &mut Network, kept: bool) {
    if kept {
        network.commit();
    } else {
        network.undo();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Instruction::{Add, Constant, Div, Mul, Parameter, Reciprocal, Sin, Sub};
    use crate::program::{Instruction, Value};

    /// A program in three parameters x, y and z, from instructions that follow them, and what it becomes.
    fn check(instructions: &[Instruction], outputs: &[Value], operations: usize) -> Program {
        let mut program = Program::new(3);
        let all = [0, 1, 2].map(Parameter).into_iter().chain(instructions.iter().copied());
        all.for_each(|instruction| {
            program.push(instruction);
        });
        program.outputs = outputs.to_vec();
        program.labels = vec![(outputs[0], 0)];
        let after =
            rearranged(&program, Effort::FINISH, [[1.5, 0.25, 3.0], [-3.0, 7.0, 0.5], [0.125, -2.0, 5.0]], 1e-15);
        assert_eq!(Counts::of(&after).total(), operations, "{after:?}");
        after
    }

    /// What a program in three parameters becomes, whose values stay what they were but for rounding.
    fn rearranged(program: &Program, effort: Effort, values: [[f64; 3]; 3], rounding: f64) -> Program {
        let after = rearrange(program.clone(), Counts::of(program).cost(), effort);
        after.assert_invariants();
        for parameters in values {
            let [before, after] = [program, &after].map(|program| program.interpret(&parameters));
            for (before, after) in before.into_iter().zip(after) {
                let same = before == after || (before - after).abs() <= rounding * before.abs();
                assert!(same, "{before} became {after} at {parameters:?}: {program:?}");
            }
        }
        after
    }

    #[test]
    fn programs_at_random_compute_what_they_did() {
        let mut random = Random(1);
        for _ in 0..10 {
            let mut program = Program::new(3);
            [0, 1, 2].map(Parameter).into_iter().for_each(|parameter| {
                program.push(parameter);
            });
            for count in 3..60 {
                // Near ones: so the formulas are deep.
                let [a, b] = [(); 2].map(|()| count - 1 - random.below(count.min(8)));
                program.push(if random.chance(50) { Mul(a, b) } else { Add(a, b) });
            }
            program.outputs = (50..60).collect();
            let program = super::super::optimize(program);
            rearranged(&program, Effort::COMPARE, [[1.5, 0.25, 0.75], [0.25, 0.5, 0.5], [0.125, 2.0, 0.75]], 1e-12);
        }
    }

    #[test]
    fn a_common_factor_comes_in_front_of_a_sum() {
        // x y + x z is x (y + z).
        check(&[Mul(0, 1), Mul(0, 2), Add(3, 4)], &[5], 2);
    }

    #[test]
    fn a_product_is_multiplied_out_where_its_terms_are_there() {
        // x (y + z) - x y is x z.
        check(&[Add(1, 2), Mul(0, 3), Mul(0, 1), Sub(4, 5)], &[6], 1);
    }

    #[test]
    fn sums_that_become_equal_are_one() {
        // sin(x y + x z) + sin(x (y + z)), and the negative of its angle.
        let instructions = [
            Mul(0, 1),
            Mul(0, 2),
            Add(3, 4),
            Sin(5),
            Add(1, 2),
            Mul(0, 7),
            Sin(8),
            Add(6, 9),
            Constant(2.0),
            Sub(1, 0),
            Sub(0, 1),
            Mul(12, 13),
        ];
        check(&instructions, &[10, 14], 7);
    }

    #[test]
    fn a_value_that_is_divided_by_is_taken_in_front() {
        // x / z + y / z is (x + y) / z.
        check(&[Div(0, 2), Reciprocal(2), Mul(1, 4), Add(3, 5)], &[6], 2);
    }

    #[test]
    fn what_is_as_short_as_it_can_be_stays_with_its_labels() {
        let after = check(&[Mul(0, 1), Add(2, 3)], &[4], 2);
        assert_eq!(after.labels, [(4, 0)]);
    }
}
