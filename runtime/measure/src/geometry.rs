//! Wheel radii, wheel base, steer axis tilt and trail.

use std::f64::consts::PI;

use carvallo::Uncertain;

use crate::table::Table;

/// The geometry of a bicycle in m and rad.
#[derive(Clone, Copy)]
pub struct Geometry<'a> {
    /// Wheel base.
    pub w: Uncertain<'a>,
    /// Trail.
    pub c: Uncertain<'a>,
    /// Steer axis tilt.
    pub lam: Uncertain<'a>,
    /// Radius of the rear wheel.
    pub r_r: Uncertain<'a>,
    /// Radius of the front wheel.
    pub r_f: Uncertain<'a>,
}

impl<'a> Geometry<'a> {
    pub fn of(table: &Table<'a>) -> Self {
        // The wheels roll a distance d in n turns.
        let radius = |distance: &str, turns: &str| table.get(distance) / table.get(turns) / (2.0 * PI);
        let (r_r, r_f) = (radius("dR", "nR"), radius("dF", "nF"));
        let [w, lam, offset] = if table.has("w") || table.has("gamma") {
            [table.get("w"), -table.get("gamma") + PI / 2.0, table.get("f")]
        } else {
            of_offsets(table, r_r, r_f)
        };
        // Moore (2012), from the fork offset.
        let c = (r_f * lam.sin() - offset) / lam.cos();
        Self { w, c, lam, r_r, r_f }
    }
}

/// Wheel base, steer axis tilt and fork offset from heights over a table that the bicycle lies on and diameters of axles, by
/// the perpendicular distances a and b of the wheel centres from the steer axis and the distance c along it between these.
fn of_offsets<'a>(table: &Table<'a>, r_r: Uncertain<'a>, r_f: Uncertain<'a>) -> [Uncertain<'a>; 3] {
    let half = |name: &str| table.get(name) / 2.0;
    let a = table.get("h1") + table.get("h2") - table.get("h3") + half("d1") - half("d2");
    let b = table.get("h4") - half("d3") - table.get("h5") + half("d4");
    let square = (table.get("d") + half("d2") + half("d3")).squared() - (a - b).squared();
    if square.value() <= 0.0 {
        table.problem("`d` is too short for the heights: the axles are farther apart across the steer axis".to_owned());
    }
    let c = square.sqrt();
    // (a + b) sin(lam) - c cos(lam) = rF - rR, which BicycleParameters solves by Newton's iteration.
    let along = ((a + b).squared() + c.squared()).sqrt();
    let lam = c.atan2(a + b) + ((r_f - r_r) / along).asin();
    [(a + b) * lam.cos() + c * lam.sin(), lam, b]
}

/// Where the centre of the handlebar's reference circle is, forward and up from the centre of the front wheel, of a fork that
/// was measured apart from its handlebar: behind it by u1, and above it by u2.
pub fn handlebar<'a>(table: &Table<'a>, lam: Uncertain<'a>) -> [Uncertain<'a>; 2] {
    let (r5, r6) = (table.get("d5") / 2.0, table.get("d6") / 2.0);
    // Across the steer axis, and along it.
    let l1 = table.get("h7") - table.get("h6") + r5 - r6;
    let l0 = table.get("l") - r5 - r6;
    if l0.value() <= l1.value().abs() {
        table.problem("`l` is too short for `h6` and `h7`".to_owned());
    }
    let l2 = (l0.squared() - l1.squared()).sqrt();
    [l2 * lam.sin() - l1 * lam.cos(), l2 * lam.cos() + l1 * lam.sin()]
}
