//! Straight-line programs: what the symbolic stage leaves, what the passes improve, what is emitted.

mod counts;
mod interpret;
pub mod passes;

pub use counts::Counts;
use nanoserde::{DeBin, SerBin};

/// A value: the position of the instruction that computes it.
pub type Value = usize;

/// One step of a program. It uses only earlier values.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, SerBin)]
pub enum Instruction {
    /// The parameter at a position.
    Parameter(usize),
    /// A number.
    Constant(f64),
    /// a + b.
    Add(Value, Value),
    /// a - b.
    Sub(Value, Value),
    /// a b.
    Mul(Value, Value),
    /// a / b.
    Div(Value, Value),
    /// -a.
    Neg(Value),
    /// a^2.
    Square(Value),
    /// 1 / a.
    Reciprocal(Value),
    /// a to a whole power; only until the pass `powers`.
    Power(Value, i32),
    /// The square root of a.
    Sqrt(Value),
    /// The sine of a, in radians.
    Sin(Value),
    /// The cosine of a, in radians.
    Cos(Value),
    /// The tangent of a, in radians.
    Tan(Value),
}

impl Instruction {
    /// The values that this instruction uses.
    pub fn operands(&self) -> impl Iterator<Item = Value> + use<> {
        let (first, second) = match *self {
            Self::Parameter(_) | Self::Constant(_) => (None, None),
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => (Some(a), Some(b)),
            Self::Neg(a)
            | Self::Square(a)
            | Self::Reciprocal(a)
            | Self::Power(a, _)
            | Self::Sqrt(a)
            | Self::Sin(a)
            | Self::Cos(a)
            | Self::Tan(a) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }

    /// The same instruction on other values.
    pub fn map(self, mut f: impl FnMut(Value) -> Value) -> Self {
        match self {
            Self::Parameter(_) | Self::Constant(_) => self,
            Self::Add(a, b) => Self::Add(f(a), f(b)),
            Self::Sub(a, b) => Self::Sub(f(a), f(b)),
            Self::Mul(a, b) => Self::Mul(f(a), f(b)),
            Self::Div(a, b) => Self::Div(f(a), f(b)),
            Self::Neg(a) => Self::Neg(f(a)),
            Self::Square(a) => Self::Square(f(a)),
            Self::Reciprocal(a) => Self::Reciprocal(f(a)),
            Self::Power(a, n) => Self::Power(f(a), n),
            Self::Sqrt(a) => Self::Sqrt(f(a)),
            Self::Sin(a) => Self::Sin(f(a)),
            Self::Cos(a) => Self::Cos(f(a)),
            Self::Tan(a) => Self::Tan(f(a)),
        }
    }
}

/// A straight-line program in single assignment.
#[derive(Clone, Debug, DeBin, Default, PartialEq, SerBin)]
pub struct Program {
    /// The number of parameters that it may read.
    pub parameters: usize,
    /// In an order in which each uses only earlier ones.
    pub instructions: Vec<Instruction>,
    /// The values that it computes, in the order of the outputs.
    pub outputs: Vec<Value>,
    /// Values that are a definition of the model, and the position of that definition: names for readers.
    pub labels: Vec<(Value, usize)>,
}

impl Program {
    /// An empty program in so many parameters.
    pub fn new(parameters: usize) -> Self {
        Self { parameters, ..Self::default() }
    }

    /// Appends an instruction and returns its value.
    pub fn push(&mut self, instruction: Instruction) -> Value {
        self.instructions.push(instruction);
        self.instructions.len() - 1
    }

    /// How often each value is used, outputs included.
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.instructions.len()];
        let operands = self.instructions.iter().flat_map(Instruction::operands);
        for value in operands.chain(self.outputs.iter().copied()) {
            uses[value] += 1;
        }
        uses
    }

    /// Checks what holds for every program: operands come before their use, parameters exist, constants are finite.
    ///
    /// # Panics
    /// If it does not hold. That is a mistake in a pass, never in a user's model.
    pub fn assert_invariants(&self) {
        for (position, instruction) in self.instructions.iter().enumerate() {
            assert!(
                instruction.operands().all(|value| value < position),
                "{position}: {instruction:?} uses a later value"
            );
            match *instruction {
                Instruction::Parameter(index) => assert!(index < self.parameters, "{position}: no parameter {index}"),
                Instruction::Constant(value) => assert!(value.is_finite(), "{position}: constant {value}"),
                _ => {}
            }
        }
        let named = self.outputs.iter().chain(self.labels.iter().map(|(value, _)| value));
        assert!(named.into_iter().all(|value| *value < self.instructions.len()), "an output that nothing computes");
    }
}
