//! The search for what makes the numbers that were given.

mod double;
mod solve;

use carvallo::Expression;

use crate::conventions::{Convention, Effect};
use crate::machine::{FormulaSlip, Machine};
use crate::predict::{Predictor, World};

pub use self::double::DoubleSlip;
pub use self::solve::{digits, relation};

/// A value with up to so many significant digits may be what stood there.
const PLAIN: usize = 5;

/// What makes the numbers that were given, in the place of those of the machine: one cause, or two together.
#[derive(Clone, Debug)]
pub struct Found<'a> {
    /// One or two.
    pub causes: Vec<Cause<'a>>,
    /// The matrices that it makes.
    pub world: World,
}

/// One cause.
#[derive(Clone, Debug)]
pub enum Cause<'a> {
    /// A convention, an entry or a parameter taken for another.
    Convention(&'a Convention),
    /// A slip in a formula.
    Slip(&'a FormulaSlip),
    /// Two slips in one formula.
    Slips(DoubleSlip),
    /// The parameter at a position has another value.
    Parameter(usize, f64),
    /// The definition at a position has another value, whatever its formula is.
    Definition(usize, f64),
    /// The speeds are others by this factor.
    Speed(f64),
}

/// Everything that reproduces all numbers to the given digits, by the fewest causes: one; or else two, of which one is a
/// convention; or else another value of one definition, with two slips in its formula that make it.
pub fn explain<'a>(machine: &'a Machine, predictor: &Predictor) -> Vec<Found<'a>> {
    let search = Search { machine, predictor, here: predictor.predict(&machine.world()) };
    let mut found = Vec::new();
    machine.singles(&mut |cause, world| {
        if predictor.fits(world) {
            found.push(Found { causes: vec![cause], world: world.clone() });
        }
    });
    // A value with many digits fits some number or other: it explains nothing where something else does.
    let is_plain = |found: &Found| !matches!(found.causes[..], [Cause::Parameter(_, value)] if digits(value) > PLAIN);
    found.extend(search.parameters());
    if found.iter().any(is_plain) {
        found.retain(is_plain);
    }
    if found.is_empty() {
        found = search.pairs();
    }
    if found.is_empty() {
        found = search.definitions();
    }
    found
}

struct Search<'a, 'b> {
    machine: &'a Machine,
    predictor: &'b Predictor<'b>,
    /// The numbers as they are here.
    here: Vec<f64>,
}

impl<'a> Search<'a, '_> {
    /// The matrices of all slips that make any, for these parameters.
    fn each_slip(&self, parameters: &[f64], tell: &mut dyn FnMut(&'a FormulaSlip, &mut Vec<f64>)) {
        let base = self.machine.formulas.values(parameters);
        let mut own = base.clone();
        for slip in self.machine.slips() {
            if self.machine.slip(slip, parameters, &base, &mut own) {
                tell(slip, &mut own.entries);
            }
        }
    }

    /// The parameters of which another value fits, and speeds, where something else than matrices was given.
    fn parameters(&self) -> Vec<Found<'a>> {
        let mut found = self.parameters_with(None);
        found.extend(self.speeds());
        found
    }

    fn parameters_with(&self, convention: Option<&'a Convention>) -> Vec<Found<'a>> {
        // A single number any parameter can make.
        if self.here.len() < 2 {
            return Vec::new();
        }
        let machine = self.machine;
        let mut found = Vec::new();
        for (at, _) in machine.info.parameters.iter().enumerate().filter(|(_, parameter)| parameter.used) {
            let world = |x: f64| {
                let mut parameters = machine.parameters.clone();
                if let Some(convention) = convention {
                    convention.change_parameters(&mut parameters);
                }
                parameters[at] = x;
                let old = machine.world_of(&parameters);
                let Some(convention) = convention else { return Some(old) };
                let mut own = World::default();
                convention.change_matrices(&old, &mut own, machine.formulas.count);
                Some(own)
            };
            // What cannot be is nobody's, unless it is a slip of the pen.
            let domain = machine.info.parameters[at].domain;
            let old = machine.parameters[at];
            let can_be = |x: &f64| domain.contains(*x) || relation(old, *x).is_some();
            if let Some(x) = solve::solve(self.predictor, old, &world).filter(can_be) {
                let causes = convention.map(Cause::Convention).into_iter().chain([Cause::Parameter(at, x)]);
                found.extend(world(x).map(|world| Found { causes: causes.collect(), world }));
            }
        }
        found
    }

    /// All speeds may be others, by one factor.
    fn speeds(&self) -> Vec<Found<'a>> {
        let given = self.predictor.given();
        if !given.matrices.is_empty() || self.here.len() < 2 || !self.machine.info.depends_on_speed() {
            return Vec::new();
        }
        let world = |factor: f64| {
            let mut world = self.machine.world();
            let square = self.machine.formulas.count * self.machine.formulas.count;
            for (matrix, power) in world.entries.chunks_exact_mut(square).zip([0, -1, 0, 1, 0, 0, 1, 2]) {
                matrix.iter_mut().for_each(|entry| *entry *= factor.powi(power));
            }
            (factor > 0.0).then_some(world)
        };
        let found = solve::solve(self.predictor, 1.0, &world);
        let found = found.and_then(|x| Some(Found { causes: vec![Cause::Speed(x)], world: world(x)? }));
        found.into_iter().collect()
    }

    /// Those of the usual conventions that these numbers show at all.
    fn seen(&self) -> Vec<&'a Convention> {
        let is_seen = |convention: &&Convention| {
            let found = self.predictor.predict(&self.machine.world_with(convention));
            let tolerances = self.predictor.tolerances();
            let is_same = |at: usize| (found[at] - self.here[at]).abs() <= tolerances[at];
            !(0..found.len()).all(is_same)
        };
        self.machine.usual.iter().filter(is_seen).collect()
    }

    /// A convention with a slip, with another convention, or with another value of a parameter.
    fn pairs(&self) -> Vec<Found<'a>> {
        let machine = self.machine;
        let count = machine.formulas.count;
        let conventions = self.seen();
        let (of_parameters, of_matrices): (Vec<&Convention>, Vec<&Convention>) =
            conventions.iter().partition(|own| matches!(own.effect, Effect::Parameters(_)));
        let mut found = Vec::new();
        for (at, &first) in conventions.iter().enumerate() {
            let mut parameters = machine.parameters.clone();
            first.change_parameters(&mut parameters);
            for &second in &conventions[at + 1..] {
                // What acts on matrices acts on those of the parameters of the other one, and after them.
                let mut both = parameters.clone();
                second.change_parameters(&mut both);
                let (mut one, mut two) = (World::default(), World::default());
                first.change_matrices(&machine.world_of(&both), &mut one, count);
                second.change_matrices(&one, &mut two, count);
                if self.predictor.fits(&two) {
                    found.push(Found { causes: vec![Cause::Convention(first), Cause::Convention(second)], world: two });
                }
            }
        }
        let mut own = World::default();
        let mut old = World { entries: Vec::new(), gravity: machine.gravity(&machine.parameters) };
        self.each_slip(&machine.parameters, &mut |slip, entries| {
            std::mem::swap(&mut old.entries, entries);
            for &convention in &of_matrices {
                convention.change_matrices(&old, &mut own, count);
                if self.predictor.fits(&own) {
                    let causes = vec![Cause::Convention(convention), Cause::Slip(slip)];
                    found.push(Found { causes, world: own.clone() });
                }
            }
            std::mem::swap(&mut old.entries, entries);
        });
        for &convention in &of_parameters {
            let mut parameters = machine.parameters.clone();
            convention.change_parameters(&mut parameters);
            let mut world = World { entries: Vec::new(), gravity: machine.gravity(&parameters) };
            self.each_slip(&parameters, &mut |slip, entries| {
                std::mem::swap(&mut world.entries, entries);
                if self.predictor.fits(&world) {
                    let causes = vec![Cause::Convention(convention), Cause::Slip(slip)];
                    found.push(Found { causes, world: world.clone() });
                }
                std::mem::swap(&mut world.entries, entries);
            });
        }
        if found.is_empty() {
            found.extend(conventions.into_iter().flat_map(|own| self.parameters_with(Some(own))));
        }
        found
    }

    /// Another value of one definition, with two slips that make it where there are any.
    fn definitions(&self) -> Vec<Found<'a>> {
        if self.here.len() < 2 {
            return Vec::new();
        }
        let machine = self.machine;
        let definitions = machine.formulas.names.len() - machine.parameters.len();
        let mut found = Vec::new();
        for at in 0..definitions {
            let world = |x: f64| {
                let mut own = machine.values.clone();
                let number = Expression::Number(String::new(), x);
                let done = machine.formulas.change(&[at], &number, &machine.parameters, &mut own);
                done.then(|| World { entries: own.entries, gravity: machine.gravity(&machine.parameters) })
            };
            if let Some(x) = solve::solve(self.predictor, machine.values.definition(at), &world) {
                let doubles = double::find(machine, self.predictor, at, x);
                if doubles.is_empty() {
                    found.extend(world(x).map(|world| Found { causes: vec![Cause::Definition(at, x)], world }));
                }
                found.extend(doubles);
            }
        }
        // A formula that is told goes before a value alone.
        let is_told = |found: &Found| matches!(found.causes[..], [Cause::Slips(_)]);
        if found.iter().any(is_told) {
            found.retain(is_told);
        }
        found
    }
}
