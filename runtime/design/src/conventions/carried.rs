//! What standard deviations and correlations become by formulas, to first order.

use carvallo::Covariance;

use super::dual::Dual;
use super::name::Values;
use crate::design::Given;

/// Less than this, relative to a value, is what rounding leaves of deviations that cancel.
const ROUNDING: f64 = 1e-12;

/// The deviations of what formulas make of values, as sums of the same independent parts that those of the values are.
pub struct Carried(Vec<(&'static str, Vec<f64>)>);

impl Carried {
    /// By exact derivatives of the formulas, which are those of the values.
    pub fn new(values: &Values, covariance: &Covariance, formulas: fn(&Values) -> Result<Values, String>) -> Self {
        let mut carried: Vec<(&str, Vec<f64>)> = Vec::new();
        for (position, parts) in covariance.parts().iter().enumerate() {
            if parts.iter().all(|part| *part == 0.0) {
                continue;
            }
            let Ok(varied) = formulas(&values.varied(position)) else { continue };
            for (name, Dual { slope, .. }) in varied.iter().filter(|(_, value)| value.slope != 0.0) {
                let at = carried.iter().position(|(own, _)| *own == name).unwrap_or_else(|| {
                    carried.push((name, Vec::new()));
                    carried.len() - 1
                });
                let sum = &mut carried[at].1;
                sum.resize(sum.len().max(parts.len()), 0.0);
                sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += slope * part);
            }
        }
        let results = formulas(values).unwrap_or_default();
        let size = |name: &str| results.get(name).map_or(0.0, |result| result.value.abs());
        carried.retain(|(name, parts)| norm(parts) > ROUNDING * size(name));
        Self(carried)
    }

    /// The parts of a result.
    fn parts(&self, name: &str) -> &[f64] {
        self.0.iter().find(|(own, _)| *own == name).map_or(&[], |(_, parts)| parts)
    }

    /// The standard deviation of a result; zero if it does not vary.
    pub fn deviation(&self, name: &str) -> f64 {
        norm(self.parts(name))
    }

    /// How results vary together, in the order of these names; nothing if none do.
    pub fn covariance<'a>(&self, names: impl Iterator<Item = &'a str>) -> Option<Covariance> {
        let parts = names.map(|name| self.parts(name).to_vec()).collect();
        Covariance::of_parts(parts).ok().filter(|covariance| !covariance.correlations().is_empty())
    }
}

fn norm(parts: &[f64]) -> f64 {
    parts.iter().fold(0.0, |sum: f64, part| sum.hypot(*part))
}

/// The standard deviations of values; zero where there is none.
pub fn deviations<'a>(values: impl IntoIterator<Item = &'a Given>) -> Vec<f64> {
    let deviation = |given: &Given| given.deviation.as_ref().map_or(0.0, |deviation| deviation.value);
    values.into_iter().map(deviation).collect()
}
