//! Matrices that are given themselves, as a model with their entries for parameters.

use carvallo::{Coefficients, CoordinateInfo, Domain, Matrix, MatrixName, ModelInfo, ParameterInfo, Sensitivity};

use crate::model::Shipped;

/// The form of the benchmark: M q'' + v C1 q' + (g K0 + v² K2) q = f.
static BENCHMARK: Shipped = Shipped::new(
    &BENCHMARK_INFO,
    |parameters| Ok(Box::new(coefficients(&BENCHMARK_INFO, parameters))),
    |parameters, visitor| visitor(&coefficients(&BENCHMARK_INFO, parameters)),
    differentiate,
);

const BENCHMARK_INFO: ModelInfo = ModelInfo {
    name: "Matrices",
    parameters: &entries::<17>(&[MatrixName::M, MatrixName::C1, MatrixName::K0, MatrixName::K2]),
    matrices: &[MatrixName::M, MatrixName::C1, MatrixName::K0, MatrixName::K2],
    gravity: Some(16),
    ..GENERAL_INFO
};

/// All matrices.
static GENERAL: Shipped = Shipped::new(
    &GENERAL_INFO,
    |parameters| Ok(Box::new(coefficients(&GENERAL_INFO, parameters))),
    |parameters, visitor| visitor(&coefficients(&GENERAL_INFO, parameters)),
    differentiate,
);

const GENERAL_INFO: ModelInfo = ModelInfo {
    name: "AllMatrices",
    docs: "Two coordinates, by the entries of their matrices.",
    source: "",
    parameters: &entries::<33>(&MatrixName::ALL),
    coordinates: &[coordinate("q1"), coordinate("q2")],
    matrices: &MatrixName::ALL,
    entries: &[],
    sets: &[],
    requirements: &[],
    formulas: &[],
    gravity: Some(32),
};

/// They are no models that ship, but can be named like them.
pub static MATRICES: [&Shipped; 2] = [&BENCHMARK, &GENERAL];

const fn coordinate(name: &'static str) -> CoordinateInfo {
    CoordinateInfo::new(name, "1")
}

/// The parameters: the entries of matrices row by row, and gravity.
const fn entries<const N: usize>(matrices: &[MatrixName]) -> [ParameterInfo; N] {
    let gravity = ParameterInfo {
        name: "g",
        symbol: "g",
        docs: "Gravitational field strength.",
        unit: "N/kg",
        domain: Domain::FINITE,
        used: true,
    };
    let mut entries = [gravity; N];
    let mut at = 0;
    while at + 1 < N {
        let name = names(matrices[at / 4])[at % 4];
        entries[at] = ParameterInfo { name, symbol: name, docs: "", unit: "1", domain: Domain::FINITE, used: true };
        at += 1;
    }
    entries
}

/// What the entries of a matrix are called, row by row.
pub const fn names(matrix: MatrixName) -> [&'static str; 4] {
    match matrix {
        MatrixName::M => ["M_11", "M_12", "M_21", "M_22"],
        MatrixName::Cm1 => ["C-1_11", "C-1_12", "C-1_21", "C-1_22"],
        MatrixName::C0 => ["C0_11", "C0_12", "C0_21", "C0_22"],
        MatrixName::C1 => ["C1_11", "C1_12", "C1_21", "C1_22"],
        MatrixName::Kc => ["Kc_11", "Kc_12", "Kc_21", "Kc_22"],
        MatrixName::K0 => ["K0_11", "K0_12", "K0_21", "K0_22"],
        MatrixName::K1 => ["K1_11", "K1_12", "K1_21", "K1_22"],
        MatrixName::K2 => ["K2_11", "K2_12", "K2_21", "K2_22"],
    }
}

/// The matrices with these entries; those that the form does not have are zero.
fn coefficients(info: &ModelInfo, entries: &[f64]) -> Coefficients<f64, 2> {
    let matrix = |matrix: MatrixName| match info.matrices.iter().position(|name| *name == matrix) {
        Some(at) => Matrix::from_row_slice(&entries[4 * at..4 * at + 4]),
        None => Matrix::zeros(),
    };
    let [m, cm1, c0, c1, kc, k0, k1, k2] = MatrixName::ALL.map(matrix);
    Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, ..Default::default() }
}

fn differentiate(_: &[f64]) -> Result<Option<Sensitivity<2>>, String> {
    Err("matrices that are given themselves have no parameters that their critical speeds could depend on".to_owned())
}
