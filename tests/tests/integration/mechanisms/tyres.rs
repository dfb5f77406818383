//! Wheels that slip sideways: machines on tyres whose side force is linear in slip and camber.

use carvallo::{Coefficients, Complex, States};
use carvallo_compiler::compile;

use super::interpreted;

/// A motorcycle after R. S. Sharp, The stability and control of motorcycles, J. Mech. Eng. Sci. 13 (1971): two bodies on two
/// tyres whose side forces relax, with the parameters of case 1.
const MOTORCYCLE: &str = include_str!("motorcycle.txt");

/// The eigenvalues that he prints for it, in 1/s, by speed in ft/s: capsize, weave and wobble.
const PRINTED: [(f64, f64, [f64; 2], [f64; 2]); 8] = [
    (10.0, -3.56, [2.01, 1.63], [-5.20, 55.7]),
    (20.0, -2.83, [-0.18, 2.09], [-5.91, 55.8]),
    (30.0, -0.13, [-3.36, 4.56], [-6.42, 55.5]),
    (50.0, 0.08, [-6.59, 11.4], [-6.52, 54.6]),
    (70.0, 0.08, [-3.97, 16.8], [-5.70, 54.0]),
    (100.0, 0.07, [-1.82, 19.2], [-3.94, 54.3]),
    (130.0, 0.05, [-1.13, 20.4], [-2.24, 55.6]),
    (160.0, 0.04, [-0.96, 21.2], [-0.82, 57.5]),
];

/// Half a unit of the last of the digits that are printed of a number: two behind the point, or three in all.
fn half_a_unit(printed: f64) -> f64 {
    if printed.abs() < 10.0 { 0.005 } else { 0.05 }
}

#[test]
fn a_motorcycle_has_the_eigenvalues_that_sharp_prints() {
    let compiled = compile(MOTORCYCLE.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error:?}"));
    let states: Vec<_> =
        compiled.model.coordinates.iter().map(|coordinate| format!("{:?}", coordinate.states)).collect();
    assert_eq!(states, ["Rate", "Rate", "Both", "Both", "Position", "Position"]);
    let set = &compiled.model.sets[0];
    let matrices: Coefficients<f64, 6> = interpreted(&compiled, &set.values);
    let states = [States::Rate, States::Rate, States::Both, States::Both, States::Position, States::Position];
    let matrices = Coefficients { states, ..matrices };
    let mut checked = 0;
    for (speed, capsize, weave, wobble) in PRINTED {
        let found = matrices.at(speed, 32.2).and_then(|system| system.eigenvalues()).expect("a regular system");
        assert_eq!(found.len(), 8);
        for (re, im) in [(capsize, 0.0), (weave[0], weave[1]), (wobble[0], wobble[1])] {
            let expected = Complex::new(re, im);
            let nearest = found.iter().min_by(|a, b| (*a - expected).norm().total_cmp(&(*b - expected).norm()));
            let nearest = nearest.expect("eight of them");
            let fits = (nearest.re - re).abs() <= half_a_unit(re) && (nearest.im - im).abs() <= half_a_unit(im);
            assert!(fits, "at {speed} ft/s {nearest} is printed as {expected}");
            checked += 1;
        }
    }
    assert_eq!(checked, 24);
}
