//! The passes that improve a program, in their order.

mod powers;
mod quotients;
mod rebuild;
mod signs;
mod tie;

pub use tie::tie;

use super::Program;

/// Runs all passes.
pub fn optimize(program: Program) -> Program {
    // After this point whole powers are squares, products and reciprocals.
    let program = checked(powers::expand(program));
    // After this point no instruction uses a negation; only outputs may be negated.
    let program = checked(signs::collect(program));
    // After this point no reciprocal is used by one product alone, and no value divides twice.
    let program = checked(quotients::divide(program));
    // After this point no two instructions are equal, and every value is used.
    checked(rebuild::common(program))
}

/// The invariants of every program hold between passes.
fn checked(program: Program) -> Program {
    program.assert_invariants();
    program
}
