//! The programs of a compiled mechanism, run by the interpreter.

use std::cell::OnceCell;

use carvallo_compiler::Compiled;
use carvallo_compiler::nonlinear::{self, Layout, MotionPrograms};
use carvallo_compiler::program::{Instruction, Program};

/// A number, and its derivative with respect to something.
#[derive(Clone, Copy)]
pub struct Dual(pub f64, pub f64);

/// Runs a program with derivatives.
pub fn differentiate(program: &Program, inputs: &[Dual]) -> Vec<Dual> {
    let mut values: Vec<Dual> = Vec::new();
    for instruction in &program.instructions {
        let at = |value: usize| values[value];
        let value = match *instruction {
            Instruction::Parameter(index) => inputs[index],
            Instruction::Constant(value) => Dual(value, 0.0),
            Instruction::Add(a, b) => Dual(at(a).0 + at(b).0, at(a).1 + at(b).1),
            Instruction::Sub(a, b) => Dual(at(a).0 - at(b).0, at(a).1 - at(b).1),
            Instruction::Mul(a, b) => Dual(at(a).0 * at(b).0, at(a).1 * at(b).0 + at(a).0 * at(b).1),
            Instruction::Div(a, b) => {
                let quotient = at(a).0 / at(b).0;
                Dual(quotient, (at(a).1 - quotient * at(b).1) / at(b).0)
            }
            Instruction::Neg(a) => Dual(-at(a).0, -at(a).1),
            Instruction::Square(a) => Dual(at(a).0 * at(a).0, 2.0 * at(a).0 * at(a).1),
            Instruction::Reciprocal(a) => Dual(at(a).0.recip(), -at(a).1 / (at(a).0 * at(a).0)),
            Instruction::Sqrt(a) => Dual(at(a).0.sqrt(), at(a).1 / (2.0 * at(a).0.sqrt())),
            Instruction::Sin(a) => Dual(at(a).0.sin(), at(a).0.cos() * at(a).1),
            Instruction::Cos(a) => Dual(at(a).0.cos(), -at(a).0.sin() * at(a).1),
            Instruction::Tan(a) => Dual(at(a).0.tan(), at(a).1 / (at(a).0.cos() * at(a).0.cos())),
            Instruction::Power(..) => unreachable!("a pass expands them"),
        };
        values.push(value);
    }
    program.outputs.iter().map(|output| values[*output]).collect()
}

/// A mechanism with values of its parameters.
pub struct Interpreted<'a> {
    compiled: &'a Compiled,
    values: Vec<f64>,
    constants: Vec<f64>,
    /// With those of derivatives, which not every model asks for.
    with_partials: OnceCell<MotionPrograms>,
}

/// What derivatives are with respect to, by its place.
#[derive(Clone, Copy)]
pub enum Input {
    Parameter(usize),
    /// Among all positions, speeds and forces.
    State(usize),
}

impl<'a> Interpreted<'a> {
    pub fn new(compiled: &'a Compiled, values: &[f64]) -> Self {
        let programs = compiled.programs.motion.as_ref().expect("nonlinear equations");
        Self {
            compiled,
            values: values.to_vec(),
            constants: programs.constants.interpret(values),
            with_partials: OnceCell::new(),
        }
    }

    fn programs(&self) -> &MotionPrograms {
        self.compiled.programs.motion.as_ref().expect("nonlinear equations")
    }

    pub fn layout(&self) -> &Layout {
        &self.compiled.model.motion.as_ref().expect("nonlinear equations").layout
    }

    /// How many speeds there are.
    pub fn speeds(&self) -> usize {
        self.layout().conditions.independent.len()
    }

    /// By positions, what is given by joints.
    pub fn positions(&self, by_joint: &[(usize, f64)]) -> Vec<f64> {
        let value = |joint: &usize| by_joint.iter().find(|(known, _)| known == joint).map_or(0.0, |(_, value)| *value);
        self.layout().positions.iter().map(value).collect()
    }

    fn run(&self, program: &Program, state: [&[f64]; 3]) -> Vec<f64> {
        let inputs: Vec<f64> = self.constants.iter().chain(state.into_iter().flatten()).copied().collect();
        program.interpret(&inputs)
    }

    fn unforced(&self, program: &Program, positions: &[f64], speeds: &[f64]) -> Vec<f64> {
        let forces = self.compiled.model.kinematics.as_ref().map_or(0, |kinematics| kinematics.applied.len());
        self.run(program, [positions, speeds, &vec![0.0; forces]])
    }

    /// Newton's method with whole steps.
    pub fn close(&self, mut positions: Vec<f64>) -> Vec<f64> {
        let places: Vec<usize> = self.layout().standing.iter().map(|joint| self.place(*joint)).collect();
        for _ in 0..30 {
            let closure = self.unforced(&self.programs().closure, &positions, &vec![0.0; self.speeds()]);
            let steps = &closure[closure.len() / 2..];
            places.iter().zip(steps).for_each(|(place, step)| positions[*place] += step);
        }
        positions
    }

    fn place(&self, joint: usize) -> usize {
        self.layout().positions.iter().position(|position| *position == joint).expect("a position")
    }

    /// The rates of all positions.
    pub fn rates(&self, positions: &[f64], speeds: &[f64]) -> Vec<f64> {
        self.unforced(&self.programs().rates, positions, speeds)
    }

    /// The second derivatives of all positions.
    pub fn accelerations(&self, positions: &[f64], speeds: &[f64]) -> Vec<f64> {
        self.unforced(&self.programs().accelerations, positions, speeds)
    }

    /// The rates of the speeds.
    pub fn speed_rates(&self, positions: &[f64], speeds: &[f64]) -> Vec<f64> {
        self.unforced(&self.programs().derivatives, positions, speeds).split_off(positions.len())
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, positions: &[f64], speeds: &[f64]) -> [f64; 2] {
        let energy = self.unforced(&self.programs().energy, positions, speeds);
        [energy[0], energy[1]]
    }

    /// The derivatives in time of the rates of all positions.
    pub fn rates_in_time(&self, positions: &[f64], speeds: &[f64]) -> Vec<f64> {
        let rates = self.rates(positions, speeds);
        let speed_rates = self.speed_rates(positions, speeds);
        let state = positions.iter().chain(speeds).zip(rates.iter().chain(&speed_rates));
        let state = state.map(|(value, rate)| Dual(*value, *rate));
        let forces = self.compiled.model.kinematics.as_ref().map_or(0, |kinematics| kinematics.applied.len());
        let inputs: Vec<Dual> = self
            .constants
            .iter()
            .map(|value| Dual(*value, 0.0))
            .chain(state)
            .chain((0..forces).map(|_| Dual(0.0, 0.0)))
            .collect();
        differentiate(&self.programs().rates, &inputs).iter().map(|rate| rate.1).collect()
    }

    /// How fast the potential energy changes.
    pub fn potential_rate(&self, positions: &[f64], speeds: &[f64]) -> f64 {
        let rates = self.rates(positions, speeds);
        let state = positions.iter().zip(&rates).map(|(value, rate)| Dual(*value, *rate));
        let inputs = self.constants.iter().map(|value| Dual(*value, 0.0)).chain(state);
        let inputs: Vec<Dual> = inputs.chain(speeds.iter().map(|speed| Dual(*speed, 0.0))).collect();
        differentiate(&self.programs().energy, &inputs)[1].1
    }

    /// The forces of the ground on all wheels together.
    pub fn contact_force(&self, positions: &[f64], speeds: &[f64]) -> [f64; 3] {
        let forces = self.unforced(&self.programs().contact_forces, positions, speeds);
        forces.chunks(3).fold([0.0; 3], |sum, force| [0, 1, 2].map(|axis| sum[axis] + force[axis]))
    }

    /// The derivatives of the rates of all positions, and then of those of the speeds, in a state with forces, by numbers that
    /// carry them through the programs of the equations: where dependent positions follow by a step of Newton's method.
    pub fn differentiate(&self, state: &[f64], input: Input) -> Vec<f64> {
        let programs = self.programs();
        let mut parameters: Vec<Dual> = self.values.iter().map(|value| Dual(*value, 0.0)).collect();
        let mut state: Vec<Dual> = state.iter().map(|value| Dual(*value, 0.0)).collect();
        match input {
            Input::Parameter(index) => parameters[index].1 = 1.0,
            Input::State(index) => state[index].1 = 1.0,
        }
        let constants = differentiate(&programs.constants, &parameters);
        let run = |program: &Program, state: &[Dual]| differentiate(program, &[constants.as_slice(), state].concat());
        let closure = run(&programs.closure, &state);
        for (joint, step) in self.layout().standing.iter().zip(&closure[self.layout().standing.len()..]) {
            assert!(step.0.abs() < 1e-12, "the wheels touch the ground");
            state[self.place(*joint)].1 = step.1;
        }
        run(&programs.derivatives, &state).iter().map(|rate| rate.1).collect()
    }

    /// The same derivatives by the programs that were compiled for them: a row for each rate, with respect to the state and to
    /// the parameters.
    pub fn partials(&self, state: &[f64]) -> [Vec<Vec<f64>>; 2] {
        let described = self.compiled.model.motion.as_ref().expect("nonlinear equations");
        let programs =
            self.with_partials.get_or_init(|| nonlinear::compile(&described.machine, &described.layout, true));
        let partials = programs.partials.as_ref().expect("what is asked for");
        let inputs = [programs.constants.interpret(&self.values), state.to_vec()].concat();
        [(&partials.by_state, state.len()), (&partials.by_parameters, self.values.len())]
            .map(|(program, columns)| program.interpret(&inputs).chunks(columns).map(<[f64]>::to_vec).collect())
    }
}
