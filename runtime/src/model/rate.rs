//! Rates that follow from the coordinates of a mechanism.

use crate::number::Scalar;

/// The rate of something that rolls, such as the yaw rate of a bicycle or the spin of a wheel, to first order:
///
/// ```text
/// v speed + rates · q' + v (coordinates · q + heading psi)
/// ```
///
/// with the forward speed v in m/s, the N coordinates q of the model, and the yaw angle psi in rad, positive to the right,
/// where that is no coordinate. In rad/s for what turns and m/s for what slides.
///
/// The path over the ground follows: integrate the yaw rate to psi and the lateral velocity, which is v psi and more, to y;
/// x is v t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate<T, const N: usize> {
    /// In steady straight motion, divided by v.
    pub speed: T,
    /// The part proportional to each q'.
    pub rates: [T; N],
    /// The part proportional to v and each q.
    pub coordinates: [T; N],
    /// The part proportional to v and the yaw.
    pub heading: T,
}

impl<T: Scalar, const N: usize> Rate<T, N> {
    /// The rate at a forward speed, coordinates `q`, their rates `q_dot`, and a yaw angle `psi`.
    pub fn at(&self, v: T, q: &[T; N], q_dot: &[T; N], psi: T) -> T {
        let dot = |factors: &[T; N], values: &[T; N]| {
            factors.iter().zip(values).fold(T::from_f64(0.0), |sum, (factor, value)| sum + *factor * *value)
        };
        v * (self.speed + dot(&self.coordinates, q) + self.heading * psi) + dot(&self.rates, q_dot)
    }
}

#[cfg(test)]
mod tests {
    use super::Rate;

    #[test]
    fn parts_add_up() {
        let rate = Rate { speed: -2.0, rates: [3.0, 0.0], coordinates: [0.0, 5.0], heading: 7.0 };
        assert_eq!(rate.at(10.0, &[100.0, 1.0], &[1.0, 100.0], 0.5), 10.0 * (-2.0 + 5.0 + 3.5) + 3.0);
    }
}
