//! Critical speeds and stable ranges of many designs, at every level of instructions that the processor has: each must be what it
//! is alone, to the last bit.

use carvallo::batch::{Batch, BatchError};
use carvallo::{Coefficients, Model, Stability, SystemError};
use carvallo_tests::facts::{RandomSystem, random_systems};
use carvallo_tests::{bicycles, designs};

/// Bicycles, systems with damping at rest and others, some of which have no stability or none that `f64` alone tells.
fn systems() -> (Vec<Coefficients<f64, 2>>, Vec<f64>) {
    let mut systems: Vec<(Coefficients<f64, 2>, f64)> = Vec::new();
    systems.extend(bicycles::all().iter().map(|(_, bicycle)| (bicycle.coefficients(), bicycle.g)));
    systems.extend((0..101).map(designs::numbered).map(|design| (design.coefficients(), design.g)));
    let of_two = random_systems().into_iter().filter(|system| system.coordinates == 2);
    systems.extend(of_two.map(|system| (system.coefficients(), RandomSystem::GRAVITY)));
    // By turns, so that lanes of every kind lie beside each other.
    for number in 0..designs_with_faults().len() {
        systems.insert(7 * number + 3, designs_with_faults()[number]);
    }
    let damped = |(coefficients, gravity): &(Coefficients<f64, 2>, f64)| {
        let mut damped = *coefficients;
        damped.c0 = coefficients.m * 0.3;
        (damped, *gravity)
    };
    let also: Vec<_> = systems.iter().step_by(3).map(damped).collect();
    systems.extend(also);
    systems.into_iter().unzip()
}

fn designs_with_faults() -> [(Coefficients<f64, 2>, f64); 6] {
    let usual = designs::numbered(1).coefficients();
    let with = |change: fn(&mut Coefficients<f64, 2>)| {
        let mut changed = usual;
        change(&mut changed);
        changed
    };
    [
        (with(|all| all.m.fill(0.0)), 9.81),
        (with(|all| all.k0.m11 = f64::NAN), 9.81),
        (with(|all| all.k1.m12 = 3.0), 9.81),
        (with(|all| all.c1.fill(0.0)), 9.81),
        (with(|all| all.k2.m11 = 1e200), 9.81),
        (usual, f64::INFINITY),
    ]
}

#[test]
fn stability_is_computed_in_lanes_as_alone() {
    let (coefficients, gravity) = systems();
    let alone: Vec<_> = coefficients.iter().zip(&gravity).map(|(all, gravity)| Stability::new(all, *gravity)).collect();
    assert!(alone.iter().any(Result::is_err) && alone.iter().filter(|found| found.is_ok()).count() > 100);
    for batch in Batch::levels() {
        for count in [0, 1, 5, 8, coefficients.len()] {
            let mut found = vec![Err(SystemError::AtRest); count];
            batch.stability(&coefficients[..count], &gravity[..count], &mut found).unwrap();
            for (place, (found, alone)) in found.iter().zip(&alone).enumerate() {
                // Errors may hold what is no number.
                assert_eq!(format!("{found:?}"), format!("{alone:?}"), "{batch}, {place}");
            }
        }
    }
}

#[test]
fn what_does_not_fit_is_an_error_that_says_so() {
    let (coefficients, gravity) = systems();
    let mut room = vec![Err(SystemError::AtRest); 3];
    let short = Batch::new().stability(&coefficients[..3], &gravity[..2], &mut room);
    assert_eq!(short, Err(BatchError::Length { what: "gravity", position: 0, expected: 3, found: 2 }));
    let short = Batch::new().stability(&coefficients[..2], &gravity[..2], &mut room);
    assert_eq!(short, Err(BatchError::Length { what: "result", position: 0, expected: 2, found: 3 }));
}
