//! The equations of motion at one speed and one gravity.

use core::any::Any;

use super::coefficients::{Coefficients, Matrix, MatrixName};
use super::error::SystemError;
use super::states::States;
use crate::number::Scalar;

/// The linearized equations of motion at one speed: `M q'' + C q' + K q = f`, each matrix N x N.
///
/// Rows and columns follow the coordinates of the model. For coordinates that are angles in rad, f are torques in N m,
/// M is in kg m^2, C in N m s and K in N m.
///
/// Matrices, and with them [`state_space`](Self::state_space), are in the numbers `T` throughout, so that `f32` needs no
/// `f64` on a processor without it. Eigenvalues are always computed in `f64`, which holds every `f32` exactly.
///
/// ```
/// use carvallo::{Matrix, System};
///
/// // A pendulum of 2 kg on a massless rod of 0.5 m, hanging: 0.5 q'' + 9.81 q = f.
/// let pendulum = System::new(Matrix::<f64, 1>::new(0.5), Matrix::<f64, 1>::new(0.0), Matrix::<f64, 1>::new(9.81));
/// let swing = pendulum.eigenvalues()?;
/// assert!((swing[1].im - (9.81_f64 / 0.5).sqrt()).abs() < 1e-12);
/// # Ok::<(), carvallo::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct System<const N: usize, T: Scalar = f64> {
    /// Mass matrix M.
    pub m: Matrix<T, N>,
    /// Damping matrix C = C-1/v + C0 + v C1.
    pub c: Matrix<T, N>,
    /// Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2.
    pub k: Matrix<T, N>,
    /// Which of the position and the rate of each coordinate are states.
    pub states: [States; N],
}

impl<const N: usize, T: Scalar> System<N, T> {
    /// From M, C and K. Positions and rates of all coordinates are states.
    pub const fn new(m: Matrix<T, N>, c: Matrix<T, N>, k: Matrix<T, N>) -> Self {
        Self { m, c, k, states: [States::Both; N] }
    }

    /// What multiplies the highest derivatives that the motion has: the columns of M, and those of C for coordinates of first
    /// order.
    pub(crate) fn leading(&self) -> Matrix<T, N> {
        let mut leading = self.m;
        for (column, states) in self.states.iter().enumerate() {
            if *states == States::Position {
                leading.set_column(column, &self.c.column(column));
            }
        }
        leading
    }

    /// What is computed of the same numbers as `f64`, exactly; without a copy where they are that.
    #[inline]
    pub(crate) fn widened<R>(&self, compute: impl FnOnce(&System<N>) -> R) -> R {
        if let Some(system) = (self as &dyn Any).downcast_ref() {
            return compute(system);
        }
        let [m, c, k] = [&self.m, &self.c, &self.k].map(|matrix| matrix.map(Scalar::to_f64));
        compute(&System { m, c, k, states: self.states })
    }

    /// The same, where nobody asks which entry.
    pub(crate) fn is_finite(&self) -> bool {
        let is_finite = |matrix: &Matrix<T, N>| matrix.as_slice().iter().all(|entry| entry.is_finite());
        is_finite(&self.m) && is_finite(&self.c) && is_finite(&self.k)
    }

    /// Whether every entry is finite.
    pub(crate) fn require_finite(&self) -> Result<(), SystemError> {
        for (quantity, matrix) in [("M", &self.m), ("C", &self.c), ("K", &self.k)] {
            require_all_finite(quantity, matrix)?;
        }
        Ok(())
    }
}

impl<T: Scalar, const N: usize> Coefficients<T, N> {
    /// The equations of motion at a forward speed in m/s and a gravitational field strength in N/kg.
    ///
    /// A negative speed is running backwards. All is computed in the numbers of the coefficients; those in `f32` are
    /// rounded there once more, which converting them first avoids: `Coefficients::<f64, N>::from(coefficients)`.
    ///
    /// # Errors
    /// If the speed, the gravity or an entry is not finite, if there is a C-1 and the speed is zero, or if C or K leaves the
    /// range of `T`.
    pub fn at(&self, speed: T, gravity: T) -> Result<System<N, T>, SystemError> {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states } = self;
        // Entry by entry, so that none of the matrices is copied.
        let mut c = c0.zip_map(c1, |c0, c1| c0 + c1 * speed);
        // v (v K2): the square alone may overflow where the product does not.
        let mut k = kc.zip_zip_map(k0, k2, |kc, k0, k2| kc + k0 * gravity + k2 * speed * speed);
        if self.has_odd_powers() {
            let zero = T::from_f64(0.0);
            // Where there is no C-1, nothing is divided by a speed of zero.
            c.zip_apply(cm1, |c, entry| *c += if entry == zero { entry } else { entry / speed });
            k.zip_apply(k1, |k, entry| *k += entry * speed);
        }
        // A sum is finite only where all of its terms are: nothing else is looked at where nothing is wrong.
        let system = System { m: *m, c, k, states: *states };
        if system.is_finite() { Ok(system) } else { Err(self.find_fault(speed, gravity, &system)) }
    }

    /// What keeps the equations at a speed from being finite.
    #[inline(always)]
    fn find_fault(&self, speed: T, gravity: T, system: &System<N, T>) -> SystemError {
        let zero = T::from_f64(0.0);
        let required = self.require_finite().and_then(|()| {
            require_finite("speed", speed)?;
            require_finite("gravity", gravity)?;
            if speed == zero && self.cm1.as_slice().iter().any(|&entry| entry != zero) {
                return Err(SystemError::AtRest);
            }
            require_in_range("C-1/v + C0 + v C1", &system.c)
        });
        match required {
            Ok(()) => SystemError::OutOfRange { quantity: "Kc + g K0 + v K1 + v^2 K2" },
            Err(fault) => fault,
        }
    }

    /// Whether every entry is finite.
    pub(crate) fn require_finite(&self) -> Result<(), SystemError> {
        for name in MatrixName::ALL {
            require_all_finite(name.name(), self.matrix(name))?;
        }
        Ok(())
    }
}

/// The same numbers, exactly.
impl<const N: usize> From<System<N, f32>> for System<N> {
    fn from(system: System<N, f32>) -> Self {
        system.widened(System::clone)
    }
}

/// Whether every entry of a result is finite, of what was computed from finite numbers.
pub(crate) fn require_in_range<T: Scalar, const N: usize>(
    quantity: &'static str,
    result: &Matrix<T, N>,
) -> Result<(), SystemError> {
    if result.as_slice().iter().all(|entry| entry.is_finite()) {
        Ok(())
    } else {
        Err(SystemError::OutOfRange { quantity })
    }
}

/// By their slice, which takes less than half of the iterator of matrices.
fn require_all_finite<T: Scalar, const N: usize>(
    quantity: &'static str,
    matrix: &Matrix<T, N>,
) -> Result<(), SystemError> {
    matrix.as_slice().iter().try_for_each(|&entry| require_finite(quantity, entry))
}

pub(crate) fn require_finite<T: Scalar>(quantity: &'static str, value: T) -> Result<(), SystemError> {
    if value.is_finite() { Ok(()) } else { Err(SystemError::NotFinite { quantity, value: value.to_f64() }) }
}

/// Whether a speed is one of those from zero that an analysis along the speed runs over.
pub(crate) fn require_speed(speed: f64) -> Result<(), SystemError> {
    require_finite("speed", speed)?;
    if speed < 0.0 { Err(SystemError::NegativeSpeed { speed }) } else { Ok(()) }
}
