//! Runs a program: the oracle that the passes and the generated code are tested against.

use super::{Instruction, Program};

impl Program {
    /// The outputs at the given parameters, with sine and cosine of the platform.
    pub fn interpret(&self, parameters: &[f64]) -> Vec<f64> {
        self.interpret_with(parameters, f64::sin_cos)
    }

    /// The outputs at the given parameters, with another sine and cosine, such as those of the runtime.
    pub fn interpret_with(&self, parameters: &[f64], sin_cos: impl Fn(f64) -> (f64, f64)) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.instructions.len());
        for instruction in &self.instructions {
            let value = match *instruction {
                Instruction::Parameter(index) => parameters[index],
                Instruction::Constant(value) => value,
                Instruction::Add(a, b) => values[a] + values[b],
                Instruction::Sub(a, b) => values[a] - values[b],
                Instruction::Mul(a, b) => values[a] * values[b],
                Instruction::Div(a, b) => values[a] / values[b],
                Instruction::Neg(a) => -values[a],
                Instruction::Square(a) => values[a] * values[a],
                Instruction::Reciprocal(a) => values[a].recip(),
                Instruction::Power(a, n) => values[a].powi(n),
                Instruction::Sqrt(a) => values[a].sqrt(),
                Instruction::Sin(a) => sin_cos(values[a]).0,
                Instruction::Cos(a) => sin_cos(values[a]).1,
                Instruction::Tan(a) => values[a].tan(),
            };
            values.push(value);
        }
        self.outputs.iter().map(|value| values[*value]).collect()
    }
}
