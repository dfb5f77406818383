//! Eigenvalues of many systems: at every level of the processor those of each system alone, to the last bit.

use carvallo::batch::{Batch, BatchError, Eigenvalues};
use carvallo::{Coefficients, Complex, Matrix, Model, System, SystemError};
use carvallo_tests::{bicycles, designs, facts};
use nalgebra::Matrix2;
use proptest::prelude::*;

fn bits(eigenvalues: &Eigenvalues) -> Result<[(u64, u64); 4], String> {
    let bits = |value: Complex<f64>| (value.re.to_bits(), value.im.to_bits());
    eigenvalues.as_ref().map(|four| four.map(bits)).map_err(|error| format!("{error:?}"))
}

fn unset(count: usize) -> Vec<Eigenvalues> {
    vec![Ok([Complex::new(f64::NAN, f64::NAN); 4]); count]
}

fn assert_same(found: &[Eigenvalues], expected: impl IntoIterator<Item = Eigenvalues>, batch: &Batch) {
    let mut count = 0;
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(bits(found), bits(&expected), "{batch}, number {count}");
        count += 1;
    }
    assert_eq!(count, found.len());
}

fn check(systems: &[System<2>]) {
    for batch in Batch::levels() {
        let mut found = unset(systems.len());
        batch.eigenvalues(systems, &mut found).unwrap();
        assert_same(&found, systems.iter().map(System::quartic_eigenvalues), &batch);
    }
}

fn check_along(coefficients: &Coefficients<f64, 2>, gravity: f64, speeds: &[f64]) {
    for batch in Batch::levels() {
        let mut found = unset(speeds.len());
        batch.eigenvalues_along(coefficients, gravity, speeds, &mut found).unwrap();
        let one = |&speed: &f64| coefficients.at(speed, gravity)?.quartic_eigenvalues();
        assert_same(&found, speeds.iter().map(one), &batch);
    }
}

#[test]
fn real_bicycles_through_their_double_roots() {
    let mut speeds: Vec<f64> = (0..=51).map(|step| 0.2 * f64::from(step)).collect();
    for critical in facts::critical_speeds().iter().filter(|critical| critical.kind == "double_root") {
        speeds.extend((-3..=3).map(|steps| critical.speed * (1.0 + f64::from(steps) * f64::EPSILON)));
    }
    for (_, bicycle) in bicycles::all() {
        let coefficients = bicycle.coefficients();
        check_along(&coefficients, bicycle.g, &speeds);
        check(&speeds.iter().map(|&speed| coefficients.at(speed, bicycle.g).unwrap()).collect::<Vec<_>>());
    }
}

/// A number of any sign and size, zero, or not a number at all.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0),
        2 => (-4..=4i32).prop_map(f64::from),
        4 => -10.0..10.0f64,
        2 => (-300..300, -10.0..10.0).prop_map(|(exponent, digits): (i32, f64)| digits * 10f64.powi(exponent)),
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(-0.0), Just(1e-310)],
    ]
}

proptest! {
    #![proptest_config(designs::config(1000))]

    #[test]
    fn systems_of_any_kind_side_by_side(entries in prop::collection::vec(prop::array::uniform12(any_number()), 0..20)) {
        let matrix = |entries: &[f64]| Matrix2::from_column_slice(entries);
        let system = |e: &[f64; 12]| System::new(matrix(&e[..4]), matrix(&e[4..8]), matrix(&e[8..]));
        check(&entries.iter().map(system).collect::<Vec<_>>());
    }

    #[test]
    fn speeds_of_any_kind_side_by_side(
        design in designs::any(),
        gravity in prop_oneof![9 => 0.0..30.0, 1 => any_number()],
        speeds in prop::collection::vec(prop_oneof![9 => -30.0..30.0, 1 => any_number()], 0..20),
    ) {
        check_along(&design.coefficients(), gravity, &speeds);
    }
}

#[test]
fn one_that_is_wrong_leaves_the_others_alone() {
    let one = Matrix2::identity();
    let mut systems = [System::new(one, one * 0.5, one); 11];
    systems[3].m = Matrix2::new(1.0, 2.0, 2.0, 4.0);
    systems[10].k[(1, 0)] = f64::NAN;
    let mut found = unset(11);
    Batch::new().eigenvalues(&systems, &mut found).unwrap();
    assert!(matches!(found[3], Err(SystemError::SingularMass)));
    assert!(matches!(found[10], Err(SystemError::NotFinite { quantity: "K", .. })));
    assert_eq!(found.iter().filter(|eigenvalues| eigenvalues.is_ok()).count(), 9);
}

#[test]
fn slices_of_unequal_length_are_an_error() {
    let one = Matrix2::identity();
    let systems = [System::new(one, one, one); 3];
    let mut found = unset(2);
    let error = Batch::new().eigenvalues(&systems, &mut found).unwrap_err();
    assert_eq!(error, BatchError::Length { what: "result", position: 0, expected: 3, found: 2 });
    assert!(found.iter().all(|eigenvalues| eigenvalues.unwrap()[0].re.is_nan()), "nothing is written");
}

/// Systems of more coordinates side by side: damped and not, with matrices of any kind, singular, and not a number.
fn check_any<const N: usize>(seed: u64) {
    let mut state = seed;
    let mut draw = || {
        // The generator of Knuth's MMIX.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut systems = Vec::new();
    for number in 0..13 {
        let mut matrix = || Matrix::<f64, N>::from_fn(|_, _| draw());
        let (l, c, k) = (matrix(), matrix(), matrix() * 10.0);
        let mass = l * l.transpose() + Matrix::<f64, N>::identity() * 0.5;
        systems.push(match number {
            2 => System::new(mass, c * 0.0, k),
            // Not positive, not symmetric, singular, not a number, and all eigenvalues the same.
            4 => System::new(-mass, c, k),
            5 => System::new(l, c, k),
            7 => System::new(mass * 0.0, c, k),
            8 => System::new(mass, c, k * f64::NAN),
            11 => System::new(mass, mass * 2.0, mass),
            _ => System::new(mass, c * c.transpose(), k * k.transpose()),
        });
    }
    for batch in Batch::levels() {
        let mut found = vec![Ok(vec![Complex::new(f64::NAN, 0.0); 3]); systems.len()];
        batch.eigenvalues_of_any(&systems, &mut found).unwrap();
        for (number, (found, system)) in found.iter().zip(&systems).enumerate() {
            let bits = |values: &Vec<Complex<f64>>| -> Vec<[u64; 2]> {
                values.iter().map(|value| [value.re.to_bits(), value.im.to_bits()]).collect()
            };
            let [found, expected] = [found, &system.eigenvalues()].map(|values| match values {
                Ok(values) => Ok(bits(values)),
                Err(error) => Err(error.to_string()),
            });
            assert_eq!(found, expected, "{batch}, number {number}, seed {seed}");
        }
    }
}

proptest! {
    #![proptest_config(designs::config(30))]

    #[test]
    fn systems_of_more_coordinates_side_by_side(seed: u64) {
        check_any::<2>(seed);
        check_any::<3>(seed);
        check_any::<4>(seed);
        check_any::<5>(seed);
        check_any::<8>(seed);
    }
}
