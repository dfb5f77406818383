//! Critical speeds of every model that ships, against all that is printed, known in closed form, or recomputed of them.

use carvallo::{CriticalKind, Model, Stability};
use carvallo_models::each_model;
use carvallo_tests::facts::{ModelSpeed, model_speeds};

/// How many of the speeds are those of this model, of each of whose sets all are found.
fn check<const N: usize, M: Model<N, Scalar = f64>>() -> usize {
    let known: Vec<ModelSpeed> = model_speeds().into_iter().filter(|fact| fact.model == M::INFO.name).collect();
    for set in M::INFO.sets {
        let model = M::from_slice(set.values).expect("a value for each parameter");
        let stability = Stability::new(&model.coefficients(), model.gravity().unwrap_or(0.0)).expect("an answer");
        for fact in known.iter().filter(|fact| fact.set == set.name) {
            let critical = fact.find(&stability.critical_speeds).expect("one of its kind");
            let bound = fact.half_a_unit() + (1e-13 * fact.speed()).max(critical.error);
            assert!((critical.speed - fact.speed()).abs() <= bound, "{fact:?} where {critical:?} is found");
        }
        let none = stability.critical_speeds.iter().all(|critical| critical.kind == CriticalKind::DoubleRoot);
        assert!(!known.is_empty() || none, "nothing to hold {} against: {stability:?}", M::INFO.name);
    }
    known.iter().filter(|fact| M::INFO.sets.iter().any(|set| set.name == fact.set)).count()
}

#[test]
fn every_critical_speed_that_is_known_of_a_model_comes_out() {
    assert_eq!(each_model!(check).iter().sum::<usize>(), model_speeds().len());
}
