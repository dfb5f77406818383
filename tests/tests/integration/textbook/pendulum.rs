//! Chains of links.

use carvallo::Coefficients;
use carvallo_tests::textbook::pendulum::{Link, standing, standing_at_hinges};
use nalgebra::Matrix2;

use super::{G, same};

/// Kibble & Berkshire, eq. 11.21, with the mass M on L above and m on l below.
#[test]
fn a_double_pendulum_has_the_published_frequencies() {
    let [upper, lower] = [(1.3, 0.7), (0.4, 1.9)].map(|(m, l)| Link { l, a: l, m, i: 0.0 });
    let found = squared_frequencies(&standing([upper, lower]));
    let ratio = (upper.m + lower.m) / upper.m;
    let sum = ratio * (G / upper.l + G / lower.l);
    let product = ratio * G * G / (upper.l * lower.l);
    assert!((found[0] + found[1] - sum).abs() < 1e-13 * sum);
    assert!((found[0] * found[1] - product).abs() < 1e-13 * product);
}

/// Riley, Hobson & Bence, problem 9.7: T = M l^2 (8/3 q1'^2 + 2 q1' q2' + 2/3 q2'^2), V = M g l (3/2 q1^2 + 1/2 q2^2)
/// for two rods of the mass M and the length 2 l each, hanging.
#[test]
fn two_equal_rods_have_the_published_energies() {
    let [mass, l] = [2.0, 0.3];
    let rod = Link { l: 2.0 * l, a: l, m: mass, i: mass * (2.0 * l).powi(2) / 12.0 };
    let found = standing([rod, rod]);
    same(found.m, Matrix2::new(16.0 / 3.0, 2.0, 2.0, 4.0 / 3.0) * (mass * l * l), "M");
    same(found.k0, Matrix2::new(-3.0, 0.0, 0.0, -1.0) * (mass * l), "K0");
}

/// Abramowitz & Stegun, table 25.9: the zeros of Laguerre's polynomials of degrees 1 to 5.
#[test]
fn equal_weights_on_equal_strings_swing_at_the_zeros_of_the_polynomials_of_laguerre() {
    let weight = Link { l: 0.5, a: 0.5, m: 0.7, i: 0.0 };
    check([weight], &[1.0]);
    check([weight; 2], &[0.585786437627, 3.414213562373]);
    check([weight; 3], &[0.415774556783, 2.294280360279, 6.289945082937]);
    check([weight; 4], &[0.322547689619, 1.745761101158, 4.536620296921, 9.395070912301]);
    check([weight; 5], &[0.263560319718, 1.413403059107, 3.596425771041, 7.085810005859, 12.640800844276]);

    fn check<const N: usize>(links: [Link; N], zeros: &[f64]) {
        for coefficients in [standing(links), standing_at_hinges(links)] {
            for (found, zero) in squared_frequencies(&coefficients).into_iter().zip(zeros) {
                assert!((found * links[0].l / G - zero).abs() <= 1e-12 * zeros[N - 1], "{found} instead of {zero} g/l");
            }
        }
    }
}

/// The angles at the hinges of a chain of different links: what one hinge's torque does is what the parts above do.
#[test]
fn at_the_hinges_the_uppermost_feels_its_own_link_and_the_lowest_all_as_one_body() {
    let links = [(0.9, 0.4, 3.0, 0.2), (0.7, 0.3, 2.0, 0.1), (0.5, 0.2, 1.0, 0.05)];
    let links = links.map(|(l, a, m, i)| Link { l, a, m, i });
    let found = standing_at_hinges(links);
    // By the parallel axis theorem, the heights of the centres above the lowest hinge.
    let heights = [0.4, 0.9 + 0.3, 0.9 + 0.7 + 0.2];
    let parts = links.into_iter().zip(heights);
    let whole: f64 = parts.clone().map(|(link, height)| link.i + link.m * height * height).sum();
    let moment: f64 = parts.map(|(link, height)| link.m * height).sum();
    assert!((found.m[(0, 0)] - whole).abs() < 1e-14 * whole);
    assert!((found.k0[(0, 0)] + moment).abs() < 1e-14 * moment);
    assert!((found.m[(2, 2)] - (0.05 + 1.0 * 0.2 * 0.2)).abs() < 1e-15);
    assert!((found.k0[(2, 2)] + 1.0 * 0.2).abs() < 1e-15);
}

/// The squared frequencies of the chain when it hangs, in increasing order.
fn squared_frequencies<const N: usize>(standing: &Coefficients<f64, N>) -> Vec<f64> {
    let eigenvalues = standing.at(0.0, -G).unwrap().eigenvalues().unwrap();
    let mut squares: Vec<f64> =
        eigenvalues.iter().filter(|value| value.im > 0.0).map(|value| value.im * value.im).collect();
    squares.sort_by(f64::total_cmp);
    assert_eq!(squares.len(), N, "{eigenvalues:?}");
    squares
}
