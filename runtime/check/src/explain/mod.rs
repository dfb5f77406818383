//! The search for what makes the numbers that were given.

mod acting;
mod beside;
mod constant;
mod curve;
mod double;
mod factor;
mod forces;
mod gains;
mod pairs;
mod readings;
mod scaled;
mod set;
mod slips;
mod solve;
mod undeclared;
mod unknown;
mod written;
mod zeros;

use std::cell::OnceCell;

use self::unknown::Unknown;
use crate::behind;
use crate::conventions::{Convention, Effect};
use crate::machine::Machine;
use crate::predict::{Predictor, World};
use crate::report::rank;
use carvallo_slips::FormulaSlip;

pub use carvallo_slips::DoubleSlip;

pub use self::constant::Force;
pub use self::forces::{Missing, find as of_accelerations, missing, off};

pub use self::factor::Scaled;
pub use self::readings::{Explained, explain};
pub use self::solve::{digits, relation};
use self::undeclared::of_eigenvalues;
pub use self::undeclared::{Undeclared, find as undeclared};
pub use self::written::written;

/// A value with up to so many significant digits may be what stood there.
const PLAIN: usize = 5;
/// So many digits fewer than the numbers have gains that were meant.
const SPARE: usize = 2;
/// And those of which no two causes need be tried, that many at most, and so many fewer.
const SURE: usize = 3;
const SURELY_SPARE: usize = 4;
/// So many numbers may have been written wrongly, all of them.
const WRITTEN: usize = 2;

/// What makes the numbers that were given, in the place of those of the machine: one cause, or two together.
#[derive(Clone, Debug)]
pub struct Found<'a> {
    /// One or two.
    pub causes: Vec<Cause<'a>>,
    /// The matrices that it makes.
    pub world: World,
}

impl Found<'_> {
    /// A value with many digits fits some number or other: it explains nothing where something else does.
    pub fn is_plain(&self) -> bool {
        !matches!(self.causes[..], [Cause::Parameter(_, value)] if digits(value) > PLAIN)
    }

    /// Whether it is a feedback with gains of so few digits that no other cause makes the same numbers.
    fn has_sure_gains(&self, predictor: &Predictor) -> bool {
        let is_sure = |own: &Undeclared| own.digits <= SURE && own.digits + SURELY_SPARE <= known_digits(predictor);
        matches!(&self.causes[..], [Cause::Feedback(own)] if is_sure(own))
    }

    /// How unlikely it is.
    pub fn rank(&self, machine: &Machine) -> u32 {
        self.causes.iter().map(|cause| rank(machine, cause)).sum()
    }

    /// Whether speeds that are others make it.
    fn has_other_speeds(&self) -> bool {
        let is_other = |cause: &Cause| match cause {
            Cause::Convention(own) => matches!(own.effect, Effect::Speeds(..)),
            cause => matches!(cause, Cause::Speed(_)),
        };
        self.causes.iter().any(is_other)
    }
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
    /// Matrices are multiplied by something.
    Scaled(Scaled),
    /// The loop is closed, by feedback that was not declared.
    Feedback(Undeclared),
    /// A force is not declared, or another one than is.
    Force(Force),
    /// Numbers are cut off, and not rounded; so unlikely by what else shows it.
    CutOff(u32, Which),
    /// A number itself was written wrongly, whatever it comes from: in words.
    Written(String),
}

/// Of numbers.
#[derive(Clone, Copy, Debug)]
pub enum Which {
    /// All of them.
    All,
    /// Some of them.
    Some,
}

impl Cause<'_> {
    /// How unlikely it is, of slips; 0 for others.
    fn rank_of_slips(&self) -> u32 {
        match self {
            Self::Slip(own) => own.rank(),
            Self::Slips(double) => double.rank(),
            _ => 0,
        }
    }
}

/// The search for explanations of numbers of a machine. They may be read in several ways, as rounded or as cut off: most of the
/// search is for what fits in any of them, and done once.
pub struct Search<'a, 'b> {
    machine: &'a Machine,
    /// The numbers as they are here.
    here: Vec<f64>,
    rounded: &'b Predictor<'b>,
    any: &'b Predictor<'b>,
    /// With the numbers that each makes: critical speeds of many coordinates take long.
    singles: OnceCell<Vec<(Found<'a>, Vec<f64>)>>,
    conventions: OnceCell<Vec<&'a Convention>>,
    pairs: OnceCell<Vec<Found<'a>>>,
    slips: OnceCell<Vec<Found<'a>>>,
    /// What other values may explain the numbers in any way of reading: of parameters and speeds, of parameters beside a
    /// convention, and of definitions.
    values: [OnceCell<Vec<Unknown<'a>>>; 3],
}

impl<'a, 'b> Search<'a, 'b> {
    /// Of numbers that are `rounded`, or read in other ways; `any` agrees with whatever one of these agrees with.
    pub fn new(machine: &'a Machine, rounded: &'b Predictor<'b>, any: &'b Predictor<'b>) -> Self {
        let here = rounded.predict(&machine.world());
        let values = [const { OnceCell::new() }; 3];
        let (singles, conventions) = (OnceCell::new(), OnceCell::new());
        let (pairs, slips) = (OnceCell::new(), OnceCell::new());
        Self { machine, here, rounded, any, singles, conventions, pairs, slips, values }
    }

    /// The same of the numbers as rounded, for most of which that is quicker; what is found already is among what may be it.
    pub fn of_rounded(&self) -> Search<'a, 'b> {
        let own = Self::new(self.machine, self.rounded, self.rounded);
        Self { singles: self.singles.clone(), ..own }
    }

    /// Whether a slip or a convention alone reproduces all numbers, read in one way.
    pub fn has_one_cause(&self, predictor: &Predictor) -> bool {
        self.singles().iter().any(|own| is_made(own, predictor))
    }

    /// What reproduces all numbers, read in one way, by a slip, a convention or another value of a parameter alone.
    pub fn by_one(&self, predictor: &Predictor) -> Vec<Found<'a>> {
        let single = self.singles().iter().filter(|own| is_made(own, predictor));
        let mut found: Vec<Found> = single.map(|(found, _)| found.clone()).collect();
        if found.is_empty()
            && let Some(own) = scaled::find(self.machine, predictor, &self.here)
        {
            return vec![own];
        }
        // Speeds in another unit are told with it.
        let has_unit = found.iter().any(|own| own.has_other_speeds());
        let solved = self.solved(predictor, self.parameters());
        let has_others = !found.is_empty();
        found.extend(solved.into_iter().filter(|own| !(has_unit && own.has_other_speeds())));
        // One number of several that was written wrongly is likelier than a value that nobody would write.
        if !has_others && !found.is_empty() {
            let written = self.written(predictor, 1);
            let is_likelier =
                |own: &Found| written.iter().all(|other| own.rank(self.machine) > other.rank(self.machine));
            if found.iter().all(is_likelier) {
                found.extend(written);
            }
        }
        // Of accelerations the forces tell it at once.
        let forces = constant::find(self.machine, predictor, most_digits(predictor));
        let is_declared = !forces.is_empty() && forces.iter().all(Force::is_of_declared);
        let causes: Vec<Cause> = forces.into_iter().map(Cause::Force).collect();
        let by_forces = Some(Found { causes, world: self.machine.world() }).filter(|own| !own.causes.is_empty());
        if found.iter().any(Found::is_plain) {
            found.retain(Found::is_plain);
            found.extend(by_forces.filter(|_| is_declared));
        } else if self.written(predictor, 1).is_empty() {
            let law = self.closed(predictor, of_accelerations(self.machine, predictor));
            let all: Vec<Found> = by_forces.into_iter().chain(law).collect();
            found = if all.is_empty() { found } else { all };
        }
        found
    }

    fn fitting(&self, all: &[Found<'a>], predictor: &Predictor) -> Vec<Found<'a>> {
        all.iter().filter(|found| predictor.fits(&found.world)).cloned().collect()
    }

    /// Everything that reproduces all numbers, read in one way, to the given digits, by the fewest causes: one; or else two
    /// conventions, slips, or one of each; or else another value of one definition, with two slips in its formula that make it.
    pub fn explain(&self, predictor: &Predictor) -> Vec<Found<'a>> {
        let mut found = self.by_one(predictor);
        // Of one number alone that is likelier than two causes.
        if found.is_empty() {
            found = self.written(predictor, 1);
        }
        let all_closed = OnceCell::new();
        let closed = || {
            all_closed.get_or_init(|| {
                let closed = undeclared(self.machine, predictor).or_else(|| of_eigenvalues(self.machine, predictor));
                self.closed(predictor, closed)
            })
        };
        // Gains of so few digits are no chance, and cost less than two causes.
        if found.is_empty() {
            found.extend(closed().clone().filter(|own| own.has_sure_gains(predictor)));
        }
        if found.is_empty() {
            found = self.fitting(self.pairs(), predictor);
            found.extend(self.fitting(self.slips(), predictor));
        }
        // One equation that is off in one state any value makes that stands in it.
        let is_known = off(self.machine, predictor) != Some(1);
        if found.is_empty() && is_known {
            found.extend(self.solved(predictor, self.parameters_with_conventions()));
        }
        if found.is_empty() && is_known {
            found = self.of_definitions(predictor);
        }
        if found.is_empty() {
            found = self.written(predictor, WRITTEN);
        }
        if found.is_empty() {
            found.extend(closed().clone());
        }
        found
    }

    /// A closed loop whose gains somebody may have meant.
    fn closed(&self, predictor: &Predictor, closed: Option<Undeclared>) -> Option<Found<'a>> {
        let plain = closed.filter(|own| !own.laws.is_empty() && own.digits <= most_digits(predictor));
        plain.map(|own| Found { causes: vec![Cause::Feedback(own)], world: self.machine.world() })
    }

    /// All numbers that do not agree, of which there are so many at most, written wrongly; or all of C and K that stand behind state
    /// matrices.
    fn written(&self, predictor: &Predictor, most: usize) -> Vec<Found<'a>> {
        let causes = all_written(predictor, &self.here, most).or_else(|| {
            let given = behind::state_matrices(self.machine, predictor)?;
            let behind = Predictor::new(&given, self.machine);
            all_written(&behind, &behind.predict(&self.machine.world()), most)
        });
        causes.map(|causes| Found { causes, world: self.machine.world() }).into_iter().collect()
    }

    fn singles(&self) -> &[(Found<'a>, Vec<f64>)] {
        self.singles.get_or_init(|| {
            let mut found = Vec::new();
            let mut tell = |cause: Cause<'a>, world: &World| {
                let made = || (Found { causes: vec![cause], world: world.clone() }, self.any.predict(world));
                found.extend(self.any.may_fit(world).then(made).filter(|own| is_made(own, self.any)));
            };
            let all = self.at_speeds().chain(self.of_matrices());
            all.for_each(|own| tell(Cause::Convention(own), &self.machine.world_with(own)));
            self.machine.singles(&mut tell);
            found
        })
    }

    /// Those of the usual conventions that these numbers show at all.
    fn conventions(&self) -> &[&'a Convention] {
        let here = self.machine.world();
        let is_seen =
            |convention: &&Convention| !self.rounded.is_same([&here, &self.machine.world_with(convention)], &self.here);
        self.conventions.get_or_init(|| self.machine.usual.iter().chain(self.at_speeds()).filter(is_seen).collect())
    }

    /// Conventions of what is at speeds, where any is given.
    fn at_speeds(&self) -> impl Iterator<Item = &'a Convention> + use<'a> {
        let given = self.rounded.given();
        let has_sums = !(given.system_matrices.is_empty() && given.state_matrices.is_empty());
        let has_powers = given.speeds().iter().any(|speed| *speed > 0.0);
        let of = |has_any: bool, all: &'a [Convention]| if has_any { all } else { &[] };
        of(has_sums, &self.machine.sums).iter().chain(of(has_powers, &self.machine.powers))
    }

    /// Those of whole matrices, where any is given.
    fn of_matrices(&self) -> impl Iterator<Item = &'a Convention> + use<'a> {
        let given = self.rounded.given();
        let (has_matrices, has_states) = (!given.matrices.is_empty(), !given.state_matrices.is_empty());
        let has_any = has_matrices || has_states || !given.system_matrices.is_empty();
        let of = |has_any: bool, at: usize| if has_any { &self.machine.wholes()[at][..] } else { &[] };
        of(has_matrices, 0).iter().chain(of(has_any, 1))
    }

    fn pairs(&self) -> &[Found<'a>] {
        self.pairs.get_or_init(|| pairs::find(self.machine, self.any, self.conventions()))
    }

    fn slips(&self) -> &[Found<'a>] {
        self.slips.get_or_init(|| {
            let mut found = slips::find(self.machine, self.any);
            found.extend(zeros::find(self.machine, self.any));
            found
        })
    }

    /// The parameters of which another value fits, and speeds, where something else than matrices was given.
    fn parameters(&self) -> &[Unknown<'a>] {
        let has_speeds = self.any.given().matrices.is_empty() && self.machine.info.depends_on_speed();
        let speed = has_speeds.then_some(Unknown::Speed);
        self.values[0].get_or_init(|| self.solvable(Unknown::parameters(self.machine, None).chain(speed)))
    }

    fn parameters_with_conventions(&self) -> &[Unknown<'a>] {
        let all = || self.conventions().iter().flat_map(|own| Unknown::parameters(self.machine, Some(own)));
        self.values[1].get_or_init(|| self.solvable(all()))
    }

    fn definitions(&self) -> &[Unknown<'a>] {
        let formulas = &self.machine.formulas;
        let tried = (0..formulas.definitions).filter(|at| formulas.formulas[*at].is_tried);
        self.values[2].get_or_init(|| self.solvable(tried.map(Unknown::Definition)))
    }

    fn solvable(&self, unknowns: impl Iterator<Item = Unknown<'a>>) -> Vec<Unknown<'a>> {
        // A single number any of them can make.
        let unknowns = unknowns.filter(|_| self.here.len() > 1);
        self.any.begin();
        unknowns.filter(|unknown| unknown.solve(self.machine, self.any).is_some()).collect()
    }

    fn solved(&self, predictor: &Predictor, unknowns: &[Unknown<'a>]) -> Vec<Found<'a>> {
        predictor.begin();
        let found = unknowns.iter().filter_map(|unknown| {
            let x = unknown.solve(self.machine, predictor)?;
            unknown.found(self.machine, x)
        });
        found.collect()
    }

    /// Another value of one definition, with two slips that make it where there are any.
    fn of_definitions(&self, predictor: &Predictor) -> Vec<Found<'a>> {
        let mut found = Vec::new();
        for value in self.solved(predictor, self.definitions()) {
            let doubles = match value.causes[..] {
                [Cause::Definition(at, x)] => double::find(self.machine, predictor, &[at], (x, 1e-2 * x.abs())),
                _ => Vec::new(),
            };
            match doubles.is_empty() {
                true => found.push(value),
                false => found.extend(doubles),
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

/// Whether all numbers, read in one way, are those that something makes.
fn is_made((found, numbers): &(Found, Vec<f64>), predictor: &Predictor) -> bool {
    predictor.may_fit(&found.world) && predictor.agreeing(numbers) == numbers.len()
}

/// So many digits gains and forces have at most that were meant: some or other make any mistakes in one equation; by few digits, short
/// ones do.
fn most_digits(predictor: &Predictor) -> usize {
    PLAIN.min(known_digits(predictor).saturating_sub(SPARE))
}

/// The digits of the number that has the most.
fn known_digits(predictor: &Predictor) -> usize {
    predictor.numbers().iter().map(|(_, reading)| reading.digits).max().unwrap_or_default()
}

/// How all numbers that do not agree, some but so many at most, were written wrongly.
fn all_written<'a>(predictor: &Predictor, here: &[f64], most: usize) -> Option<Vec<Cause<'a>>> {
    let slips = written(predictor, here);
    let wrong = here.len() - predictor.agreeing(here);
    let explained: Vec<usize> = slips.iter().flat_map(|slip| slip.numbers.iter().copied()).collect();
    let is_all = (0..here.len()).all(|at| predictor.agrees(at, here[at]) || explained.contains(&at));
    if wrong == 0 || wrong > most || !is_all {
        return None;
    }
    // Two that were exchanged are told once.
    let mut left: Vec<usize> = explained;
    let mut causes = Vec::new();
    for slip in slips {
        if slip.numbers.iter().all(|at| left.contains(at)) {
            left.retain(|at| !slip.numbers.contains(at));
            causes.push(Cause::Written(slip.what));
        }
    }
    Some(causes)
}
