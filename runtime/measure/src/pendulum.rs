//! Moments of inertia from periods of oscillation.

use std::f64::consts::TAU;

use carvallo::Uncertain;

use crate::table::Table;

/// About the centre of mass in kg m^2, of what swings as a compound pendulum with its centre of mass at a distance in m from
/// the axis, with a period in s.
pub fn compound<'a>(
    table: &Table<'a>,
    mass: Uncertain<'a>,
    length: Uncertain<'a>,
    period: Uncertain<'a>,
) -> Uncertain<'a> {
    (period / TAU).squared() * mass * table.get("g") * length - mass * length.squared()
}

/// A wire or rod that parts are hung on.
#[derive(Clone, Copy)]
pub struct Torsion<'a> {
    /// In N m/rad.
    stiffness: Uncertain<'a>,
}

impl<'a> Torsion<'a> {
    /// By the period with a cylinder P hung across it, whose moment of inertia follows from its mass, length and diameter.
    pub fn of(table: &Table<'a>) -> Self {
        let (radius, length) = (table.get("dP") / 2.0, table.get("lP"));
        let moment = table.get("mP") * (radius.squared() * 3.0 + length.squared()) / 12.0;
        Self { stiffness: moment * TAU * TAU / table.get("TtP1").squared() }
    }

    /// About the vertical through the centre of mass in kg m^2, by the period in s.
    pub fn moment(self, period: Uncertain<'a>) -> Uncertain<'a> {
        self.stiffness * (period / TAU).squared()
    }
}
