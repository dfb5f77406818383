//! Parameters that are drawn as they were measured, with their standard deviations and correlations.

use carvallo::Covariance;
use carvallo_design::conventions::Varying;
use carvallo_design::{Design, Failure, Place};

use super::random::{Distribution, Draws};

/// What asks for it in the place of a distribution.
pub const MEASURED: &str = "measured";

/// The streams of the generator below this are of parameters that are drawn by themselves.
const FIRST_STREAM: u64 = 1 << 32;

/// All parameters of a design that have a standard deviation.
#[derive(Debug)]
pub struct Together {
    /// Where each is among those of the model.
    pub positions: Vec<usize>,
    pub means: Vec<f64>,
    /// For each, the parts of its deviation that come from each source, as [`Covariance::parts`] has them.
    pub parts: Vec<Vec<f64>>,
}

impl Together {
    /// # Errors
    /// If no parameter but the others has a standard deviation.
    pub fn new(design: &Design, others: &[&Varying]) -> Result<Self, Failure> {
        let deviation = |given: &carvallo_design::Given| given.deviation.as_ref().map_or(0.0, |spread| spread.value);
        let deviations: Vec<f64> = design.parameters.iter().map(deviation).collect();
        let fail = |message: String| Failure::at(Place::Option(format!("--random {MEASURED}")), message);
        let positions: Vec<usize> = (0..deviations.len())
            .filter(|position| deviations[*position] > 0.0)
            .filter(|position| others.iter().all(|other| other.position() != Some(*position)))
            .collect();
        if positions.is_empty() {
            return Err(fail(format!("none of the parameters of {} has a standard deviation", design.title())));
        }
        let all = match &design.covariance {
            Some(covariance) => covariance.clone(),
            None => Covariance::independent(&deviations).map_err(|error| fail(error.to_string()))?,
        };
        let means = positions.iter().map(|&position| design.parameters[position].value).collect();
        let parts = positions.iter().map(|&position| all.parts()[position].clone()).collect();
        Ok(Self { positions, means, parts })
    }

    /// The values of each parameter in the samples with these numbers.
    pub fn columns(&self, seed: u64, numbers: impl Iterator<Item = u64> + Clone) -> Vec<Vec<f64>> {
        let mut columns: Vec<Vec<f64>> =
            self.means.iter().map(|mean| numbers.clone().map(|_| *mean).collect()).collect();
        let sources = self.parts.iter().map(Vec::len).max().unwrap_or(0);
        let is_used =
            |source: &usize| self.parts.iter().any(|parts| parts.get(*source).is_some_and(|part| *part != 0.0));
        for source in (0..sources).filter(is_used) {
            let standard = Distribution::Normal { mean: 0.0, deviation: 1.0 };
            let mut draws = Draws::new(standard, seed, FIRST_STREAM + source as u64);
            let samples: Vec<f64> = numbers.clone().map(|number| draws.sample(number)).collect();
            for (column, parts) in columns.iter_mut().zip(&self.parts) {
                let part = parts.get(source).copied().unwrap_or(0.0);
                column.iter_mut().zip(&samples).for_each(|(value, sample)| *value += part * sample);
            }
        }
        columns
    }
}

#[cfg(test)]
mod tests {
    use super::Together;
    use carvallo_design::conventions::Varying;
    use carvallo_design::input;

    /// Within five standard errors of 20,000 samples.
    #[test]
    fn samples_vary_together() {
        let benchmark =
            carvallo_design::file::write(&input::load(&input::Request::default()).unwrap(), &|_| String::new());
        let text = benchmark.replace("mB = 85", "mB = { value = 85, std = 5 }").replace("c = 0.08", "c = '0.08+-0.01'");
        let text = text + "\n[correlations]\nmB = { c = -0.6 }\n";
        let design = input::read("both.toml", text.into_bytes()).unwrap();
        let together = Together::new(&design, &[]).unwrap();
        let count = 20_000;
        let columns = together.columns(3, 0..count);
        let [c, m] = &columns[..] else { panic!("two") };
        let n = count as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
        let [mean_c, mean_m] = [mean(c), mean(m)];
        assert!((mean_c - 0.08).abs() < 5.0 * 0.01 / n.sqrt() && (mean_m - 85.0).abs() < 5.0 * 5.0 / n.sqrt());
        let product =
            |a: &[f64], x: f64, b: &[f64], y: f64| a.iter().zip(b).map(|(a, b)| (a - x) * (b - y)).sum::<f64>() / n;
        let [cc, mm, cm] =
            [product(c, mean_c, c, mean_c), product(m, mean_m, m, mean_m), product(c, mean_c, m, mean_m)];
        let bound = 5.0 / (2.0 * n).sqrt();
        assert!((cc.sqrt() / 0.01 - 1.0).abs() < bound && (mm.sqrt() / 5.0 - 1.0).abs() < bound);
        assert!((cm / (cc * mm).sqrt() + 0.6).abs() < 5.0 * (1.0 - 0.36) / n.sqrt());
        // By their numbers alone.
        assert_eq!(together.columns(3, 12_345..12_346), [[c[12_345]], [m[12_345]]]);
        let first = Varying::of_model(design.info(), together.positions[0]);
        let alone = Together::new(&design, &[&first]).unwrap();
        assert_eq!(alone.positions, together.positions[1..]);
    }
}
