//! Derivatives of gains, against differences of gains, which are held against SciPy, and against a closed form.

use carvallo_design::Design;
use nalgebra::DMatrix;

use super::{design, regulators};
use crate::{Regulator, Weights};

fn gains(design: &Design, speed: f64, weights: &Weights) -> DMatrix<f64> {
    Regulator::new(design, speed, weights).expect("a regulator").gains
}

/// The derivative with respect to a parameter by differences of sixth order, whose error is some 1e-9 of the gains.
fn by_differences(design: &Design, speed: f64, weights: &Weights, parameter: usize) -> DMatrix<f64> {
    let step = 1e-3 * design.parameters[parameter].value.abs().max(1e-2);
    let at = |steps: f64| {
        let mut values = design.values();
        values[parameter] += steps * step;
        gains(&design.with_values(&values).expect("a design"), speed, weights)
    };
    ((at(1.0) - at(-1.0)) * 45.0 - (at(2.0) - at(-2.0)) * 9.0 + (at(3.0) - at(-3.0))) / (60.0 * step)
}

#[test]
fn derivatives_of_gains_are_those_of_differences() {
    for (model, set, speed, inputs, weights) in [
        ("Whipple", "pista", 3.0, &["Tdelta"][..], &[][..]),
        ("Whipple", "pista", 6.0, &["Tphi", "Tdelta"], &["phi=10", "delta_rate=0.1", "Tdelta=0.5"]),
        // Yaw and place, which follow from the geometry.
        ("Whipple", "benchmark", 5.0, &["Tdelta"], &["phi=1", "psi=2", "y=0.5", "psi_rate=0.3", "Tdelta=0.01"]),
        ("Motorcycle", "standard", 20.0, &["Tdelta"], &[]),
        ("DoublePendulum", "rods", 0.0, &["Ttheta1", "Ttheta2"], &[]),
        ("TowedWheel", "example", 2.0, &["Tpsi", "Fy"], &["psi=1", "y_rate=2"]),
    ] {
        let design = design(model, set);
        let weights = regulators::read(&design, inputs, weights).expect("weights");
        let regulator = Regulator::new(&design, speed, &weights).expect("a regulator");
        let found = regulator.sensitivities(&design, &weights).expect("derivatives");
        assert_eq!(found.len(), design.parameters.len());
        let mut moved = 0;
        for (parameter, found) in found.iter().enumerate() {
            let expected = by_differences(&design, speed, &weights, parameter);
            let name = design.info().parameters[parameter].name;
            let size = regulator.gains.norm() / design.parameters[parameter].value.abs().max(1e-2) + expected.norm();
            let error = (found - &expected).norm() / size;
            assert!(error < 1e-8, "{model} {set} by {name}: {error:e}, {found} is not {expected}");
            moved += usize::from(expected.norm() > 1e-3 * size);
        }
        assert!(moved > 3, "{model}: {moved}");
    }
}

/// `m l^2 x'' = -m g l x + T` with the weights q of x and 1 of T: `K = -m g l + sqrt((m g l)^2 + q)`.
#[test]
fn a_pendulum_has_a_closed_form() {
    let pendulum = design("Pendulum", "seconds");
    let value = |name: &str| pendulum.value(name).expect("a parameter");
    let stiffness = value("m") * value("g") * value("l");
    let weights = regulators::read(&pendulum, &["Ttheta"], &["theta=3"]).expect("weights");
    let found = Regulator::new(&pendulum, 0.0, &weights).expect("a regulator").sensitivities(&pendulum, &weights);
    let found = found.expect("derivatives");
    for name in ["m", "g", "l"] {
        let by_stiffness = -1.0 + stiffness / (stiffness * stiffness + 3.0).sqrt();
        let expected = by_stiffness * stiffness / value(name);
        let place = pendulum.info().position(name).expect("a parameter");
        assert!(
            (found[place][(0, 0)] - expected).abs() < 1e-13 * expected.abs(),
            "{name}: {} {expected}",
            found[place]
        );
    }
}
