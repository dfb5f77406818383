//! A curve of turns, followed from straight running by predictor and corrector.

use nalgebra::{DMatrix, DVector};

use super::balance::{At, Balance};
use super::stability::eigenvalues;
use super::{Turn, Turns, TurnsEnd, TurnsError};
use crate::motion::MotionError;
use crate::simulation::Machine;

/// Steps along the curve, in rad and in shares of the speed at which it begins.
const FIRST: f64 = 0.01;
const LONGEST: f64 = 0.04;
const SHORTEST: f64 = 1e-6;
const MOST_STEPS: usize = 1000;
/// In such shares, or as many times the one at which it begins: a curve that comes so far goes on to infinite speed.
const FASTEST: f64 = 5.0;

/// Newton's method is at rounding after four of its steps, if it gets there.
const MOST_CORRECTIONS: usize = 12;
/// Accelerations of a free position that are zero but for rounding, in 1/s².
const ZERO: f64 = 1e-10;
/// Corrections that are.
const STILL: f64 = 1e-14;
/// Corrections that may be.
const SMALL: f64 = 1e-10;

/// What has fallen, or is turned around, in rad.
const FALLEN: f64 = 80.0 * core::f64::consts::PI / 180.0;
const AROUND: f64 = core::f64::consts::PI;

/// A condition that picks one point of the curve: the sum of its factors times free positions and the share of the speed.
pub(super) struct Condition {
    pub factors: DVector<f64>,
    pub value: f64,
}

impl Turns {
    /// The turns that begin at a capsize speed in m/s, to the side to which the last free position, of a bicycle its steer, is
    /// positive.
    ///
    /// The curve is followed in steps of at most 0.04 rad, or as much of that speed, with Newton's method at each point, until
    /// it comes to rest or to straight running, or the machine would have fallen. Derivatives are those of a
    /// declaration that says `derivatives;`, else differences of four points each; the turns themselves do not depend on their
    /// errors.
    ///
    /// # Errors
    /// If the machine does not run on wheels, or if at the speed no lean and steer are in balance.
    pub fn from_capsize(machine: &dyn Machine, speed: f64) -> Result<Self, TurnsError> {
        if !(speed.is_finite() && speed > 0.0) {
            return Err(TurnsError::Speed { speed });
        }
        let balance = Balance::new(machine)?;
        let curve = Curve { balance, unit: speed };
        let count = curve.balance.free.len();
        let mut point = DVector::zeros(count + 1);
        point[count] = 1.0;
        let first = curve.turn(&point).map_err(TurnsError::Motion)?;
        let tangent = curve.departure(&point).map_err(TurnsError::Motion)?;
        let (others, end) = curve.follow(point, tangent);
        if others.is_empty() {
            return Err(TurnsError::NoBalance { speed });
        }
        let turns = core::iter::once(first).chain(others).collect();
        Ok(Self { begin: TurnsEnd::Straight, turns, end, by_yaw: false })
    }

    /// The turns of the curve at which a position has a value, by Newton's method from those beside it. Straight running, with
    /// which a curve begins, is one of them if the value is exactly that.
    ///
    /// # Errors
    /// If the equations have no value there.
    pub fn where_position(&self, machine: &dyn Machine, position: usize, value: f64) -> Result<Vec<Turn>, TurnsError> {
        let mut balance = Balance::new(machine)?;
        let Some(index) = balance.free.iter().position(|&place| place == position) else { return Ok(Vec::new()) };
        if self.by_yaw {
            balance = balance.by_yaw().ok_or(TurnsError::NoTurns)?;
        }
        let of = |turn: &Turn| if self.by_yaw { turn.yaw_rate } else { turn.speed };
        let unit = self.turns.first().map_or(1.0, of);
        let curve = Curve { balance, unit };
        let count = curve.balance.free.len();
        let mut found: Vec<Turn> =
            self.turns.first().into_iter().filter(|turn| turn.positions[position] == value).cloned().collect();
        for pair in self.turns.windows(2) {
            let [before, after] = [pair[0].positions[position], pair[1].positions[position]];
            let is_between = (before - value) * (after - value) < 0.0 || after == value;
            if !is_between {
                continue;
            }
            let share = (value - before) / (after - before);
            let between = |from: f64, to: f64| from + share * (to - from);
            let mut guess = DVector::from_iterator(
                count + 1,
                curve
                    .balance
                    .free
                    .iter()
                    .map(|&place| between(pair[0].positions[place], pair[1].positions[place]))
                    .chain([0.0]),
            );
            guess[count] = between(of(&pair[0]), of(&pair[1])) / unit;
            let condition = Condition { factors: unit_vector(count + 1, index), value };
            let corrected = curve.correct(guess, &condition).map_err(TurnsError::Motion)?;
            if let Some((point, _)) = corrected {
                found.push(curve.turn(&point).map_err(TurnsError::Motion)?);
            }
        }
        Ok(found)
    }
}

/// Turns as points: free positions, and the speed, or the yaw rate, as a share of that at which the curve begins.
pub(super) struct Curve<'a> {
    pub balance: Balance<'a>,
    pub unit: f64,
}

impl Curve<'_> {
    /// The turns behind a point of the curve, in the direction of a tangent, and where they end.
    pub fn follow(&self, mut point: DVector<f64>, mut tangent: DVector<f64>) -> (Vec<Turn>, TurnsEnd) {
        let count = self.balance.free.len();
        let mut turns = Vec::new();
        let mut step = FIRST;
        let fastest = FASTEST * point[count].max(1.0);
        let end = loop {
            if turns.len() >= MOST_STEPS {
                break TurnsEnd::Lost(None);
            }
            let mut next = self.next(&point, &tangent, step);
            // What is singular at a point is not approached in ever smaller steps, but stepped over.
            if self.balance.is_by_yaw() && !matches!(next, Ok(Some(_))) {
                next = self.next(&point, &tangent, 2.0 * step);
            }
            let (corrected, corrections) = match next {
                Ok(Some(next)) => next,
                Ok(None) if step <= SHORTEST => break TurnsEnd::Lost(None),
                Err(error) if step <= SHORTEST => break TurnsEnd::Lost(Some(error)),
                _ => {
                    step *= 0.5;
                    continue;
                }
            };
            if corrected[count] <= 0.0 {
                // At rest; the curve goes on as the same turns run backward.
                let at_rest = Condition { factors: unit_vector(count + 1, count), value: 0.0 };
                let found = self.correct(corrected.clone(), &at_rest).ok().flatten();
                let found = found.filter(|(at_rest, _)| (at_rest - &corrected).norm() < 2.0 * step);
                let Some(Ok(turn)) = found.map(|(point, _)| self.turn(&point)) else { break TurnsEnd::Lost(None) };
                turns.push(turn);
                break TurnsEnd::Rest;
            }
            if corrected.rows(0, count).amax() < 0.5 * step && turns.len() > 1 {
                break TurnsEnd::Straight;
            }
            let leans = self.balance.lean.is_some_and(|lean| corrected[lean].abs() > FALLEN);
            let has_fallen = leans || corrected.rows(0, count).amax() > AROUND;
            match self.turn(&corrected).and_then(|turn| Ok((turn, self.tangent(&corrected, &tangent)?))) {
                Ok((turn, along)) => {
                    turns.push(turn);
                    (point, tangent) = (corrected, along);
                }
                Err(error) => break TurnsEnd::Lost(Some(error)),
            }
            if has_fallen {
                break TurnsEnd::Fallen;
            }
            if point[count] > fastest {
                break TurnsEnd::Fast;
            }
            if corrections <= 4 {
                step = (1.5 * step).min(LONGEST);
            }
        };
        (turns, end)
    }

    fn accelerations(&self, point: &[f64]) -> Result<Vec<f64>, MotionError> {
        let (free, share) = point.split_at(self.balance.free.len());
        self.balance.accelerations(free, share[0] * self.unit)
    }

    fn slopes(&self, point: &DVector<f64>) -> Result<DMatrix<f64>, MotionError> {
        let (free, share) = point.as_slice().split_at(self.balance.free.len());
        let mut slopes = self.balance.slopes_of_turns(free, share[0] * self.unit)?;
        slopes.column_mut(free.len()).scale_mut(self.unit);
        Ok(slopes)
    }

    /// The direction in which turns depart from straight running: the free positions that are closest to balance.
    fn departure(&self, point: &DVector<f64>) -> Result<DVector<f64>, MotionError> {
        let count = self.balance.free.len();
        let slopes = self.slopes(point)?.columns(0, count).into_owned();
        let direction = least(&slopes);
        let sign = if direction[count - 1] < 0.0 { -1.0 } else { 1.0 };
        Ok(DVector::from_iterator(count + 1, direction.iter().map(|x| sign * x).chain([0.0])))
    }

    /// The direction of the curve at a point, on from the one before.
    pub fn tangent(&self, point: &DVector<f64>, before: &DVector<f64>) -> Result<DVector<f64>, MotionError> {
        let slopes = self.slopes(point)?;
        let size = slopes.ncols();
        // One row more, so that there is a direction without a slope.
        let square = DMatrix::from_fn(size, size, |i, j| if i < slopes.nrows() { slopes[(i, j)] } else { 0.0 });
        let direction = least(&square);
        Ok(if direction.dot(before) < 0.0 { -direction } else { direction })
    }

    /// The next point, with the number of corrections that it took; `None` if Newton's method does not get there.
    fn next(
        &self,
        point: &DVector<f64>,
        tangent: &DVector<f64>,
        step: f64,
    ) -> Result<Option<(DVector<f64>, usize)>, MotionError> {
        let condition = Condition { factors: tangent.clone(), value: tangent.dot(point) + step };
        let found = self.correct(point + tangent * step, &condition)?;
        // Not one far away.
        Ok(found.filter(|(next, _)| (next - point).norm() < 2.0 * step))
    }

    /// The point near a guess that is a turn and satisfies a condition.
    pub fn correct(
        &self,
        mut point: DVector<f64>,
        condition: &Condition,
    ) -> Result<Option<(DVector<f64>, usize)>, MotionError> {
        let (size, mut last) = (point.len(), f64::INFINITY);
        for corrections in 1..=MOST_CORRECTIONS {
            let (accelerations, slopes) = (self.accelerations(point.as_slice())?, self.slopes(&point)?);
            let matrix =
                DMatrix::from_fn(size, size, |i, j| if i + 1 < size { slopes[(i, j)] } else { condition.factors[j] });
            let missing = condition.value - condition.factors.dot(&point);
            let right = DVector::from_iterator(size, accelerations.iter().map(|value| -value).chain([missing]));
            let Some(correction) = matrix.lu().solve(&right) else { return Ok(None) };
            if !correction.iter().all(|value| value.is_finite()) {
                return Ok(None);
            }
            point += &correction;
            // Rounding is all that is left where corrections no longer shrink.
            let length = correction.norm();
            if length < STILL || length < SMALL && length >= last {
                let left = self.accelerations(point.as_slice())?;
                let is_turn = left.iter().all(|value| value.abs() < ZERO);
                return Ok(is_turn.then_some((point, corrections)));
            }
            last = length;
        }
        Ok(None)
    }

    pub fn turn(&self, point: &DVector<f64>) -> Result<Turn, MotionError> {
        let count = self.balance.free.len();
        let free = &point.as_slice()[..count];
        let at = self.balance.at(free, point[count] * self.unit)?;
        let rates = self.balance.rates(&at)?;
        let info = self.balance.machine.info();
        let rate = |name: &str| info.position(name).map_or(0.0, |place| rates[place]);
        let (speed, yaw_rate) = (rate("x"), rate("psi"));
        let At { positions, speeds } = at;
        let eigenvalues = eigenvalues(&self.balance, free, &speeds)?;
        // The same at every speed, and so also at rest.
        let rolling = self.balance.rates(&self.balance.at(free, 1.0)?)?;
        let along = |name: &str| info.position(name).map_or(0.0, |place| rolling[place]);
        let radius = if along("psi") == 0.0 { f64::INFINITY } else { (along("x") / along("psi")).abs() };
        Ok(Turn { positions, rates, speed, yaw_rate, radius, eigenvalues })
    }
}

/// The direction in which a square matrix is smallest.
fn least(matrix: &DMatrix<f64>) -> DVector<f64> {
    let svd = matrix.clone().svd(false, true);
    let last = svd.singular_values.imin();
    match svd.v_t {
        Some(directions) => directions.row(last).transpose(),
        None => DVector::zeros(matrix.ncols()),
    }
}

pub(super) fn unit_vector(size: usize, place: usize) -> DVector<f64> {
    DVector::from_fn(size, |i, _| if i == place { 1.0 } else { 0.0 })
}
