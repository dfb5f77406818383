//! Random valid designs: everything from a folding bicycle to a cargo bicycle and beyond, and what degenerates.

use carvallo::{Model, Scalar};
use carvallo_models::Whipple;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Random cases that are the same on every run; another seed looks further. With the environment variable
/// `PROPTEST_CASES` there are at most so many.
pub fn config(cases: u32) -> ProptestConfig {
    let most = std::env::var("PROPTEST_CASES").map(|most| most.parse().expect("PROPTEST_CASES is a number"));
    let cases = most.map_or(cases, |most| cases.min(most));
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(1899), failure_persistence: None, ..ProptestConfig::default() }
}

/// Designs of usual proportions, in which each parameter takes a value at the edge once in ten times.
pub fn any() -> impl Strategy<Value = Whipple> {
    RANGES
        .map(|(_, low, high, edge)| prop_oneof![9 => low..high, 1 => Just(edge)])
        .prop_map(|values| from_ranges(&values))
        .prop_filter("the front assembly has a mass", |design| design.validate().is_ok())
}

/// Designs of usual proportions, none of whose parameters is at an edge.
pub fn regular() -> impl Strategy<Value = Whipple> {
    RANGES.map(|(_, low, high, _)| low..high).prop_map(|values| from_ranges(&values))
}

/// Designs near one, each of whose parameters is 0.6 to 1.5 times as large.
pub fn near(design: &Whipple) -> impl Strategy<Value = Whipple> + use<> {
    let mut values = [0.0; RANGES.len()];
    design.write_to(&mut values).expect("room for every parameter");
    RANGES
        .map(|_| 0.6..1.5)
        .prop_map(move |factors| Whipple::from_slice(&std::array::from_fn::<f64, 26, _>(|i| values[i] * factors[i])))
        .prop_map(|design| design.expect("as many parameters"))
        .prop_filter("parameters in their domains", |design| design.validate().is_ok())
}

/// The design of a number: of usual proportions, and the same on every run.
pub fn numbered(number: u64) -> Whipple {
    // Splitmix64, by Steele, Lea & Flood (2014): its state advances by an odd constant, so every number has its own.
    let mut state = number.wrapping_mul(RANGES.len() as u64);
    from_ranges(&RANGES.map(|(_, low, high, _)| {
        state = state.wrapping_add(1);
        let mixed = state.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let fraction = ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        low + fraction * (high - low)
    }))
}

/// For each parameter: its name, a range of usual values, and a value at the edge of what is legitimate.
///
/// Products of inertia are fractions of the largest that a body can have, the geometric mean of its moments xx and zz,
/// so that every design could be built and its mass matrix is positive definite.
const RANGES: [(&str, f64, f64, f64); 26] = [
    ("w", 0.7, 2.0, 0.5),
    ("c", -0.1, 0.2, 0.0),   // no trail; the range has both signs
    ("lam", -0.3, 0.9, 0.0), // a vertical steer axis
    ("g", 1.0, 25.0, 0.0),   // free fall
    ("rR", 0.1, 0.5, 0.05),
    ("mR", 0.5, 10.0, 0.0),   // massless wheels
    ("IRxx", 0.01, 0.3, 0.0), // wheels that do not spin up: a skate
    ("IRyy", 0.01, 0.5, 0.0),
    ("xB", -0.2, 1.0, 0.0),
    ("zB", -1.5, -0.2, 0.0),
    ("mB", 5.0, 150.0, 0.0),
    ("IBxx", 0.2, 15.0, 0.01),
    ("IByy", 0.2, 15.0, 0.0),
    ("IBzz", 0.2, 10.0, 0.01),
    ("IBxz", -0.9, 0.9, 0.0),
    ("xH", 0.4, 1.5, 0.0),
    ("zH", -1.2, -0.2, 0.0),
    ("mH", 0.5, 10.0, 0.0),
    ("IHxx", 0.01, 0.5, 0.001),
    ("IHyy", 0.01, 0.5, 0.0),
    ("IHzz", 0.002, 0.2, 0.001),
    ("IHxz", -0.9, 0.9, 0.0),
    ("rF", 0.1, 0.5, 0.05),
    ("mF", 0.5, 10.0, 0.0),
    ("IFxx", 0.01, 0.3, 0.0),
    ("IFyy", 0.01, 0.5, 0.0),
];

/// The design of drawn values, with fractions turned into products of inertia.
fn from_ranges(values: &[f64; 26]) -> Whipple {
    let named = |name: &str| {
        let position = RANGES.iter().position(|(range, ..)| *range == name);
        values[position.unwrap_or_else(|| panic!("no range for {name}"))]
    };
    let value = |name| match name {
        "IBxz" => named("IBxz") * (named("IBxx") * named("IBzz")).sqrt(),
        "IHxz" => named("IHxz") * (named("IHxx") * named("IHzz")).sqrt(),
        _ => named(name),
    };
    let values: Vec<f64> = Whipple::INFO.parameters.iter().map(|parameter| value(parameter.name)).collect();
    Whipple::from_slice(&values).expect("a value for every parameter")
}

/// Every parameter rounded to `f32`.
pub fn narrowed(design: &Whipple) -> Whipple<f32> {
    let mut values = [0.0; RANGES.len()];
    design.write_to(&mut values).expect("room for every parameter");
    Whipple::from_slice(&values.map(<f32 as Scalar>::from_f64)).expect("as many parameters")
}
