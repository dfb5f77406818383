//! Formulas at a few parameters: what is different there needs no attempt to prove it equal, which can take long.

use super::intervals::Interval;
use super::ranges::{Ranges, Reading};
use crate::domain::{Bound, Domain};
use crate::formula::Formula;
use crate::spread::fraction;

/// Values of the definitions at a few parameters inside the domains.
#[derive(Debug)]
pub struct Samples(Vec<Ranges>);

/// How many parameter values are looked at.
const COUNT: usize = 2;

impl Samples {
    pub fn new(domains: &[Domain], definitions: &[Formula]) -> Self {
        let sample = |number| {
            let first = number * domains.len();
            let parameters = domains.iter().enumerate().map(|(index, domain)| inside(domain, fraction(first + index)));
            let mut ranges = Ranges::new(Reading::Exact, parameters.map(Interval::point).collect());
            definitions.iter().for_each(|definition| ranges.push_definition(definition));
            ranges
        };
        Self((0..COUNT).map(sample).collect())
    }

    /// Enclosures of the values of a formula.
    pub fn of(&self, formula: &Formula) -> Vec<Interval> {
        self.0.iter().map(|ranges| ranges.of(formula)).collect()
    }
}

/// Values that are known less well than this decide nothing, and nothing is worth a proof on their account.
const WIDEST: f64 = 1e-3;

/// Whether a formula with these values is likely to be zero.
pub fn maybe_zero(values: &[Interval]) -> bool {
    values.iter().all(|value| value.width() < WIDEST && !value.excludes_zero())
}

/// Whether a formula with these values is likely to be another one, up to its sign and a power of two: in `f64` no other
/// multiple of what is not zero is not zero either.
pub fn maybe_multiples(one: &[Interval], other: &[Interval]) -> bool {
    let ratio = |(one, other): (&Interval, &Interval)| [*one, other.reciprocal()].into_iter().product();
    let ratios: Vec<Interval> = one.iter().zip(other).map(ratio).collect();
    let power_of_two =
        |ratio: &Interval| (ratio.middle().abs().log2() - ratio.middle().abs().log2().round()).abs() < WIDEST;
    ratios.iter().all(|ratio| ratio.width() < WIDEST && power_of_two(ratio))
        && !ratios.windows(2).any(|pair| pair[0].is_apart_from(pair[1]))
}

/// A value of a domain, unless it has no more than one.
fn inside(domain: &Domain, fraction: f64) -> f64 {
    let end = |bound| match bound {
        Bound::Unbounded => None,
        Bound::Open(value) | Bound::Closed(value) => Some(value),
    };
    match (end(domain.lower), end(domain.upper)) {
        (Some(low), Some(high)) => low + (high - low) * fraction,
        (Some(low), None) => low + 0.5 + fraction,
        (None, Some(high)) => high - 0.5 - fraction,
        (None, None) => 0.5 + fraction,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::Term;

    /// What parameters have in common only by how samples are taken is no reason to look for a proof.
    #[test]
    fn no_parameter_is_the_mean_of_its_neighbours() {
        let domains = [Domain::POSITIVE; 6];
        let samples = Samples::new(&domains, &[]);
        for middle in 1..5 {
            let [before, at, after] = [middle - 1, middle, middle + 1].map(Formula::Parameter);
            let sum = [Term::plus(before), Term::minus(at.clone()), Term::minus(at), Term::plus(after)];
            assert!(!maybe_zero(&samples.of(&Formula::Sum(sum.into()))), "{middle}");
        }
    }
}
