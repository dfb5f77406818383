//! The steady turns of a design: a curve from each of its capsize speeds, and those that begin elsewhere.

use carvallo::motion::{MotionInfo, PositionKind};
use carvallo::simulation::Machine;
use carvallo::turns::{Turn, Turns, TurnsEnd, TurnsError};
use carvallo::{CriticalKind, CriticalSpeed};
use carvallo_design::{Design, Failure, WithoutMachine};

use crate::analysis::simulation::Quantity;

/// Real parts below this, in 1/s, are zero but for the rounding of differences.
const ZERO: f64 = 1e-8;

/// All curves of a design.
#[derive(Debug)]
pub struct Families<'a> {
    /// What turns.
    pub design: &'a Design,
    /// What turns are told by: their positions, those that depend on others behind them.
    pub positions: Vec<(usize, Quantity)>,
    /// The rates that are not zero in a turn: of the yaw and the wheels.
    pub rates: Vec<(usize, Quantity)>,
    /// One for each capsize speed, and behind them those that begin elsewhere.
    pub families: Vec<Family>,
}

/// One curve.
#[derive(Debug)]
pub struct Family {
    /// The capsize speed at which it begins, in m/s, if it begins at one.
    pub capsize: Option<f64>,
    /// Where it begins.
    pub begin: TurnsEnd,
    /// Along the curve.
    pub turns: Vec<Turn>,
    /// Where it ends.
    pub end: TurnsEnd,
}

impl<'a> Families<'a> {
    /// The curves of a design, or of them the turns at which the steer, or what is steered last, has the given values.
    ///
    /// # Errors
    /// If there are none.
    pub fn new(design: &'a Design, steers: Option<&[f64]>) -> Result<Self, Failure> {
        let title = design.title();
        let fail = |message: String| Failure::Run(format!("{title}: {message}"));
        let stability = design.equations.stability(design.gravity().unwrap_or(0.0));
        let stability = stability.map_err(|error| fail(error.to_string()))?;
        let is_capsize = |critical: &&CriticalSpeed| critical.kind == CriticalKind::Capsize;
        let speeds: Vec<f64> = stability.critical_speeds.iter().filter(is_capsize).map(|found| found.speed).collect();
        let mut found: Result<Vec<Family>, String> = Ok(Vec::new());
        let mut told = [Vec::new(), Vec::new()];
        let machine = design.with_machine(&mut |machine| {
            told = quantities(machine.info());
            let steer = told[0].iter().rfind(|(place, _)| machine.info().positions[*place].kind == PositionKind::Free);
            let steer = steer.map_or(0, |(place, _)| *place);
            let family = |(capsize, curve): (Option<f64>, Turns)| {
                let turns = match steers {
                    None => curve.turns,
                    Some(steers) => {
                        let at = steers.iter().map(|&value| curve.where_position(machine, steer, value));
                        at.collect::<Result<Vec<_>, _>>()?.concat()
                    }
                };
                Ok(Family { capsize, begin: curve.begin, turns, end: curve.end })
            };
            found = curves(machine, &speeds)
                .and_then(|curves| curves.into_iter().map(family).collect::<Result<Vec<_>, TurnsError>>())
                .map_err(|error| error.to_string());
        });
        let families = found.map_err(fail)?;
        let is_closed = !matches!(machine, Err(WithoutMachine::Feedback(_)));
        if families.is_empty() && speeds.is_empty() && is_closed {
            return Err(fail("there is no capsize speed, at which steady turns begin".to_owned()));
        }
        machine.map_err(|without| fail(design.explain(&without)))?;
        let [positions, rates] = told;
        Ok(Self { design, positions, rates, families })
    }
}

/// The curve from each of some capsize speeds, and the others.
fn curves(machine: &dyn Machine, speeds: &[f64]) -> Result<Vec<(Option<f64>, Turns)>, TurnsError> {
    let from_capsize = |&speed: &f64| Turns::from_capsize(machine, speed);
    let known = speeds.iter().map(from_capsize).collect::<Result<Vec<_>, _>>()?;
    // What does not run on wheels has none.
    let others = Turns::others(machine, &known).unwrap_or_default();
    let known = speeds.iter().copied().map(Some).zip(known);
    Ok(known.chain(others.into_iter().map(|turns| (None, turns))).collect())
}

/// What turns are told by: positions, and rates.
fn quantities(info: &MotionInfo) -> [Vec<(usize, Quantity)>; 2] {
    let all = || {
        let positions = info.positions.iter().enumerate();
        positions.map(|(place, position)| {
            (position.kind, place, Quantity::new(position.name, position.label, position.unit))
        })
    };
    let of =
        |wanted: PositionKind| all().filter(move |(kind, ..)| *kind == wanted).map(|(_, place, told)| (place, told));
    let positions = of(PositionKind::Free).chain(of(PositionKind::Dependent)).collect();
    let rates = of(PositionKind::Ignorable).filter(|(_, told)| !matches!(told.name, "x" | "y")).collect();
    [positions, rates]
}

/// The largest real part of the eigenvalues near a turn, in 1/s.
pub fn growth(turn: &Turn) -> f64 {
    turn.eigenvalues.iter().map(|eigenvalue| eigenvalue.re).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether a turn is stable, in a word.
pub fn verdict(turn: &Turn) -> &'static str {
    match growth(turn) {
        growth if growth > ZERO => "unstable",
        growth if growth < -ZERO => "stable",
        _ => "marginal",
    }
}

/// Where a curve ends or begins, in words.
pub fn end(end: TurnsEnd) -> String {
    match end {
        TurnsEnd::Rest => "at rest, in an equilibrium".to_owned(),
        TurnsEnd::Straight => "in straight running".to_owned(),
        TurnsEnd::Fallen => "followed no further: it leans by 80 degrees, or is turned around".to_owned(),
        TurnsEnd::Fast => "followed no further: it becomes ever faster".to_owned(),
        TurnsEnd::Lost(Some(error)) => format!("followed no further: {error}"),
        _ => "followed no further".to_owned(),
    }
}
