//! The state space x' = A x + B f, with the state x = (q, q').

use carvallo::{Model, System};
use carvallo_tests::bicycles;
use nalgebra::{Matrix2, Schur, Vector2, Vector4};

/// A fixed bound, since an unbounded iteration has been seen not to end.
const ITERATIONS: usize = 200;

#[test]
fn a_state_moves_as_the_equation_of_motion_says() {
    for (name, bicycle) in bicycles::all() {
        let system = bicycle.coefficients().at(4.5, bicycle.g).unwrap();
        let System { m, c, k, .. } = system;
        let (q, rate, torque) = (Vector2::new(0.1, -0.3), Vector2::new(-0.7, 0.2), Vector2::new(3.0, -0.5));
        let space = system.state_space().unwrap();
        let moved = space.a() * Vector4::new(q.x, q.y, rate.x, rate.y) + space.b() * torque;
        assert_eq!(moved.fixed_rows::<2>(0), rate, "{name}");
        let left_over = m * moved.fixed_rows::<2>(2) + c * rate + k * q - torque;
        let size = m.abs() * moved.fixed_rows::<2>(2).abs() + (c * rate).abs() + (k * q).abs() + torque.abs();
        assert!(left_over.norm() <= 1e-13 * size.norm(), "{name}: {left_over}");
    }
}

#[test]
fn its_matrix_has_the_eigenvalues_of_the_system() {
    for (name, bicycle) in bicycles::all() {
        for speed in [0.3, 2.2, 6.0, 15.0] {
            let system = bicycle.coefficients().at(speed, bicycle.g).unwrap();
            let schur = Schur::try_new(system.state_space().unwrap().a(), f64::EPSILON, ITERATIONS).unwrap();
            let mut left = schur.complex_eigenvalues().as_slice().to_vec();
            let eigenvalues = system.quartic_eigenvalues().unwrap();
            let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
            for value in eigenvalues {
                let near = left.iter().position(|other| (other - value).norm() <= 1e-10 * largest);
                left.swap_remove(near.unwrap_or_else(|| panic!("{name} at {speed}: {value} is not in {left:?}")));
            }
        }
    }
}

#[test]
fn a_force_acts_through_the_inverse_of_the_mass() {
    let system = System::new(Matrix2::new(2.0, 1.0, 1.0, 1.0), Matrix2::zeros(), Matrix2::zeros());
    let b = system.state_space().unwrap().b();
    assert_eq!(b.fixed_rows::<2>(0), Matrix2::zeros());
    assert_eq!(b.fixed_rows::<2>(2), Matrix2::new(1.0, -1.0, -1.0, 2.0));
}
