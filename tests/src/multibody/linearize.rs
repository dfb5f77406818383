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
    pub fn linearized<const N: usize>(&self, independent: [usize; N], forward: Option<usize>) -> Coefficients<f64, N> {
        self.linearized_by(&Drive::new(independent, forward))
    }

    /// The same at any speed and gravity of what drives the mechanism.
    ///
    /// Whatever holds the mechanism in the reference motion, such as the preload of a spring, is taken to be constant.
    pub fn linearized_by<const N: usize>(&self, drive: &Drive<N>) -> Coefficients<f64, N> {
        let at = |speed, gravity| self.linearized_at(&Drive { speed, gravity, ..*drive });
        // Without speed there is no slip angle: three others tell apart what goes with 1/v, 1 and v, and with 1, v and v².
        let [slow, running, fast] = [0.5, 1.0, 2.0].map(|speed| at(speed, 0.0));
        let heavy = at(1.0, 1.0);
        let [cm1, c0, c1] = powers([slow.c * 0.5, running.c, fast.c * 2.0]);
        let [kc, k1, k2] = powers([slow.k, running.k, fast.k]);
        Coefficients { m: running.m, cm1, c0, c1, kc, k1, k0: heavy.k - running.k, k2, ..Default::default() }
    }

    /// The linearized equations at one speed and one gravity.
    pub fn linearized_at<const N: usize>(&self, drive: &Drive<N>) -> System<N> {
        let slope =
            |varied, step| (self.varied(drive, varied, step) - self.varied(drive, varied, -step)) / (2.0 * step);
        // Richardson: the error that grows with the square of the step drops out.
        let small = |varied| (slope(varied, STEP) * 4.0 - slope(varied, 2.0 * STEP)) / 3.0;
        // Without slip angles the forces are quadratic in the rates with those that follow, and they are linear in the
        // accelerations, so that central differences over any step are exact; a step of one has no rounding of its own.
        let slips = self.contacts.iter().any(|contact| contact.slip.is_some());
        let by_rates = if slips { small(Varied::Rate) } else { slope(Varied::Rate, 1.0) };
        System::new(slope(Varied::Acceleration, 1.0), by_rates, small(Varied::Position))
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

/// The coefficients of the polynomial of the second degree that has these values at 1/2, 1 and 2.
fn powers<const N: usize>([half, one, two]: [Matrix<f64, N>; 3]) -> [Matrix<f64, N>; 3] {
    // Divided differences.
    let (below, above) = ((one - half) / 0.5, two - one);
    let second = (above - below) / 1.5;
    let first = below - second * 1.5;
    [one - first - second, first, second]
}

/// In rad or m, and their rates: small enough for errors of the fourth order in it to drown in those of rounding.
const STEP: f64 = 2e-4;
