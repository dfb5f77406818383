//! The linear equations of motion at one speed, solved exactly.

use core::ops::AddAssign as _;

use nalgebra::{DMatrix, DVector};

use super::error::{SimulationError, require_ascending, require_finite, require_length};
use super::exponential::Propagator;
use super::force::{Force, pieces};
use crate::model::Rate;
use crate::system::{StateSpace, States, System, SystemError};

/// The motion `M q'' + C q' + K q = f` of the linear equations at one speed, for any number of coordinates, by its exact
/// solution: the matrix exponential, in which forces that are linear in time are exact as well.
///
/// What is told of a motion is at times that are asked for; how far they lie apart changes nothing but rounding.
#[derive(Clone, Debug)]
pub struct LinearMotion {
    /// How many coordinates there are.
    coordinates: usize,
    /// The places of the rates among the states, of the coordinates whose rates are states.
    rates: Vec<Option<usize>>,
    /// How many quantities follow.
    following: usize,
    /// Of `x' = A x + B f + c`, with the positions, what follows, and the rates that are states, in x.
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DVector<f64>,
}

/// A motion at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The time in s.
    pub time: f64,
    /// The position of each coordinate, and behind them what follows.
    pub positions: Vec<f64>,
    /// The rate of each of them.
    pub rates: Vec<f64>,
    /// The second derivative of each of them; where a force jumps, that behind the jump.
    pub accelerations: Vec<f64>,
}

impl LinearMotion {
    /// The motion of a system.
    ///
    /// Of a coordinate of which only the [rate](States::Rate) is a state, the position is the integral of the rate. Of one of
    /// which only the [position](States::Position) is, the rate follows.
    ///
    /// # Errors
    /// If the system has no [state-space form](System::state_space).
    pub fn new<const N: usize>(system: &System<N>) -> Result<Self, SystemError> {
        let StateSpace { stiffness, damping, input, states } = system.state_space()?;
        Ok(Self::from_columns([stiffness.as_slice(), damping.as_slice(), input.as_slice()], &states))
    }

    /// From what is solved for, column by column. Not generic, so that it is compiled once.
    fn from_columns([stiffness, damping, input]: [&[f64]; 3], states: &[States]) -> Self {
        let count = states.len();
        let mut size = count;
        let rates: Vec<Option<usize>> = states
            .iter()
            .map(|states| {
                (*states != States::Position).then(|| {
                    size += 1;
                    size - 1
                })
            })
            .collect();
        let (mut a, mut b) = (DMatrix::zeros(size, size), DMatrix::zeros(size, count));
        for i in 0..count {
            // What is solved for is the rate of a coordinate of first order, the acceleration of any other.
            let row = rates[i].unwrap_or(i);
            if let Some(rate) = rates[i] {
                a[(i, rate)] = 1.0;
            }
            for j in 0..count {
                let place = i + count * j;
                a[(row, j)] = stiffness[place];
                b[(row, j)] = input[place];
                if let Some(rate) = rates[j] {
                    a[(row, rate)] = damping[place];
                }
            }
        }
        Self { coordinates: count, rates, following: 0, a, b, c: DVector::zeros(size) }
    }

    /// The same motion with what follows from it at a forward speed in m/s: the yaw, and other quantities by their rates,
    /// such as the place to the right and the angles of wheels. They stand behind the coordinates, in this order.
    ///
    /// The rates have the units of [`Rate`], and are those of the same N coordinates.
    #[must_use]
    pub fn followed_by<const N: usize>(self, speed: f64, yaw: &Rate<f64, N>, others: &[Rate<f64, N>]) -> Self {
        let (first, count) = (self.coordinates + self.following, 1 + others.len());
        let moved = |place: usize| if place < first { place } else { place + count };
        let size = self.a.nrows() + count;
        let mut a = DMatrix::zeros(size, size);
        let (mut b, mut c) = (DMatrix::zeros(size, self.b.ncols()), DVector::zeros(size));
        for i in 0..self.a.nrows() {
            (0..self.a.nrows()).for_each(|j| a[(moved(i), moved(j))] = self.a[(i, j)]);
            (0..self.b.ncols()).for_each(|j| b[(moved(i), j)] = self.b[(i, j)]);
            c[moved(i)] = self.c[i];
        }
        let rates: Vec<Option<usize>> = self.rates.iter().map(|place| place.map(moved)).collect();
        for (row, rate) in (first..).zip(core::iter::once(yaw).chain(others)) {
            c[row] = speed * rate.speed;
            a[(row, first)] = speed * rate.heading;
            for (j, place) in rates.iter().enumerate() {
                a[(row, j)] += speed * rate.coordinates[j];
                match place {
                    Some(place) => a[(row, *place)] += rate.rates[j],
                    // The rate of a coordinate of first order is what its own row says.
                    None => {
                        let (of_state, of_forces) = (a.row(j) * rate.rates[j], b.row(j) * rate.rates[j]);
                        a.row_mut(row).add_assign(of_state);
                        b.row_mut(row).add_assign(of_forces);
                    }
                }
            }
        }
        Self { coordinates: self.coordinates, rates, following: self.following + count, a, b, c }
    }

    /// The same motion with one force more behind the others, such as that of a motor on a wheel, by the generalized forces on the
    /// coordinates that a force of one makes.
    ///
    /// # Panics
    /// If there are more than coordinates.
    #[must_use]
    pub fn with_force(mut self, shares: &[f64]) -> Self {
        let column = self.b.columns(0, shares.len()) * DVector::from_column_slice(shares);
        let last = self.b.ncols();
        self.b = self.b.insert_column(last, 0.0);
        self.b.set_column(last, &column);
        self
    }

    /// The motion at times in s that ascend, of which the first is that of the initial state.
    ///
    /// `positions` are those of the coordinates and of what follows, `rates` those of the coordinates; rates of coordinates
    /// of first order follow, and are not looked at. There is one force for each coordinate, and
    /// one for each that came [with](Self::with_force) it.
    ///
    /// # Errors
    /// If there are too many or too few numbers, if one is not finite, if the times do not ascend, or if the motion leaves
    /// the range of `f64`.
    pub fn run(
        &self,
        positions: &[f64],
        rates: &[f64],
        forces: &[Force],
        times: &[f64],
    ) -> Result<Vec<Snapshot>, SimulationError> {
        let count = self.coordinates + self.following;
        require_length("initial positions", count, positions.len())?;
        require_length("initial rates", self.coordinates, rates.len())?;
        require_length("forces", self.b.ncols(), forces.len())?;
        require_finite("initial positions", positions)?;
        require_finite("initial rates", rates)?;
        require_ascending(times)?;
        let mut state = DVector::zeros(self.a.nrows());
        state.rows_mut(0, count).copy_from_slice(positions);
        self.rates.iter().zip(rates).for_each(|(place, rate)| {
            if let Some(place) = place {
                state[*place] = *rate;
            }
        });
        let start = times.first().copied().unwrap_or(0.0);
        // The time that was asked for, and the one that is reached: no time is known to less than its rounding, and steps
        // that differ by no more are one. As the clock counts what was taken, it never errs by more, either.
        let (mut reached, mut clock) = (start, start);
        let mut propagator: Option<Propagator> = None;
        let mut snapshots = Vec::with_capacity(times.len());
        for &time in times {
            let out_of_range = || SimulationError::OutOfRange { time };
            for end in pieces(forces, reached, time) {
                let (step, rounding) = (end - clock, 4.0 * f64::EPSILON * end.abs().max(start.abs()));
                if step > rounding {
                    let taken = match propagator.take() {
                        Some(last) if (last.step - step).abs() <= rounding => last,
                        _ => Propagator::new(&self.a, step).map_err(|error| error.at(time))?,
                    };
                    let first = self.driven(forces.iter().map(|force| force.at(reached)));
                    let growth = self.driven(forces.iter().map(|force| force.until(end))) - &first;
                    state = taken.advance(&state, &first, &growth);
                    clock += taken.step;
                    propagator = Some(taken);
                }
                reached = end;
            }
            let snapshot = self.snapshot(time, &state, forces);
            let all = [&snapshot.positions, &snapshot.rates, &snapshot.accelerations];
            if all.into_iter().flatten().any(|value| !value.is_finite()) {
                return Err(out_of_range());
            }
            snapshots.push(snapshot);
        }
        Ok(snapshots)
    }

    /// B f + c.
    fn driven(&self, forces: impl Iterator<Item = f64>) -> DVector<f64> {
        &self.b * DVector::from_iterator(self.b.ncols(), forces) + &self.c
    }

    fn snapshot(&self, time: f64, state: &DVector<f64>, forces: &[Force]) -> Snapshot {
        let lines = || forces.iter().map(|force| force.line_from(time));
        let derivative = &self.a * state + self.driven(lines().map(|line| line.0));
        let slopes = DVector::from_iterator(self.b.ncols(), lines().map(|line| line.1));
        let second = &self.a * &derivative + &self.b * slopes;
        let listed = |values: &DVector<f64>| values.as_slice()[..self.coordinates + self.following].to_vec();
        Snapshot { time, positions: listed(state), rates: listed(&derivative), accelerations: listed(&second) }
    }
}
