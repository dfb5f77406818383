//! What the struct of the parameters can do: sets by name, in `f32` as well, conversions between kinds of numbers, and text.

use carvallo::{Model, ModelInfo};
use carvallo_models::{Pendulum, RollingDisc, Whipple, each_model};

/// Table 1 of Meijaard et al. (2007), which has decimals that are no binary fractions.
const TRAIL: &str = "0.08";

#[test]
fn sets_are_found_by_name_however_it_is_spelt() {
    for name in ["benchmark", "Benchmark", "BENCHMARK", "bench-mark", "bench_mark"] {
        assert_eq!(Whipple::set(name), Some(Whipple::BENCHMARK), "{name}");
    }
    assert_eq!(Whipple::set("pista"), None);
    assert_eq!(Whipple::INFO.set("Benchmark").map(|set| set.name), Some("benchmark"));
}

#[test]
fn sets_are_there_in_single_precision() {
    let trail: f32 = TRAIL.parse().unwrap();
    assert_eq!(Whipple::<f32>::set("benchmark").map(|bicycle| bicycle.c), Some(trail));
    // In a constant too, as on a microcontroller.
    const SINGLE: Whipple<f32> = Whipple::BENCHMARK.to_f32();
    assert_eq!((SINGLE.c, SINGLE.mB, SINGLE.zB), (trail, 85.0, -0.9));
    assert_eq!(SINGLE, Whipple::BENCHMARK.cast());
}

#[test]
fn from_single_precision_nothing_is_lost() {
    let trail: f32 = TRAIL.parse().unwrap();
    let double = Whipple::from(Whipple::BENCHMARK.to_f32());
    assert_eq!((double.c, double.mB), (f64::from(trail), 85.0));
    assert_ne!(double.c, Whipple::BENCHMARK.c);
    let converted: Whipple = Whipple::BENCHMARK.to_f32().into();
    assert_eq!(converted, double);
}

/// Every set of every model by its name, in both kinds of numbers.
#[test]
fn every_set_is_found_in_every_model() {
    fn check<const N: usize, M: Model<N, Scalar = f64>>() -> &'static ModelInfo
    where
        M::Over<f32>: Model<N, Scalar = f32>,
    {
        for set in M::INFO.sets {
            let upper = set.name.to_uppercase().replace('_', " ");
            let (double, single) = (M::set(&upper).unwrap(), M::Over::<f32>::set(set.name).unwrap());
            assert_eq!(double.parameters().as_ref(), set.values, "{} of {}", set.name, M::INFO.name);
            let nearest: Vec<f32> = set.values.iter().map(|value| *value as f32).collect();
            assert_eq!(single.parameters().as_ref(), nearest, "{} of {}", set.name, M::INFO.name);
        }
        M::INFO
    }
    let checked = each_model!(check);
    assert!(checked.iter().filter(|info| !info.sets.is_empty()).count() > 5);
}

#[test]
fn a_description_needs_no_number_type() {
    assert_eq!(Whipple::INFO.name, "Whipple");
    assert_eq!(Whipple::INFO, Whipple::<f32>::INFO);
    assert_eq!(Pendulum::INFO.coordinates.len(), 1);
}

#[test]
fn parameters_are_written_one_a_line_with_their_units() {
    let disc = RollingDisc { r: 0.3, m: 1.0, Ia: 1e-7, It: 0.0225, g: 9.81 };
    let text = "r  = 0.3 m\nm  = 1.0 kg\nIa = 1e-7 kg*m^2\nIt = 0.0225 kg*m^2\ng  = 9.81 N/kg";
    assert_eq!(disc.to_string(), text);
    let single = RollingDisc { r: 0.3, m: 1.0, Ia: 1e-7, It: 0.0225, g: 9.81_f32 };
    assert_eq!(single.to_string(), text);
    let rounded = "r  = 0.30 m\nm  = 1.00 kg\nIa = 0.00 kg*m^2\nIt = 0.02 kg*m^2\ng  = 9.81 N/kg";
    assert_eq!(format!("{disc:.2}"), rounded);
}

#[test]
fn the_alternate_form_says_what_they_are() {
    let text = format!("{:#}", Whipple::BENCHMARK);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[..4],
        [
            "# Whipple: The Whipple-Carvallo bicycle: the linearized equations of lean and steer about upright straight \
             running.",
            "w    = 1.02 m  # Wheel base.",
            "c    = 0.08 m  # Trail: positive when the front contact is behind the point where the steer axis meets the \
             ground.",
            "lam  = 0.3141592653589793 rad  # λ: Steer axis tilt: 90 degrees minus the head angle.",
        ]
    );
    // Table 1: 4 of the whole bicycle, 4 of each wheel, 7 of each frame.
    assert_eq!(lines.len(), 1 + 4 + 2 * 4 + 2 * 7);
}
