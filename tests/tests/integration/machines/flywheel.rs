//! The bicycle with flywheels.

#![allow(non_snake_case)] // Names of the field.

use carvallo::Model;
use carvallo_models::{FlywheelBicycle, Whipple};

use super::assert_same;

/// At one speed a flywheel does what a heavier rim of a wheel would: `I v/r` more angular momentum.
#[test]
fn a_flywheel_is_a_heavier_rim_at_one_speed() {
    for (hB, hH) in [(0.0, 5.0), (3.0, 0.0), (1.25, 2.5)] {
        let bicycle = FlywheelBicycle { hB, hH, ..FlywheelBicycle::BENCHMARK };
        for speed in [0.25, 3.0, 8.0] {
            let benchmark = Whipple::BENCHMARK;
            let IRyy = benchmark.IRyy + hB * benchmark.rR / speed;
            let IFyy = benchmark.IFyy + hH * benchmark.rF / speed;
            let found = bicycle.coefficients().at(speed, bicycle.g).unwrap();
            let expected = Whipple { IRyy, IFyy, ..benchmark }.coefficients().at(speed, bicycle.g).unwrap();
            assert_same(found.m, expected.m);
            assert_same(found.c, expected.c);
            assert_same(found.k, expected.k);
        }
    }
}

/// Flywheels that turn against the wheels cancel what those do by turning, at one speed: as in the bicycle of Kooijman et al.
/// (2011), here with rims of no axial inertia.
#[test]
fn flywheels_cancel_the_spin_of_the_wheels() {
    let benchmark = Whipple::BENCHMARK;
    let speed = 5.0;
    let (hB, hH) = (-benchmark.IRyy * speed / benchmark.rR, -benchmark.IFyy * speed / benchmark.rF);
    let found = FlywheelBicycle { hB, hH, ..FlywheelBicycle::BENCHMARK }.coefficients().at(speed, 9.81).unwrap();
    let expected = Whipple { IRyy: 0.0, IFyy: 0.0, ..benchmark }.coefficients().at(speed, 9.81).unwrap();
    assert_same(found.c, expected.c);
    assert_same(found.k, expected.k);
}
