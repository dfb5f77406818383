//! The equations of motion of all joints, projected on the motions that the wheels leave free.
//!
//! With z the positions of all joints, the steady motion has no acceleration in a frame that does not turn. So
//!
//! ```text
//! mass z'' + (damping + v spin) z' + (stiffness + g weight) z = forces of the contacts, and applied ones,
//! ```
//!
//! where `weight` has the second derivatives of the heights of the centres of mass and, times the steady load of each
//! wheel, of its contact point. The rates are `z' = N q' + v B z`, hence `z'' = N q'' + v B N q' + v² B B z`, and in the
//! virtual motions N the contacts do no work.

use super::composite::{Composites, spin_momenta};
use super::contact::{Contact, gyroscopic};
use super::formulas::Formulas;
use super::loads::loads;
use super::matrix::{self, Matrix, plus, times, transposed};
use super::mechanism::{Mechanism, Motion};
use super::motion::Motions;
use super::vectors::cross;
use super::{Fault, Matrices};
use crate::symbolic::Form;
use crate::syntax::MatrixName;

/// The coefficient matrices of the coordinates; those that are zero are left out.
pub fn project(
    mechanism: &Mechanism<Form>,
    contacts: &[Contact<'_>],
    motions: &Motions,
    formulas: &mut Formulas<'_>,
) -> Result<Matrices, Vec<Fault>> {
    let Motions { rates, positions, places, .. } = motions;
    let unreduced = Unreduced::new(mechanism, contacts, formulas)?;
    let virtual_motions = transposed(rates);
    // A row for each freedom, a column for each joint. Spin stays as it is: it cancels out of sums.
    let project = |matrix: &Matrix| times(&virtual_motions, matrix);
    let mut named = |what: &str, matrix: &Matrix| {
        let named = |(freedom, row): (usize, Vec<Form>)| {
            let of = mechanism.coordinates.get(freedom).map_or("forward", |joint| &mechanism.joints[*joint].name);
            let name = |column: usize| format!("{what}_{of}_{}", mechanism.joints[column].name);
            row.iter().enumerate().map(|(column, entry)| formulas.name(name(column), entry)).collect()
        };
        project(matrix).into_iter().enumerate().map(named).collect::<Matrix>()
    };
    let (mass, weight) = (named("P", &unreduced.mass), named("W", &unreduced.weight));
    let [spin, damping, stiffness] = [&unreduced.spin, &unreduced.damping, &unreduced.stiffness].map(project);

    let moving = plus(&times(&mass, positions), &spin);
    let by_rates = [
        (MatrixName::M, times(&mass, rates)),
        (MatrixName::C0, times(&damping, rates)),
        (MatrixName::C1, times(&moving, rates)),
    ];
    let by_positions = [
        (MatrixName::Kc, times(&stiffness, places)),
        (MatrixName::K0, times(&weight, places)),
        (MatrixName::K2, times(&moving, positions)),
    ];
    let n = mechanism.coordinates.len();
    let mut faults = Vec::new();
    let stays = |entry: &Form| !formulas.is_zero(entry);
    for (_, matrix) in &by_rates {
        let coupled =
            (0..n).filter(|q| matrix[n..].iter().any(|row| stays(&row[*q])) || matrix[*q][n..].iter().any(stays));
        faults.extend(coupled.map(|q| Fault::Coupled { joint: mechanism.coordinates[q] }));
    }
    for (_, matrix) in &by_positions {
        let coupled = (0..n).filter(|q| matrix[n..].iter().any(|row| stays(&row[mechanism.coordinates[*q]])));
        faults.extend(coupled.map(|q| Fault::Coupled { joint: mechanism.coordinates[q] }));
        let remaining = motions.rolling.iter().filter(|joint| matrix.iter().any(|row| stays(&row[**joint])));
        faults.extend(remaining.map(|joint| Fault::Remains { joint: *joint }));
    }
    let dragged = times(&damping, positions);
    let joints = (0..mechanism.joints.len()).filter(|joint| dragged.iter().any(|row| stays(&row[*joint])));
    faults.extend(joints.map(|joint| Fault::Dragged { joint }));
    faults.extend(massless(&by_rates[0].1, n, formulas).map(|q| Fault::Massless { joint: mechanism.coordinates[q] }));
    if !faults.is_empty() {
        return Err(faults);
    }

    let by_rates =
        by_rates.into_iter().map(|(name, matrix)| (name, matrix::new(n, n, |row, column| matrix[row][column].clone())));
    let by_positions = by_positions.into_iter().map(|(name, matrix)| {
        (name, matrix::new(n, n, |row, column| matrix[row][mechanism.coordinates[column]].clone()))
    });
    let all = by_rates.chain(by_positions).map(|(name, matrix)| {
        let matrix = matrix.iter().map(|row| row.iter().map(|entry| settled(entry, formulas)).collect()).collect();
        (name, mirrored(matrix, formulas))
    });
    Ok(all
        .filter(|(name, matrix)| *name == MatrixName::M || matrix.iter().flatten().any(|entry| !entry.is_nothing()))
        .collect())
}

/// A coordinate that, with those before it, moves without a kinetic energy, whatever the parameters.
fn massless(mass: &Matrix, n: usize, formulas: &Formulas<'_>) -> Option<usize> {
    let mut rows: Vec<Vec<f64>> =
        mass[..n].iter().map(|row| row[..n].iter().map(|entry| formulas.at_sample(entry)).collect()).collect();
    for pivot in 0..n {
        let size = rows[pivot].iter().fold(0.0_f64, |size, entry| size.max(entry.abs()));
        let divisor = rows[pivot][pivot];
        if divisor.abs() <= ROUNDING * size || divisor == 0.0 {
            return Some(pivot);
        }
        let (done, rest) = rows.split_at_mut(pivot + 1);
        for row in rest {
            let factor = row[pivot] / divisor;
            row.iter_mut().zip(&done[pivot]).skip(pivot).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    None
}

/// A pivot that is smaller than this beside its row is a rounding error.
const ROUNDING: f64 = 1e-9;

/// The shortest form of an entry; zero if it is proved to be.
fn settled(entry: &Form, formulas: &Formulas<'_>) -> Form {
    if formulas.is_zero(entry) { Form::number(0) } else { formulas.shortest(entry) }
}

/// With the same form for entries that mirror each other, where they are equal.
fn mirrored(matrix: Matrix, formulas: &Formulas<'_>) -> Matrix {
    let size = matrix.len();
    matrix::new(size, size, |row, column| {
        let (entry, mirrored) = (&matrix[row][column], &matrix[column][row]);
        let equal = row > column && formulas.is_zero(&(entry - mirrored));
        if equal { mirrored.clone() } else { entry.clone() }
    })
}

/// The matrices of all joints, as if there were no contacts but for their loads.
struct Unreduced {
    mass: Matrix,
    /// To be multiplied by the speed.
    spin: Matrix,
    /// To be multiplied by gravity.
    weight: Matrix,
    damping: Matrix,
    stiffness: Matrix,
}

impl Unreduced {
    fn new(
        mechanism: &Mechanism<Form>,
        contacts: &[Contact<'_>],
        formulas: &mut Formulas<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let count = mechanism.joints.len();
        let composites = Composites::new(mechanism, formulas);
        let loads = match mechanism.has_weight {
            true => loads(mechanism, contacts, &composites, formulas)?,
            false => vec![Form::number(0); contacts.len()],
        };
        let momenta = spin_momenta(mechanism, formulas);
        let name = |what: &str, row: usize, column: usize| {
            format!("{what}_{}_{}", mechanism.joints[row].name, mechanism.joints[column].name)
        };
        let mass = matrix::symmetric(count, |row, column| {
            formulas.name(name("M", row, column), &composites.mass(row, column))
        });
        let weight = matrix::symmetric(count, |row, column| {
            if !mechanism.has_weight {
                return Form::number(0);
            }
            let lifted = contacts.iter().zip(&loads).map(|(contact, load)| load * &contact.curvature(row, column));
            let form = lifted.fold(sinking(mechanism, &composites, row, column), |sum, lifted| &sum - &lifted);
            formulas.name(name("K", row, column), &form)
        });
        let spin = matrix::new(count, count, |row, column| match mechanism.farther(row, column) {
            Some(far) => (&momenta[far] * &gyroscopic(mechanism, row, column)).simplest(),
            None => Form::number(0),
        });
        let diagonal = |values: Vec<Option<&Form>>| {
            let value = |joint: usize| values[joint].cloned().unwrap_or(Form::number(0));
            matrix::new(count, count, |row, column| if row == column { value(row) } else { Form::number(0) })
        };
        let damping = diagonal(mechanism.joints.iter().map(|joint| joint.damping.as_ref()).collect());
        let stiffness = diagonal(mechanism.joints.iter().map(|joint| joint.stiffness.as_ref()).collect());
        Ok(Self { mass, spin, weight, damping, stiffness })
    }
}

/// The second derivative of the potential energy of gravity, divided by it, with respect to two joints.
fn sinking(mechanism: &Mechanism<Form>, composites: &Composites<'_>, row: usize, column: usize) -> Form {
    let near = &mechanism.joints[row.min(column)];
    match mechanism.farther(row, column) {
        Some(far) if near.motion == Motion::Turns => -&cross(&near.axis, &composites.moved(far).momentum)[2],
        _ => Form::number(0),
    }
}
