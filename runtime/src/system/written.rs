//! Matrices for serde, by the names and as the rows that files of matrices on the command line have.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::at_speed::System;
use super::coefficients::{Coefficients, Matrix, MatrixName};
use super::states::States;
use crate::number::Scalar;

/// The rows of a matrix; nothing for one that is zero.
type Rows<T> = Option<Vec<Vec<T>>>;

/// `{"M": [[1.0]], "C-1": [[2.0]], "states": ["rate"]}`: without matrices that are zero, and without states that all are both.
#[derive(Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields, rename_all = "PascalCase", bound(deserialize = "T: Deserialize<'de>"))]
struct WrittenCoefficients<T> {
    m: Vec<Vec<T>>,
    #[serde(rename = "C-1", default, skip_serializing_if = "Option::is_none")]
    cm1: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    c0: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    c1: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    kc: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    k0: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    k1: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    k2: Rows<T>,
    #[serde(rename = "states", default, skip_serializing_if = "Option::is_none")]
    states: Option<Vec<States>>,
}

/// `{"M": [[1.0]], "C": [[2.0]], "K": [[5.0]]}`, likewise.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields, rename_all = "PascalCase", bound(deserialize = "T: Deserialize<'de>"))]
struct WrittenSystem<T> {
    m: Vec<Vec<T>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    c: Rows<T>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    k: Rows<T>,
    #[serde(rename = "states", default, skip_serializing_if = "Option::is_none")]
    states: Option<Vec<States>>,
}

impl<T: Scalar + Serialize, const N: usize> Serialize for Coefficients<T, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let written = |name: MatrixName| write_unless_zero(self.matrix(name));
        WrittenCoefficients {
            m: write(&self.m),
            cm1: written(MatrixName::Cm1),
            c0: written(MatrixName::C0),
            c1: written(MatrixName::C1),
            kc: written(MatrixName::Kc),
            k0: written(MatrixName::K0),
            k1: written(MatrixName::K1),
            k2: written(MatrixName::K2),
            states: write_states(&self.states),
        }
        .serialize(serializer)
    }
}

impl<'de, T: Scalar + Deserialize<'de>, const N: usize> Deserialize<'de> for Coefficients<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let WrittenCoefficients { m, cm1, c0, c1, kc, k0, k1, k2, states } =
            WrittenCoefficients::deserialize(deserializer)?;
        let mut coefficients = Self { states: read_states(states)?, ..Self::default() };
        for (name, rows) in MatrixName::ALL.into_iter().zip([Some(m), cm1, c0, c1, kc, k0, k1, k2]) {
            *coefficients.matrix_mut(name) = read(name.name(), rows)?;
        }
        Ok(coefficients)
    }
}

impl<T: Scalar + Serialize, const N: usize> Serialize for System<N, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [c, k] = [&self.c, &self.k].map(write_unless_zero);
        WrittenSystem { m: write(&self.m), c, k, states: write_states(&self.states) }.serialize(serializer)
    }
}

impl<'de, T: Scalar + Deserialize<'de>, const N: usize> Deserialize<'de> for System<N, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let WrittenSystem { m, c, k, states } = WrittenSystem::deserialize(deserializer)?;
        Ok(Self { m: read("M", Some(m))?, c: read("C", c)?, k: read("K", k)?, states: read_states(states)? })
    }
}

fn write<T: Scalar, const N: usize>(matrix: &Matrix<T, N>) -> Vec<Vec<T>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

fn write_unless_zero<T: Scalar, const N: usize>(matrix: &Matrix<T, N>) -> Rows<T> {
    let zero = T::from_f64(0.0);
    matrix.iter().any(|&entry| entry != zero).then(|| write(matrix))
}

fn write_states<const N: usize>(states: &[States; N]) -> Option<Vec<States>> {
    (*states != [States::Both; N]).then(|| states.to_vec())
}

fn read<T: Scalar, const N: usize, E: Error>(name: &str, rows: Rows<T>) -> Result<Matrix<T, N>, E> {
    let Some(rows) = rows else { return Ok(Matrix::from_fn(|_, _| T::from_f64(0.0))) };
    let shape = |found: usize, what: &str| {
        E::custom(format_args!("`{name}` has {found} {what}: expected {N}, one for each coordinate"))
    };
    if rows.len() != N {
        return Err(shape(rows.len(), "rows"));
    }
    if let Some((index, row)) = rows.iter().enumerate().find(|(_, row)| row.len() != N) {
        return Err(shape(row.len(), &format!("entries in row {}", index + 1)));
    }
    Ok(Matrix::from_fn(|row, column| rows[row][column]))
}

fn read_states<const N: usize, E: Error>(states: Option<Vec<States>>) -> Result<[States; N], E> {
    let Some(states) = states else { return Ok([States::Both; N]) };
    let count = states.len();
    let wrong = |_| E::custom(format_args!("`states` has {count} members: expected {N}, one for each coordinate"));
    states.try_into().map_err(wrong)
}
