//! Differences of the forces about upright straight running.

use carvallo::{Coefficients, Matrix, System};

use super::Mechanism;
use super::dynamics::Drive;

/// Which quantity of the independent coordinates is varied.
#[derive(Clone, Copy)]
enum Varied {
    Position,
    Rate,
    Acceleration,
}

impl Mechanism {
    /// The coefficient matrices for independent coordinates, while `forward` runs at any constant speed.
    ///
    /// Whatever holds the mechanism in the reference motion, such as the preload of a spring, is taken to be constant.
    pub fn linearized<const N: usize>(&self, independent: [usize; N], forward: Option<usize>) -> Coefficients<f64, N> {
        let at = |speed, gravity| self.linearized_at(&Drive { independent, forward, speed, gravity });
        let System { m, c: c0, k: kc, .. } = at(0.0, 0.0);
        let running = at(1.0, 0.0);
        let heavy = at(0.0, 1.0);
        Coefficients { m, c0, c1: running.c - c0, kc, k0: heavy.k - kc, k2: running.k - kc, ..Default::default() }
    }

    /// The linearized equations at one speed and one gravity.
    pub fn linearized_at<const N: usize>(&self, drive: &Drive<N>) -> System<N> {
        // The forces are linear in the accelerations and, with the rates that follow, quadratic in the rates, so that
        // central differences over any step are exact; a step of one has no rounding of its own.
        let slope =
            |varied, step| (self.varied(drive, varied, step) - self.varied(drive, varied, -step)) / (2.0 * step);
        let (near, far) = (slope(Varied::Position, STEP), slope(Varied::Position, 2.0 * STEP));
        // Richardson: the error that grows with the square of the step drops out.
        let k = (near * 4.0 - far) / 3.0;
        System::new(slope(Varied::Acceleration, 1.0), slope(Varied::Rate, 1.0), k)
    }

    /// The forces when one independent coordinate after the other, by columns, has a displacement, rate or acceleration.
    fn varied<const N: usize>(&self, drive: &Drive<N>, varied: Varied, amount: f64) -> Matrix<f64, N> {
        Matrix::from_columns(&std::array::from_fn::<_, N, _>(|column| {
            let mut motion = [[0.0; N]; 3];
            motion[varied as usize][column] = amount;
            self.forces(drive, motion).fixed_rows::<N>(0).into_owned()
        }))
    }
}

/// In rad or m: small enough for errors of the fourth order in it to drown in those of rounding.
const STEP: f64 = 2e-4;
