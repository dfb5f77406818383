//! Designs over the domains of a model: its sets, and random ones that fulfil what it requires.

use carvallo::{Bound, Domain, Model, ModelInfo, ParameterError, ParameterInfo};
use serde::Serialize;

/// A design: a name to find it by, and its parameters in declared order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Design {
    /// Such as ``set `euro` `` or `random design 17`.
    pub name: String,
    /// The values of the parameters.
    pub parameters: Vec<f64>,
}

/// How often in a row a random design may fail to fulfil the requirements.
const ATTEMPTS: usize = 1000;
/// Once in how many times a parameter of a random design lies at the edge of its domain.
const EDGES: u64 = 10;
/// The random designs that a difference is explained with: they have no number, and no parameter at an edge.
const REGULAR: u64 = 1 << 32;

/// The sets of a model, then random designs.
///
/// # Errors
/// What the last of many attempts failed at.
pub fn designs<const N: usize, M: Model<N, Scalar = f64>>(
    random: usize,
    seed: u64,
) -> Result<Vec<Design>, ParameterError> {
    let sets = M::INFO.sets.iter();
    let mut designs: Vec<Design> = sets
        .map(|set| Design { name: format!("set `{}`", set.name), parameters: set.values.to_vec() })
        .filter(|design| valid::<N, M>(&design.parameters).is_ok())
        .collect();
    for number in 0..random as u64 {
        let parameters = valid_design::<N, M>(seed, number, EDGES)?;
        designs.push(Design { name: format!("random design {number}"), parameters });
    }
    Ok(designs)
}

/// Random designs none of whose parameters is at an edge.
///
/// # Errors
/// What the last of many attempts failed at.
pub fn regular_designs<const N: usize, M: Model<N, Scalar = f64>>(
    count: usize,
    seed: u64,
) -> Result<Vec<Vec<f64>>, ParameterError> {
    (0..count as u64).map(|number| valid_design::<N, M>(seed, REGULAR + number, u64::MAX)).collect()
}

fn valid_design<const N: usize, M: Model<N, Scalar = f64>>(
    seed: u64,
    number: u64,
    edges: u64,
) -> Result<Vec<f64>, ParameterError> {
    let mut random = Random::new(seed, number);
    let mut failed = None;
    for _ in 0..ATTEMPTS {
        let parameters = draw(M::INFO, &mut random, edges);
        match valid::<N, M>(&parameters) {
            Ok(()) => return Ok(parameters),
            Err(error) => failed = Some(error),
        }
    }
    // Of a thousand attempts the last one failed.
    Err(failed.expect("an attempt that failed"))
}

fn valid<const N: usize, M: Model<N, Scalar = f64>>(parameters: &[f64]) -> Result<(), ParameterError> {
    M::from_slice(parameters).expect("a value for every parameter").validate()
}

/// Every second design is near a set, if there is one: requirements on many parameters hold there most often.
fn draw(info: &ModelInfo, random: &mut Random, edges: u64) -> Vec<f64> {
    let sets = info.sets.len() as u64;
    if sets > 0 && random.below(2) == 0 {
        let set = &info.sets[random.below(sets) as usize];
        let near = info.parameters.iter().zip(set.values).map(|(parameter, near)| match *near {
            // A regular design has no zeros.
            0.0 if edges == u64::MAX => value(parameter, random, edges),
            near => near * random.between(0.6, 1.5),
        });
        return near.collect();
    }
    info.parameters.iter().map(|parameter| value(parameter, random, edges)).collect()
}

/// A value in the domain of a parameter: between two bounds any of them, else from a tenth to ten, an angle up to 1.2 rad.
fn value(ParameterInfo { unit, domain, .. }: &ParameterInfo, random: &mut Random, edges: u64) -> f64 {
    let Domain { lower, upper, nonzero } = *domain;
    if random.below(edges) == 0 {
        match (lower, upper) {
            (Bound::Closed(edge), _) | (_, Bound::Closed(edge)) if !(nonzero && edge == 0.0) => return edge,
            (Bound::Unbounded, Bound::Unbounded) if !nonzero => return 0.0,
            _ => {}
        }
    }
    let end = |bound| match bound {
        Bound::Unbounded => None,
        Bound::Open(end) | Bound::Closed(end) => Some(end),
    };
    let most: f64 = if *unit == "rad" { 1.2 } else { 10.0 };
    let magnitude = most * 0.01_f64.powf(random.between(0.0, 1.0));
    match (end(lower), end(upper)) {
        (Some(lower), Some(upper)) => random.between(lower, upper),
        (Some(lower), None) => lower + magnitude,
        (None, Some(upper)) => upper - magnitude,
        (None, None) => magnitude * if random.below(2) == 0 { 1.0 } else { -1.0 },
    }
}

/// Splitmix64, by Steele, Lea & Flood (2014).
struct Random(u64);

impl Random {
    /// Every number of a design has numbers of its own.
    fn new(seed: u64, number: u64) -> Self {
        let mut random = Self(seed);
        let start = random.next().wrapping_add(number);
        Self(Self(start).next())
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (self.next() >> 11) as f64 / (1_u64 << 53) as f64 * (high - low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carvallo_models::{Whipple, each_model};

    fn all_are_valid<const N: usize, M: Model<N, Scalar = f64>>() {
        let designs = designs::<N, M>(50, 1).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(designs.len(), M::INFO.sets.len() + 50);
        for design in designs {
            assert!(valid::<N, M>(&design.parameters).is_ok(), "{}: {}", M::INFO.name, design.name);
        }
    }

    #[test]
    fn designs_of_every_model_are_valid() {
        each_model!(all_are_valid);
    }

    #[test]
    fn designs_are_the_same_on_every_run_and_differ_from_each_other() {
        let found = |seed| designs::<2, Whipple>(20, seed).expect("designs");
        assert_eq!(found(7), found(7));
        assert_ne!(found(7), found(8));
        let found = found(7);
        assert!(
            found.iter().enumerate().all(|(i, one)| found[..i].iter().all(|other| one.parameters != other.parameters))
        );
        // Some lie at edges of their domains, regular ones nowhere.
        assert!(found.iter().any(|design| design.parameters.contains(&0.0)));
        let regular = regular_designs::<2, Whipple>(50, 7).expect("designs");
        assert!(!regular.iter().flatten().any(|value| *value == 0.0));
    }
}
