//! What `carvallo check` makes of every slip in the formulas of the Whipple bicycle or in the attributes of its mechanism, and of two of
//! them at once: somebody has them, and has numbers of the benchmark bicycle that come from them.

use std::collections::BTreeMap;
use std::fmt;

use carvallo::{Coefficients, CriticalKind, MatrixName, Stability};
use carvallo_check::explain::{Cause, DoubleSlip};
use carvallo_check::given::{Accelerations, CriticalSpeed, Eigenvalues, Given, Kind, Reading, StateMatrix};
use carvallo_check::machine::Machine;
use carvallo_check::{Explanation, check_machine, words};
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_slips::{FormulaSlip, Kind as KindOfSlip, Slip, Values, slips};

/// What somebody has of the bicycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Evidence {
    /// The matrices M, C1, K0 and K2, to so many digits.
    Matrices(usize),
    /// The state matrix at 5 m/s.
    StateMatrix(usize),
    /// The eigenvalues at 2, 4 and 6 m/s.
    Eigenvalues(usize),
    /// The weave and capsize speeds.
    CriticalSpeeds(usize),
    /// The accelerations of lean and steer in two states by the nonlinear equations.
    Accelerations(usize),
}

/// All digits of a double.
pub const FULL: usize = 17;

/// At which eigenvalues are known, in m/s.
const SPEEDS: [f64; 3] = [2.0, 4.0, 6.0];

/// In which accelerations are known: speed in m/s, lean and steer in rad, their rates in rad/s.
const STATES: [(f64, [f64; 2], [f64; 2]); 2] = [(4.2, [0.3, -0.4], [-0.5, 0.7]), (6.5, [-0.2, 0.25], [0.9, -0.3])];

impl Evidence {
    /// Those that are measured of attributes beside all others: no slip in a formula of a matrix is in them.
    pub const OF_MOTION: [Self; 2] = [Self::Accelerations(FULL), Self::Accelerations(5)];

    /// Those that are measured.
    pub const ALL: [Self; 8] = [
        Self::Matrices(FULL),
        Self::Matrices(4),
        Self::StateMatrix(FULL),
        Self::StateMatrix(4),
        Self::Eigenvalues(FULL),
        Self::Eigenvalues(4),
        Self::CriticalSpeeds(FULL),
        Self::CriticalSpeeds(5),
    ];
}

impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, digits) = match self {
            Self::Matrices(digits) => ("M, C1, K0, K2", *digits),
            Self::StateMatrix(digits) => ("state matrix at 5 m/s", *digits),
            Self::Eigenvalues(digits) => ("eigenvalues at 2, 4 and 6 m/s", *digits),
            Self::CriticalSpeeds(digits) => ("weave and capsize speeds", *digits),
            Self::Accelerations(digits) => ("nonlinear accelerations in two states", *digits),
        };
        let digits = if digits == FULL { "all digits".to_owned() } else { format!("{digits} digits") };
        write!(f, "{what}, {digits}")
    }
}

/// What comes of a slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// It has no such numbers: it uses itself, divides by zero, or makes no critical speed.
    NoNumbers,
    /// Its numbers are the right ones, to the digits given.
    Silent,
    /// It is the one explanation.
    Alone,
    /// So are it and others that make the same numbers of every machine: they are one formula.
    WithEquals,
    /// With others that make the same matrices of this machine alone.
    WithOthersHere,
    /// Its group is the first of several that make these numbers.
    First,
    /// Its group is another one of these.
    Among,
    /// Only others make these numbers, by what is told.
    Wrong,
    /// Nothing is told.
    Nothing,
}

impl Outcome {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::NoNumbers,
        Self::Silent,
        Self::Alone,
        Self::WithEquals,
        Self::WithOthersHere,
        Self::First,
        Self::Among,
        Self::Wrong,
        Self::Nothing,
    ];
}

/// Outcomes, counted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// How many slips have each.
    pub outcomes: BTreeMap<Outcome, usize>,
    /// How many reports that name the slip have so many explanations in all.
    pub sizes: BTreeMap<usize, usize>,
}

impl Tally {
    /// How many have an outcome.
    pub fn count(&self, outcome: Outcome) -> usize {
        self.outcomes.get(&outcome).copied().unwrap_or_default()
    }

    /// How many of those that make other numbers than the right ones are named, and how many there are.
    pub fn named(&self) -> [usize; 2] {
        use Outcome::{Alone, Among, First, Nothing, WithEquals, WithOthersHere, Wrong};
        let sum = |outcomes: &[Outcome]| outcomes.iter().map(|own| self.count(*own)).sum::<usize>();
        let named = sum(&[Alone, WithEquals, WithOthersHere, First, Among]);
        [named, named + sum(&[Wrong, Nothing])]
    }

    /// How many reports that name the slip have explanations in this range.
    pub fn of_size(&self, sizes: std::ops::RangeInclusive<usize>) -> usize {
        self.sizes.range(sizes).map(|(_, count)| count).sum()
    }

    fn add(&mut self, outcome: Outcome, size: usize) {
        *self.outcomes.entry(outcome).or_default() += 1;
        if size > 0 {
            *self.sizes.entry(size).or_default() += 1;
        }
    }

    fn merge(&mut self, other: &Self) {
        for (outcome, count) in &other.outcomes {
            *self.outcomes.entry(*outcome).or_default() += count;
        }
        for (size, count) in &other.sizes {
            *self.sizes.entry(*size).or_default() += count;
        }
    }
}

/// The benchmark bicycle, with all slips of its formulas.
///
/// # Panics
/// If its formulas cannot be read.
pub fn benchmark() -> Machine {
    Machine::with(Whipple::<f64>::INFO, &Whipple::<f64>::BENCHMARK.to_array()).expect("formulas that can be read")
}

/// The same bicycle as a mechanism, with all slips of its attributes.
///
/// # Panics
/// If its formulas cannot be read.
pub fn mechanism() -> Machine {
    let parameters = WhippleMechanism::<f64>::BENCHMARK.to_array();
    Machine::with(WhippleMechanism::<f64>::INFO, &parameters).expect("formulas that can be read")
}

/// What comes of every so many of the slips in the attributes of a mechanism on which such numbers depend, on all processors.
pub fn measure_attributes(machine: &Machine, evidence: Evidence, every: usize) -> Tally {
    let is_of_motion = matches!(evidence, Evidence::Accelerations(_));
    let is_of_attribute = |own: &&FormulaSlip| {
        let formula = own.formulas[0];
        let is_used = is_of_motion || !machine.formulas.dependents(formula).is_empty();
        machine.formulas.formulas[formula].is_of_mechanism && is_used
    };
    let slips: Vec<&FormulaSlip> = plain(machine).filter(is_of_attribute).step_by(every).collect();
    on_all_processors(&slips, &|slip| judge(machine, evidence, slip))
}

/// How many slips there are, those among them that are no formulas.
pub fn count(machine: &Machine) -> usize {
    let of = |text: &str| slips(text, &machine.formulas.names).into_iter().filter(is_plain).count();
    machine.formulas.formulas.iter().map(|formula| of(formula.text)).sum()
}

fn is_plain(slip: &Slip) -> bool {
    KindOfSlip::PLAIN.contains(&slip.kind)
}

/// What comes of every so many of the slips, each in one formula, on all processors.
pub fn measure(machine: &Machine, evidence: Evidence, every: usize) -> Tally {
    let slips: Vec<&FormulaSlip> = plain(machine).step_by(every).collect();
    on_all_processors(&slips, &|slip| judge(machine, evidence, slip))
}

fn plain(machine: &Machine) -> impl Iterator<Item = &FormulaSlip> {
    machine.slips().iter().filter(|own| own.formulas.len() == 1 && is_plain(&own.slip))
}

/// What comes of so many random pairs of slips, the same on every run: of all slips, or of those that make sense by their units.
pub fn measure_pairs(machine: &Machine, evidence: Evidence, count: usize, has_sense: bool) -> Tally {
    let slips: Vec<&FormulaSlip> = plain(machine).filter(|own| own.makes_sense || !has_sense).collect();
    // Knuth's generator (MMIX), the upper bits of which are random enough.
    let mut state = 1899_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        slips[(state >> 33) as usize % slips.len()]
    };
    let pairs: Vec<[&FormulaSlip; 2]> = (0..count).map(|_| [next(), next()]).collect();
    on_all_processors(&pairs, &|pair| judge_pair(machine, evidence, pair))
}

fn on_all_processors<T: Copy + Send + Sync>(all: &[T], judge: &(dyn Fn(T) -> (Outcome, usize) + Sync)) -> Tally {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut tally = Tally::default();
    std::thread::scope(|scope| {
        let part = |first: usize| {
            let own = all.iter().skip(first).step_by(threads).copied().collect::<Vec<_>>();
            scope.spawn(move || {
                let mut tally = Tally::default();
                for one in own {
                    let (outcome, size) = judge(one);
                    tally.add(outcome, size);
                }
                tally
            })
        };
        let parts: Vec<_> = (0..threads).map(part).collect();
        for part in parts {
            tally.merge(&part.join().expect("a check that does not panic"));
        }
    });
    tally
}

/// What comes of a slip, and of how many explanations the report is that names it.
pub fn judge(machine: &Machine, evidence: Evidence, slip: &FormulaSlip) -> (Outcome, usize) {
    let mut values = machine.values.clone();
    let is_any = slip.apply(&machine.formulas, &machine.parameters, &machine.values, &mut values);
    let given = if is_any { given(machine, evidence, &values) } else { None };
    outcome(machine, given, &[words(machine, &Cause::Slip(slip))])
}

/// The same of two slips at once. Those that stand in each other's place, need each other, or are not seen alone make none.
pub fn judge_pair(machine: &Machine, evidence: Evidence, [a, b]: [&FormulaSlip; 2]) -> (Outcome, usize) {
    let formulas = &machine.formulas;
    let sees = |slip: &FormulaSlip| {
        let mut values = machine.values.clone();
        let is_any = slip.apply(formulas, &machine.parameters, &machine.values, &mut values);
        let given = if is_any { given(machine, evidence, &values) } else { None };
        given.and_then(|given| check_machine(&given, machine).ok()).is_some_and(|report| !report.agrees)
    };
    let mut values = machine.values.clone();
    let causes = if a.formulas == b.formulas {
        let [first, second] = if a.slip.place.start <= b.slip.place.start { [a, b] } else { [b, a] };
        if first.slip.place.end > second.slip.place.start {
            return (Outcome::NoNumbers, 0);
        }
        let slips = [first.slip.clone(), second.slip.clone()];
        let double = DoubleSlip { formulas: a.formulas.clone(), slips };
        let changed = formulas.parse(a.formulas[0], &double.apply(formulas.formulas[a.formulas[0]].text));
        let Some(changed) = changed.filter(|changed| !formulas.is_circular(&a.formulas, changed)) else {
            return (Outcome::NoNumbers, 0);
        };
        formulas.change(&a.formulas, &changed, &machine.parameters, &mut values);
        vec![words(machine, &Cause::Slips(double))]
    } else {
        let uses = |slip: &FormulaSlip, other: &FormulaSlip| formulas.uses(&slip.changed, other.formulas[0]);
        if a.is_circular || b.is_circular || (uses(a, b) && uses(b, a)) {
            return (Outcome::NoNumbers, 0);
        }
        let affected = formulas.affected([a.formulas[0], b.formulas[0]]);
        let both = [(&a.formulas[..], &a.changed), (&b.formulas[..], &b.changed)];
        formulas.change_both(both, &affected, &machine.parameters, &mut values);
        [a, b].map(|slip| words(machine, &Cause::Slip(slip))).to_vec()
    };
    if !(sees(a) && sees(b)) {
        return (Outcome::Silent, 0);
    }
    outcome(machine, given(machine, evidence, &values), &causes)
}

/// What comes of numbers that somebody has by these causes, in any order.
fn outcome(machine: &Machine, given: Option<Given>, causes: &[String]) -> (Outcome, usize) {
    let Some(report) = given.and_then(|given| check_machine(&given, machine).ok()) else {
        return (Outcome::NoNumbers, 0);
    };
    if report.agrees {
        return (Outcome::Silent, 0);
    }
    if report.explanations.is_empty() {
        return (Outcome::Nothing, 0);
    }
    let is_own = |it: &Explanation| it.causes.len() == causes.len() && causes.iter().all(|own| it.causes.contains(own));
    let found = report.explanations.iter().position(|group| group.explanations.iter().any(is_own));
    let Some(found) = found else { return (Outcome::Wrong, 0) };
    let group = &report.explanations[found].explanations;
    let size = report.explanations.iter().map(|group| group.explanations.len()).sum();
    let outcome = match (report.explanations.len(), group.len()) {
        (1, 1) => Outcome::Alone,
        (1, _) if group.iter().all(|it| it.class == group[0].class) => Outcome::WithEquals,
        (1, _) => Outcome::WithOthersHere,
        _ if found == 0 => Outcome::First,
        _ => Outcome::Among,
    };
    (outcome, size)
}

/// The numbers of somebody who has these values of formulas; `None` where there are none.
fn given(machine: &Machine, evidence: Evidence, values: &Values) -> Option<Given> {
    let entries = &values.entries;
    if entries.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let rows = |matrix: usize| [0, 2].map(|row| [0, 1].map(|column| entries[4 * matrix + row + column]));
    let coefficients = Coefficients::from_rows([0, 1, 2, 3, 4, 5, 6, 7].map(rows));
    let gravity = Whipple::<f64>::BENCHMARK.g;
    Some(match evidence {
        Evidence::Matrices(digits) => {
            let matrix = |name: MatrixName| {
                let at = MatrixName::ALL.iter().position(|own| *own == name).unwrap_or_default();
                (name, rows(at).map(|row| row.map(|entry| Some(Reading::rounded(entry, digits))).to_vec()).to_vec())
            };
            let matrices = [MatrixName::M, MatrixName::C1, MatrixName::K0, MatrixName::K2].map(matrix).to_vec();
            Given { matrices, ..Given::default() }
        }
        Evidence::StateMatrix(digits) => {
            const SPEED: f64 = 5.0;
            let space = coefficients.at(SPEED, gravity).ok()?.state_space().ok()?;
            let entry = |row: usize, column: usize| match (row, column) {
                (0 | 1, _) => f64::from(u8::from(column == row + 2)),
                (_, 0 | 1) => space.stiffness[(row - 2, column)],
                _ => space.damping[(row - 2, column - 2)],
            };
            let reading = |row: usize, column: usize| Some(Reading::rounded(entry(row, column), digits));
            let rows = (0..4).map(|row| (0..4).map(|column| reading(row, column)).collect()).collect();
            Given { state_matrices: vec![StateMatrix { speed: SPEED, rows }], ..Given::default() }
        }
        Evidence::Eigenvalues(digits) => {
            let at = |speed: f64| {
                let values = coefficients.at(speed, gravity).ok()?.eigenvalues().ok()?;
                let reading = |value: f64| Reading::rounded(value, digits);
                let values = values.iter().map(|value| (reading(value.re), Some(reading(value.im)))).collect();
                Some(Eigenvalues { speed, values })
            };
            let eigenvalues = SPEEDS.into_iter().map(at).collect::<Option<_>>()?;
            Given { eigenvalues, ..Given::default() }
        }
        Evidence::CriticalSpeeds(digits) => {
            let stability = Stability::new(&coefficients, gravity).ok()?;
            let known = stability.critical_speeds.iter().filter(|own| own.kind != CriticalKind::DoubleRoot);
            let critical_speeds: Vec<CriticalSpeed> = known
                .map(|own| CriticalSpeed {
                    kind: Some(own.kind),
                    name: format!("{} speed", own.kind),
                    speed: Reading::rounded(own.speed, digits),
                })
                .collect();
            if critical_speeds.is_empty() {
                return None;
            }
            Given { critical_speeds, ..Given::default() }
        }
        Evidence::Accelerations(digits) => return of_motion(machine, digits, &machine.attributes(values)),
    })
}

/// The accelerations of a mechanism with these attributes.
fn of_motion(machine: &Machine, digits: usize, attributes: &[f64]) -> Option<Given> {
    let motion = machine.motion.as_ref()?;
    let of = |(speed, positions, rates): (f64, [f64; 2], [f64; 2])| {
        let (positions, rates, forces) = (positions.to_vec(), rates.to_vec(), vec![0.0; 2]);
        let equations = Some(Kind::Nonlinear);
        let given = Accelerations { equations, speed, positions, rates, forces, values: Vec::new() };
        let found = motion.with_attributes(&given, attributes, &machine.parameters, &[])?;
        let values = found.iter().map(|value| Some(Reading::rounded(*value, digits))).collect();
        Some(Accelerations { values, ..given })
    };
    let accelerations = STATES.into_iter().map(of).collect::<Option<_>>()?;
    Some(Given { accelerations, ..Given::default() })
}
