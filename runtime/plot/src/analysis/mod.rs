//! What is computed for a design, once, for every way of showing it.

pub mod along;
pub mod columns;
pub mod compare;
#[cfg(feature = "control")]
pub mod controllability;
#[cfg(feature = "control")]
pub mod excitation;
mod followed;
pub mod reach;
#[cfg(feature = "control")]
pub mod response;
pub mod sensitivity;
pub mod simulation;
pub mod strands;
pub mod traced;
#[cfg(feature = "control")]
pub mod transfer;
#[cfg(feature = "turns")]
pub mod turns;

use std::cmp::Ordering;
use std::ops::RangeInclusive;

use carvallo::{
    Branches, Complex, CriticalKind, CriticalSpeed, Mode, ModeValue, ModelInfo, Stability, StableRange, SystemError,
    Verdict, sort_by,
};
use carvallo_design::number::shortest;
use carvallo_design::{Design, DisplayUnit, Failure, Shape};

use self::followed::Followed;
use self::reach::reach;

/// Sizes beyond which a parameter makes the others vanish in rounding, or leaves the range of doubles.
const ORDINARY: RangeInclusive<f64> = 1e-20..=1e20;

/// Real parts that differ by less than this, relative to the largest eigenvalue, differ by rounding.
pub const ROUNDING: f64 = 1e-12;

/// The coordinates of a bicycle; only for them alone all modes have names.
const BICYCLE: [&str; 2] = ["lean", "steer"];

/// What a kind of critical speed is called in the words of the field: capsize and weave of machines that lean and steer,
/// divergence and flutter of any other.
pub fn kind(kind: CriticalKind, info: &ModelInfo) -> &'static str {
    match (kind, leans_and_steers(info)) {
        (CriticalKind::Weave, true) => "weave",
        (CriticalKind::Weave, false) => "flutter",
        (CriticalKind::Capsize, true) => "capsize",
        (CriticalKind::Capsize, false) => "divergence",
        (CriticalKind::DoubleRoot, _) => "double_root",
    }
}

/// What one critical speed is called: its kind, and wobble where what weaves is too fast for it, which takes more coordinates
/// than lean and steer.
pub fn name(critical: &CriticalSpeed, info: &ModelInfo) -> &'static str {
    let mode = critical.mode(leans_and_steers(info)).filter(|_| critical.kind == CriticalKind::Weave);
    if mode == Some(Mode::Wobble) && !is_bicycle(info) { "wobble" } else { kind(critical.kind, info) }
}

/// Whether lean and steer are among the coordinates, as those of bicycles and motorcycles.
pub fn leans_and_steers(info: &ModelInfo) -> bool {
    BICYCLE.iter().all(|label| info.coordinates.iter().any(|coordinate| coordinate.label == *label))
}

fn is_bicycle(info: &ModelInfo) -> bool {
    info.coordinates.iter().map(|coordinate| coordinate.label).eq(BICYCLE)
}

/// A design with everything about it along speed.
pub struct Analysis {
    /// What is analyzed.
    pub design: Design,
    /// Its critical speeds and stable ranges.
    pub stability: Stability,
    followed: Followed,
    /// The speed in m/s up to which there is something to see.
    pub reach: f64,
    /// What speeds are shown in: m/s, unless it is replaced.
    pub unit: DisplayUnit,
}

/// What there is at one speed.
pub struct Row<V> {
    /// In m/s; along another parameter its value.
    pub speed: f64,
    /// The eigenvalues.
    pub values: V,
}

/// The eigenvalues at one speed, in the order of their modes.
pub type ModeRow = Row<[ModeValue; 4]>;

/// The eigenvalues at one speed: followed ones in the order of their branches, others sorted by real part, and where real
/// parts are equal up to rounding, by the size of the imaginary part: so their order is the same on every machine, and pairs
/// stay together.
pub struct Eigenvalues {
    /// In 1/s.
    pub values: Vec<ModeValue>,
    /// Whether the motion is stable.
    pub verdict: Verdict,
}

/// The eigenvalues at several speeds; for a model that does not depend on the speed there is one row.
pub enum Rows {
    /// Followed mode by mode.
    Modes(Vec<ModeRow>),
    /// Followed one by one.
    Branches(Vec<Row<Eigenvalues>>),
    /// Of what does not depend on the speed.
    Sorted(Vec<Row<Eigenvalues>>),
}

impl Rows {
    /// The same with speeds in the unit that they are shown in.
    pub(crate) fn shown_in(self, unit: &DisplayUnit) -> Self {
        fn shown<V>(rows: Vec<Row<V>>, unit: &DisplayUnit) -> Vec<Row<V>> {
            rows.into_iter().map(|row| Row { speed: unit.value(row.speed), ..row }).collect()
        }
        match self {
            rows if unit.is_declared() => rows,
            Self::Modes(rows) => Self::Modes(shown(rows, unit)),
            Self::Branches(rows) => Self::Branches(shown(rows, unit)),
            Self::Sorted(rows) => Self::Sorted(rows),
        }
    }

    /// The speeds with their eigenvalues.
    pub fn values(&self) -> Vec<(f64, &[ModeValue])> {
        match self {
            Self::Modes(rows) => rows.iter().map(|row| (row.speed, row.values.as_slice())).collect(),
            Self::Branches(rows) | Self::Sorted(rows) => {
                rows.iter().map(|row| (row.speed, row.values.values.as_slice())).collect()
            }
        }
    }
}

impl Analysis {
    /// Everything about a design.
    ///
    /// # Errors
    /// If the equations of motion have no answer, such as for a singular mass matrix.
    pub fn new(design: Design) -> Result<Self, Failure> {
        let gravity = design.gravity().unwrap_or(0.0);
        let fail = |error: SystemError| Failure::Run(format!("{}: {error}{}", design.title(), extremes(&design)));
        let stability = design.equations.stability(gravity).map_err(fail)?;
        let info = design.info();
        let reach = reach(&stability, leans_and_steers(info));
        let followed = Followed::new(design.model, &*design.equations, gravity, &stability, reach).map_err(fail)?;
        Ok(Self { design, stability, followed, reach, unit: DisplayUnit::declared("m/s") })
    }

    /// All of them, ascending.
    pub fn critical_speeds(&self) -> &[CriticalSpeed] {
        &self.stability.critical_speeds
    }

    /// All of them, ascending.
    pub fn stable_ranges(&self) -> &[StableRange] {
        &self.stability.stable_ranges
    }

    /// Whether every motion dies away at a speed.
    pub fn is_stable(&self, speed: f64) -> bool {
        self.stability.verdict(speed) == Ok(Verdict::Stable)
    }

    /// The modes that columns are for, each as often as it has eigenvalues at some speed; none without names of modes.
    pub fn mode_columns(&self) -> Vec<Mode> {
        match &self.followed {
            Followed::Bicycle(modes) => modes.all(),
            Followed::Any(_) | Followed::Not => Vec::new(),
        }
    }

    /// The eigenvalues at each of the speeds; none at rest where there are no equations of motion.
    ///
    /// # Errors
    /// If they cannot be computed at one of them.
    pub fn rows(&self, speeds: &[f64]) -> Result<Rows, Failure> {
        let speeds: Vec<f64> = speeds.iter().copied().filter(|speed| self.has_equations_at(*speed)).collect();
        let speeds = speeds.as_slice();
        Ok(match &self.followed {
            Followed::Bicycle(modes) => Rows::Modes(self.each(speeds, |speed| modes.at(speed))?),
            Followed::Any(branches) => Rows::Branches(self.each(speeds, |speed| self.branches_at(branches, speed))?),
            Followed::Not => Rows::Sorted(self.each(&[0.0], |_| self.sorted())?),
        })
    }

    /// Where eigenvalues that are followed one by one meet.
    pub fn meetings(&self) -> Vec<f64> {
        match &self.followed {
            Followed::Any(branches) => branches.meetings().iter().map(|meeting| meeting.speed).collect(),
            Followed::Bicycle(_) | Followed::Not => Vec::new(),
        }
    }

    /// Whether there are equations of motion at a speed: at rest there may be none.
    pub fn has_equations_at(&self, speed: f64) -> bool {
        speed != 0.0 || self.design.equations.without_rest().is_none()
    }

    /// The eigenvectors at the speed of a row, in the order of its eigenvalues.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    pub fn shapes(&self, speed: f64, values: &[ModeValue]) -> Result<Vec<Shape>, Failure> {
        let gravity = self.design.gravity().unwrap_or(0.0);
        let values: Vec<Complex<f64>> = values.iter().map(|value| value.value).collect();
        let shapes = self.design.equations.eigenvectors(speed, gravity, &values);
        shapes.map_err(|error| Failure::Run(format!("{} at {} m/s: {error}", self.design.title(), shortest(speed))))
    }

    fn each<V>(&self, speeds: &[f64], values: impl Fn(f64) -> Result<V, SystemError>) -> Result<Vec<Row<V>>, Failure> {
        let row = |&speed: &f64| match values(speed) {
            Ok(values) => Ok(Row { speed, values }),
            Err(error) => {
                let (name, hint) = (self.design.title(), extremes(&self.design));
                let at = format!(" at {} m/s", shortest(speed));
                let at = if self.design.model.depends_on_speed() { at } else { String::new() };
                Err(Failure::Run(format!("{name}{at}: {error}{hint}")))
            }
        };
        speeds.iter().map(row).collect()
    }

    fn branches_at(&self, branches: &Branches, speed: f64) -> Result<Eigenvalues, SystemError> {
        Ok(Eigenvalues { values: branches.at(speed)?, verdict: self.stability.verdict(speed)? })
    }

    fn sorted(&self) -> Result<Eigenvalues, SystemError> {
        let mut values = self.design.equations.eigenvalues(0.0, self.design.gravity().unwrap_or(0.0))?;
        let unit = (ROUNDING * largest(values.iter().copied())).max(f64::MIN_POSITIVE);
        let key = |value: &Complex<f64>| [(value.re / unit).round(), value.im.abs(), value.im];
        sort_by(&mut values, |a, b| key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal));
        let mode = |value: Complex<f64>| if value.im == 0.0 { Mode::Real } else { Mode::Oscillatory };
        let values = values.into_iter().map(|value| ModeValue { mode: mode(value), value }).collect();
        Ok(Eigenvalues { values, verdict: self.stability.verdict(0.0)? })
    }
}

/// The size of the largest eigenvalue.
pub fn largest(values: impl Iterator<Item = Complex<f64>>) -> f64 {
    values.map(|value| value.norm()).fold(0.0, f64::max)
}

/// Why a motion that grows is told no further.
const OUT_OF_RANGE: &str = "the motion then leaves the range of floating-point numbers";
/// Why one that stays within the range of doubles is.
const TOO_LONG: &str = "the steps to it are too long for floating-point numbers to tell what moves fastest in them";

/// The parameters that are probably to blame where there is no answer, as the end of a sentence.
pub fn extremes(design: &Design) -> String {
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let extremes = parameters.filter(|(_, given)| given.value != 0.0 && !ORDINARY.contains(&given.value.abs()));
    let extremes: Vec<String> =
        extremes.map(|(info, given)| format!("{} = {}", info.name, shortest(given.value))).collect();
    if extremes.is_empty() { String::new() } else { format!("; parameters of extreme size: {}", extremes.join(", ")) }
}
