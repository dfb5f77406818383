//! Comparisons up to a tolerance, by the traits of the crate `approx`.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use super::at_speed::System;
use super::coefficients::Coefficients;
use super::state_space::StateSpace;
use crate::number::Scalar;

/// A comparison of all matrices entry by entry, as nalgebra compares one, and of what else there is for equality.
macro_rules! compare {
    ($Type:ident<$($parameter:tt),+>: $($matrix:ident),+ $(; $same:ident)?) => {
        impl<const N: usize, T> AbsDiffEq for $Type<$($parameter),+>
        where
            T: Scalar + AbsDiffEq<Epsilon: Copy>,
        {
            type Epsilon = T::Epsilon;

            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                let Self { $($matrix,)+ $($same)? } = self;
                $($matrix.abs_diff_eq(&other.$matrix, epsilon))&&+ $(&& *$same == other.$same)?
            }
        }

        impl<const N: usize, T> RelativeEq for $Type<$($parameter),+>
        where
            T: Scalar + RelativeEq<Epsilon: Copy>,
        {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }

            fn relative_eq(&self, other: &Self, epsilon: T::Epsilon, relative: T::Epsilon) -> bool {
                let Self { $($matrix,)+ $($same)? } = self;
                $($matrix.relative_eq(&other.$matrix, epsilon, relative))&&+ $(&& *$same == other.$same)?
            }
        }

        impl<const N: usize, T> UlpsEq for $Type<$($parameter),+>
        where
            T: Scalar + UlpsEq<Epsilon: Copy>,
        {
            fn default_max_ulps() -> u32 {
                T::default_max_ulps()
            }

            fn ulps_eq(&self, other: &Self, epsilon: T::Epsilon, ulps: u32) -> bool {
                let Self { $($matrix,)+ $($same)? } = self;
                $($matrix.ulps_eq(&other.$matrix, epsilon, ulps))&&+ $(&& *$same == other.$same)?
            }
        }
    };
}

compare!(Coefficients<T, N>: m, cm1, c0, c1, kc, k0, k1, k2; states);
compare!(System<N, T>: m, c, k; states);
compare!(StateSpace<N, T>: stiffness, damping, input; states);

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq, assert_ulps_eq};

    use super::*;
    use crate::system::{Matrix, MatrixName, States};

    fn next(number: f64) -> f64 {
        f64::from_bits(number.to_bits() + 1)
    }

    /// Coefficients of which no two entries are alike.
    fn coefficients() -> Coefficients<f64, 2> {
        let rows = |matrix: usize| [0, 1].map(|row| [0, 1].map(|column| (2 + 7 * matrix + 3 * row + column) as f64));
        Coefficients::from_rows(core::array::from_fn(rows))
    }

    #[test]
    fn a_difference_in_any_entry_is_seen() {
        let same = coefficients();
        for name in MatrixName::ALL {
            for at in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let mut other = same;
                let entry = &mut other.matrix_mut(name)[at];
                *entry = next(*entry);
                let difference = *entry - same.matrix(name)[at];
                assert_abs_diff_eq!(same, other, epsilon = difference);
                assert!(same.abs_diff_ne(&other, 0.9 * difference));
                assert_relative_eq!(same, other, epsilon = 0.0, max_relative = f64::EPSILON);
                assert!(same.relative_ne(&other, 0.0, 0.1 * f64::EPSILON));
                assert_ulps_eq!(same, other, epsilon = 0.0, max_ulps = 1);
                assert!(same.ulps_ne(&other, 0.0, 0));
            }
        }
    }

    #[test]
    fn what_else_differs_is_no_matter_of_tolerance() {
        let same = coefficients();
        let other = Coefficients { states: [States::Both, States::Rate], ..same };
        assert!(same.abs_diff_ne(&other, 1.0) && same.relative_ne(&other, 1.0, 1.0) && same.ulps_ne(&other, 1.0, 100));
    }

    #[test]
    fn systems_and_state_spaces_are_compared_in_each_matrix() {
        let one = Matrix::<f32, 1>::new(1.0);
        let system = System::new(one, one, one);
        let larger = one * 1.001;
        for other in [System { m: larger, ..system }, System { c: larger, ..system }, System { k: larger, ..system }] {
            assert_relative_eq!(system, other, max_relative = 1.1e-3);
            assert!(system.relative_ne(&other, 0.0, 0.9e-3));
            let [space, other] = [system, other].map(|system| system.state_space().unwrap());
            assert_relative_eq!(space, other, max_relative = 1.1e-3);
            assert!(space.relative_ne(&other, 0.0, 0.9e-3));
        }
    }
}
