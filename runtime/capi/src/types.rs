//! What C sees of results: plain numbers and codes.

use std::ffi::c_char;

use carvallo::{Change, CriticalKind, StableRange, States, UndecidedRange, Verdict};
use carvallo_design::Shipped;

/// What became of a call. carvallo_message() says more.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarvalloStatus {
    /// The answer is there.
    Ok = 0,
    /// A pointer is NULL that must not be, or is not aligned.
    NullPointer = 1,
    /// An array has not the right number of elements, or an index is too large.
    WrongSize = 2,
    /// There is no model, parameter set, file, parameter or matrix of that name.
    UnknownName = 3,
    /// A parameter, a requirement of the model or a matrix is not what it must be.
    Invalid = 4,
    /// There is no answer: such as with a mass matrix that is singular, or where a number leaves the range of doubles.
    NoAnswer = 5,
    /// A mistake in the library, which you should report.
    Panicked = 6,
}

/// What happens at a critical speed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarvalloKind {
    /// A conjugate pair of eigenvalues is on the imaginary axis: weave, wobble, flutter.
    Weave = 0,
    /// A real eigenvalue is zero: capsize, divergence.
    Capsize = 1,
    /// Two eigenvalues coincide that do not coincide at neighbouring speeds.
    DoubleRoot = 2,
}

/// What changes at a critical speed as the speed grows, of the eigenvalue or the pair.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarvalloChange {
    /// It leaves the right half-plane.
    Stabilizes = 0,
    /// It enters the right half-plane.
    Destabilizes = 1,
    /// Two real eigenvalues become a conjugate pair.
    Merges = 2,
    /// A conjugate pair becomes two real eigenvalues.
    Splits = 3,
    /// As many are on each side, or real, before and after.
    Touches = 4,
}

/// Whether the motion is stable at one speed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarvalloVerdict {
    /// Every eigenvalue has a negative real part.
    Stable = 0,
    /// No eigenvalue has a positive real part, and one has a real part of zero.
    Marginal = 1,
    /// An eigenvalue has a positive real part.
    Unstable = 2,
}

/// Which of the position and the rate of a coordinate are states.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarvalloStates {
    /// Both.
    Both = 0,
    /// Its position alone: a coordinate of first order, whose column of M is zero.
    Position = 1,
    /// Its rate alone: its columns of all stiffness matrices are zero.
    Rate = 2,
}

/// A complex number; an array of them is one of `double complex` and of `std::complex<double>`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

/// A speed above zero at which the kind of motion changes.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// What happens there.
    pub kind: CarvalloKind,
    /// What changes as the speed grows.
    pub change: CarvalloChange,
    /// The speed in m/s.
    pub speed: f64,
    /// An estimate of its error in m/s, by rounding of the matrices and of its own.
    pub error: f64,
    /// The eigenvalue in 1/s: zero, on the upper imaginary axis, or double.
    pub eigenvalue: Complex,
}

/// An open range of speeds.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; HUGE_VAL, which is infinite, if it has none.
    pub to: f64,
}

/// The coefficient matrices of M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f, each with n * n entries
/// row by row; NULL for those that are zero. Set all of it to zero first: carvallo_matrices_t matrices = {0};
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Matrices {
    /// The number of coordinates, from 1 to 12.
    pub n: usize,
    /// Mass matrix M; not NULL.
    pub m: *const f64,
    /// Damping C-1, divided by v.
    pub cm1: *const f64,
    /// Damping C0.
    pub c0: *const f64,
    /// Damping C1, multiplied by v.
    pub c1: *const f64,
    /// Stiffness Kc.
    pub kc: *const f64,
    /// Stiffness K0, multiplied by the gravity.
    pub k0: *const f64,
    /// Stiffness K1, multiplied by v.
    pub k1: *const f64,
    /// Stiffness K2, multiplied by v^2.
    pub k2: *const f64,
    /// The gravitational field strength g in N/kg.
    pub gravity: f64,
    /// For each coordinate one of carvallo_states_t; NULL if both position and rate of all are states.
    pub states: *const i32,
}

/// The values of one parameter, for many designs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// The name of the parameter.
    pub name: *const c_char,
    /// Its value in each design, in its unit.
    pub values: *const f64,
}

/// Stability of one of many designs.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Whether there is an answer; else all that follows is zero.
    pub status: CarvalloStatus,
    /// How many critical speeds there are, double roots among them.
    pub critical_speeds: usize,
    /// How many stable ranges there are.
    pub stable_ranges: usize,
    /// How many ranges are undecided: where rounding decides.
    pub undecided: usize,
    /// The first of the stable ranges; both ends zero if there is none.
    pub stable: Range,
}

/// Critical speeds and stable ranges of a machine, as it was when they were asked for.
#[derive(Debug)]
pub struct Stability {
    pub(crate) model: &'static Shipped,
    pub(crate) values: Vec<f64>,
    pub(crate) found: carvallo::Stability,
    pub(crate) critical_speeds: Vec<CriticalSpeed>,
    pub(crate) stable_ranges: Vec<Range>,
    pub(crate) undecided: Vec<Range>,
}

impl Stability {
    /// What was found for a model with these values of its parameters.
    pub(crate) fn new(model: &'static Shipped, values: Vec<f64>, found: carvallo::Stability) -> Self {
        Self {
            model,
            values,
            critical_speeds: found.critical_speeds.iter().map(CriticalSpeed::from).collect(),
            stable_ranges: found.stable_ranges.iter().copied().map(Range::from).collect(),
            undecided: found.undecided.iter().copied().map(Range::from).collect(),
            found,
        }
    }
}

impl From<&carvallo::CriticalSpeed> for CriticalSpeed {
    fn from(critical: &carvallo::CriticalSpeed) -> Self {
        let kind = match critical.kind {
            CriticalKind::Weave => CarvalloKind::Weave,
            CriticalKind::Capsize => CarvalloKind::Capsize,
            CriticalKind::DoubleRoot => CarvalloKind::DoubleRoot,
        };
        let change = match critical.change {
            Change::Stabilizes => CarvalloChange::Stabilizes,
            Change::Destabilizes => CarvalloChange::Destabilizes,
            Change::Merges => CarvalloChange::Merges,
            Change::Splits => CarvalloChange::Splits,
            Change::Touches => CarvalloChange::Touches,
        };
        let carvallo::CriticalSpeed { speed, error, eigenvalue, .. } = *critical;
        Self { kind, change, speed, error, eigenvalue: eigenvalue.into() }
    }
}

impl From<carvallo::Complex<f64>> for Complex {
    fn from(value: carvallo::Complex<f64>) -> Self {
        Self { re: value.re, im: value.im }
    }
}

impl From<Complex> for carvallo::Complex<f64> {
    fn from(value: Complex) -> Self {
        Self::new(value.re, value.im)
    }
}

impl From<StableRange> for Range {
    fn from(range: StableRange) -> Self {
        Self { from: range.from, to: range.to.unwrap_or(f64::INFINITY) }
    }
}

impl From<UndecidedRange> for Range {
    fn from(range: UndecidedRange) -> Self {
        Self { from: range.from, to: range.to }
    }
}

impl From<Verdict> for CarvalloVerdict {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Stable => Self::Stable,
            Verdict::Marginal => Self::Marginal,
            Verdict::Unstable => Self::Unstable,
        }
    }
}

impl CarvalloStates {
    /// What a number of C stands for, if it is one of them.
    pub(crate) fn of(code: i32) -> Option<States> {
        let all = [(Self::Both, States::Both), (Self::Position, States::Position), (Self::Rate, States::Rate)];
        all.into_iter().find(|(known, _)| *known as i32 == code).map(|(_, states)| states)
    }
}
