//! The numbers that somebody should have: what the matrices of a machine make of each quantity that was given.

mod meant;

use std::borrow::Cow;
use std::cell::Cell;
use std::cmp::Ordering;

use carvallo::{Complex, CriticalKind, MatrixName, ModelInfo};
use carvallo_design::feedback::Law;
use carvallo_design::matrices::{self, Coordinate, Form};
use carvallo_design::{Equations, Shipped};

use self::meant::Exact;
use crate::critical::{Critical, criticals};
use crate::form::order;
use crate::given::{Accelerations, Eigenvalues, Given, Quantity, Reading, StateMatrix, SystemMatrix};
use crate::machine::{Machine, entries_of};
use crate::relation::{Relation, of_accelerations, relations};
use crate::states::states;
use crate::zero::{Zero, zeros};
use carvallo_slips::index;

/// What makes numbers of matrices.
#[derive(Debug)]
pub struct Predictor<'a> {
    given: &'a Given,
    numbers: Vec<(Quantity, &'a Reading)>,
    /// How near a number must come to agree.
    tolerances: Vec<f64>,
    info: &'static ModelInfo,
    /// The model of any matrices of these coordinates.
    system: &'static Shipped,
    /// Of each state matrix the state, by the order of the library, that stands at each place.
    orders: Vec<Vec<usize>>,
    /// Of each gain of the feedback the entries that it is taken from, and its share in each.
    closing: Vec<Vec<(usize, f64)>>,
    /// For each state of motion that has its accelerations by them, the nonlinear equations.
    nonlinear: Vec<Option<Exact<'a>>>,
    feedback: &'a [Law],
    /// What is linear in the entries and holds where numbers agree: what does not as it is here first.
    relations: Vec<Relation>,
    /// The eigenvalues that are given as zeros of a determinant, what is the farthest off as it is here first.
    zeros: Vec<Zero>,
    /// The linear equations of motion in the states of which accelerations are given.
    motions: Vec<Relation>,
    /// The critical speeds that are given as zeros of determinants.
    criticals: Vec<Critical>,
    /// What is left of a part of the search where critical speeds are costly, and whether that was ever too little.
    left: Cell<usize>,
    is_short: Cell<bool>,
}

/// What a part of the search may cost where critical speeds are costly, in trials by determinants; and what one by all speeds does.
const COSTS: usize = 25_000;
const COST_OF_SPEEDS: usize = 1_000;

/// Matrices of the open loop, all eight row by row, the gravitational field strength in N/kg, and what closes the loop.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct World {
    /// In the order of [`MatrixName::ALL`].
    pub entries: Vec<f64>,
    /// In N/kg.
    pub gravity: f64,
    /// The values of the gains of the feedback, in the order of [`Machine::gains`].
    pub gains: Vec<f64>,
    /// The parameters.
    pub parameters: Vec<f64>,
    /// The attributes of the mechanism, of which the nonlinear equations are; none where these do not matter.
    pub attributes: Vec<f64>,
}

/// What rounding may do to a number, relative to the largest of its kind: an entry, an eigenvalue, a critical speed. Other
/// programs add in another order, and solve by other ways.
const ROUNDING: [f64; 3] = [1e-12, 1e-9, 1e-9];

/// So many digits tell a million pairs of causes apart.
const DIGITS: f64 = 6.0;

impl<'a> Predictor<'a> {
    /// For the numbers that were given of a machine.
    pub fn new(given: &'a Given, machine: &'a Machine) -> Self {
        let info = machine.info;
        let coordinates = info.coordinates.iter();
        let coordinates = coordinates.map(|own| Coordinate { name: own.name.to_owned(), states: own.states });
        let form = Form { matrices: MatrixName::ALL.to_vec(), coordinates: coordinates.collect() };
        let numbers = given.numbers();
        let orders = given.state_matrices.iter().map(|matrix| order(matrix, info)).collect();
        let closing = machine.gains().map(|gain| entries_of(gain, info, &machine.parameters));
        let (closing, system) = (closing.collect(), matrices::model(&form));
        let (nonlinear, feedback) = (Vec::new(), &machine.feedback[..]);
        let (tolerances, relations, motions) = (Vec::new(), Vec::new(), Vec::new());
        let (zeros, criticals) = (Vec::new(), Vec::new());
        let mut made = Self {
            given,
            numbers,
            tolerances,
            info,
            system,
            orders,
            closing,
            nonlinear,
            feedback,
            relations,
            zeros,
            motions,
            criticals,
            left: Cell::new(COSTS),
            is_short: Cell::new(false),
        };
        made.nonlinear = made.meant(machine);
        let world = machine.world();
        made.tolerances = self::tolerances(&made.numbers, &made.predict(&world));
        made.relations = self::relations(&made, info);
        let entries = made.closed_entries(&world);
        made.relations.sort_by_key(|own| own.holds(&entries, world.gravity));
        let closing = machine.gains().map(|gain| gain.matrix);
        // And those in which a loop stands that nobody declared.
        let undeclared = [MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K1, MatrixName::K2];
        let mut matrices: Vec<MatrixName> = info.matrices.iter().copied().chain(closing).chain(undeclared).collect();
        matrices.sort_by_key(|matrix| *matrix as usize);
        matrices.dedup();
        let far = |own: &Zero| {
            let [off, allowed] = own.off(&own.matrices(&entries, world.gravity));
            off / allowed
        };
        made.zeros = self::zeros(&made, info, &matrices);
        made.zeros.sort_by(|a, b| far(b).total_cmp(&far(a)));
        made.motions = of_accelerations(&made, info);
        made.criticals = self::criticals(&made, info, &matrices);
        made.criticals.sort_by_key(|own| (own.holds(&entries, world.gravity), own.is_weave()));
        made
    }

    /// What a number is called.
    pub fn name(&self, at: usize) -> String {
        let (quantity, is_nonlinear) = (self.numbers[at].0, self.is_nonlinear(at));
        let name = self.given.name(quantity, self.info);
        if is_nonlinear { format!("{name} by the nonlinear equations") } else { name }
    }

    /// What was given.
    pub fn given(&self) -> &'a Given {
        self.given
    }

    /// The states, by the order of the library, that stand at each place of a state matrix.
    pub fn order(&self, at: usize) -> &[usize] {
        &self.orders[at]
    }

    /// The numbers that were given, with what each is of.
    pub fn numbers(&self) -> &[(Quantity, &'a Reading)] {
        &self.numbers
    }

    /// Whether a number comes as near to the one that was given as its digits tell.
    pub fn agrees(&self, at: usize, value: f64) -> bool {
        (value - self.numbers[at].1.value).abs() <= self.tolerances[at]
    }

    /// How many of all numbers agree.
    pub fn agreeing(&self, values: &[f64]) -> usize {
        values.iter().enumerate().filter(|(at, value)| self.agrees(*at, **value)).count()
    }

    /// How near each number must come.
    pub fn tolerances(&self) -> &[f64] {
        &self.tolerances
    }

    /// Whether all numbers have so few significant digits together that some two of all causes make them by chance.
    pub fn has_few_digits(&self) -> bool {
        // Of each how many times its tolerance it is, as a power of ten.
        let each = self.numbers.iter().zip(&self.tolerances);
        let digits = each.map(|((_, reading), tolerance)| (reading.value.abs() / tolerance).log10().max(0.0));
        digits.sum::<f64>() < DIGITS
    }

    /// Whether all numbers agree.
    pub fn fits(&self, world: &World) -> bool {
        // This costs nothing, and hardly anything passes it.
        if !self.may_fit(world) {
            return false;
        }
        let has_others = self.numbers.iter().any(|(quantity, _)| !matches!(quantity, Quantity::Entry(..)));
        !has_others || {
            let mut agree = true;
            self.others(world, &mut |at, value| {
                agree = agree && self.agrees(at, value);
                agree
            });
            agree
        }
    }

    /// Numbers of which one at least does not agree, told by what costs little: others may not either.
    pub fn disagreeing(&self, world: &World) -> Vec<Vec<usize>> {
        let entries = self.closed_entries(world);
        let zeros = self.zeros.iter().filter(|own| !own.holds(&entries, world.gravity));
        let criticals = self.criticals.iter().filter(|own| !own.holds(&entries, world.gravity));
        let parts = |own: &Zero| (own.number..=own.number + usize::from(own.has_imaginary)).collect();
        zeros.map(parts).chain(criticals.map(|own| vec![own.number])).collect()
    }

    /// The same as far as this part of the search may still cost.
    pub fn fits_if_tried(&self, world: &World) -> bool {
        !self.is_costly() && self.fits(world)
            || self.is_costly()
                && self.spends(1)
                && self.may_fit(world)
                && self.spends(COST_OF_SPEEDS)
                && self.fits(world)
    }

    /// All numbers, as far as this part of the search may still cost.
    pub fn predict_if_tried(&self, world: &World) -> Option<Vec<f64>> {
        let is_tried = !self.is_costly() || self.spends(COST_OF_SPEEDS);
        is_tried.then(|| self.predict(world))
    }

    /// A part of the search begins, which may cost as much as any.
    pub fn begin(&self) {
        self.left.set(COSTS);
    }

    /// Whether anything is left of what this part of the search may cost.
    pub fn has_left(&self) -> bool {
        !self.is_costly() || self.spends(usize::from(self.left.get() == 0))
    }

    /// Whether the search was ever stopped by what it costs.
    pub fn is_short(&self) -> bool {
        self.is_short.get()
    }

    /// Whether so much is left of what this part of the search may cost, which is spent then.
    pub fn spends(&self, cost: usize) -> bool {
        let left = self.left.get().checked_sub(cost);
        self.left.set(left.unwrap_or(0));
        self.is_short.set(self.is_short.get() || left.is_none());
        left.is_some()
    }

    /// Whether the numbers are the same of other matrices; where critical speeds are costly, their characteristic polynomials.
    pub fn is_same(&self, [here, other]: [&World; 2], numbers: &[f64]) -> bool {
        if self.is_costly() && self.criticals.len() == self.numbers.len() {
            let [one, two] = [here, other].map(|world| self.closed_entries(world));
            let gravities = [here.gravity, other.gravity];
            return self.criticals.iter().all(|own| own.is_same([&one, &two], gravities));
        }
        let found = self.predict(other);
        let is_same = |at: usize| (found[at] - numbers[at]).abs() <= self.tolerances[at];
        (0..found.len()).all(is_same)
    }

    /// Whether critical speeds of more than two coordinates are given.
    pub fn is_costly(&self) -> bool {
        !self.given.critical_speeds.is_empty() && self.info.coordinates.len() > 2
    }

    /// Whether all numbers may agree, as far as that costs little.
    pub fn may_fit(&self, world: &World) -> bool {
        let entries = self.closed_entries(world);
        self.relations.iter().chain(&self.motions).all(|own| own.holds(&entries, world.gravity))
            && self.zeros.iter().all(|own| own.holds(&entries, world.gravity))
            && self.criticals.iter().all(|own| own.holds(&entries, world.gravity))
    }

    /// All numbers; NaN where there is none.
    pub fn predict(&self, world: &World) -> Vec<f64> {
        let entry = |(quantity, _): &(Quantity, _)| self.entry(*quantity, world).unwrap_or(f64::NAN);
        let mut values: Vec<f64> = self.numbers.iter().map(entry).collect();
        self.others(world, &mut |at, value| {
            values[at] = value;
            true
        });
        values
    }

    /// One number of all; NaN where there is none.
    pub fn number(&self, at: usize, world: &World) -> f64 {
        match self.numbers[at].0 {
            Quantity::Acceleration(state, of) => {
                let given = &self.given.accelerations[state];
                let found = match &self.nonlinear[state] {
                    Some(exact) => exact.accelerations(given, world, self.feedback),
                    None => self.linear(given, world),
                };
                found.map_or(f64::NAN, |found| found[of])
            }
            _ => self.predict(world)[at],
        }
    }

    /// That of an entry of a matrix; of others `None`.
    pub fn entry(&self, quantity: Quantity, world: &World) -> Option<f64> {
        match quantity {
            Quantity::Entry(matrix, row, column) => {
                let at = index(matrix, row, column, self.info.coordinates.len());
                let own = self.closed(world).filter(|(entry, _)| *entry == at);
                Some(world.entries[at] - own.map(|(_, value)| value).sum::<f64>())
            }
            _ => None,
        }
    }

    /// What is linear in the entries of the closed loop and holds where all numbers agree, what is wrong here first.
    pub fn relations(&self) -> &[Relation] {
        &self.relations
    }

    /// The eigenvalues that are given as zeros of a determinant, what is the farthest off here first.
    pub fn zeros(&self) -> &[Zero] {
        &self.zeros
    }

    /// The critical speeds that are given as zeros of determinants, what is wrong here first.
    pub fn criticals(&self) -> &[Critical] {
        &self.criticals
    }

    /// The relations of the entries of the open loop, which this closes.
    pub fn relations_of_open_loop(&self, world: &World) -> Vec<Relation> {
        let closing: Vec<(usize, f64)> = self.closed(world).collect();
        self.relations.iter().map(|own| own.clone().of_open_loop(&closing, world.gravity)).collect()
    }

    /// All entries with what feedback takes from them.
    pub fn closed_entries<'w>(&self, world: &'w World) -> Cow<'w, [f64]> {
        let mut entries = Cow::Borrowed(&world.entries[..]);
        self.closed(world).for_each(|(entry, value)| entries.to_mut()[entry] -= value);
        entries
    }

    /// Tells all numbers but the entries of matrices, until it is told to stop; where there are none, NaN.
    fn others(&self, world: &World, tell: &mut dyn FnMut(usize, f64) -> bool) {
        let is_entry = |(quantity, _): &(Quantity, _)| matches!(quantity, Quantity::Entry(..));
        let Some(first) = self.numbers.iter().position(|number| !is_entry(number)) else { return };
        let mut place = first;
        let mut next = |value: f64| {
            place += 1;
            tell(place - 1, value)
        };
        if (first..self.numbers.len()).all(|at| self.is_nonlinear(at)) {
            self.each_acceleration(None, world, &mut next);
            return;
        }
        let visited = self.visit(world, &mut |equations| self.each_other(equations, world, &mut next));
        if visited.is_err() {
            (first..self.numbers.len()).all(|_| next(f64::NAN));
        }
    }

    /// What feedback takes from entries.
    pub fn closed(&self, world: &World) -> impl Iterator<Item = (usize, f64)> {
        let each = self.closing.iter().zip(&world.gains);
        each.flat_map(|(entries, value)| entries.iter().map(move |(entry, share)| (*entry, share * value)))
    }

    /// Hands the equations of the closed loop to a visitor.
    fn visit(&self, world: &World, visitor: &mut dyn FnMut(&dyn Equations)) -> Result<(), String> {
        let mut parameters = self.closed_entries(world).into_owned();
        parameters.push(world.gravity);
        self.system.visit(&parameters, &mut |equations| {
            visitor(equations);
            Ok(())
        })
    }

    /// The same in the order of [`Given::numbers`].
    fn each_other(&self, equations: &dyn Equations, world: &World, tell: &mut dyn FnMut(f64) -> bool) {
        let gravity = world.gravity;
        let Given {
            matrices: _,
            system_matrices,
            state_matrices,
            eigenvalues,
            critical_speeds,
            accelerations: _,
            unknown: _,
        } = self.given;
        for SystemMatrix { speed, is_stiffness, rows } in system_matrices {
            let own = equations.system(*speed, gravity).ok().map(|[_, c, k]| if *is_stiffness { k } else { c });
            for (row, entries) in rows.iter().enumerate() {
                for (column, _) in entries.iter().enumerate().filter(|(_, entry)| entry.is_some()) {
                    if !tell(own.as_ref().map_or(f64::NAN, |own| own[row * entries.len() + column])) {
                        return;
                    }
                }
            }
        }
        for (StateMatrix { speed, rows }, order) in state_matrices.iter().zip(&self.orders) {
            let a = equations.state_space(*speed, gravity).ok().map(|[a, _]| a);
            for (row, entries) in rows.iter().enumerate() {
                for (column, _) in entries.iter().enumerate().filter(|(_, entry)| entry.is_some()) {
                    let value = a.as_ref().map_or(f64::NAN, |a| a[order[row] * order.len() + order[column]]);
                    if !tell(value) {
                        return;
                    }
                }
            }
        }
        for given in eigenvalues {
            let found = equations.eigenvalues(given.speed, gravity).unwrap_or_default();
            for ((_, im), value) in given.values.iter().zip(assigned(given, found)) {
                if !tell(value.re) || im.is_some() && !tell(value.im) {
                    return;
                }
            }
        }
        if !critical_speeds.is_empty() {
            let found = equations.stability(gravity).map(|stability| stability.critical_speeds).unwrap_or_default();
            for given in critical_speeds {
                let is_meant = |kind: CriticalKind| match given.kind {
                    Some(meant) => kind == meant,
                    None => kind != CriticalKind::DoubleRoot,
                };
                let of_kind = found.iter().filter(|critical| is_meant(critical.kind)).map(|critical| critical.speed);
                let distance = |speed: &f64| (speed - given.speed.value).abs();
                let nearest = of_kind.min_by(|a, b| distance(a).total_cmp(&distance(b)));
                if !tell(nearest.unwrap_or(f64::NAN)) {
                    return;
                }
            }
        }
        self.each_acceleration(Some(equations), world, tell);
    }

    /// The accelerations in their order, by linear equations where they are not by nonlinear ones.
    fn each_acceleration(&self, linear: Option<&dyn Equations>, world: &World, tell: &mut dyn FnMut(f64) -> bool) {
        for (given, nonlinear) in self.given.accelerations.iter().zip(&self.nonlinear) {
            let found = match nonlinear {
                Some(exact) => exact.accelerations(given, world, self.feedback),
                None => linear.and_then(|equations| self.accelerations(given, equations, world.gravity)),
            };
            for (of, _) in given.values.iter().enumerate().filter(|(_, value)| value.is_some()) {
                if !tell(found.as_ref().map_or(f64::NAN, |found| found[of])) {
                    return;
                }
            }
        }
    }

    /// The accelerations by the linear equations; `None` where there are none.
    fn linear(&self, given: &Accelerations, world: &World) -> Option<Vec<f64>> {
        let mut found = None;
        self.visit(world, &mut |equations| found = self.accelerations(given, equations, world.gravity)).ok()?;
        found
    }

    /// The accelerations of all coordinates by the linear equations; NaN where only the position is a state.
    fn accelerations(&self, given: &Accelerations, equations: &dyn Equations, gravity: f64) -> Option<Vec<f64>> {
        let [a, b] = equations.state_space(given.speed, gravity).ok()?;
        let states = states(self.info);
        let state: Vec<f64> =
            states.iter().map(|(is_rate, of)| if *is_rate { given.rates[*of] } else { given.positions[*of] }).collect();
        let mut found = vec![f64::NAN; self.info.coordinates.len()];
        for (row, (_, of)) in states.iter().enumerate().filter(|(_, (is_rate, _))| *is_rate) {
            let sum = |matrix: &[f64], with: &[f64]| -> f64 {
                matrix[row * with.len()..].iter().zip(with).map(|(entry, value)| entry * value).sum()
            };
            found[*of] = sum(&a, &state) + sum(&b, &given.forces);
        }
        Some(found)
    }
}

/// The eigenvalue that is nearest to each that was given, none of them twice; NaN where there are too few.
fn assigned(given: &Eigenvalues, mut found: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    let nearest = |(re, im): &(Reading, Option<Reading>)| {
        let distance = |value: &Complex<f64>| {
            let im = im.as_ref().map_or(0.0, |im| value.im - im.value);
            (value.re - re.value).hypot(im)
        };
        let order = |a: &Complex<f64>, b: &Complex<f64>| -> Ordering { distance(a).total_cmp(&distance(b)) };
        match (0..found.len()).min_by(|&a, &b| order(&found[a], &found[b])) {
            Some(at) => found.swap_remove(at),
            None => Complex::new(f64::NAN, f64::NAN),
        }
    };
    given.values.iter().map(nearest).collect()
}

/// Half a unit of the last digit, and no less than what rounding may do.
fn tolerances(numbers: &[(Quantity, &Reading)], ours: &[f64]) -> Vec<f64> {
    /// Numbers that are larger than ours by more are mistaken, and say nothing of rounding.
    const LARGER: f64 = 1e6;
    let kind = |quantity: &Quantity| match *quantity {
        Quantity::Entry(matrix, ..) => (0, matrix as usize),
        Quantity::State(at, ..) => (1, at),
        Quantity::RealPart(at, _) | Quantity::ImaginaryPart(at, _) => (2, at),
        Quantity::System(at, ..) => (5, at),
        Quantity::CriticalSpeed(_) => (3, 0),
        Quantity::Acceleration(at, _) => (4, at),
    };
    let tolerance = |(quantity, reading): &(Quantity, &Reading)| {
        let own = kind(quantity);
        let group = || numbers.iter().zip(ours).filter(|((other, _), _)| kind(other) == own);
        let largest_of_ours = group().fold(0.0, |largest: f64, (_, ours)| largest.max(ours.abs()));
        let limit = if largest_of_ours > 0.0 { LARGER * largest_of_ours } else { f64::INFINITY };
        let largest = group().fold(0.0, |largest: f64, ((_, reading), _)| largest.max(reading.value.abs())).min(limit);
        let rounding = match own.0 {
            0 | 5 => ROUNDING[0],
            2 => ROUNDING[1],
            _ => ROUNDING[2],
        };
        // A tie may be rounded to either side.
        (1.000_001 * reading.tolerance).max(rounding * largest)
    };
    numbers.iter().map(tolerance).collect()
}
