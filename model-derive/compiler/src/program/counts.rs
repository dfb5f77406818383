//! How many operations a program takes, and what they cost.

use std::fmt;

use super::{Instruction, Program};

/// Operations by kind; parameters and constants are free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications, squares among them.
    pub multiplications: usize,
    /// Divisions, reciprocals among them.
    pub divisions: usize,
    /// Changes of sign.
    pub negations: usize,
    /// Square roots.
    pub roots: usize,
    /// Sines, cosines and tangents.
    pub trigonometric: usize,
}

impl Counts {
    /// Everything that the program computes.
    pub fn of(program: &Program) -> Self {
        let mut counts = Self::default();
        for instruction in &program.instructions {
            let kind = match *instruction {
                Instruction::Parameter(_) | Instruction::Constant(_) => continue,
                Instruction::Add(..) | Instruction::Sub(..) => &mut counts.additions,
                Instruction::Mul(..) | Instruction::Square(_) | Instruction::Power(..) => &mut counts.multiplications,
                Instruction::Div(..) | Instruction::Reciprocal(_) => &mut counts.divisions,
                Instruction::Neg(_) => &mut counts.negations,
                Instruction::Sqrt(_) => &mut counts.roots,
                Instruction::Sin(_) | Instruction::Cos(_) | Instruction::Tan(_) => &mut counts.trigonometric,
            };
            *kind += 1;
        }
        counts
    }

    /// Operations of all kinds.
    pub fn total(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.negations + self.roots + self.trigonometric
    }

    /// An estimate of the time, in additions.
    pub fn cost(&self) -> usize {
        self.additions
            + self.multiplications
            + self.negations
            + DIVISION * self.divisions
            + ROOT * self.roots
            + TRIGONOMETRIC * self.trigonometric
    }
}

// What operations cost among others in straight-line code, in additions, measured on an Intel Xeon with AVX-512 by
// `cargo run --profile bench -p carvallo-tools --no-default-features --bin calibrate`, in `f64` and in `f32`:
//
// multiplication 1.0 and 1.0, change of sign 1.3 and 1.2, division 2.6 and 2.3, square root 2.6 and 1.8, sine alone 50 and
// 25, sine and cosine of one angle together 63 and 37.
//
// The weights are those in `f64` as whole numbers, and of sine and cosine half of both, since they come in pairs.

const DIVISION: usize = 3;
const ROOT: usize = 3;
const TRIGONOMETRIC: usize = 32;

/// `57 additions, 91 multiplications, 2 sines and cosines (150 operations)`.
impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.additions, "addition"),
            (self.multiplications, "multiplication"),
            (self.divisions, "division"),
            (self.negations, "negation"),
            (self.roots, "square root"),
            (self.trigonometric, "trigonometric function"),
        ];
        let words: Vec<String> = kinds
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, name)| format!("{count} {name}{}", if *count == 1 { "" } else { "s" }))
            .collect();
        match words.split_last() {
            None => f.write_str("no operations"),
            Some((only, [])) => f.write_str(only),
            Some((last, rest)) => write!(f, "{} and {last}: {} operations", rest.join(", "), self.total()),
        }
    }
}
