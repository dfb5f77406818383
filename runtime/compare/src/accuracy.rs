//! How far computed entries are from exact ones.

use serde::Serialize;

use crate::designs::Design;
use crate::explain::{SAME, entry_name};
use crate::number::Exact;

/// The errors of a side in one number type, over all designs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Accuracy {
    /// The largest error of an entry, in units of the last place of the size of its terms: of what its formula gives with
    /// every term made positive.
    pub ulps: f64,
    /// Where it is; nothing if every entry of every design is exact.
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
    /// The formula of the model; `0` for an entry that is zero.
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
        Self { epsilon, entries: Vec::new() }
    }

    /// Takes in the entries of a design.
    pub fn add(&mut self, computed: &[f64], exact: &[Exact], design: &Design) {
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
        // Rounding in single precision may be more than a billionth.
        let same = SAME.max(1e3 * self.epsilon);
        let found = |(index, error): (usize, &Option<Error>)| {
            let Error { ulps, relative, computed, exact, design } = error.clone()?;
            let worst = Worst { entry: entry_name(n, index), formula: formula(index), ulps, computed, exact, design };
            Some((relative, worst))
        };
        let all: Vec<(f64, Worst)> = self.entries.iter().enumerate().filter_map(found).collect();
        let worst = all.iter().map(|(_, worst)| worst).max_by(|one, other| one.ulps.total_cmp(&other.ulps)).cloned();
        let differences = all.into_iter().filter(|(relative, _)| *relative > same).map(|(_, worst)| worst).collect();
        Accuracy { ulps: worst.as_ref().map_or(0.0, |worst| worst.ulps), worst, differences }
    }
}

/// The error in units of the last place of the size of the terms, and in parts of that size. What is no number is
/// infinitely far off.
fn error(computed: f64, exact: &Exact, epsilon: f64) -> (f64, f64) {
    if !computed.is_finite() {
        return (f64::INFINITY, f64::INFINITY);
    }
    let error = (crate::number::Real::from(computed) - exact.value).abs().to_f64();
    if error == 0.0 {
        return (0.0, 0.0);
    }
    let unit = epsilon * 2_f64.powf(exact.size.log2().floor());
    (error / unit, error / exact.size)
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
        // Where all terms are zero, so has the entry to be.
        assert_eq!(error(0.0, &Exact::from(0.0), f64::EPSILON).0, 0.0);
        assert_eq!(error(1e-300, &Exact::from(0.0), f64::EPSILON).0, f64::INFINITY);
    }
}
