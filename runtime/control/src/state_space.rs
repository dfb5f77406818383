//! The linearized motion with inputs and outputs.

use carvallo::{Complex, States, SystemError};
use carvallo_design::feedback::Input;
use carvallo_design::number::shortest;
use carvallo_design::{Design, DisplayUnit, Failure};
use nalgebra::{DMatrix, RowDVector};

use crate::ports::{Output, Ports};
use crate::rest::poles;
use crate::signal::{Order, Quantity, Signal};

/// The linearized motion about straight running at one speed, from inputs u to outputs y:
///
/// ```text
/// x' = A x + B u
/// y  = C x + D u
/// ```
///
/// The states x are the positions that are states, then the rates, in the order of the coordinates; behind them stand positions
/// that only outputs ask for, each the integral of its rate: the yaw and the lateral place of a bicycle, and the position of
/// a coordinate of which only the rate is a state. Everything is a small deviation from the steady motion, in SI units.
///
/// ```
/// use carvallo_control::{Ports, StateSpace};
/// use carvallo_design::input::{self, Request};
///
/// let bicycle = input::load(&Request::default())?;
/// let ports = Ports::of(&bicycle);
/// let (torque, lean) = (ports.input("Tdelta").unwrap(), ports.output("phi").unwrap());
/// let steered = StateSpace::new(&bicycle, 5.0, &[torque], &[lean])?;
/// assert_eq!((steered.a.shape(), steered.b.shape(), steered.c.shape()), ((4, 4), (4, 1), (1, 4)));
/// # Ok::<(), carvallo_design::Failure>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StateSpace {
    /// The state matrix A, one row for each state.
    pub a: DMatrix<f64>,
    /// The input matrix B, one column for each input.
    pub b: DMatrix<f64>,
    /// The output matrix C, one row for each output.
    pub c: DMatrix<f64>,
    /// The feedthrough D, one row for each output and one column for each input.
    pub d: DMatrix<f64>,
    /// What the states are.
    pub states: Vec<Signal>,
    /// What the inputs are.
    pub inputs: Vec<Signal>,
    /// What the outputs are.
    pub outputs: Vec<Signal>,
    /// The forward speed in m/s; nothing where the equations do not depend on it.
    pub speed: Option<f64>,
    /// What the speed is shown in.
    pub speed_unit: DisplayUnit,
}

impl StateSpace {
    /// Of a design at a forward speed in m/s, which matters only where its equations depend on it: with some of the
    /// [inputs](Ports::inputs), by their places, and any outputs.
    ///
    /// # Errors
    /// If there are no equations of motion at the speed, or if an output follows an input with the derivative of that, as the
    /// acceleration of a coordinate of first order may.
    pub fn new(design: &Design, speed: f64, inputs: &[usize], outputs: &[Output]) -> Result<Self, Failure> {
        let ports = Ports::of(design);
        let fail = |message: String| {
            let at =
                if design.model.depends_on_speed() { format!(" at {} m/s", shortest(speed)) } else { String::new() };
            Failure::Run(format!("{}{at}: {message}", design.title()))
        };
        let matrices = design.equations.state_space(speed, design.gravity().unwrap_or(0.0));
        let all = forces(design, &ports, inputs);
        let mut plant = Plant::new(&ports, matrices.map_err(|error| fail(error.to_string()))?, &all);
        plant.integrate_rates(&ports);
        plant.integrate_kinematics(design, speed);
        let rows = outputs.iter().map(|&output| {
            plant.row(output).ok_or_else(|| {
                let (output, coordinate) = (ports.signal(output).name, ports.quantities[output.quantity].name);
                fail(format!(
                    "`{output}` follows the inputs with their derivatives, since `{coordinate}` is of first order; it can be no \
                     output of a state space"
                ))
            })
        });
        let rows: Vec<Row> = rows.collect::<Result<_, _>>()?;
        let (c, d): (Vec<_>, Vec<_>) = rows.into_iter().map(|Row { c, d }| (c, d)).unzip();
        let states = plant.states;
        let space = Self {
            c: stacked(&c, plant.a.ncols()),
            d: stacked(&d, plant.b.ncols()),
            a: plant.a,
            b: plant.b,
            states,
            inputs: inputs.iter().map(|&input| ports.inputs[input].clone()).collect(),
            outputs: outputs.iter().map(|&output| ports.signal(output)).collect(),
            speed: design.model.depends_on_speed().then_some(speed),
            speed_unit: DisplayUnit::declared("m/s"),
        };
        if [&space.a, &space.b, &space.c, &space.d].into_iter().flatten().any(|entry| !entry.is_finite()) {
            return Err(fail("the state space leaves the range of floating-point numbers".to_owned()));
        }
        Ok(space.without_unused(ports.states().len()))
    }

    /// The eigenvalues of the state matrix in 1/s, sorted by real part, then by imaginary part; those at zero are exactly that.
    ///
    /// # Errors
    /// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
    pub fn poles(&self) -> Result<Vec<Complex<f64>>, SystemError> {
        poles(&self.a)
    }

    /// One input and one output of it, by their places.
    ///
    /// # Panics
    /// If there is no such input or output.
    pub fn channel(&self, input: usize, output: usize) -> Self {
        Self {
            a: self.a.clone(),
            b: self.b.columns(input, 1).into_owned(),
            c: self.c.rows(output, 1).into_owned(),
            d: self.d.view((output, input), (1, 1)).into_owned(),
            states: self.states.clone(),
            inputs: vec![self.inputs[input].clone()],
            outputs: vec![self.outputs[output].clone()],
            speed: self.speed,
            speed_unit: self.speed_unit.clone(),
        }
    }

    /// Without the integrals, which stand behind so many states, that no output needs. Each depends on those before it alone.
    fn without_unused(mut self, own: usize) -> Self {
        for state in (own..self.states.len()).rev() {
            let is_used = self.c.column(state).iter().chain(self.a.column(state).iter()).any(|entry| *entry != 0.0);
            if !is_used {
                self.states.remove(state);
                self.a = self.a.remove_row(state).remove_column(state);
                self.b = self.b.remove_row(state);
                self.c = self.c.remove_column(state);
            }
        }
        self
    }
}

/// The forces on the coordinates that each of some inputs makes, in its column.
fn forces(design: &Design, ports: &Ports, inputs: &[usize]) -> DMatrix<f64> {
    let coordinates = ports.states.len();
    let mut forces = DMatrix::zeros(coordinates, inputs.len());
    for (column, &input) in inputs.iter().enumerate() {
        match ports.forces[input] {
            Input::Coordinate(row) => forces[(row, column)] = 1.0,
            Input::Applied(force) => {
                let shares = design.model.shares(&design.values(), force).unwrap_or_default();
                shares.into_iter().enumerate().for_each(|(row, share)| forces[(row, column)] = share);
            }
        }
    }
    forces
}

/// How something depends on states and inputs.
#[derive(Clone, Debug)]
struct Row {
    c: RowDVector<f64>,
    d: RowDVector<f64>,
}

/// States and inputs, and where the position of each quantity is among the states.
struct Plant {
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    states: Vec<Signal>,
    /// Nothing before it is integrated.
    positions: Vec<Option<usize>>,
    rates: Vec<Option<usize>>,
}

impl Plant {
    /// From the rows of A and B, and the forces on all coordinates, a column for each input.
    fn new(ports: &Ports, [a, b]: [Vec<f64>; 2], forces: &DMatrix<f64>) -> Self {
        let states = ports.states();
        let place =
            |quantity: usize, order: Order| states.iter().position(|state| *state == Output { quantity, order });
        let coordinates = ports.states.len();
        let b = DMatrix::from_row_slice(states.len(), coordinates, &b);
        Self {
            a: DMatrix::from_row_slice(states.len(), states.len(), &a),
            b: b * forces,
            positions: (0..coordinates).map(|quantity| place(quantity, Order::Position)).collect(),
            rates: (0..coordinates).map(|quantity| place(quantity, Order::Rate)).collect(),
            states: states.iter().map(|&state| ports.signal(state)).collect(),
        }
    }

    /// Makes states of the positions of which only the rates are.
    fn integrate_rates(&mut self, ports: &Ports) {
        for (coordinate, states) in ports.states.iter().enumerate() {
            if *states == States::Rate {
                let row = self.state(self.rates[coordinate]);
                self.positions[coordinate] = Some(self.integrate(row, &ports.quantities[coordinate]));
            }
        }
    }

    /// Makes states of the yaw and the lateral place of a bicycle.
    fn integrate_kinematics(&mut self, design: &Design, speed: f64) {
        let Some(kinematics) = design.kinematics() else { return };
        let following = &Ports::of(design).quantities[self.positions.len()..];
        for (rate, quantity) in [kinematics.yaw, kinematics.lateral].iter().zip(following) {
            let mut row = Row { c: RowDVector::zeros(self.a.ncols()), d: RowDVector::zeros(self.b.ncols()) };
            for (coordinate, (of_rate, of_position)) in rate.rates.iter().zip(&rate.coordinates).enumerate() {
                for (order, factor) in [(Order::Rate, *of_rate), (Order::Position, speed * of_position)] {
                    if let Some(part) = self.row(Output { quantity: coordinate, order }).filter(|_| factor != 0.0) {
                        row.c += part.c * factor;
                        row.d += part.d * factor;
                    }
                }
            }
            // The yaw is the first of them.
            if let Some(yaw) = self.positions.get(rate.coordinates.len()).copied().flatten() {
                row.c[yaw] += speed * rate.heading;
            }
            let place = self.integrate(row, quantity);
            self.positions.push(Some(place));
            self.rates.push(None);
        }
    }

    /// Adds a state that grows as a row says; its place.
    fn integrate(&mut self, rate: Row, quantity: &Quantity) -> usize {
        let place = self.states.len();
        let grown = |matrix: &DMatrix<f64>, columns: usize| matrix.clone().resize(place + 1, columns, 0.0);
        (self.a, self.b) = (grown(&self.a, place + 1), grown(&self.b, self.b.ncols()));
        self.a.view_mut((place, 0), (1, place)).copy_from(&rate.c);
        self.b.row_mut(place).copy_from(&rate.d);
        self.states.push(quantity.signal(Order::Position));
        place
    }

    /// An output; `None` if it takes the derivative of an input.
    fn row(&self, Output { quantity, order }: Output) -> Option<Row> {
        match (order, self.rates[quantity]) {
            (Order::Position, _) => Some(self.state(self.positions[quantity])),
            (Order::Rate, rate @ Some(_)) => Some(self.state(rate)),
            (Order::Rate, None) => self.derivative(&self.state(self.positions[quantity])),
            (Order::Acceleration, _) => self.derivative(&self.row(Output { quantity, order: Order::Rate })?),
        }
    }

    /// A state itself.
    fn state(&self, place: Option<usize>) -> Row {
        let mut c = RowDVector::zeros(self.a.ncols());
        if let Some(place) = place {
            c[place] = 1.0;
        }
        Row { c, d: RowDVector::zeros(self.b.ncols()) }
    }

    fn derivative(&self, Row { c, d }: &Row) -> Option<Row> {
        // Adding zero turns -0 into 0.
        let with_positive_zeros = |row: RowDVector<f64>| row.add_scalar(0.0);
        let has_no_input = d.iter().all(|entry| *entry == 0.0);
        has_no_input.then(|| Row { c: with_positive_zeros(c * &self.a), d: with_positive_zeros(c * &self.b) })
    }
}

fn stacked(rows: &[RowDVector<f64>], columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns, |row, column| rows[row][column])
}
