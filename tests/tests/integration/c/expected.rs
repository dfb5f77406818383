//! What the generated Rust computes of some designs, in the words that the program of C prints.

use carvallo::{Coefficients, Evaluator, Model, Rate, Scalar, StateSpace, States, SystemError};
use carvallo_models::{
    RollingDisc, WheeledPendulum, WheeledPendulumKinematics, WhippleMechanism, WhippleMechanismKinematics,
};

use super::motion::{Motions, motions};

/// One model: what the program reads and what it is to print.
pub struct Expected {
    pub model: &'static str,
    pub has_derivatives: bool,
    /// Whether rates and forces are among the words.
    pub has_kinematics: bool,
    /// What its motions are asked for, if it has nonlinear equations.
    pub motions: Option<Motions>,
    /// How many designs there are in each precision.
    pub designs: usize,
    /// How many more there are of which only the validity is asked for.
    pub checked: usize,
    pub input: String,
    /// Lines, each with what it is.
    pub words: Vec<(String, String)>,
}

/// A number of which the bits are printed.
pub trait Bits: Scalar {
    fn bits(self) -> String;
}

impl Bits for f64 {
    fn bits(self) -> String {
        format!("{:x}", self.to_bits())
    }
}

impl Bits for f32 {
    fn bits(self) -> String {
        format!("{:x}", self.to_bits())
    }
}

const SPEEDS: [f64; 3] = [5.3, -2.1, 0.0];

impl Expected {
    pub fn of<const N: usize, M: Model<N, Scalar = f64>>() -> Self {
        let designs = designs::<N, M>();
        let checked = checked::<N, M>();
        let mut expected = Self {
            model: M::INFO.name,
            has_derivatives: false,
            has_kinematics: false,
            motions: None,
            designs: designs.len(),
            checked: checked.len(),
            input: String::new(),
            words: Vec::new(),
        };
        for (values, speed) in &designs {
            expected.design_in_double::<N, M>(values, *speed);
        }
        for values in &checked {
            expected.check::<f64, N, M>(values);
        }
        for (values, speed) in &designs {
            expected.design_in_single::<N, M>(values, *speed);
        }
        for values in &checked {
            expected.check::<f32, N, M>(values);
        }
        expected
    }

    fn design_in_double<const N: usize, M: Model<N, Scalar = f64>>(&mut self, values: &[f64], speed: f64) {
        let model = M::from_slice(values).expect("as many values as parameters");
        let gravity = model.gravity().unwrap_or(9.81);
        self.read(&[values, &[speed, gravity]].concat());
        self.coefficients::<f64, N, M>(&model.coefficients(), speed, gravity);
        self.kinematics(values);
        self.motions(values);
        self.derivatives::<f64, N, M>(&model);
    }

    fn design_in_single<const N: usize, M: Model<N, Scalar = f64>>(&mut self, values: &[f64], speed: f64) {
        let values: Vec<f32> = values.iter().map(|value| *value as f32).collect();
        let model = M::Over::<f32>::from_parameters(|position| values[position]);
        let gravity = M::INFO.gravity.map_or(9.81, |position| values[position]);
        self.read(&[&values[..], &[speed as f32, gravity]].concat());
        let states = M::INFO.coordinates.iter().map(|coordinate| coordinate.states);
        let states: Vec<States> = states.collect();
        let states = std::array::from_fn(|coordinate| states[coordinate]);
        let coefficients = Coefficients { states, ..Coefficients::from_rows(model.rows()) };
        self.coefficients::<f32, N, M>(&coefficients, speed as f32, gravity);
        self.kinematics(&values);
        self.motions(&values);
        if self.has_derivatives {
            self.derivatives_in_single(&values);
        }
    }

    fn derivatives<T: Bits, const N: usize, M: Model<N, Scalar = T>>(&mut self, model: &M) {
        if let Some((_, derivatives)) = model.derivatives() {
            self.has_derivatives = true;
            for (coefficients, parameter) in derivatives.as_ref().iter().zip(M::INFO.parameters) {
                self.matrices::<T, N, M>(&format!("derivative by {}", parameter.name), coefficients);
            }
        }
    }

    /// By the name of the model: what is generic over models knows them as models in double precision alone.
    fn derivatives_in_single(&mut self, values: &[f32]) {
        macro_rules! of {
            ($($model:ident)*) => {
                match self.model {
                    $(stringify!($model) => {
                        self.derivatives(&carvallo_models::$model::from_array(values.try_into().expect("as many values")));
                    })*
                    other => panic!("{other} has derivatives, and is to be in this list"),
                }
            };
        }
        of!(BalanceAssist CantileveredPipe Car CarTrailer DoublePendulum FlywheelBicycle JeffcottRotor Motorcycle Pendulum
            RearSteered RollingDisc Skateboard ThreePipes TowedWheel TwoPipes TypicalSection WheeledPendulum Wheelset Whipple
            WhippleLeaning WhippleMechanism WhippleSprung WhippleTyres);
    }

    /// What is wrong with a design in the numbers T, of which no requirement is so near to a bound that its rounding decides.
    fn check<T: Bits, const N: usize, M: Model<N, Scalar = f64>>(&mut self, values: &[f64]) {
        let values: Vec<T> = values.iter().map(|value| T::from_f64(*value)).collect();
        let wide: Vec<f64> = values.iter().map(|value| value.to_f64()).collect();
        self.read(&values);
        self.words.push((format!("validity of {wide:?}"), validity::<N, M>(&M::from_slice(&wide).expect("as many"))));
    }

    fn read<T: Bits>(&mut self, values: &[T]) {
        let words: Vec<String> = values.iter().map(|value| value.bits()).collect();
        self.input.push_str(&format!("{}\n", words.join(" ")));
    }

    fn coefficients<T: Bits, const N: usize, M: Model<N>>(
        &mut self,
        coefficients: &Coefficients<T, N>,
        speed: T,
        gravity: T,
    ) {
        self.matrices::<T, N, M>("matrix", coefficients);
        let system = coefficients.at(speed, gravity);
        self.words.push(("at a speed".into(), code(system.as_ref().err()).to_string()));
        if let Ok(system) = system {
            let space = system.state_space();
            self.words.push(("state space".into(), code(space.as_ref().err()).to_string()));
            let [a, b] = space.map_or_else(|_| zeros::<T, N>(), |space| full(&space));
            self.numbers("A", &a);
            self.numbers("B", &b);
        }
    }

    fn kinematics<T: Bits>(&mut self, values: &[T]) {
        if let Some(numbers) = kinematics(self.model, values) {
            self.has_kinematics = true;
            self.numbers("kinematics", &numbers);
        }
    }

    /// Motions from some states, each of which is read beside the design.
    fn motions<T: Bits>(&mut self, values: &[T]) {
        let Some(motions) = motions(self.model, values) else { return };
        self.read(&motions.states);
        for (what, code, numbers) in &motions.results {
            self.words.push((what.clone(), code.to_string()));
            self.numbers(what, numbers);
        }
        self.motions = Some(motions.what);
    }

    fn matrices<T: Bits, const N: usize, M: Model<N>>(&mut self, what: &str, coefficients: &Coefficients<T, N>) {
        for name in M::INFO.matrices {
            let matrix = coefficients.matrix(*name);
            let entries: Vec<T> = (0..N * N).map(|place| matrix[(place / N, place % N)]).collect();
            self.numbers(&format!("{what} {name}"), &entries);
        }
    }

    /// With one zero for both.
    fn numbers<T: Bits>(&mut self, what: &str, values: &[T]) {
        let words = values.iter().enumerate();
        let words = words.map(|(place, value)| (format!("{what}, {place}"), (*value + T::from_f64(0.0)).bits()));
        self.words.extend(words);
    }
}

/// The rates and forces of some models, in the order of their members.
fn kinematics<T: Scalar>(model: &str, values: &[T]) -> Option<Vec<T>> {
    fn flat<T: Scalar, const N: usize>(rates: &[Rate<T, N>]) -> Vec<T> {
        let rates = rates.iter().flat_map(|rate| {
            let parts = [&[rate.speed][..], &rate.rates, &rate.coordinates, &[rate.heading]];
            parts.concat()
        });
        rates.collect()
    }
    macro_rules! of {
        ($model:ident, [$($rate:ident),*], $forces:expr) => {{
            let kinematics = $model::from_array(values.try_into().expect("as many values")).kinematics();
            let forces: fn(&_) -> Vec<T> = $forces;
            Some([flat(&[$(kinematics.$rate),*]), forces(&kinematics)].concat())
        }};
    }
    match model {
        "RollingDisc" => of!(RollingDisc, [lateral, wheel_D], |_| Vec::new()),
        "WhippleMechanism" => {
            of!(WhippleMechanism, [lateral, yaw, wheel_R, wheel_F], |k: &WhippleMechanismKinematics<T>| k
                .forces
                .concat())
        }
        "WheeledPendulum" => {
            of!(WheeledPendulum, [lateral, lean, wheel_L, wheel_R], |k: &WheeledPendulumKinematics<T>| k
                .forces
                .concat())
        }
        _ => None,
    }
}

/// The sets of a model and others near them, at several speeds.
fn designs<const N: usize, M: Model<N, Scalar = f64>>() -> Vec<(Vec<f64>, f64)> {
    let mut designs = Vec::new();
    for (number, set) in M::INFO.sets.iter().enumerate() {
        for (step, speed) in SPEEDS.into_iter().enumerate() {
            let factor = |place: usize| 1.0 + 0.03 * ((place * 7 + step * 5 + number) as f64).sin() * step as f64;
            designs.push((set.values.iter().enumerate().map(|(place, value)| value * factor(place)).collect(), speed));
        }
    }
    designs
}

/// Each set, and then each parameter of the first with values that it may not have.
fn checked<const N: usize, M: Model<N, Scalar = f64>>() -> Vec<Vec<f64>> {
    let mut designs: Vec<Vec<f64>> = M::INFO.sets.iter().map(|set| set.values.to_vec()).collect();
    for place in 0..M::INFO.parameters.len() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1e10, -0.1, -0.0, 0.0, 1e-10, 1e10] {
            let mut values = designs[0].clone();
            values[place] = value;
            designs.push(values);
        }
    }
    designs
}

/// What C says of the first thing that is wrong: what Rust says, without the value.
fn validity<const N: usize, M: Model<N, Scalar = f64>>(model: &M) -> String {
    let name = M::INFO.name;
    let Err(error) = model.validate() else { return format!("{name}: the parameters are valid") };
    let unit = if matches!(error.unit, "" | "1") { String::new() } else { format!(" in {}", error.unit) };
    let required = match error.required.to_string() {
        any if any == "any finite value" || any == "finite" => "finite".to_string(),
        other => format!("finite and {other}"),
    };
    format!("{name}: {}{unit} must be {required}", error.subject)
}

/// The codes of `carvallo_system.h`.
fn code(error: Option<&SystemError>) -> u32 {
    match error {
        None => 0,
        Some(SystemError::NotFinite { .. }) => 1,
        Some(SystemError::AtRest) => 2,
        Some(SystemError::OutOfRange { .. }) => 3,
        Some(SystemError::SingularMass) => 4,
        Some(other) => panic!("{other}"),
    }
}

fn zeros<T: Scalar, const N: usize>() -> [Vec<T>; 2] {
    [4, 2].map(|blocks| vec![T::from_f64(0.0); blocks * N * N])
}

/// A and B by the definition of their blocks: the state is (q, q'), and what is no state has a row of zeros.
fn full<T: Scalar, const N: usize>(space: &StateSpace<N, T>) -> [Vec<T>; 2] {
    let [mut a, mut b] = zeros::<T, N>();
    for row in 0..N {
        let target = match space.states[row] {
            States::Position => row,
            States::Both | States::Rate => N + row,
        };
        for column in 0..N {
            a[target * 2 * N + column] = space.stiffness[(row, column)];
            a[target * 2 * N + N + column] = space.damping[(row, column)];
            b[target * N + column] = space.input[(row, column)];
        }
        if space.states[row] == States::Both {
            a[row * 2 * N + N + row] = T::from_f64(1.0);
        }
    }
    [a, b]
}
