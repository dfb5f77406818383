//! A frame, or a part of one, by what was measured of it in several orientations.

use carvallo::Uncertain;
use carvallo_design::joined::Inertia;

use crate::names::{MOST, of_orientation};
use crate::pendulum::{Torsion, compound};
use crate::table::Table;

/// What is less apart in orientation, in rad, hardly says where the centre of mass is: 5 degrees.
const NEARLY_PARALLEL: f64 = 0.087;

/// The mass, centre and moments of inertia of the part with a letter, which was hung at a reference point: x and z in m, as
/// parameters have them.
///
/// In each orientation, the steer axis makes an angle alpha with the horizontal, and the vertical through the axis that the part
/// hangs from, in which its centre of mass lies, passes the reference point at a distance a.
pub fn measured<'a>(
    table: &Table<'a>,
    part: char,
    torsion: Torsion<'a>,
    lam: Uncertain<'a>,
    [x, z]: [Uncertain<'a>; 2],
) -> Inertia<'a> {
    let mass = table.get(&format!("m{part}"));
    let count = orientations(table, part);
    // Between the x axes of the part as it hangs and of the bicycle.
    let angles: Vec<Uncertain> = (1..=count).map(|i| lam - table.get(&format!("alpha{part}{i}"))).collect();
    let distances: Vec<Uncertain> = (1..=count).map(|i| table.get(&format!("a{part}{i}"))).collect();
    let moments: Vec<Uncertain> = (1..=count).map(|i| torsion.moment(table.get(&format!("Tt{part}{i}")))).collect();
    let [dx, dz] = centre(table, part, &angles, &distances);
    let [xx, xz, zz] = components(table, part, &angles, &moments);
    let length = (dx.squared() + dz.squared()).sqrt();
    let yy = compound(table, mass, length, table.get(&format!("Tc{part}1")));
    Inertia { mass, x: x + dx, z: z + dz, xx, yy, zz, xz }
}

/// In how many orientations it was measured: three at least.
fn orientations(table: &Table, part: char) -> usize {
    let is_there = |&index: &usize| of_orientation(part, index).iter().any(|name| table.has(name));
    (1..=MOST).filter(is_there).max().unwrap_or(0).max(3)
}

/// Forward and down from the reference point: the mean of the points in which any two of the lines meet on which the centre of
/// mass lies, x sin(beta) + z cos(beta) = -a, as BicycleParameters has it.
fn centre<'a>(
    table: &Table<'a>,
    part: char,
    angles: &[Uncertain<'a>],
    distances: &[Uncertain<'a>],
) -> [Uncertain<'a>; 2] {
    let mut sums = [table.exact(0.0); 2];
    let mut count = 0.0;
    for (j, second) in angles.iter().enumerate() {
        for (i, first) in angles[..j].iter().enumerate() {
            let apart = (*first - *second).sin();
            let (one, other) = (format!("alpha{part}{}", i + 1), format!("alpha{part}{}", j + 1));
            if apart.value().abs() < 1e-6 {
                table.problem(format!("`{one}` and `{other}` are the same direction, so that their lines do not meet"));
            } else if apart.value().abs() < NEARLY_PARALLEL {
                let degrees = apart.value().asin().abs().to_degrees();
                table.warn(format!(
                    "`{one}` and `{other}` are only {degrees:.1}° apart, so that where their lines meet is uncertain"
                ));
            }
            sums[0] = sums[0] + (distances[j] * first.cos() - distances[i] * second.cos()) / apart;
            sums[1] = sums[1] + (distances[i] * second.sin() - distances[j] * first.sin()) / apart;
            count += 1.0;
        }
    }
    sums.map(|sum| sum / count)
}

/// Ixx, Ixz and Izz from the moments of inertia about vertical axes in several orientations, by least squares:
/// J = cos(beta)^2 Ixx - 2 sin(beta) cos(beta) Ixz + sin(beta)^2 Izz.
fn components<'a>(
    table: &Table<'a>,
    part: char,
    angles: &[Uncertain<'a>],
    moments: &[Uncertain<'a>],
) -> [Uncertain<'a>; 3] {
    let rows: Vec<[Uncertain; 3]> = angles
        .iter()
        .map(|angle| {
            let (s, c) = (angle.sin(), angle.cos());
            [c.squared(), s * c * -2.0, s.squared()]
        })
        .collect();
    let total =
        |product: &dyn Fn(usize) -> Uncertain<'a>| (0..rows.len()).fold(table.exact(0.0), |sum, k| sum + product(k));
    let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| total(&|k| rows[k][i] * rows[k][j])));
    let right = [0, 1, 2].map(|i| total(&|k| rows[k][i] * moments[k]));
    let determinant = determinant(matrix);
    if determinant.value().abs() < 1e-9 {
        table.problem(format!("the angles of `alpha{part}1` and so on must be three different directions"));
    }
    [0, 1, 2].map(|column| {
        let mut replaced = matrix;
        for (row, value) in replaced.iter_mut().zip(right) {
            row[column] = value;
        }
        self::determinant(replaced) / determinant
    })
}

fn determinant([a, b, c]: [[Uncertain; 3]; 3]) -> Uncertain {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}
