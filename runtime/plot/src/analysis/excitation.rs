//! What a response is to, as it is written.

use carvallo_control::{Order, Ports, ShownIn, Signal, StateSpace};
use carvallo_design::quantity::{self, Context, Mistake, Reason, no_names};
use carvallo_design::{Design, Failure, Place, Problem, nearest, number};

use crate::analysis::simulation::{Quantity, doubt, value};

/// What a response is to.
#[derive(Clone, Debug, PartialEq)]
pub enum Excitation {
    /// An input, by its place, that is so large from time zero on.
    Step {
        /// Its place.
        input: usize,
        /// In the unit of the input.
        size: f64,
    },
    /// An impulse of an input, by its place.
    Impulse {
        /// Its place.
        input: usize,
        /// In the unit of the input times s.
        size: f64,
    },
    /// A state at time zero, in the units and the order of the states.
    Initial(Vec<f64>),
}

impl Excitation {
    /// A step of the one input of a state space, of a size such as `2 N m`, in its unit where none is written.
    ///
    /// # Errors
    /// If there are several inputs, or if the size is no number in such a unit.
    pub fn step(size: &str, space: &StateSpace) -> Result<Self, Failure> {
        sized("--step", size, space).map(|(input, size)| Self::Step { input, size })
    }

    /// An impulse of the one input of a state space, by its integral over time.
    ///
    /// # Errors
    /// As for [`step`](Self::step).
    pub fn impulse(size: &str, space: &StateSpace) -> Result<Self, Failure> {
        sized("--impulse", size, space).map(|(input, size)| Self::Impulse { input, size })
    }

    /// The same in the units that the inputs and states of a state space are [shown](StateSpace::in_units) in.
    #[must_use]
    pub fn in_units(self, space: &StateSpace, shown: &ShownIn) -> Self {
        let sized = |input: usize, size: f64| shown(&space.inputs[input].unit).value(size);
        match self {
            Self::Step { input, size } => Self::Step { input, size: sized(input, size) },
            Self::Impulse { input, size } => Self::Impulse { input, size: sized(input, size) },
            Self::Initial(state) => Self::Initial(space.state_in_units(&state, shown)),
        }
    }

    /// A state at time zero, of which some are given as `phi_rate=0.5` and the others are zero.
    ///
    /// # Errors
    /// Everything that is wrong with what is given.
    pub fn initial(given: &[String], design: &Design, space: &StateSpace) -> Result<Self, Failure> {
        let ports = Ports::of(design);
        let mut state = vec![None; space.states.len()];
        let mut problems = Vec::new();
        for option in given {
            if let Err(message) = add(option, &ports, space, &mut state) {
                problems.push(Problem { place: Place::Option(format!("--initial {option}")), message });
            }
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        Ok(Self::Initial(state.into_iter().map(|value| value.unwrap_or(0.0)).collect()))
    }

    /// What of a state that is given is probably in another unit than was meant.
    pub fn doubts(given: &[String], design: &Design) -> Vec<String> {
        let ports = Ports::of(design);
        let doubtful = |option: &String| {
            let (name, text) = option.split_once('=')?;
            let output = ports.output(name).ok().filter(|output| output.order == Order::Position)?;
            let carvallo_control::Quantity { name, label, unit } = ports.quantities[output.quantity];
            doubt(text, &Quantity::new(name, label, unit))
        };
        given.iter().filter_map(doubtful).collect()
    }
}

/// The one input, and the size in its unit; of an impulse, that times s.
fn sized(option: &str, text: &str, space: &StateSpace) -> Result<(usize, f64), Failure> {
    let [input] = &space.inputs[..] else {
        let names: Vec<&str> = space.inputs.iter().map(|input| input.name.as_str()).collect();
        let place = Place::Option(option.to_owned());
        return Err(Failure::at(place, format!("of which input? Name one by --input: {}", names.join(", "))));
    };
    let unit = match (option, input.unit.as_str()) {
        ("--impulse", "1") => "s".to_owned(),
        ("--impulse", unit) => format!("{unit}*s"),
        (_, unit) => unit.to_owned(),
    };
    let fail = |message| Failure::at(Place::Option(format!("{option}={text}")), message);
    read(text, &unit).map(|size| (0, size)).map_err(fail)
}

/// A number in a unit.
fn read(text: &str, unit: &str) -> Result<f64, String> {
    quantity::number(text, Context { unit, names: &no_names }).map_err(|Mistake { reason, .. }| match reason {
        Reason::Unit(found) => format!("`{text}`: `{found}` is no unit for it; it is in {}", number::unit(unit)),
        Reason::Other(reason) => format!("`{text}` must be a finite number: {reason}"),
    })
}

/// Reads one of them.
fn add(option: &str, ports: &Ports, space: &StateSpace, state: &mut [Option<f64>]) -> Result<(), String> {
    let (name, text) = option.split_once('=').ok_or("expected NAME=VALUE, such as phi=0.1 or phi_rate=0.5")?;
    let named = ports.output(name).map(|output| (output, ports.signal(output)));
    let is_state = |signal: &Signal| space.states.iter().position(|state| state.name == signal.name);
    let found = named.ok().and_then(|(output, signal)| Some((output, is_state(&signal)?)));
    let Some((output, place)) = found else {
        let names: Vec<&str> = space.states.iter().map(|state| state.name.as_str()).collect();
        let hint = nearest(name.trim(), names.iter().copied());
        let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        return Err(format!("`{}` is no state{hint}\nthey are {}", name.trim(), names.join(", ")));
    };
    let quantity = ports.quantities[output.quantity];
    let quantity = Quantity::new(quantity.name, quantity.label, quantity.unit);
    let value = value(text, &quantity, output.order == Order::Rate)?;
    if state[place].replace(value).is_some() {
        return Err("it is given twice".to_owned());
    }
    Ok(())
}
