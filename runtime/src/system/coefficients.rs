//! The coefficient matrices of the linearized equations of motion.

use core::fmt;

use nalgebra::SMatrix;

use super::rows::Rows;
use super::states::States;
use crate::number::Scalar;

/// A matrix of N x N numbers, of [`nalgebra`].
///
/// It becomes one of another library entry by entry, and comes back so by `Matrix::from_fn`:
///
/// ```ignore
/// let of_ndarray = ndarray::Array2::from_shape_fn((N, N), |at| matrix[at]);
/// let of_faer = faer::Mat::from_fn(N, N, |row, column| matrix[(row, column)]);
/// // With nalgebra's feature `convert-mint`, for N = 2:
/// let of_mint: mint::ColumnMatrix2<f64> = matrix.into();
/// ```
pub type Matrix<T, const N: usize> = SMatrix<T, N, N>;

/// The coefficient matrices of
/// `M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f`, each N x N.
///
/// Rows and columns follow the coordinates of the model. For coordinates that are angles in rad, M is in kg m^2, C-1 in
/// N m^2, C0 in N m s, C1 in kg m, Kc in N m, K0 in kg m, K1 in N s and K2 in kg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<T: Scalar, const N: usize> {
    /// Mass matrix M.
    pub m: Matrix<T, N>,
    /// Damping C-1, to be divided by v, as slipping tyres have it; unless it is zero there are no equations of motion at
    /// rest.
    pub cm1: Matrix<T, N>,
    /// Damping C0 that does not depend on the speed.
    pub c0: Matrix<T, N>,
    /// Damping C1, to be multiplied by v.
    pub c1: Matrix<T, N>,
    /// Stiffness Kc that depends on neither gravity nor speed.
    pub kc: Matrix<T, N>,
    /// Stiffness K0, to be multiplied by g.
    pub k0: Matrix<T, N>,
    /// Stiffness K1, to be multiplied by v.
    pub k1: Matrix<T, N>,
    /// Stiffness K2, to be multiplied by v^2.
    pub k2: Matrix<T, N>,
    /// Which of the position and the rate of each coordinate are states.
    pub states: [States; N],
}

/// All of them zero: `Coefficients { m, k0, ..Default::default() }` has the matrices that are not.
impl<T: Scalar, const N: usize> Default for Coefficients<T, N> {
    fn default() -> Self {
        Self::from_rows([[[T::from_f64(0.0); N]; N]; 8])
    }
}

impl<T: Scalar, const N: usize> Coefficients<T, N> {
    /// From the rows of each matrix, in the order M, C-1, C0, C1, Kc, K0, K1, K2. Positions and rates of all coordinates are
    /// states.
    pub fn from_rows([m, cm1, c0, c1, kc, k0, k1, k2]: [[[T; N]; N]; 8]) -> Self {
        let matrix = |rows: [[T; N]; N]| SMatrix::from_fn(|row, column| rows[row][column]);
        let [m, cm1, c0, c1] = [m, cm1, c0, c1].map(matrix);
        let [kc, k0, k1, k2] = [kc, k0, k1, k2].map(matrix);
        Self { m, cm1, c0, c1, kc, k0, k1, k2, states: [States::Both; N] }
    }

    /// The same numbers as `f64`, exactly.
    pub(crate) fn widen(&self) -> Coefficients<f64, N> {
        #[cfg(feature = "std")]
        if let Some(wide) = (self as &dyn core::any::Any).downcast_ref() {
            return *wide;
        }
        let mut wide = Coefficients { states: self.states, ..Default::default() };
        for name in MatrixName::ALL {
            *wide.matrix_mut(name) = self.matrix(name).map(Scalar::to_f64);
        }
        wide
    }

    /// Whether there is a C-1 or a K1: without them damping is of the powers 0 and 1 of the speed and stiffness of 0 and 2,
    /// for which two coordinates have faster and exact ways.
    pub(crate) fn has_odd_powers(&self) -> bool {
        let zero = T::from_f64(0.0);
        let is_zero = |matrix: &Matrix<T, N>| matrix.as_slice().iter().all(|&entry| entry == zero);
        !is_zero(&self.cm1) || !is_zero(&self.k1)
    }

    /// One of the matrices.
    pub fn matrix(&self, name: MatrixName) -> &Matrix<T, N> {
        let Self { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = self;
        match name {
            MatrixName::M => m,
            MatrixName::Cm1 => cm1,
            MatrixName::C0 => c0,
            MatrixName::C1 => c1,
            MatrixName::Kc => kc,
            MatrixName::K0 => k0,
            MatrixName::K1 => k1,
            MatrixName::K2 => k2,
        }
    }

    /// One of the matrices, to be changed.
    pub fn matrix_mut(&mut self, name: MatrixName) -> &mut Matrix<T, N> {
        let Self { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = self;
        match name {
            MatrixName::M => m,
            MatrixName::Cm1 => cm1,
            MatrixName::C0 => c0,
            MatrixName::C1 => c1,
            MatrixName::Kc => kc,
            MatrixName::K0 => k0,
            MatrixName::K1 => k1,
            MatrixName::K2 => k2,
        }
    }
}

/// The same numbers, exactly.
impl<const N: usize> From<Coefficients<f32, N>> for Coefficients<f64, N> {
    fn from(coefficients: Coefficients<f32, N>) -> Self {
        coefficients.widen()
    }
}

/// The rows of a matrix, from an array that holds the entries of several of them row by row: its own begin at `first`.
///
/// Compiled models make their matrices by it. Rows of two `f32` that are written where they are used, or taken from an
/// array at places known there, are for LLVM one whole number of 64 bits each, and then it puts no loop over designs into
/// lanes; so the rows are taken by a function that learns the place. It counts, since what iterates would be a call for
/// each entry wherever a profile has `lto = "off"`; and it counts by four, since loops stay loops where a profile has
/// `opt-level = "s"`, but for those of one turn, as that of two coordinates then is.
///
/// # Panics
/// If the array ends before the matrix.
#[inline(always)]
pub fn rows<T: Copy, const N: usize, const ENTRIES: usize>(entries: &[T; ENTRIES], first: usize) -> Rows<T, N> {
    let mut rows = [[entries[first]; N]; N];
    let mut index = 0;
    while index + 4 <= N * N {
        rows[index / N][index % N] = entries[first + index];
        rows[(index + 1) / N][(index + 1) % N] = entries[first + index + 1];
        rows[(index + 2) / N][(index + 2) % N] = entries[first + index + 2];
        rows[(index + 3) / N][(index + 3) % N] = entries[first + index + 3];
        index += 4;
    }
    while index < N * N {
        rows[index / N][index % N] = entries[first + index];
        index += 1;
    }
    Rows(rows)
}

/// One of the coefficient matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixName {
    /// Mass matrix M.
    M,
    /// Damping C-1, a coefficient of 1/v.
    Cm1,
    /// Damping C0.
    C0,
    /// Damping C1, a coefficient of v.
    C1,
    /// Stiffness Kc.
    Kc,
    /// Stiffness K0, a coefficient of g.
    K0,
    /// Stiffness K1, a coefficient of v.
    K1,
    /// Stiffness K2, a coefficient of v^2.
    K2,
}

impl MatrixName {
    /// All of them, in the order in which a model lists them.
    pub const ALL: [Self; 8] = [Self::M, Self::Cm1, Self::C0, Self::C1, Self::Kc, Self::K0, Self::K1, Self::K2];

    /// The name as declarations write it, such as `C1`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::M => "M",
            Self::Cm1 => "C-1",
            Self::C0 => "C0",
            Self::C1 => "C1",
            Self::Kc => "Kc",
            Self::K0 => "K0",
            Self::K1 => "K1",
            Self::K2 => "K2",
        }
    }
}

/// Reads `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1`, `K2`.
impl fmt::Display for MatrixName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
