//! Standard deviations against those of many random designs.

use carvallo::batch::Batch;
use carvallo::{Coefficients, CriticalDerivative, CriticalKind, CriticalSpeed, Model, Stability, standard_deviation};
use carvallo_models::Whipple;
use carvallo_tests::{bicycles, exact};

use super::sensitivity;

/// Some of the bicycles all of whose parameters have deviations.
const MEASURED: [&str; 3] = ["browser", "pista", "yellow"];

/// Normal numbers, the same on every run: splitmix64 of Steele, Lea & Flood (2014), and the method of Box & Muller (1958).
struct Normal(u64);

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((mixed ^ (mixed >> 31)) >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    fn next(&mut self) -> f64 {
        let (radius, turn) = (self.uniform(), self.uniform());
        (-2.0 * radius.ln()).sqrt() * (std::f64::consts::TAU * turn).cos()
    }

    /// A design whose parameters vary with their deviations.
    fn design(&mut self, values: &[f64], deviations: &[f64]) -> Whipple {
        let varied = values.iter().zip(deviations).map(|(value, deviation)| value + deviation * self.next());
        Whipple::from_slice(&varied.collect::<Vec<_>>()).unwrap()
    }
}

/// The coefficients of designs whose parameters vary with their deviations, with the gravity of each.
fn varied(label: &str, samples: usize, seed: u64) -> Vec<(Coefficients<f64, 2>, f64)> {
    let (design, deviations, mut normal) = (bicycles::named(label), bicycles::deviations(label), Normal(seed));
    let values = exact::values(&design);
    let designs: Vec<Whipple> = (0..samples).map(|_| normal.design(&values, &deviations)).collect();
    let mut coefficients = vec![design.coefficients(); samples];
    Batch::new().coefficients(&designs, &mut coefficients).unwrap();
    coefficients.into_iter().zip(designs.iter().map(|design| design.g)).collect()
}

/// The standard deviation of samples about a value.
fn spread(samples: &[f64], about: f64) -> f64 {
    (samples.iter().map(|sample| (sample - about).powi(2)).sum::<f64>() / samples.len() as f64).sqrt()
}

fn entries(coefficients: &Coefficients<f64, 2>) -> Vec<f64> {
    let Coefficients { m, c1, k0, k2, .. } = coefficients;
    [m, c1, k0, k2].into_iter().flat_map(|matrix| matrix.iter().copied()).collect()
}

#[test]
fn those_of_the_matrices_are_those_of_random_designs() {
    for label in MEASURED {
        let (design, deviations) = (bicycles::named(label), bicycles::deviations(label));
        let samples: Vec<Vec<f64>> = varied(label, 100_000, 2007).iter().map(|(sample, _)| entries(sample)).collect();
        let nominal = entries(&design.coefficients());
        let found = entries(&sensitivity(&design).matrix_deviations(&deviations).unwrap());
        for (entry, (found, nominal)) in found.iter().zip(nominal).enumerate() {
            let expected = spread(&samples.iter().map(|sample| sample[entry]).collect::<Vec<_>>(), nominal);
            // A spread of so many samples is uncertain by 0.22 %; the rest is what is not of first order.
            assert!((found - expected).abs() <= 0.012 * expected, "{label}, entry {entry}: {found}, {expected}");
        }
    }
}

/// The only critical speed of a kind.
fn only(kind: CriticalKind, stability: &Stability) -> CriticalSpeed {
    let mut found = stability.critical_speeds.iter().filter(|critical| critical.kind == kind);
    let (Some(only), None) = (found.next(), found.next()) else { panic!("{stability:?}") };
    *only
}

/// Those of double roots come and go within the deviations, and weave and capsize may change places.
#[test]
fn those_of_critical_speeds_are_those_of_random_designs() {
    let stability = |(coefficients, gravity): &(_, f64)| Stability::new(coefficients, *gravity).unwrap();
    for label in MEASURED {
        let (design, deviations) = (bicycles::named(label), bicycles::deviations(label));
        let samples: Vec<Stability> = varied(label, 20_000, 1899).iter().map(stability).collect();
        let (nominal, sensitivity) = (stability(&(design.coefficients(), design.g)), sensitivity(&design));
        for kind in [CriticalKind::Weave, CriticalKind::Capsize] {
            let speeds: Vec<f64> = samples.iter().map(|sample| only(kind, sample).speed).collect();
            let nominal = only(kind, &nominal);
            let found = sensitivity.critical_speed(&nominal).unwrap();
            let CriticalDerivative::Smooth { speed, .. } = found else { panic!("{label}: {nominal:?}") };
            let (found, expected) = (standard_deviation(&speed, &deviations).unwrap(), spread(&speeds, nominal.speed));
            // A spread of so many samples is uncertain by 0.5 %, and what is not of first order adds to it.
            assert!(
                (found - expected).abs() <= 0.03 * expected && found > 0.0,
                "{label}: {nominal:?}: {found}, {expected}"
            );
        }
    }
}
