//! The characteristic polynomial of two coordinates and its derivatives, at any scale of the matrices.

use super::pencil::equilibrate;
use crate::numeric::{DoubleDouble, Tracked, exponent, ldexp};
use crate::system::{Coefficients, Matrix};

/// The coefficients of `det(M s^2 + C s + K)` in s, ascending, or their derivatives.
pub(super) type Quartic = [Tracked; 5];

/// Something for each entry of `[K, C, M]`.
pub(super) type Entries<T> = [[[T; 3]; 2]; 2];

/// The matrices of two coordinates, with rows, columns, time and speed measured in powers of two that bring all entries to
/// at most about one.
pub(super) struct Scaled {
    coefficients: Coefficients<f64, 2>,
    /// Gravity is this, times a power of two that K0 is scaled by.
    gravity: f64,
    gravity_exponent: i32,
    rows: [i32; 2],
    columns: [i32; 2],
    pub(super) speed_unit: i32,
    pub(super) time_unit: i32,
}

impl Scaled {
    pub(super) fn new(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Self {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let (rows, columns) = equilibrate(m);
        let largest = |matrix: &Matrix<f64, 2>| {
            let places = (0..4).map(|i| (i / 2, i % 2));
            places.filter_map(|(i, j)| Some(exponent(matrix[(i, j)])? + rows[i] + columns[j])).max()
        };
        let gravity_exponent = exponent(gravity).unwrap_or(0);
        let weight = if gravity == 0.0 { None } else { largest(k0).map(|e| e + gravity_exponent) };
        let half = |e: i32| (e + 1).div_euclid(2);
        let time_unit = largest(c0).max(largest(kc).max(weight).map(half)).unwrap_or(0);
        let speed_unit = time_unit - largest(c1).max(largest(k2).map(half)).unwrap_or(time_unit);
        let gravity = ldexp(gravity, -gravity_exponent);
        let mut scaled =
            Self { coefficients: *coefficients, gravity, gravity_exponent, rows, columns, speed_unit, time_unit };
        scaled.coefficients = scaled.scaled(coefficients);
        scaled
    }

    /// Other coefficients, or derivatives of them, in the same units.
    pub(super) fn scaled(&self, coefficients: &Coefficients<f64, 2>) -> Coefficients<f64, 2> {
        let scaled = |matrix: &Matrix<f64, 2>, power: i32| {
            Matrix::from_fn(|i, j| ldexp(matrix[(i, j)], self.rows[i] + self.columns[j] + power))
        };
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let (time, speed) = (self.time_unit, self.speed_unit);
        Coefficients {
            m: scaled(m, 0),
            c0: scaled(c0, -time),
            c1: scaled(c1, speed - time),
            kc: scaled(kc, -2 * time),
            k0: scaled(k0, self.gravity_exponent - 2 * time),
            k2: scaled(k2, 2 * (speed - time)),
        }
    }

    /// The characteristic polynomial at a scaled speed.
    pub(super) fn characteristic(&self, speed: DoubleDouble) -> Quartic {
        let [[a, b], [c, d]] = self.matrices(speed);
        powers(|i, j| a[i] * d[j] - b[i] * c[j])
    }

    /// The entries of K, C and M at a scaled speed.
    pub(super) fn matrices(&self, speed: DoubleDouble) -> Entries<Tracked> {
        self.entries(&self.coefficients, speed)
    }

    /// The derivative of the characteristic polynomial with respect to the speed.
    pub(super) fn by_speed(&self, speed: DoubleDouble) -> Quartic {
        let Coefficients { c1, k2, .. } = &self.coefficients;
        let twice = Tracked::from(speed + speed);
        let entry = |i, j| [twice * k2[(i, j)].into(), c1[(i, j)].into(), Tracked::ZERO];
        self.along(&[[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]], speed)
    }

    /// Its derivative in the direction of scaled derivatives of the coefficients.
    fn by(&self, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> Quartic {
        self.along(&self.entries(direction, speed), speed)
    }

    fn along(&self, [[da, db], [dc, dd]]: &Entries<Tracked>, speed: DoubleDouble) -> Quartic {
        let [[a, b], [c, d]] = self.matrices(speed);
        powers(|i, j| (da[i] * d[j] + a[i] * dd[j]) - (db[i] * c[j] + b[i] * dc[j]))
    }

    fn entries(&self, coefficients: &Coefficients<f64, 2>, speed: DoubleDouble) -> Entries<Tracked> {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let speed = Tracked::from(speed);
        let entry = |i, j| {
            let weight: Tracked = DoubleDouble::product(self.gravity, k0[(i, j)]).into();
            let stiffness = Tracked::from(kc[(i, j)]) + weight + speed * speed * k2[(i, j)].into();
            [stiffness, Tracked::from(c0[(i, j)]) + speed * c1[(i, j)].into(), m[(i, j)].into()]
        };
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
    }

    /// The derivatives of K, C and M at a scaled speed in the direction of scaled derivatives of the coefficients.
    pub(super) fn direction(&self, direction: &Coefficients<f64, 2>, speed: f64) -> Entries<f64> {
        let Coefficients { m, c0, c1, kc, k0, k2 } = direction;
        let k = kc + k0 * self.gravity + k2 * speed * speed;
        let c = c0 + c1 * speed;
        let entry = |i, j| [k[(i, j)], c[(i, j)], m[(i, j)]];
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
    }

    /// How many of the lowest coefficients are zero at all speeds.
    pub(super) fn zeros(&self, speed: DoubleDouble) -> usize {
        let is_zero = |power: usize| samples(speed).iter().all(|&v| self.characteristic(v)[power].sign() == 0);
        (0..4).take_while(|&power| is_zero(power)).count()
    }

    /// Whether so many of the lowest coefficients stay zero at all speeds in a direction.
    pub(super) fn keeps_zeros(&self, zeros: usize, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> bool {
        zeros == 0 || samples(speed).iter().all(|&v| self.by(direction, v)[..zeros].iter().all(|p| p.sign() == 0))
    }
}

/// Different speeds, more than the degree of the coefficients, which are polynomials in the speed; the first one tells most.
fn samples(speed: DoubleDouble) -> [DoubleDouble; 5] {
    [2.0, 3.0, 4.0, 5.0, 1.0].map(|factor: f64| speed * factor.into())
}

/// The coefficients of a sum of products of two polynomials of the second degree, given the terms of a pair of powers.
fn powers(terms: impl Fn(usize, usize) -> Tracked) -> Quartic {
    let mut product = [Tracked::ZERO; 5];
    for i in 0..3 {
        for j in 0..3 {
            product[i + j] = product[i + j] + terms(i, j);
        }
    }
    product
}
