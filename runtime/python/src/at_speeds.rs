//! What there is of one design at speeds, added to lists of numbers.

use carvallo::batch::Batch;
use carvallo::{Complex, SystemError};
use carvallo_design::Equations;

/// The entries of each matrix of the form, row by row.
pub fn matrices(
    equations: &dyn Equations,
    _gravity: f64,
    _index: usize,
    arrays: &mut [Vec<f64>; 8],
) -> Result<(), String> {
    for (array, (_, rows)) in arrays.iter_mut().zip(equations.matrices()) {
        rows.iter().for_each(|row| array.extend_from_slice(row));
    }
    Ok(())
}

/// The entries of M, C and K, row by row, speed by speed.
pub fn system(
    equations: &dyn Equations,
    gravity: f64,
    speeds: &[f64],
    arrays: &mut [Vec<f64>; 3],
) -> Result<(), String> {
    for &speed in speeds {
        let matrices = equations.system(speed, gravity).map_err(|error| at(speed, error))?;
        arrays.iter_mut().zip(matrices).for_each(|(array, entries)| array.extend(entries));
    }
    Ok(())
}

/// The entries of A and B, row by row, speed by speed.
pub fn state_space(
    equations: &dyn Equations,
    gravity: f64,
    speeds: &[f64],
    arrays: &mut [Vec<f64>; 2],
) -> Result<(), String> {
    for &speed in speeds {
        let matrices = equations.state_space(speed, gravity).map_err(|error| at(speed, error))?;
        arrays.iter_mut().zip(matrices).for_each(|(array, entries)| array.extend(entries));
    }
    Ok(())
}

/// The eigenvalues, speed by speed.
pub fn eigenvalues(
    equations: &dyn Equations,
    gravity: f64,
    speeds: &[f64],
    [values]: &mut [Vec<Complex<f64>>; 1],
) -> Result<(), String> {
    /// Speeds at once in the lanes of the processor.
    const STRETCH: usize = 64;
    let Some(two) = equations.of_two() else {
        for &speed in speeds {
            values.extend(equations.eigenvalues(speed, gravity).map_err(|error| at(speed, error))?);
        }
        return Ok(());
    };
    values.reserve(4 * speeds.len());
    let batch = Batch::new();
    let mut found = [const { Ok([Complex::new(0.0, 0.0); 4]) }; STRETCH];
    for speeds in speeds.chunks(STRETCH) {
        let found = &mut found[..speeds.len()];
        batch.eigenvalues_along(two, gravity, speeds, found).map_err(|error| error.to_string())?;
        for (&speed, four) in speeds.iter().zip(found) {
            values.extend(four.as_ref().map_err(|error| at(speed, *error))?);
        }
    }
    Ok(())
}

/// The eigenvalues, their right and their left eigenvectors, speed by speed.
pub fn eigenvectors(
    equations: &dyn Equations,
    gravity: f64,
    speeds: &[f64],
    [values, right, left]: &mut [Vec<Complex<f64>>; 3],
) -> Result<(), String> {
    for &speed in speeds {
        let fail = |error: SystemError| at(speed, error);
        let found = equations.eigenvalues(speed, gravity).map_err(fail)?;
        for shape in equations.eigenvectors(speed, gravity, &found).map_err(fail)? {
            right.extend(shape.right);
            left.extend(shape.left);
        }
        values.extend(found);
    }
    Ok(())
}

/// What is wrong, and at which speed.
pub fn at(speed: f64, error: SystemError) -> String {
    format!("at {speed} m/s: {error}")
}
