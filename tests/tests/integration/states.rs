//! Coordinates of which only the position or only the rate is a state, against closed forms.

use carvallo::{Complex, Matrix, States, System};
use nalgebra::{Matrix1, Matrix2, Matrix3};

fn assert_eigenvalues<const N: usize>(system: &System<N>, expected: &[Complex<f64>]) {
    let found = system.eigenvalues().expect("a regular system");
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).norm() <= 1e-14 * expected.norm().max(1.0), "{found} is not {expected}");
    }
}

fn real(values: &[f64]) -> Vec<Complex<f64>> {
    values.iter().map(|value| Complex::from(*value)).collect()
}

#[test]
fn one_coordinate_has_one_eigenvalue() {
    let [m, c, k] = [2.0, 3.0, 5.0].map(Matrix1::new);
    let held = System { states: [States::Position], ..System::new(Matrix1::zeros(), c, k) };
    assert_eigenvalues(&held, &real(&[-5.0 / 3.0]));
    let coasting = System { states: [States::Rate], ..System::new(m, c, Matrix1::zeros()) };
    assert_eigenvalues(&coasting, &real(&[-1.5]));
}

/// Sideways and yaw rate of a car: `M r' + C r = 0`, a quadratic.
#[test]
fn rates_alone_are_the_eigenvalues_of_damping() {
    let (m, c) = (Matrix2::new(1200.0, 0.0, 0.0, 1500.0), Matrix2::new(7000.0, 23500.0, -500.0, 10750.0));
    let car = System { states: [States::Rate; 2], ..System::new(m, c, Matrix2::zeros()) };
    let (a, d) = (7000.0_f64 / 1200.0, 10750.0 / 1500.0);
    let (half, product) = ((a + d) / 2.0, a * d + 23500.0 * 500.0 / 1200.0 / 1500.0);
    let root = (product - half * half).sqrt();
    assert_eigenvalues(&car, &[Complex::new(-half, -root), Complex::new(-half, root)]);
    // Of the four states of the state space two have neither a row nor a column.
    let space = car.state_space().expect("a regular system");
    let (a, b) = (space.a(), space.b());
    assert!((0..2).all(|i| a.row(i).iter().chain(a.column(i).iter()).chain(b.row(i).iter()).all(|&x| x == 0.0)));
    assert_eq!([a[(2, 2)], a[(3, 2)], b[(2, 0)]], [-7000.0 / 1200.0, 500.0 / 1500.0, 1.0 / 1200.0]);
}

/// A mass on a spring whose other end is a dashpot: `m x'' + k (x - s) = 0` and `c s' + k (s - x) = 0`, beside a coordinate
/// on its own. The first two have the eigenvalues 0, as nothing holds them, and those of `m c p² + m k p + k c`.
#[test]
fn a_coordinate_of_first_order_has_one_eigenvalue_beside_others() {
    let (m, c, k) = (2.0_f64, 8.0_f64, 3.0_f64);
    for order in [[0, 1, 2], [2, 0, 1], [1, 2, 0]] {
        let place = |entries: [[f64; 3]; 3]| Matrix3::from_fn(|i, j| entries[order[i]][order[j]]);
        let system = System::new(
            place([[m, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
            place([[0.0, 0.0, 0.0], [0.0, c, 0.0], [0.0, 0.0, 7.0]]),
            place([[k, -k, 0.0], [-k, k, 0.0], [0.0, 0.0, 12.0]]),
        );
        let states = order.map(|coordinate| if coordinate == 1 { States::Position } else { States::Both });
        let half = k / c / 2.0;
        let root = (k / m - half * half).sqrt();
        let pair = [Complex::new(-half, -root), Complex::new(-half, root)];
        let expected = [real(&[-4.0, -3.0]), pair.to_vec(), real(&[0.0])].concat();
        assert_eigenvalues(&System { states, ..system }, &expected);
    }
}

/// The state space of the same, with the rate of the coordinate of first order in the row of its position.
#[test]
fn state_spaces_have_what_is_solved_for_in_the_rows_of_states() {
    let (m, c, k) = (2.0, 8.0, 4.0);
    let system =
        System::new(Matrix2::new(m, 0.0, 0.0, 0.0), Matrix2::new(0.0, 0.0, 0.0, c), Matrix2::new(k, -k, -k, k));
    let system = System { states: [States::Both, States::Position], ..system };
    let space = system.state_space().expect("a regular system");
    let expected = [[0.0, 0.0, 1.0, 0.0], [0.5, -0.5, 0.0, 0.0], [-2.0, 2.0, 0.0, 0.0], [0.0; 4]];
    let a = space.a();
    assert!((0..4).all(|i| (0..4).all(|j| a[(i, j)] == expected[i][j])), "{a}");
    let b = space.b();
    assert_eq!([b[(1, 1)], b[(2, 0)], b[(3, 1)], b[(0, 0)]], [0.125, 0.5, 0.0, 0.0]);
    // Without damping nothing could be solved for its rate.
    let undamped = System { c: Matrix::<f64, 2>::zeros(), ..system };
    assert_eq!(undamped.eigenvalues(), Err(carvallo::SystemError::SingularMass));
}
