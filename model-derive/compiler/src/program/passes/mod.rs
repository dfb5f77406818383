//! The passes that improve a program, in their order.

mod common_pairs;
mod cse;
mod nary;
mod powers;
mod quotients;
mod rearrange;
mod schedule;
mod signs;
mod substitute;

pub use cse::Builder;
pub use rearrange::{Effort, rearrange};
pub use schedule::schedule;
pub use substitute::substitute;

use super::Program;

/// Runs all passes.
pub fn optimize(program: Program) -> Program {
    // After this point whole powers are squares, products and reciprocals.
    let program = checked(powers::expand(program));
    // After this point no instruction uses a negation; only outputs may be negated.
    let program = checked(signs::collect(program));
    // After this point no two products or sums compute the same pair of factors or terms; where signs moved out of a sum,
    // more of them are the same.
    let program = checked(signs::collect(common_pairs::extract(program)));
    let program = checked(signs::collect(common_pairs::extract(program)));
    // After this point no reciprocal is used by one product alone, and no value divides twice.
    let program = checked(quotients::divide(program));
    // After this point no two instructions are equal, and every value is used.
    checked(cse::eliminate(program))
}

/// The invariants of every program hold between passes.
fn checked(program: Program) -> Program {
    program.assert_invariants();
    program
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Counts, Instruction};

    /// Builds a program in two parameters x and y from instructions that follow them.
    fn program(instructions: &[Instruction], outputs: &[usize]) -> Program {
        let mut program = Program::new(2);
        program.push(Instruction::Parameter(0));
        program.push(Instruction::Parameter(1));
        instructions.iter().for_each(|instruction| {
            program.push(*instruction);
        });
        program.outputs = outputs.to_vec();
        program
    }

    fn check(before: Program, counts: Counts, expected: impl Fn(f64, f64) -> Vec<f64>) {
        let after = optimize(before);
        assert_eq!(Counts::of(&after), counts, "{after:?}");
        for (x, y) in [(1.5, 0.25), (-3.0, 7.0), (0.125, -2.0)] {
            assert_eq!(after.interpret(&[x, y]), expected(x, y), "at {x}, {y}");
        }
    }

    #[test]
    fn powers_share_their_squares() {
        let before =
            program(&[Instruction::Power(0, 6), Instruction::Power(0, 4), Instruction::Power(1, -1)], &[2, 3, 4]);
        let counts = Counts { multiplications: 3, divisions: 1, ..Counts::default() };
        check(before, counts, |x, y| vec![x * x * (x * x * (x * x)), x * x * (x * x), 1.0 / y]);
    }

    #[test]
    fn signs_move_out_of_sums_and_products() {
        // (-x) * y + (-(x + y)) is -(x y + (x + y)).
        let before = program(
            &[
                Instruction::Neg(0),
                Instruction::Mul(2, 1),
                Instruction::Add(0, 1),
                Instruction::Neg(4),
                Instruction::Add(3, 5),
            ],
            &[6],
        );
        let counts = Counts { additions: 2, multiplications: 1, negations: 1, ..Counts::default() };
        check(before, counts, |x, y| vec![-(x * y + (x + y))]);
    }

    #[test]
    fn opposite_differences_are_computed_once() {
        let before = program(&[Instruction::Sub(0, 1), Instruction::Sub(1, 0), Instruction::Mul(2, 3)], &[4]);
        let counts = Counts { additions: 1, multiplications: 1, negations: 1, ..Counts::default() };
        check(before, counts, |x, y| vec![-((x - y) * (x - y))]);
    }

    #[test]
    fn signs_are_chosen_so_that_outputs_need_no_negation() {
        // -(1 + (x - y)) and 2 + (1 + (x - y)): with y - x instead, neither is negated.
        let before = program(
            &[
                Instruction::Constant(1.0),
                Instruction::Constant(2.0),
                Instruction::Sub(0, 1),
                Instruction::Add(2, 4),
                Instruction::Neg(5),
                Instruction::Add(3, 5),
            ],
            &[6, 7],
        );
        let after = signs::choose(before.clone());
        assert_eq!(Counts::of(&after), Counts { additions: 3, ..Counts::default() }, "{after:?}");
        assert_eq!(after.interpret(&[1.5, 0.25]), before.interpret(&[1.5, 0.25]));
    }

    #[test]
    fn one_quotient_divides_and_several_share_a_reciprocal() {
        let before = program(&[Instruction::Reciprocal(1), Instruction::Mul(0, 2)], &[3]);
        check(before, Counts { divisions: 1, ..Counts::default() }, |x, y| vec![x / y]);

        let before = program(&[Instruction::Div(0, 1), Instruction::Add(0, 1), Instruction::Div(3, 1)], &[2, 4]);
        let counts = Counts { additions: 1, multiplications: 2, divisions: 1, ..Counts::default() };
        check(before, counts, |x, y| vec![x * (1.0 / y), (x + y) * (1.0 / y)]);
    }

    #[test]
    fn products_share_pairs_of_factors_however_they_are_bracketed() {
        // x^2 y and x y.
        let before = program(&[Instruction::Square(0), Instruction::Mul(2, 1), Instruction::Mul(0, 1)], &[3, 4]);
        check(before, Counts { multiplications: 2, ..Counts::default() }, |x, y| vec![x * (x * y), x * y]);

        // x^2 y^2 is the square of x y.
        let before = program(&[Instruction::Square(0), Instruction::Square(1), Instruction::Mul(2, 3)], &[4]);
        check(before, Counts { multiplications: 2, ..Counts::default() }, |x, y| vec![x * y * (x * y)]);
    }

    #[test]
    fn sums_share_pairs_of_terms_and_their_negatives() {
        // x + x^2 + y^2 and y - x^2 - y^2.
        let before = program(
            &[
                Instruction::Square(0),
                Instruction::Square(1),
                Instruction::Add(0, 2),
                Instruction::Add(4, 3),
                Instruction::Sub(1, 2),
                Instruction::Sub(6, 3),
            ],
            &[5, 7],
        );
        let counts = Counts { additions: 3, multiplications: 2, ..Counts::default() };
        check(before, counts, |x, y| vec![x + (x * x + y * y), y - (x * x + y * y)]);
    }

    #[test]
    fn half_of_a_doubled_value_may_be_part_of_another_sum() {
        let before = program(
            &[Instruction::Constant(2.0), Instruction::Mul(2, 0), Instruction::Add(3, 1), Instruction::Add(0, 1)],
            &[4, 5],
        );
        check(before, Counts { additions: 2, ..Counts::default() }, |x, y| vec![x + (x + y), x + y]);
    }

    #[test]
    fn divisions_by_one_value_share_its_reciprocal_with_the_factors_beside_it() {
        // x y / (x + y) and x / (x + y).
        let before = program(
            &[Instruction::Add(0, 1), Instruction::Mul(0, 1), Instruction::Div(3, 2), Instruction::Div(0, 2)],
            &[4, 5],
        );
        let counts = Counts { additions: 1, multiplications: 1, divisions: 1, ..Counts::default() };
        check(before, counts, |x, y| vec![x / (x + y) * y, x / (x + y)]);
    }

    #[test]
    fn a_long_chain_of_squares_takes_no_more_than_before() {
        let squares: Vec<Instruction> =
            std::iter::once(Instruction::Square(0)).chain((2..40).map(Instruction::Square)).collect();
        let after = optimize(program(&squares, &[40]));
        assert_eq!(Counts::of(&after).multiplications, 39);
    }

    #[test]
    fn equal_and_unused_instructions_go() {
        let before = program(
            &[Instruction::Add(0, 1), Instruction::Add(1, 0), Instruction::Sin(0), Instruction::Mul(2, 3)],
            &[5],
        );
        let counts = Counts { additions: 1, multiplications: 1, ..Counts::default() };
        check(before, counts, |x, y| vec![(x + y) * (x + y)]);
    }

    #[test]
    #[should_panic(expected = "uses a later value")]
    fn a_program_that_looks_ahead_is_refused() {
        program(&[Instruction::Add(0, 2)], &[2]).assert_invariants();
    }

    #[test]
    #[should_panic(expected = "a definition depends on itself")]
    fn results_that_depend_on_their_own_placeholders_are_refused() {
        let placeholder = program(&[Instruction::Constant(0.0), Instruction::Add(2, 0)], &[3]);
        substitute(placeholder, &[(0, 2)], &[3]);
    }
}
