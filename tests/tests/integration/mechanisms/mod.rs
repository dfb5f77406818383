//! Models that are derived from mechanisms, against formulas, figures and dynamics from elsewhere.

#[cfg(feature = "compiler")]
mod added;
#[cfg(feature = "compiler")]
mod attachments;
mod bicycles;
#[cfg(feature = "compiler")]
mod chains;
#[cfg(feature = "compiler")]
mod feedback;
#[cfg(feature = "compiler")]
mod identity;
mod kinematics;
#[cfg(feature = "compiler")]
mod loads;
mod others;
#[cfg(feature = "compiler")]
mod parts;
#[cfg(feature = "compiler")]
mod physical;
#[cfg(feature = "compiler")]
pub mod random;
#[cfg(feature = "compiler")]
mod tyres;
#[cfg(feature = "compiler")]
mod vehicles;

#[cfg(feature = "compiler")]
use carvallo::States;
use carvallo::{Coefficients, Matrix};

/// The matrices of a compiled model at values of its parameters, with what of its coordinates are states.
#[cfg(feature = "compiler")]
pub fn interpreted<const N: usize>(compiled: &carvallo_compiler::Compiled, values: &[f64]) -> Coefficients<f64, N> {
    let entries = compiled.programs.matrices.interpret(values);
    let mut rows = [[[0.0; N]; N]; 8];
    for ((name, _), entries) in compiled.model.matrices.iter().zip(entries.chunks(N * N)) {
        let known = ["M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2"];
        let place = known.iter().position(|known| *known == name.name()).expect("a matrix");
        for (row, entries) in rows[place].iter_mut().zip(entries.chunks(N)) {
            row.copy_from_slice(entries);
        }
    }
    let states = std::array::from_fn(|index| match compiled.model.coordinates[index].states {
        carvallo_compiler::States::Both => States::Both,
        carvallo_compiler::States::Position => States::Position,
        carvallo_compiler::States::Rate => States::Rate,
    });
    Coefficients { states, ..Coefficients::from_rows(rows) }
}

/// What stands between the braces of a source.
#[cfg(feature = "compiler")]
pub fn declaration(source: &str) -> &str {
    let (_, body) = source.split_once('{').expect("an opening brace");
    body.rsplit_once('}').expect("a closing brace").0
}

/// Whether each matrix agrees with another one, to a part of the largest entry of that.
pub fn assert_close<const N: usize>(
    found: &Coefficients<f64, N>,
    expected: &Coefficients<f64, N>,
    part: f64,
    what: &str,
) {
    let matrices = |c: &Coefficients<f64, N>| [c.m, c.cm1, c.c0, c.c1, c.kc, c.k0, c.k1, c.k2];
    let names = ["M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2"];
    for ((found, expected), name) in matrices(found).into_iter().zip(matrices(expected)).zip(names) {
        let size = |matrix: Matrix<f64, N>| matrix.iter().fold(0.0_f64, |size, entry| size.max(entry.abs()));
        let error = size(found - expected);
        // What is zero in exact arithmetic is compared with what it is the difference of.
        assert!(error <= part * size(expected).max(1.0), "{what}: {name} is {found}, not {expected}: {error:e}");
    }
}
