//! Eigenvalues that were given, as zeros of the determinant of `s^2 M + s C + K`: whether matrices can have them is told so by a few
//! products, before their eigenvalues are computed.

use carvallo::{Complex, MatrixName, ModelInfo};

use crate::given::{Eigenvalues, Quantity, Reading};
use crate::predict::Predictor;
use crate::states::states;

/// More than rounding leaves, relative to what is added up.
pub const ROUNDING: f64 = 1e-12;

/// Beyond so much of an eigenvalue it is not known well enough for this.
const LARGEST: f64 = 1e-2;

/// A square matrix, row by row.
pub type Square = Vec<Complex<f64>>;

/// An eigenvalue that was given, at its speed.
#[derive(Clone, Debug)]
pub struct Zero {
    /// Which number its real part is; the imaginary one comes next, where it is given.
    pub number: usize,
    /// Whether it is.
    pub has_imaginary: bool,
    /// In m/s.
    pub speed: f64,
    /// Of each matrix whether its factor in the sum is 1, s or s^2, and what it is multiplied by besides.
    parts: Vec<(MatrixName, usize, f64)>,
    /// The eigenvalue, and what is as far away on either side as may be.
    points: [Complex<f64>; 3],
    count: usize,
}

/// All of which both parts are known, once of each pair; other matrices than these are zero.
pub fn zeros(predictor: &Predictor, info: &ModelInfo, matrices: &[MatrixName]) -> Vec<Zero> {
    let (numbers, tolerances) = (predictor.numbers(), predictor.tolerances());
    let mut zeros = Vec::new();
    for (at, (quantity, re)) in numbers.iter().enumerate() {
        let Quantity::RealPart(set, index) = *quantity else { continue };
        let Eigenvalues { speed, values } = &predictor.given().eigenvalues[set];
        let (im, tolerance) = match &values[index].1 {
            Some(im) => (im.value, tolerances[at].hypot(tolerances[at + 1])),
            None if is_real(values, index, states(info).len()) => (0.0, tolerances[at]),
            None => continue,
        };
        let has_imaginary = values[index].1.is_some();
        let (eigenvalue, speed) = (Complex::new(re.value, im), *speed);
        let part = |&matrix: &MatrixName| match matrix {
            MatrixName::M => (matrix, 2, 1.0),
            MatrixName::Cm1 => (matrix, 1, 1.0 / speed),
            MatrixName::C0 => (matrix, 1, 1.0),
            MatrixName::C1 => (matrix, 1, speed),
            // Gravity is multiplied with the entry.
            MatrixName::Kc | MatrixName::K0 => (matrix, 0, 1.0),
            MatrixName::K1 => (matrix, 0, speed),
            MatrixName::K2 => (matrix, 0, speed * speed),
        };
        let parts: Vec<_> = matrices.iter().map(part).collect();
        let points = [0.0, tolerance, -tolerance].map(|away| eigenvalue + away);
        let is_finite = parts.iter().all(|(.., factor)| factor.is_finite()) && eigenvalue.is_finite();
        if is_finite && im >= 0.0 && tolerance <= LARGEST * eigenvalue.norm() {
            zeros.push(Zero { number: at, has_imaginary, speed, parts, points, count: info.coordinates.len() });
        }
    }
    zeros
}

/// Whether an eigenvalue is real of which the real part alone is known: that of a pair is there twice, where all are given.
fn is_real(values: &[(Reading, Option<Reading>)], index: usize, count: usize) -> bool {
    let (own, _) = &values[index];
    let is_other = |(at, (other, _)): (usize, &(Reading, Option<Reading>))| {
        at == index || (other.value - own.value).abs() > 2.0 * (other.tolerance + own.tolerance)
    };
    values.len() == count && values.iter().enumerate().all(is_other)
}

impl Zero {
    /// Whether the eigenvalue is real.
    pub fn is_real(&self) -> bool {
        self.points[0].im == 0.0
    }

    /// Whether these entries of the closed loop may have it: those that have do.
    pub fn holds(&self, entries: &[f64], gravity: f64) -> bool {
        let [off, allowed] = self.off(&self.matrices(entries, gravity));
        off <= allowed
    }

    /// The matrix whose determinant is zero, and the same on either side.
    pub fn matrices(&self, entries: &[f64], gravity: f64) -> [Square; 3] {
        let square = self.count * self.count;
        // K, C and M at the speed.
        let mut sums = vec![0.0; 3 * square];
        for &(matrix, power, factor) in &self.parts {
            let factor = if matrix == MatrixName::K0 { gravity * factor } else { factor };
            let (sum, own) = (&mut sums[power * square..][..square], &entries[matrix as usize * square..][..square]);
            for at in 0..square {
                sum[at] += factor * own[at];
            }
        }
        let (k, c, m) = (&sums[..square], &sums[square..2 * square], &sums[2 * square..]);
        self.points.map(|s| {
            let squared = s * s;
            let entry =
                |at: usize| Complex::new(squared.re * m[at] + s.re * c[at] + k[at], squared.im * m[at] + s.im * c[at]);
            (0..square).map(entry).collect()
        })
    }

    /// The determinant of the matrix whose determinant is zero.
    pub fn determinant(&self, entries: &[f64], gravity: f64) -> Complex<f64> {
        determinant(&self.matrices(entries, gravity)[0], self.count)
    }

    /// How large the determinant is, and how large it may be: beside another eigenvalue twice as large as on the side that differs more.
    pub fn off(&self, [here, right, left]: &[Square; 3]) -> [f64; 2] {
        let [off, right, left] = [here, right, left].map(|own| determinant(own, self.count));
        let allowed = (right - off).norm().max((left - off).norm());
        [off.norm(), 4.0 * allowed + ROUNDING * size(here, self.count)]
    }
}

/// What a determinant is at most.
pub fn size(matrix: &[Complex<f64>], count: usize) -> f64 {
    matrix.chunks_exact(count).map(|row| row.iter().map(|own| own.norm()).sum::<f64>()).product()
}

/// By elimination with the largest pivots.
pub fn determinant(matrix: &[Complex<f64>], count: usize) -> Complex<f64> {
    if let [a, b, c, d] = *matrix {
        return a * d - b * c;
    }
    let mut matrix = matrix.to_vec();
    let mut product = Complex::new(1.0, 0.0);
    for column in 0..count {
        let largest = (column..count)
            .max_by(|&a, &b| matrix[a * count + column].norm().total_cmp(&matrix[b * count + column].norm()))
            .unwrap_or(column);
        if largest != column {
            (0..count).for_each(|at| matrix.swap(column * count + at, largest * count + at));
            product = -product;
        }
        let pivot = matrix[column * count + column];
        product *= pivot;
        if pivot.norm() == 0.0 {
            break;
        }
        for row in column + 1..count {
            let factor = matrix[row * count + column] / pivot;
            for at in column..count {
                let change = factor * matrix[column * count + at];
                matrix[row * count + at] -= change;
            }
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use carvallo::Complex;

    use super::determinant;

    /// Vandermonde's of 1, 2, i and -1: the product of all differences.
    #[test]
    fn determinants_have_their_sign() {
        let points = [(1.0, 0.0), (2.0, 0.0), (0.0, 1.0), (-1.0, 0.0)].map(|(re, im)| Complex::new(re, im));
        let rows: Vec<_> = points.iter().flat_map(|own| (0..4).map(|power| own.powi(power))).collect();
        let mut expected = Complex::new(1.0, 0.0);
        for (at, a) in points.iter().enumerate() {
            points[at + 1..].iter().for_each(|b| expected *= b - a);
        }
        assert!((determinant(&rows, 4) - expected).norm() < 1e-12);
    }
}
