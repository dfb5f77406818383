//! Whole matrices under the key of another one or in other units, and one coordinate in degrees. They are told by themselves.

use std::f64::consts::PI;

use carvallo::{MatrixName, ModelInfo};
use carvallo_slips::index;

use super::speeds::power;
use super::{Assignment, Convention};

/// Of a kg that of another unit, and what it is called.
const MASSES: [(f64, &str); 4] = [(1.0, "kg"), (1e3, "g"), (1.0 / 0.453_592_37, "lb"), (1.0 / 14.593_902_937, "slug")];

/// Of a m that of another unit, and what it is called.
const LENGTHS: [(f64, &str); 4] = [(1e3, "mm"), (1e2, "cm"), (1.0 / 0.0254, "inches"), (1.0 / 0.3048, "feet")];

/// Values of g that stand in textbooks, standards and tables, in N/kg.
const GRAVITIES: [f64; 6] = [9.80665, 9.81, 9.8, 9.806, 9.82, 10.0];

/// All of matrices, with these entries.
pub fn wholes(info: &ModelInfo, entries: &[f64], gravity: f64) -> Vec<Convention> {
    let build = Build { info, count: info.coordinates.len(), entries };
    let mut found = build.units();
    if gravity != 0.0 && info.matrices.contains(&MatrixName::K0) {
        found.extend(GRAVITIES.into_iter().filter(|own| *own != gravity).map(|own| {
            let what = format!("g is in K0, as {own} N/kg in the place of {gravity}: it is multiplied already");
            Convention::of_entries(what, build.from(MatrixName::K0, MatrixName::K0, own))
        }));
    }
    found.extend(build.under_others(gravity));
    found.extend(if build.count > 1 { build.degrees(true) } else { Vec::new() });
    found
}

/// One coordinate in degrees, of several: in state matrices as well.
pub fn degrees(info: &ModelInfo) -> Vec<Convention> {
    let build = Build { info, count: info.coordinates.len(), entries: &[] };
    if build.count > 1 { build.degrees(false) } else { Vec::new() }
}

struct Build<'a> {
    info: &'a ModelInfo,
    count: usize,
    entries: &'a [f64],
}

impl Build<'_> {
    /// The places of a matrix among all entries.
    fn places(&self, matrix: MatrixName) -> std::ops::Range<usize> {
        let first = index(matrix, 0, 0, self.count);
        first..first + self.count * self.count
    }

    /// One matrix by another one times a factor.
    fn from(&self, to: MatrixName, from: MatrixName, factor: f64) -> Vec<Assignment> {
        self.places(to).zip(self.places(from)).map(|(to, from)| Assignment::times(to, from, factor)).collect()
    }

    /// All entries of the model times factors of their matrix, row and column.
    fn scaled(&self, factor: impl Fn(MatrixName, usize, usize) -> f64) -> Vec<Assignment> {
        let of = |&matrix: &MatrixName| self.places(matrix).enumerate().map(move |(at, place)| (matrix, at, place));
        let each = self.info.matrices.iter().flat_map(of);
        let times =
            |(matrix, at, place)| Assignment::times(place, place, factor(matrix, at / self.count, at % self.count));
        each.map(times).filter(|own| own.factor != 1.0).collect()
    }

    /// A matrix under the key of another one, and two that are exchanged.
    fn under_others(&self, gravity: f64) -> Vec<Convention> {
        let has_any = |matrix: MatrixName| self.places(matrix).any(|at| self.entries[at] != 0.0);
        let own: Vec<MatrixName> = self.info.matrices.iter().copied().filter(|own| has_any(*own)).collect();
        let mut found = Vec::new();
        for &from in &own {
            // One entry of another matrix may as well be a slip in its formula.
            let is_meant = |to: &MatrixName| *to != from && (self.count > 1 || !own.contains(to));
            for to in MatrixName::ALL.into_iter().filter(is_meant) {
                found.push(Convention::of_entries(format!("{from} stands under {to}"), self.from(to, from, 1.0)));
            }
        }
        for (at, &first) in own.iter().enumerate() {
            for &second in &own[at + 1..] {
                let both = [self.from(first, second, 1.0), self.from(second, first, 1.0)].concat();
                let what = format!("{first} and {second} are exchanged: each stands under the other");
                found.push(Convention::of_entries(what, both));
            }
        }
        if own.contains(&MatrixName::K0) && gravity != 1.0 && gravity != 0.0 {
            let product = self.from(MatrixName::Kc, MatrixName::K0, gravity);
            found.push(Convention::of_entries("g*K0 stands under Kc", product));
        }
        found
    }

    /// Each angle in degrees, or its equation as well.
    fn degrees(&self, of_equation: bool) -> Vec<Convention> {
        let angles = self.info.coordinates.iter().enumerate().filter(|(_, own)| own.unit == "rad");
        let both = [("is in degrees", PI / 180.0, 0), ("in rad was taken for degrees and converted", 180.0 / PI, 1)];
        let convention = |(at, label, (what, factor, rank)): (usize, &str, (&str, f64, u8))| {
            let one = |own: usize| if own == at { factor } else { 1.0 };
            let (all, end) = match of_equation {
                true => (self.scaled(|_, row, column| one(row) * one(column)), ", and so was its equation"),
                false => (self.scaled(|_, _, column| one(column)), ""),
            };
            Convention::of_entries(format!("{label} {what}{end}"), all).ranked(rank)
        };
        angles.flat_map(|(at, own)| both.map(|both| convention((at, own.label, both)))).collect()
    }

    /// Lengths in another unit, in g and in speeds as well, and masses in another one; nothing where coordinates are neither angles nor
    /// lengths.
    fn units(&self) -> Vec<Convention> {
        let power_of = |unit: &str| match unit {
            "rad" => Some(1),
            "m" => Some(0),
            _ => None,
        };
        let powers: Option<Vec<i32>> = self.info.coordinates.iter().map(|own| power_of(own.unit)).collect();
        let Some(powers) = powers else { return Vec::new() };
        let mut found = Vec::new();
        for (length, of_length) in LENGTHS {
            for (mass, of_mass) in MASSES {
                let all = self.scaled(|matrix, row, column| {
                    let of_gravity = i32::from(matrix == MatrixName::K0);
                    mass * length.powi(powers[row] + powers[column] - power(matrix) - of_gravity)
                });
                let what = match mass == 1.0 {
                    true => format!("lengths are in {of_length} in the place of m, in g and speeds as well"),
                    false => format!("lengths are in {of_length}, in g and speeds as well, and masses in {of_mass}"),
                };
                found.push(Convention::of_entries(what, all));
            }
        }
        found
    }
}
