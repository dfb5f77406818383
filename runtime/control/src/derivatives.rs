//! How a state space changes with the parameters of its design.

use carvallo::{States, SystemError};
use carvallo_design::feedback::Input;
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure, Sensitive};
use nalgebra::DMatrix;

use crate::ports::{Output, Ports};
use crate::signal::Order;
use crate::state_space::StateSpace;

/// The derivatives of the matrices of a state space with respect to a parameter, exact to rounding; D is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct StateSpaceDerivative {
    /// Of A.
    pub a: DMatrix<f64>,
    /// Of B.
    pub b: DMatrix<f64>,
    /// Of C, whose outputs are positions and rates.
    pub c: DMatrix<f64>,
}

impl StateSpaceDerivative {
    /// Those of a [state space](StateSpace::new) of a design, with respect to each parameter in declared order.
    ///
    /// With M x'' the leading terms, `M [A, B] = R` has the derivative `M [A, B]' = R' - M' [A, B]`, and derivatives of M, C and K are
    /// those of the model.
    ///
    /// # Errors
    /// If the model was compiled without derivatives, or one is not finite.
    pub fn of_parameters(
        design: &Design,
        space: &StateSpace,
        inputs: &[usize],
        outputs: &[Output],
    ) -> Result<Vec<Self>, Failure> {
        let speed = space.speed.unwrap_or(0.0);
        let fail = |message: String| {
            let at = space.speed.map(|speed| format!(" at {} m/s", shortest(speed))).unwrap_or_default();
            Failure::Run(format!("{}{at}: {message}", design.title()))
        };
        let ports = Ports::of(design);
        if let Some(&input) = inputs.iter().find(|input| matches!(ports.forces[**input], Input::Applied(_))) {
            return Err(fail(format!(
                "there are no derivatives with the input `{}`, for how it moves the coordinates changes with parameters; expected forces \
                 on these",
                ports.inputs[input].name
            )));
        }
        let sensitivity = design.model.sensitivity(&design.values()).map_err(&fail)?;
        let plant = Plant::new(design, space, inputs, outputs).map_err(|error| fail(error.to_string()))?;
        let of = |parameter: usize| plant.derivative(&*sensitivity, parameter, speed);
        (0..design.parameters.len()).map(of).collect::<Result<_, _>>().map_err(|error| fail(error.to_string()))
    }
}

/// What the derivatives with respect to all parameters have in common.
struct Plant<'a> {
    design: &'a Design,
    space: &'a StateSpace,
    ports: Ports,
    inputs: &'a [usize],
    outputs: &'a [Output],
    /// The states without integrals.
    states: Vec<Output>,
    /// Of each coordinate the state whose derivative its equation gives.
    solved: Vec<usize>,
    /// The inverse of what multiplies the highest derivatives.
    inverse: DMatrix<f64>,
}

impl<'a> Plant<'a> {
    fn new(
        design: &'a Design,
        space: &'a StateSpace,
        inputs: &'a [usize],
        outputs: &'a [Output],
    ) -> Result<Self, SystemError> {
        let ports = Ports::of(design);
        let states = ports.states();
        let highest = |(quantity, states): (usize, &States)| Output {
            quantity,
            order: if *states == States::Position { Order::Position } else { Order::Rate },
        };
        let place = |output: Output| states.iter().position(|state| *state == output).unwrap_or(0);
        let solved: Vec<usize> = ports.states.iter().enumerate().map(|own| place(highest(own))).collect();
        // The forces of all coordinates drive what is solved for by it.
        let [_, b] = design.equations.state_space(space.speed.unwrap_or(0.0), design.gravity().unwrap_or(0.0))?;
        let inverse = DMatrix::from_row_slice(states.len(), solved.len(), &b).select_rows(&solved);
        Ok(Self { design, space, ports, inputs, outputs, states, solved, inverse })
    }

    fn derivative(
        &self,
        sensitivity: &dyn Sensitive,
        parameter: usize,
        speed: f64,
    ) -> Result<StateSpaceDerivative, SystemError> {
        let (count, own) = (self.solved.len(), self.states.len());
        let [m, c, k] = sensitivity.system(parameter, speed)?.map(|rows| DMatrix::from_row_slice(count, count, &rows));
        let leading = DMatrix::from_fn(count, count, |row, column| {
            if self.ports.states[column] == States::Position { c[(row, column)] } else { m[(row, column)] }
        });
        let right = DMatrix::from_fn(count, own, |row, state| match self.states[state] {
            Output { quantity, order: Order::Position } => -k[(row, quantity)],
            Output { quantity, .. } => -c[(row, quantity)],
        });
        let now = self.space.a.select_rows(&self.solved).columns(0, own).into_owned();
        let of_a = &self.inverse * (right - &leading * now);
        let of_b = -(&self.inverse * leading * &self.inverse).select_columns(self.inputs);
        let size = self.space.a.nrows();
        let (mut a, mut b) = (DMatrix::zeros(size, size), DMatrix::zeros(size, self.inputs.len()));
        for (row, state) in self.solved.iter().enumerate() {
            a.view_mut((*state, 0), (1, own)).copy_from(&of_a.row(row));
            b.set_row(*state, &of_b.row(row));
        }
        let yaw = self.yaw(parameter, speed);
        if let Some(place) = (own..size).find(|place| self.space.states[*place].name == "psi") {
            a.view_mut((place, 0), (1, own)).copy_from_slice(&yaw);
        }
        let mut of_c = DMatrix::zeros(self.outputs.len(), size);
        let rates = self.outputs.iter().enumerate().filter(|(_, output)| output.order == Order::Rate);
        for (row, &Output { quantity, .. }) in rates {
            match self.ports.states.get(quantity) {
                // What follows from the equations, and not from a state.
                Some(States::Position) => of_c.set_row(row, &a.row(self.solved[quantity])),
                None if self.ports.quantities[quantity].name == "psi" => {
                    of_c.view_mut((row, 0), (1, own)).copy_from_slice(&yaw);
                }
                _ => {}
            }
        }
        Ok(StateSpaceDerivative { a, b, c: of_c })
    }

    /// Whether the yaw follows from lean and steer.
    fn has_yaw(&self) -> bool {
        self.ports.quantities.len() > self.solved.len()
    }

    /// The derivative of the yaw rate of a bicycle, `(v delta + c delta') cos(lam) / w` (Meijaard et al. 2007, appendix B), with respect
    /// to a parameter, by state. The place y follows from the yaw alone.
    fn yaw(&self, parameter: usize, speed: f64) -> Vec<f64> {
        let mut row = vec![0.0; self.states.len()];
        let value = |name: &str| self.design.value(name);
        let (Some(w), Some(c), Some(lam), true) = (value("w"), value("c"), value("lam"), self.has_yaw()) else {
            return row;
        };
        let (sin, cos) = lam.sin_cos();
        let [of_steer, of_rate] = match self.design.info().parameters[parameter].name {
            "w" => [-speed * cos / (w * w), -c * cos / (w * w)],
            "c" => [0.0, cos / w],
            "lam" => [-speed * sin / w, -c * sin / w],
            _ => [0.0, 0.0],
        };
        for (state, entry) in self.states.iter().zip(&mut row) {
            match (self.ports.quantities[state.quantity].name, state.order) {
                ("delta", Order::Position) => *entry = of_steer,
                ("delta", Order::Rate) => *entry = of_rate,
                _ => {}
            }
        }
        row
    }
}
