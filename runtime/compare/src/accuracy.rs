//! How far computed entries are from exact ones.

use serde::Serialize;

use crate::designs::Design;
use crate::explain::{SAME, entry_name};
use crate::number::{Exact, Real};

/// The errors of a side in one number type, over all designs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Accuracy {
    /// The largest error of an entry, in units of the last place of the size of its terms: of what its formula gives with
    /// every term made positive.
    pub ulps: f64,
    /// The largest error of an entry in units of the last place of the largest entry of its matrix. What terms of opposite
    /// sign lose is in it: a formula that is written with fewer of them is better by it.
    pub ulps_of_matrix: f64,
    /// Where the first of them is; nothing if every entry of every design is exact.
    pub worst: Option<Worst>,
    /// The entries that are not the same formula: off by more than a billionth of their terms at one design at least, each
    /// where it is farthest off.
    pub differences: Vec<Worst>,
}

/// An entry at the design at which it is farthest off.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Worst {
    /// The entry, such as `C1_12`.
    pub entry: String,
    /// The formula of the model, with the definitions that it names; `0` for an entry that is zero, empty where the model tells none.
    pub formula: String,
    /// The error in units of the last place of the size of its terms.
    pub ulps: f64,
    /// What was computed.
    pub computed: f64,
    /// The exact value, to the nearest number.
    pub exact: f64,
    /// The design.
    pub design: Design,
}

/// The largest errors so far, entry by entry.
pub struct Errors {
    epsilon: f64,
    entries: Vec<Option<Error>>,
    ulps_of_matrix: f64,
}

#[derive(Clone)]
struct Error {
    ulps: f64,
    /// In parts of the size of the terms.
    relative: f64,
    computed: f64,
    exact: f64,
    design: Design,
}

impl Errors {
    /// For numbers with this epsilon.
    pub fn new(epsilon: f64) -> Self {
        Self { epsilon, entries: Vec::new(), ulps_of_matrix: 0.0 }
    }

    /// Takes in the entries of a design, with `n` coordinates.
    pub fn add(&mut self, n: usize, computed: &[f64], exact: &[Exact], design: &Design) {
        for (computed, exact) in computed.chunks(n * n).zip(exact.chunks(n * n)) {
            let largest = exact.iter().map(|exact| exact.value.abs().to_f64()).fold(0.0, f64::max);
            let errors = computed.iter().zip(exact).map(|(computed, exact)| off(*computed, exact));
            let error = errors.fold(0.0, f64::max);
            if error > 0.0 {
                self.ulps_of_matrix = self.ulps_of_matrix.max(error / unit(largest, self.epsilon));
            }
        }
        self.entries.resize(exact.len(), None);
        for ((largest, computed), exact) in self.entries.iter_mut().zip(computed).zip(exact) {
            let (ulps, relative) = error(*computed, exact, self.epsilon);
            if ulps > largest.as_ref().map_or(0.0, |error| error.ulps) {
                let (computed, exact) = (*computed, exact.value.to_f64());
                *largest = Some(Error { ulps, relative, computed, exact, design: design.clone() });
            }
        }
    }

    /// What they come to; `formula` tells the formula of an entry.
    pub fn accuracy(self, n: usize, formula: impl Fn(usize) -> String) -> Accuracy {
        let same = same(self.epsilon);
        let found = |(index, error): (usize, &Option<Error>)| {
            let Error { ulps, relative, computed, exact, design } = error.clone()?;
            let worst = Worst { entry: entry_name(n, index), formula: formula(index), ulps, computed, exact, design };
            Some((relative, worst))
        };
        let all: Vec<(f64, Worst)> = self.entries.iter().enumerate().filter_map(found).collect();
        let worst = all.iter().map(|(_, worst)| worst).max_by(|one, other| one.ulps.total_cmp(&other.ulps)).cloned();
        let differences = all.into_iter().filter(|(relative, _)| *relative > same).map(|(_, worst)| worst).collect();
        let ulps = worst.as_ref().map_or(0.0, |worst| worst.ulps);
        Accuracy { ulps, ulps_of_matrix: self.ulps_of_matrix, worst, differences }
    }
}

/// Of its terms, how much an entry may differ in numbers with an epsilon and still be the same formula: rounding in single
/// precision may be more than a billionth.
pub fn same(epsilon: f64) -> f64 {
    SAME.max(1e3 * epsilon)
}

/// The error in units of the last place of the size of the terms, and in parts of that size.
fn error(computed: f64, exact: &Exact, epsilon: f64) -> (f64, f64) {
    let error = off(computed, exact);
    if error == 0.0 { (0.0, 0.0) } else { (error / unit(exact.size, epsilon), error / exact.size) }
}

/// How far a number is from the exact one. What is no number is infinitely far off.
fn off(computed: f64, exact: &Exact) -> f64 {
    if computed.is_finite() { (Real::from(computed) - exact.value).abs().to_f64() } else { f64::INFINITY }
}

/// The unit of the last place of a size.
fn unit(size: f64, epsilon: f64) -> f64 {
    epsilon * 2_f64.powf(size.log2().floor())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_in_units_of_the_last_place_of_the_terms() {
        let (one, third) = (Exact::from(1.0), Exact::from(1.0) / Exact::from(3.0));
        let exact = one - third;
        // 2/3, of terms that come to 4/3, whose unit is an epsilon. The nearest number is a sixth of it below, and the next
        // one half of it further.
        let next = 2.0 / 3.0 + f64::EPSILON / 2.0;
        let (ulps, relative) = error(next, &exact, f64::EPSILON);
        assert!((ulps - 1.0 / 3.0).abs() < 1e-9, "{ulps}");
        assert!((relative / (ulps * f64::EPSILON * 0.75) - 1.0).abs() < 1e-12);
        assert_eq!(error(f64::NAN, &exact, f64::EPSILON).0, f64::INFINITY);
        assert_eq!(error(f64::NAN, &exact, f64::EPSILON).1, f64::INFINITY);
        // Where all terms are zero, so has the entry to be.
        assert_eq!(error(0.0, &Exact::from(0.0), f64::EPSILON).0, 0.0);
        assert_eq!(error(1e-300, &Exact::from(0.0), f64::EPSILON).0, f64::INFINITY);
    }
    #[test]
    fn errors_in_a_matrix_are_in_units_of_its_largest_entry() {
        let exact = [6.0, 0.0, 0.0, 1.0].map(Exact::from);
        let design = Design { name: String::new(), parameters: Vec::new() };
        let mut errors = Errors::new(f64::EPSILON);
        errors.add(2, &[6.0, 0.0, 0.0, 1.0 + f64::EPSILON], &exact, &design);
        let accuracy = errors.accuracy(2, |_| String::new());
        assert_eq!((accuracy.ulps, accuracy.ulps_of_matrix), (1.0, 0.25));
    }
}
