//! The left and right eigenvectors of any number of coordinates.

use nalgebra::{Complex, SVector};

use crate::numeric::ComplexDoubleDouble;
use crate::pencil::{Elimination, Matrices, dot};
use crate::system::{System, SystemError};

/// The eigenvectors of one eigenvalue s of `Q(s) = M s^2 + C s + K`: the shape of a mode, as phasors, and what excites it.
///
/// A component belongs to the coordinate in its place: to its position or, where only the rate is a
/// [state](crate::States), to that: its columns of Q(s) and Q'(s) below are `M s + C` and M. Rates of others are the
/// component times s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenvectors<const N: usize> {
    /// The right one, x with `Q(s) x = 0`. Its largest component is exactly 1, so that the size of each other is relative to
    /// that one, and its argument is the phase by which it leads it: `q_j(t) = Re(x_j exp(s t))`. Of components whose sizes
    /// differ by less than 1e-9 the first one is the largest; units matter to that.
    pub right: SVector<Complex<f64>, N>,
    /// The left one, y with `y^H Q(s) = 0`, where the H is the transpose of the conjugate. It is scaled by
    /// `y^H Q'(s) x = 1`, where `Q'(s) = 2 s M + C`, so that a change of the matrices changes the eigenvalue by
    /// `ds = -y^H (s^2 dM + s dC + dK) x`, and a force f that acts as an impulse excites the mode by `y^H f`. Where the
    /// eigenvalue is multiple its largest component is 1 instead.
    pub left: SVector<Complex<f64>, N>,
    /// By how much relative rounding of the matrix entries may move the eigenvectors, in units of that rounding: about
    /// `log10(condition)` of their digits are lost. From 2^40 on the eigenvalue counts as multiple.
    ///
    /// A multiple eigenvalue may have as many right eigenvectors as its multiplicity, and then each of them is given one that
    /// is independent of the others, as those of equal uncoupled oscillators. Or it has fewer, as where a real pair becomes
    /// an oscillation, and then some are given twice.
    pub condition: f64,
}

/// From this condition on an eigenvalue counts as multiple.
const MULTIPLE: f64 = (1u64 << 40) as f64;

/// Eigenvalues that are closer than this, relative to the largest, may be one; and pivots that are smaller are zero.
const CLOSE: f64 = 1e-7;

const ZERO: Complex<f64> = Complex::new(0.0, 0.0);

/// Sizes that differ by less, relative to them, are equal.
const TIE: f64 = 1e-9;

impl<const N: usize> System<N> {
    /// The eigenvectors of its [eigenvalues](Self::eigenvalues), given in any order, in the same order.
    ///
    /// They are found by elimination in twice the precision, after a step of Newton's iteration that takes rounding out of
    /// the eigenvalue.
    ///
    /// ```
    /// use carvallo::{Matrix, System};
    ///
    /// // A pendulum that carries another one: they swing together, the lower one farther by the root of two.
    /// let m = Matrix::<f64, 2>::new(2.0, 1.0, 1.0, 1.0);
    /// let k = Matrix::<f64, 2>::new(2.0, 0.0, 0.0, 1.0);
    /// let system = System::new(m, Matrix::<f64, 2>::zeros(), k);
    /// let values = system.eigenvalues()?;
    /// let slow = values.iter().position(|s| s.im > 0.0 && s.im < 1.0).unwrap();
    /// let shape = system.eigenvectors(&values)?[slow].right;
    /// assert!((shape[0].re - 0.5_f64.sqrt()).abs() < 1e-15 && shape[1].re == 1.0);
    /// # Ok::<(), carvallo::SystemError>(())
    /// ```
    ///
    /// # Errors
    /// If an entry is not finite, or if a vector leaves the range of `f64`.
    pub fn eigenvectors(&self, eigenvalues: &[Complex<f64>]) -> Result<Vec<Eigenvectors<N>>, SystemError> {
        self.require_finite()?;
        let vectors = find_vectors(&Matrices::of_system(self), eigenvalues)?;
        let vector = |entries: &[Complex<f64>]| SVector::from_fn(|row, _| entries[row]);
        let of = |Vectors { right, left, condition }: Vectors| Eigenvectors {
            right: vector(&right),
            left: vector(&left),
            condition,
        };
        Ok(vectors.into_iter().map(of).collect())
    }
}

/// The eigenvectors of one eigenvalue, of any number of coordinates.
struct Vectors {
    right: Vec<Complex<f64>>,
    left: Vec<Complex<f64>>,
    condition: f64,
}

fn find_vectors(matrices: &Matrices, eigenvalues: &[Complex<f64>]) -> Result<Vec<Vectors>, SystemError> {
    let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let of = |(index, &s): (usize, &Complex<f64>)| {
        let others = eigenvalues.iter().enumerate().filter(|(other, _)| *other != index);
        let closeness: f64 = others.map(|(_, t)| 1.0 / (s - t).norm()).sum();
        let before = eigenvalues[..index].iter().filter(|t| (s - **t).norm() <= CLOSE * largest).count();
        let vectors = find(matrices, if is_zero(matrices, s, largest) { ZERO } else { s }, closeness, before);
        let is_finite = |vector: &[Complex<f64>]| vector.iter().all(|x| x.re.is_finite() && x.im.is_finite());
        if is_finite(&vectors.right) && is_finite(&vectors.left) {
            Ok(vectors)
        } else {
            Err(SystemError::OutOfRange { quantity: "an eigenvector" })
        }
    };
    eigenvalues.iter().enumerate().map(of).collect()
}

/// Whether an eigenvalue that rounding beside the largest one cannot tell from zero is that: where it is far from it relative
/// to its own size, the columns of rates say nothing of which of them is the vector.
fn is_zero(matrices: &Matrices, s: Complex<f64>, largest: f64) -> bool {
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let is_singular =
        || Elimination::new(&matrices.at(ComplexDoubleDouble::ZERO, 0), &matrices.sizes(0.0, 0)).pivot(0) <= ROUNDING;
    s != ZERO && s.norm() <= ROUNDING * largest && is_singular()
}

/// Those of an eigenvalue, with the sum of its reciprocal distances to all others, and how many of these are the same as it
/// and have eigenvectors already.
fn find(matrices: &Matrices, s: Complex<f64>, closeness: f64, before: usize) -> Vectors {
    const SMALL: f64 = 1e-6;
    let wide = ComplexDoubleDouble { re: s.re.into(), im: s.im.into() };
    let mut null = NullVectors::new(matrices, wide, before);
    let step = null.residual / null.slope;
    if step.norm() * closeness <= SMALL {
        null = NullVectors::new(matrices, wide - step, before);
    }
    let NullVectors { right, left, slope, residual, rounding } = null;
    let error = rounding.max(residual.norm() / f64::EPSILON) / slope.norm();
    // Without a slope the eigenvalue is not simple, and the condition infinite or not a number.
    let condition = if (error * closeness).is_nan() { f64::INFINITY } else { error * closeness };
    let (right, factor) = scaled(&right);
    let left = if condition < MULTIPLE {
        // With the right one as it is scaled now.
        let inverse = ComplexDoubleDouble::from(1.0) / (slope * factor);
        left.into_iter().map(|entry| entry * inverse).collect()
    } else {
        scaled(&left).0
    };
    let entries = |vector: Vec<ComplexDoubleDouble>| vector.into_iter().map(ComplexDoubleDouble::to_f64);
    Vectors { right: entries(right).collect(), left: entries(left).map(|entry| entry.conj()).collect(), condition }
}

/// The vector with a largest component of 1, and what it was multiplied by.
fn scaled(vector: &[ComplexDoubleDouble]) -> (Vec<ComplexDoubleDouble>, ComplexDoubleDouble) {
    let size = vector.iter().map(|entry| entry.norm()).fold(0.0, f64::max);
    let largest = vector.iter().copied().find(|entry| entry.norm() >= size * (1.0 - TIE));
    let one = ComplexDoubleDouble::from(1.0);
    let factor = largest.map_or(one, |largest| one / largest);
    let by = |entry: &ComplexDoubleDouble| {
        // Exactly, and not up to the last digit of twice the precision.
        if Some(*entry) == largest { one } else { *entry * factor }
    };
    (vector.iter().map(by).collect(), factor)
}

struct NullVectors {
    right: Vec<ComplexDoubleDouble>,
    /// Not conjugated: its transpose is y^H.
    left: Vec<ComplexDoubleDouble>,
    slope: ComplexDoubleDouble,
    residual: ComplexDoubleDouble,
    rounding: f64,
}

/// What an eigenvalue nearby is less by, to first order.
pub(super) fn newton_step(matrices: &Matrices, s: ComplexDoubleDouble) -> ComplexDoubleDouble {
    let NullVectors { residual, slope, .. } = NullVectors::new(matrices, s, 0);
    residual / slope
}

impl NullVectors {
    fn new(matrices: &Matrices, s: ComplexDoubleDouble, before: usize) -> Self {
        let value = matrices.at(s, 0);
        let elimination = Elimination::new(&value, &matrices.sizes(s.norm(), 0));
        let independent = (1..matrices.count()).take_while(|&place| elimination.pivot(place) <= CLOSE).count();
        let number = before.min(independent);
        let (right, left) = (elimination.right(number), elimination.left(number));
        Self {
            slope: matrices.form([&left, &right], s, 1),
            residual: dot(&left, &value.times(&right)),
            rounding: matrices.form_of_sizes([&left, &right], s, 0),
            right,
            left,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, SMatrix, SVector};

    use crate::system::{Matrix, States, System};

    fn pencil<const N: usize>(system: &System<N>, s: Complex<f64>, order: usize) -> SMatrix<Complex<f64>, N, N> {
        SMatrix::from_fn(|i, j| {
            let [m, c, k] = [&system.m, &system.c, &system.k].map(|matrix| Complex::new(matrix[(i, j)], 0.0));
            match (system.states[j], order) {
                (States::Rate, 0) => s * m + c,
                (States::Rate, _) => m,
                (_, 0) => (s * m + c) * s + k,
                (_, _) => s * m * 2.0 + c,
            }
        })
    }

    /// Both are what they are said to be, and scaled as they are said to be.
    fn check<const N: usize>(system: &System<N>) {
        let values = system.eigenvalues().unwrap();
        for (s, vectors) in values.iter().zip(system.eigenvectors(&values).unwrap()) {
            let size = pencil(system, *s, 0).map(|entry| entry.norm()).max();
            assert!((pencil(system, *s, 0) * vectors.right).norm() < 1e-13 * size);
            assert!((vectors.left.adjoint() * pencil(system, *s, 0)).norm() < 1e-13 * size * vectors.left.norm());
            let largest = vectors.right.iter().map(|entry| entry.norm()).fold(0.0, f64::max);
            assert!(largest <= 1.0 + 1e-9 && vectors.right.iter().any(|entry| *entry == Complex::new(1.0, 0.0)));
            let product = (vectors.left.adjoint() * pencil(system, *s, 1) * vectors.right)[(0, 0)];
            assert!((product - 1.0).norm() < 1e-12, "{product}");
            assert!(vectors.condition < 1e3, "{}", vectors.condition);
        }
    }

    #[test]
    fn both_sides_of_damped_coordinates_of_every_kind() {
        let m = Matrix::<f64, 3>::new(3.0, 0.4, 0.1, 0.4, 2.0, -0.2, 0.1, -0.2, 1.0);
        let c = Matrix::<f64, 3>::new(0.3, 1.0, 0.0, -1.0, 0.5, 0.2, 0.1, 0.0, 0.2);
        let k = Matrix::<f64, 3>::new(5.0, 1.0, -2.0, 0.5, 7.0, 1.0, 2.0, -1.0, 3.0);
        check(&System::new(m, c, k));
        // The first one of first order, of the second only the rate.
        let (mut mass, mut stiffness) = (m, k);
        mass.column_mut(0).fill(0.0);
        stiffness.column_mut(1).fill(0.0);
        let damping = c + Matrix::<f64, 3>::identity();
        check(&System {
            states: [States::Position, States::Rate, States::Both],
            ..System::new(mass, damping, stiffness)
        });
    }

    /// Of x'' + x = y' and y'' + 4 y = -x' with i omega: y leads or lags x by a quarter.
    #[test]
    fn phases_are_those_of_the_equations() {
        let c = Matrix::<f64, 2>::new(0.0, -1.0, 1.0, 0.0);
        let system = System::new(Matrix::<f64, 2>::identity(), c, Matrix::<f64, 2>::new(1.0, 0.0, 0.0, 4.0));
        let values = system.eigenvalues().unwrap();
        for (s, vectors) in values.iter().zip(system.eigenvectors(&values).unwrap()) {
            // (s^2 + 1) x = s y.
            let expected = (s * s + 1.0) / s;
            assert!((vectors.right[1] / vectors.right[0] - expected).norm() < 1e-14);
            assert!((vectors.right[1] / vectors.right[0]).re.abs() < 1e-14);
        }
    }

    /// A cart with an inverted pendulum goes on at any speed, with the pendulum upright: that is the vector of what is zero
    /// but for rounding, which is far from zero relative to its own size.
    #[test]
    fn what_rounding_leaves_of_zero_has_the_vector_of_zero() {
        let m = Matrix::<f64, 2>::new(0.69, -0.0696, -0.0696, 0.008404);
        let k = Matrix::<f64, 2>::new(0.0, 0.0, 0.0, -0.412);
        let states = [States::Rate, States::Both];
        let system = System { states, ..System::new(m, Matrix::<f64, 2>::zeros(), k) };
        let fast = f64::sqrt(0.412 * 0.69 / (0.69 * 0.008404 - 0.0696 * 0.0696));
        for zero in [-5.5e-16, 3e-15, 1e-30, 0.0] {
            let values = [-fast, zero, fast].map(|s| Complex::new(s, 0.0));
            let vectors = system.eigenvectors(&values).unwrap()[1];
            assert_eq!(vectors.right, SVector::from([1.0, 0.0].map(|x| Complex::new(x, 0.0))), "{zero:e}");
            // The momentum is 0.69 x' - 0.0696 theta'.
            assert!((vectors.left[0] * 0.69 - 1.0).norm() < 1e-15, "{zero:e}");
        }
    }

    /// Equal oscillators have two shapes; at critical damping there is one for both eigenvalues.
    #[test]
    fn multiple_eigenvalues_have_as_many_vectors_as_there_are() {
        let one = Matrix::<f64, 2>::identity();
        let equal = System::new(one, one * 0.1, one * 4.0);
        let values = equal.eigenvalues().unwrap();
        let vectors = equal.eigenvectors(&values).unwrap();
        for half in [-1.0, 1.0] {
            let of_half = values.iter().zip(&vectors).filter(|(value, _)| value.im * half > 0.0);
            let shapes: Vec<_> = of_half.map(|(_, vectors)| vectors.right).collect();
            let minor = shapes[0][0] * shapes[1][1] - shapes[0][1] * shapes[1][0];
            assert!(shapes.len() == 2 && minor.norm() > 0.5, "{shapes:?}");
        }
        assert!(vectors.iter().all(|vectors| vectors.condition >= super::MULTIPLE));
        let critical = System::new(Matrix::<f64, 1>::new(1.0), Matrix::<f64, 1>::new(2.0), Matrix::<f64, 1>::new(1.0));
        let values = critical.eigenvalues().unwrap();
        for vectors in critical.eigenvectors(&values).unwrap() {
            assert_eq!((vectors.right[0], vectors.left[0]), (Complex::new(1.0, 0.0), Complex::new(1.0, 0.0)));
            assert!(vectors.condition >= super::MULTIPLE);
        }
    }
}
