//! Statements of a model as straight-line code.

use std::collections::HashMap;

use carvallo::{Expression, Formula, Function};

/// One step, on the values of earlier ones, or of what is read, by their places.
#[derive(Clone, Copy, Debug)]
enum Step {
    Number(f64),
    Add(usize, usize),
    Sub(usize, usize),
    Mul(usize, usize),
    Div(usize, usize),
    Neg(usize),
    Call(Function, usize),
}

impl Step {
    /// The same step on other values.
    fn map(self, mut f: impl FnMut(usize) -> usize) -> Self {
        match self {
            Self::Number(number) => Self::Number(number),
            Self::Add(a, b) => Self::Add(f(a), f(b)),
            Self::Sub(a, b) => Self::Sub(f(a), f(b)),
            Self::Mul(a, b) => Self::Mul(f(a), f(b)),
            Self::Div(a, b) => Self::Div(f(a), f(b)),
            Self::Neg(a) => Self::Neg(f(a)),
            Self::Call(function, a) => Self::Call(function, f(a)),
        }
    }
}

/// What statements compute.
#[derive(Clone, Debug)]
pub struct Program {
    inputs: usize,
    steps: Vec<Step>,
    results: Vec<usize>,
}

impl Program {
    /// From lines of statements such as `T0=A1*A2;R0=T0+A3`, which read so many values of these letters and have results of another
    /// one; `None` where they cannot be read.
    pub fn new(lines: &[&str], read: &[(char, usize)], result: char) -> Option<Self> {
        let numbered = |(letter, count): &(char, usize)| {
            let letter = *letter;
            (0..*count).map(move |number| format!("{letter}{number}"))
        };
        let mut places: HashMap<String, usize> = HashMap::new();
        for name in read.iter().flat_map(numbered) {
            places.insert(name, places.len());
        }
        let mut own = Self { inputs: places.len(), steps: Vec::new(), results: Vec::new() };
        for statement in lines.iter().flat_map(|line| line.split(';')) {
            let (name, formula) = statement.split_once('=')?;
            let find = |name: &str| places.get(name).copied().map(Expression::Definition);
            let formula = Expression::new(&Formula::parse(formula)?, &find)?;
            let place = own.push(&formula);
            places.insert(name.to_owned(), place);
        }
        let results = (0..).map_while(|number| places.get(&format!("{result}{number}")).copied());
        own.results = results.collect();
        Some(own)
    }

    /// Of what is read and of each step whether so many of the results, the first ones, depend on it.
    fn needed(&self, results: usize) -> Vec<bool> {
        let mut is_needed = vec![false; self.inputs + self.steps.len()];
        self.results[..results].iter().for_each(|place| is_needed[*place] = true);
        for (at, step) in self.steps.iter().enumerate().rev() {
            if is_needed[self.inputs + at] {
                step.map(|place| {
                    is_needed[place] = true;
                    place
                });
            }
        }
        is_needed
    }

    /// Whether a result depends on what is read at a place.
    pub fn depends_on(&self, place: usize) -> bool {
        self.needed(self.results.len())[place]
    }

    /// The same with so many of the results, the first ones, and what these take.
    pub fn first(&self, results: usize) -> Self {
        let is_needed = self.needed(results);
        let mut own = Self { inputs: self.inputs, steps: Vec::new(), results: Vec::new() };
        let mut new: Vec<usize> = (0..self.inputs).collect();
        for (at, step) in self.steps.iter().enumerate() {
            let is_needed = is_needed[self.inputs + at];
            new.push(if is_needed { own.step(step.map(|place| new[place])) } else { 0 });
        }
        own.results = self.results[..results].iter().map(|place| new[*place]).collect();
        own
    }

    /// How many results there are.
    pub fn results(&self) -> usize {
        self.results.len()
    }

    /// The results of what is read, by parts that stand behind each other; infinite or not a number where there is none.
    pub fn run(&self, read: &[&[f64]]) -> Vec<f64> {
        let mut all = vec![0.0; self.inputs + self.steps.len()];
        // A slice is indexed without a call where nothing is optimized.
        let values = &mut all[..];
        let mut at = 0;
        for part in read {
            values[at..][..part.len()].copy_from_slice(part);
            at += part.len();
        }
        for step in &self.steps {
            values[at] = match *step {
                Step::Number(number) => number,
                Step::Add(a, b) => values[a] + values[b],
                Step::Sub(a, b) => values[a] - values[b],
                Step::Mul(a, b) => values[a] * values[b],
                Step::Div(a, b) => values[a] / values[b],
                Step::Neg(a) => -values[a],
                Step::Call(Function::Sin, a) => values[a].sin(),
                Step::Call(Function::Cos, a) => values[a].cos(),
                Step::Call(Function::Tan, a) => values[a].tan(),
                Step::Call(Function::Sqrt, a) => values[a].sqrt(),
            };
            at += 1;
        }
        self.results.iter().map(|place| values[*place]).collect()
    }

    fn step(&mut self, step: Step) -> usize {
        self.steps.push(step);
        self.inputs + self.steps.len() - 1
    }

    /// Appends what computes a formula, and returns the place of its value.
    fn push(&mut self, formula: &Expression) -> usize {
        match formula {
            Expression::Number(_, number) => self.step(Step::Number(*number)),
            Expression::Pi => self.step(Step::Number(std::f64::consts::PI)),
            Expression::Parameter(place) | Expression::Definition(place) => *place,
            Expression::Sum(terms) => self.fold(terms, 0.0, Step::Add, Step::Sub),
            Expression::Product(factors) => self.fold(factors, 1.0, Step::Mul, Step::Div),
            Expression::Power(base, exponent) => {
                let factors = vec![(*exponent < 0, (**base).clone()); exponent.unsigned_abs() as usize];
                self.fold(&factors, 1.0, Step::Mul, Step::Div)
            }
            Expression::Call(function, argument) => {
                let argument = self.push(argument);
                self.step(Step::Call(*function, argument))
            }
        }
    }

    /// Parts one after the other, of which the first stands alone unless it is inverse, from what changes nothing.
    fn fold(
        &mut self,
        parts: &[(bool, Expression)],
        neutral: f64,
        direct: fn(usize, usize) -> Step,
        inverse: fn(usize, usize) -> Step,
    ) -> usize {
        let mut all: Option<usize> = None;
        for (is_inverse, part) in parts {
            let part = self.push(part);
            all = Some(match (all, is_inverse) {
                (None, false) => part,
                (None, true) if neutral == 0.0 => self.step(Step::Neg(part)),
                (None, true) => {
                    let neutral = self.step(Step::Number(neutral));
                    self.step(inverse(neutral, part))
                }
                (Some(all), false) => self.step(direct(all, part)),
                (Some(all), true) => self.step(inverse(all, part)),
            });
        }
        all.unwrap_or_else(|| self.step(Step::Number(neutral)))
    }
}

#[cfg(test)]
mod tests {
    use super::Program;

    /// By hand: a = 3, b = 2.
    #[test]
    fn statements_are_read_as_they_are_written() {
        let lines = ["T0=A0-(A1-1.5)*A0^2;R1=-A1^2*A0/A1", "R0=1/T0;R2=sqrt(A0+sin(R0-R0)+cos(0))"];
        let program = Program::new(&lines, &[('A', 2)], 'R').expect("statements");
        assert_eq!(program.run(&[&[3.0], &[2.0]]), [-1.0 / 1.5, -6.0, 2.0]);
        assert_eq!([0, 1].map(|place| program.depends_on(place)), [true, true]);
        let first = program.first(1);
        assert_eq!((first.run(&[&[3.0], &[2.0]]), first.steps.len()), (vec![-1.0 / 1.5], 7));
    }

    #[test]
    fn what_cannot_be_read_is_none() {
        for lines in ["R0=A2", "R0", "R0=A0+", "R0=T0;T0=A0"] {
            assert!(Program::new(&[lines], &[('A', 2)], 'R').is_none(), "{lines}");
        }
    }
}
