//! The car with a trailer, against a second derivation.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Change, Coefficients, Matrix, Model, Stability, States};
use carvallo_models::CarTrailer;
use nalgebra::Vector3;

use super::{assert_near, assert_same, eigenvalues};

/// By Lagrange, in a place across the road Y, the yaw psi and the angle q. A point at x of the car is at `Y + x psi`, one at u
/// behind the ball at `Y - (h + u) psi - u q`: rows of coefficients, in which the kinetic energy is a sum of squares. A tyre
/// slips by the rate of its place less the heading of its wheel times v. With the velocity along the axes of the car in the
/// place of Y' = y' + v psi the heading of the car cancels, and Y'' = y'' + v psi'.
fn derived(vehicle: CarTrailer) -> Coefficients<f64, 3> {
    let CarTrailer { m, I, a, b, h, mT, IT, e, l, Cf, Cr, CT, d, .. } = vehicle;
    let car = |x: f64| Vector3::new(1.0, x, 0.0);
    let trailer = |u: f64| Vector3::new(1.0, -h - u, -u);
    let (yaw, trailer_yaw, angle) = (Vector3::y(), Vector3::new(0.0, 1.0, 1.0), Vector3::z());
    let square = |of: Vector3<f64>| of * of.transpose();
    let inertia = square(car(0.0)) * m + square(yaw) * I + square(trailer(e)) * mT + square(trailer_yaw) * IT;
    let slip = square(car(a)) * Cf + square(car(-b)) * Cr + square(trailer(l)) * CT;
    Coefficients {
        m: inertia,
        cm1: slip,
        c0: square(angle) * d,
        c1: inertia.column(0) * yaw.transpose(),
        kc: -trailer(l) * angle.transpose() * CT,
        states: [States::Rate, States::Rate, States::Both],
        ..Default::default()
    }
}

const VEHICLES: [CarTrailer; 3] = [
    CarTrailer::CARAVAN,
    CarTrailer::LOADED_BEHIND,
    CarTrailer { m: 900.0, h: 2.1, e: 1.9, l: 2.3, Cf: 55e3, Cr: 64e3, CT: 31e3, d: 700.0, ..CarTrailer::CARAVAN },
];

#[test]
fn a_car_with_a_trailer_is_that_of_a_second_derivation() {
    for vehicle in VEHICLES {
        let (found, expected) = (vehicle.coefficients(), derived(vehicle));
        assert_eq!(found.states, expected.states);
        let pairs =
            [(found.m, expected.m), (found.cm1, expected.cm1), (found.c1, expected.c1), (found.kc, expected.kc)];
        pairs.into_iter().for_each(|(found, expected)| assert_same(found, expected));
        assert_same(found.c0, expected.c0);
        assert_eq!([found.k0, found.k1, found.k2], [Matrix::<f64, 3>::zeros(); 3]);
    }
}

/// The speed above which it snakes is where a bisection ends with the rightmost eigenvalue of the second derivation.
#[test]
fn a_car_with_a_trailer_snakes_above_its_critical_speed() {
    for vehicle in [CarTrailer::CARAVAN, CarTrailer::LOADED_BEHIND] {
        let stability = Stability::new(&vehicle.coefficients(), vehicle.g).expect("an answer");
        let [snaking] = stability.critical_speeds[..] else { panic!("{stability:?}") };
        assert_eq!(snaking.change, Change::Destabilizes);
        let coefficients = derived(vehicle);
        let grows = |speed: f64| eigenvalues(&coefficients, speed, 0.0).iter().any(|value| value.re > 0.0);
        let [mut slow, mut fast] = [1.0, 200.0];
        assert!(!grows(slow) && grows(fast));
        while fast - slow > 1e-12 * fast {
            let middle = (slow + fast) / 2.0;
            *(if grows(middle) { &mut fast } else { &mut slow }) = middle;
        }
        assert_near(snaking.speed, slow, 1e-10);
        assert!(snaking.eigenvalue.im != 0.0);
    }
    // A load behind the axle makes it snake sooner, which every instruction of caravans says.
    let [well, badly] = [CarTrailer::CARAVAN, CarTrailer::LOADED_BEHIND]
        .map(|vehicle| Stability::new(&vehicle.coefficients(), vehicle.g).unwrap().critical_speeds[0].speed);
    assert!(badly < well, "{badly} and {well}");
}
