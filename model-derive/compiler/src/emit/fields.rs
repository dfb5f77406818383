//! What the fields of the struct of the matrices are called, and what is written above them.

use crate::matrix_name::MatrixName;

/// The field that holds a matrix in generated code.
pub fn field_name(matrix: MatrixName) -> &'static str {
    match matrix {
        MatrixName::M => "m",
        MatrixName::Cm1 => "cm1",
        MatrixName::C0 => "c0",
        MatrixName::C1 => "c1",
        MatrixName::Kc => "kc",
        MatrixName::K0 => "k0",
        MatrixName::K1 => "k1",
        MatrixName::K2 => "k2",
    }
}

/// What a matrix is, with its place in the equation of motion.
pub fn field_docs(matrix: MatrixName) -> &'static str {
    match matrix {
        MatrixName::M => "Mass matrix M, the coefficient of q''.",
        MatrixName::Cm1 => "Damping C-1, a coefficient of q'/v.",
        MatrixName::C0 => "Damping C0, a coefficient of q'.",
        MatrixName::C1 => "Damping C1, a coefficient of v q'.",
        MatrixName::Kc => "Stiffness Kc, a coefficient of q.",
        MatrixName::K0 => "Stiffness K0, a coefficient of g q.",
        MatrixName::K1 => "Stiffness K1, a coefficient of v q.",
        MatrixName::K2 => "Stiffness K2, a coefficient of v^2 q.",
    }
}
