//! What the generated Rust computes of motions.

use carvallo::Scalar;
use carvallo::motion::{Linearizable, MotionError, MotionInfo};
use carvallo_models::{DoublePendulum, RollingDisc, WheeledPendulum, WhippleLeaning, WhippleMechanism, WhippleTyres};

/// What there is to ask of a model.
#[derive(Clone, Copy)]
pub struct Motions {
    pub info: &'static MotionInfo,
    /// How many parameters the equations are differentiated by.
    pub parameters: usize,
}

/// Some states and what comes of them: for each function what it is, the code of its error, and its numbers if there is none.
pub struct Computed<T> {
    pub what: Motions,
    pub states: Vec<T>,
    pub results: Vec<(String, u32, Vec<T>)>,
}

/// How many states there are.
pub const STATES: usize = 4;

/// Those of a model with nonlinear equations.
pub fn motions<T: Scalar>(model: &str, values: &[T]) -> Option<Computed<T>> {
    macro_rules! of {
        ($model:ident) => {
            Some(compute(&$model::from_array(values.try_into().expect("as many values")).motion(), values.len()))
        };
    }
    match model {
        "DoublePendulum" => of!(DoublePendulum),
        "RollingDisc" => of!(RollingDisc),
        "WheeledPendulum" => of!(WheeledPendulum),
        "WhippleLeaning" => of!(WhippleLeaning),
        "WhippleMechanism" => of!(WhippleMechanism),
        "WhippleTyres" => of!(WhippleTyres),
        _ => None,
    }
}

fn compute<M: Linearizable>(motion: &M, parameters: usize) -> Computed<M::Scalar> {
    let mut computed =
        Computed { what: Motions { info: M::INFO, parameters }, states: Vec::new(), results: Vec::new() };
    for state in 0..STATES {
        add(motion, state, &mut computed);
    }
    computed
}

/// Upright, leaning and steered, lying flat, and one that cannot be.
fn add<M: Linearizable>(motion: &M, state: usize, computed: &mut Computed<M::Scalar>) {
    let scalar = <M::Scalar as Scalar>::from_f64;
    let size = [0.0, 0.3, 0.0, 0.2][state];
    let mut place = 0;
    let mut next = |size: f64| {
        place += 1;
        scalar(size * f64::from(place * place + 3).sin())
    };
    let mut positions = <M::Positions as carvallo::motion::Vector<M::Scalar>>::from_fn(|_| next(size));
    let mut speeds = <M::Speeds as carvallo::motion::Vector<M::Scalar>>::from_fn(|_| next(2.0));
    let forces = <M::Forces as carvallo::motion::Vector<M::Scalar>>::from_fn(|_| next(5.0));
    if state == 2 {
        positions.as_mut().iter_mut().for_each(|position| *position = scalar(std::f64::consts::FRAC_PI_2));
    }
    if state == 3 {
        speeds.as_mut()[0] = scalar(f64::INFINITY);
    }
    computed.states.extend(positions.as_ref().iter().chain(speeds.as_ref()).chain(forces.as_ref()));
    let mut add = |what: &str, result: Result<Vec<M::Scalar>, MotionError>| {
        let (code, numbers) = result.map_or_else(|error| (code(&error), Vec::new()), |numbers| (0, numbers));
        computed.results.push((format!("{what} of state {state}"), code, numbers));
    };
    if !M::INFO.dependent.is_empty() {
        let closed = motion.close(&positions);
        if let Ok(closed) = &closed {
            positions = *closed;
        }
        add("positions", closed.map(|positions| positions.as_ref().to_vec()));
    }
    add("rates", motion.rates(&positions, &speeds).map(|rates| rates.as_ref().to_vec()));
    let derivatives = motion.derivatives(&positions, &speeds, &forces);
    add("derivatives", derivatives.map(|(rates, speeds)| [rates.as_ref(), speeds.as_ref()].concat()));
    let accelerations = motion.accelerations(&positions, &speeds, &forces);
    add("accelerations", accelerations.map(|accelerations| accelerations.as_ref().to_vec()));
    let energy = motion.energy(&positions, &speeds);
    add("energy", energy.map(|energy| vec![energy.kinetic, energy.potential]));
    if !M::INFO.wheels.is_empty() {
        let contact_forces = motion.contact_forces(&positions, &speeds, &forces);
        add("contact forces", contact_forces.map(|contact_forces| contact_forces.as_ref().concat()));
    }
    let linearization = motion.linearize(&positions, &speeds, &forces);
    let [a, b] = [M::INFO.positions.len() + M::INFO.speeds.len(), M::INFO.forces.len()];
    add(
        "A and B",
        linearization.map(|found| {
            let mut entries = vec![scalar(0.0); (a + b) * a];
            let (of_a, of_b) = entries.split_at_mut(a * a);
            found.copy_into(of_a, of_b);
            entries
        }),
    );
    let by_parameters = motion.by_parameters(&positions, &speeds, &forces);
    add(
        "derivatives by parameters",
        by_parameters.map(|rows| rows.as_ref().iter().flat_map(|row| row.as_ref().iter().copied()).collect()),
    );
}

/// The codes of `carvallo_motion.h`.
fn code(error: &MotionError) -> u32 {
    match error {
        MotionError::NotFinite { .. } => 1,
        MotionError::NotClosed { .. } => 2,
        MotionError::Singular { .. } => 3,
        other => panic!("{other}"),
    }
}
