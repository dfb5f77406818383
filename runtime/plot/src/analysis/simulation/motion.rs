//! A motion as it is told, whichever equations it is of.

use carvallo::sort_by;
use carvallo_design::Design;
use carvallo_design::feedback::forces;
use carvallo_design::number::by_time;

use super::watch::Happened;

/// The order in which quantities of bicycles are told: that of the paper.
const ORDER: [&str; 8] = ["x", "y", "psi", "phi", "pitch", "delta", "thetaR", "thetaF"];

/// The places of quantities in the order in which they are told: of bicycles that of the paper, of others their own.
pub fn order(quantities: &[Quantity]) -> Vec<usize> {
    let place = |quantity: &Quantity| ORDER.iter().position(|name| *name == quantity.name);
    let mut places: Vec<usize> = (0..quantities.len()).collect();
    if quantities.iter().all(|quantity| place(quantity).is_some()) {
        sort_by(&mut places, |&a, &b| place(&quantities[a]).cmp(&place(&quantities[b])));
    }
    places
}

/// Something that moves, with its symbol, what it is, and the unit of its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its symbol.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
    /// Of its position.
    pub unit: &'static str,
}

impl Quantity {
    /// A quantity by its symbol, what it is, and the unit of its position.
    pub const fn new(name: &'static str, label: &'static str, unit: &'static str) -> Self {
        Self { name, label, unit }
    }

    /// The unit of its rate, or with `power` 2 of its acceleration.
    pub fn unit_per_time(&self, power: u32) -> String {
        by_time(self.unit, power)
    }
}

/// A motion, row by row.
#[derive(Debug)]
pub struct Motion<'a> {
    /// What moves.
    pub design: &'a Design,
    /// Whether it is by the linear equations.
    pub is_linear: bool,
    /// In the order in which they are told.
    pub quantities: Vec<Quantity>,
    /// The wheels that touch the ground, where the forces on them are known.
    pub wheels: Vec<&'static str>,
    /// Ascending in time.
    pub rows: Vec<Row>,
    /// What was watched for and happened, in its order.
    pub events: Vec<Happened>,
    /// Why it ended before its time, if it did.
    pub end: Option<String>,
    /// What else is to be known of it.
    pub notes: Vec<String>,
}

/// A motion at one time, in SI units.
#[derive(Clone, Debug)]
pub struct Row {
    /// In s.
    pub t: f64,
    /// Of each quantity.
    pub positions: Vec<f64>,
    /// Of each quantity.
    pub rates: Vec<f64>,
    /// Of each quantity.
    pub accelerations: Vec<f64>,
    /// Kinetic and potential, in J.
    pub energy: Option<[f64; 2]>,
    /// The force of the ground on each wheel, in N.
    pub contact_forces: Vec<[f64; 3]>,
    /// The force of each law of feedback, in the order of the design.
    pub feedback: Vec<f64>,
}

impl Motion<'_> {
    /// Where a quantity stands in the rows.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.quantities.iter().position(|quantity| quantity.name == name)
    }

    /// The forces that follow from the motion, in the order of the design: what they are called, and their units as models declare
    /// them.
    pub fn feedback(&self) -> Vec<(String, &'static str)> {
        self.design.feedback.iter().map(|law| law.force(self.design.info())).collect()
    }

    /// The forward speed in m/s, of bicycles that of the rear wheel: -rR thetaR'.
    pub fn speed(&self, row: &Row) -> Option<f64> {
        let (radius, wheel) = (self.design.value("rR")?, self.position("thetaR")?);
        Some(-radius * row.rates[wheel])
    }
}

/// A time in s as it is told in words.
pub(super) fn time(time: f64) -> String {
    match time {
        time if 0.0 < time && time < 1e-4 => format!("{time:.3e}"),
        time => format!("{time:.6}").trim_end_matches('0').trim_end_matches('.').to_owned(),
    }
}

/// The force of each law of feedback at a speed in m/s, from positions and rates of quantities in any order.
pub(super) fn fed_back(
    design: &Design,
    speed: f64,
    quantities: &[Quantity],
    positions: &[f64],
    rates: &[f64],
) -> Vec<f64> {
    forces(&design.feedback, speed, |coordinate| {
        let name = design.info().coordinates[coordinate].name;
        let place = quantities.iter().position(|quantity| quantity.name == name);
        place.map_or((0.0, 0.0), |place| (positions[place], rates[place]))
    })
}
