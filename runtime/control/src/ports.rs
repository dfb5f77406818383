//! The inputs and outputs that a design has, by their names.

use carvallo::{ModelInfo, States};
use carvallo_design::feedback::Input;
use carvallo_design::{Design, is_called, nearest};

use crate::signal::{Order, Quantity, Signal};

/// What may be an input or an output of the linearized motion of a design.
///
/// Inputs are the generalized forces of its coordinates, as `Tdelta`; a coordinate or its label names its own as well. Behind them stand
/// forces of the mechanism that act on no coordinate, as the motor `TL` on a wheel, which are inputs only where they are named.
/// Outputs are the coordinates, their rates and accelerations: `phi`, `phi_rate` or `phi'`, `phi_acceleration` or `phi''`, and
/// with labels `lean_rate`. For models whose parameters are those of the shipped bicycles there are the yaw `psi` and the place
/// `y` to the right of the line of the steady motion, at which the rear wheel touches the ground.
#[derive(Clone, Debug)]
pub struct Ports {
    /// One for each coordinate, in their order, and behind them those of forces that act on none.
    pub inputs: Vec<Signal>,
    /// What they act on.
    pub(crate) forces: Vec<Input>,
    info: &'static ModelInfo,
    /// The coordinates, and behind them what follows from them.
    pub quantities: Vec<Quantity>,
    /// Which of the position and the rate of each coordinate are states.
    pub(crate) states: Vec<States>,
}

/// An output: a derivative of one of the [quantities](Ports::quantities).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output {
    /// The place of the quantity.
    pub quantity: usize,
    /// Which derivative.
    pub order: Order,
}

/// What follows from the coordinates of a bicycle, in this order.
const FOLLOWING: [Quantity; 2] =
    [Quantity { name: "psi", label: "yaw", unit: "rad" }, Quantity { name: "y", label: "lateral place", unit: "m" }];

impl Ports {
    /// Those of a design.
    pub fn of(design: &Design) -> Self {
        let info = design.info();
        let following = FOLLOWING.iter().filter(|_| design.kinematics().is_some());
        let quantities: Vec<Quantity> = info.coordinates.iter().map(Quantity::from).chain(following.copied()).collect();
        let forces = Input::all(info);
        let signal = |force: &Input| match force {
            Input::Coordinate(place) => quantities[*place].force(),
            Input::Applied(place) => Signal::from(&info.forces[*place]),
        };
        Self {
            inputs: forces.iter().map(signal).collect(),
            forces,
            info,
            quantities,
            states: info.coordinates.iter().map(|coordinate| coordinate.states).collect(),
        }
    }

    /// The inputs that are the forces of the coordinates.
    pub fn all_inputs(&self) -> Vec<usize> {
        (0..self.states.len()).collect()
    }

    /// The outputs that are the states: positions, then rates.
    pub fn states(&self) -> Vec<Output> {
        let of = |order: Order, without: States| {
            let states = self.states.iter().enumerate().filter(move |(_, states)| **states != without);
            states.map(move |(quantity, _)| Output { quantity, order })
        };
        of(Order::Position, States::Rate).chain(of(Order::Rate, States::Position)).collect()
    }

    /// The outputs that are the coordinates: their positions, or where only the rate is a state, that.
    pub fn coordinates(&self) -> Vec<Output> {
        let order = |states: &States| if *states == States::Rate { Order::Rate } else { Order::Position };
        let outputs = self.states.iter().enumerate();
        outputs.map(|(quantity, states)| Output { quantity, order: order(states) }).collect()
    }

    /// The place of an input by its name, in letters of either case.
    ///
    /// # Errors
    /// If there is none of that name: those that there are.
    pub fn input(&self, name: &str) -> Result<usize, String> {
        let name = name.trim();
        let found = self.inputs.iter().position(|signal| signal.name == name).or_else(|| {
            let mut inputs = self.inputs.iter().zip(&self.forces);
            inputs.position(|(input, force)| {
                is_called(&input.name, &input.label, name)
                    || force.names(self.info).iter().any(|own| is_called(own, own, name))
            })
        });
        found.ok_or_else(|| self.unknown(name, "input", self.inputs.iter().map(|input| input.name.clone()).collect()))
    }

    /// An output by its name, in letters of either case.
    ///
    /// # Errors
    /// If there is none of that name: those that there are.
    pub fn output(&self, name: &str) -> Result<Output, String> {
        let name = name.trim();
        let exact = |order: Order| {
            let stem = name.strip_suffix(order.suffix())?;
            let quantity = self.quantities.iter().position(|quantity| quantity.name == stem)?;
            Some(Output { quantity, order })
        };
        let by_any_name = |&(suffix, order): &(&str, Order)| {
            let stem = name.strip_suffix(suffix)?.trim_end();
            let of = |quantity: &Quantity| {
                is_called(quantity.name, quantity.label, stem) || quantity.name.eq_ignore_ascii_case(stem)
            };
            Some(Output { quantity: self.quantities.iter().position(of)?, order })
        };
        let found = Order::ALL.into_iter().find_map(exact).or_else(|| SUFFIXES.iter().find_map(by_any_name));
        found.ok_or_else(|| {
            let of_order = |order: Order| self.quantities.iter().map(move |quantity| quantity.signal(order).name);
            self.unknown(name, "output", Order::ALL.into_iter().flat_map(of_order).collect())
        })
    }

    /// What an output is called, and its unit.
    pub fn signal(&self, output: Output) -> Signal {
        self.quantities[output.quantity].signal(output.order)
    }

    fn unknown(&self, name: &str, what: &str, names: Vec<String>) -> String {
        if name.is_empty() {
            return format!("there is no name; expected an {what} such as {}\nthey are {}", names[0], names.join(", "));
        }
        let hint = nearest(name, names.iter().map(String::as_str));
        let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        format!("`{name}` is no {what} of {}{hint}\nthey are {}", self.info.name, names.join(", "))
    }
}

/// What may stand behind the name of a quantity, the longer before what they end with.
const SUFFIXES: [(&str, Order); 10] = [
    ("''", Order::Acceleration),
    ("'", Order::Rate),
    ("_acceleration", Order::Acceleration),
    (" acceleration", Order::Acceleration),
    ("_ddot", Order::Acceleration),
    ("_rate", Order::Rate),
    (" rate", Order::Rate),
    ("_dot", Order::Rate),
    ("dot", Order::Rate),
    ("", Order::Position),
];
