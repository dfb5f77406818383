//! Speeds in another unit.

use carvallo::{MatrixName, ModelInfo};
use carvallo_design::feedback::Law;

use super::{Assignment, Convention, Effect};

/// All of them, where anything depends on the speed.
pub fn speeds(info: &ModelInfo, laws: &[Law]) -> Vec<Convention> {
    let mut gains = laws.iter().flat_map(|law| &law.gains);
    if !info.depends_on_speed() && gains.all(|gain| power(gain.matrix) == 0) {
        return Vec::new();
    }
    units().into_iter().map(|(what, factor)| Convention::of_speeds(what, factor, laws)).collect()
}

/// What may have been done to all speeds, in words, and by which factor of them the numbers are.
pub fn units() -> Vec<(String, f64)> {
    let units = [("km/h", 3.6), ("miles per hour", 1.0 / 0.44704), ("feet per second", 1.0 / 0.3048)];
    let both = |(unit, value): (&str, f64)| {
        [
            (format!("speeds are in {unit} in the place of m/s"), 1.0 / value),
            (format!("speeds in m/s were taken for {unit} and converted"), value),
        ]
    };
    units.into_iter().flat_map(both).collect()
}

impl Convention {
    /// All speeds are others by a factor; those of the feedback, too.
    pub fn of_speeds(what: impl Into<String>, factor: f64, laws: &[Law]) -> Self {
        let gains = laws.iter().flat_map(|law| &law.gains).map(|gain| factor.powi(power(gain.matrix))).collect();
        Self { what: what.into(), effect: Effect::Speeds(factor, gains), rank: 0 }
    }
}

/// What other speeds make of entries.
pub(super) fn assignments(factor: f64, count: usize) -> Vec<Assignment> {
    let scale = |at: usize| Assignment::times(at, at, factor.powi(power(MatrixName::ALL[at / (count * count)])));
    let all = (0..MatrixName::ALL.len() * count * count).map(scale);
    all.filter(|own| own.factor != 1.0).collect()
}

/// The power of the speed that stands before a matrix.
pub fn power(matrix: MatrixName) -> i32 {
    match matrix {
        MatrixName::Cm1 => -1,
        MatrixName::C1 | MatrixName::K1 => 1,
        MatrixName::K2 => 2,
        MatrixName::M | MatrixName::C0 | MatrixName::Kc | MatrixName::K0 => 0,
    }
}
