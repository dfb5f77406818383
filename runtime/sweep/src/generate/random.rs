//! A parameter that is drawn: `c=0.02..0.12` or `mB=85+-5`.

use carvallo_design::conventions::{Naming, Varying};
use carvallo_design::input::measured;
use carvallo_design::number::with_unit;
use carvallo_design::parameter::{any_possible, check_units, number, too_wide};
use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng as _, SeedableRng as _};

/// The 32-bit words that each sample takes, whatever its distribution.
const WORDS: u128 = 4;

/// No sample is farther from the mean, in standard deviations: sqrt(-2 ln 2^-53) is 8.57.
const FARTHEST: f64 = 8.6;

/// A parameter and its distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct Random {
    pub parameter: Varying,
    /// Each parameter has numbers of its own, which do not depend on what else is drawn.
    stream: u64,
    pub distribution: Distribution,
}

/// How a parameter is distributed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    Uniform { low: f64, high: f64 },
    Normal { mean: f64, deviation: f64 },
}

impl Random {
    /// # Errors
    /// What is wrong. Distributions that partly leave the parameter's domain are not: they make designs without a result.
    pub fn parse(text: &str, naming: &Naming) -> Result<Self, String> {
        let expected = "expected NAME=LOW..HIGH, NAME=MEAN+-DEVIATION or measured, such as c=0.02..0.12 or mB=85+-5";
        let (name, values) = text.split_once('=').ok_or(expected)?;
        let varying = naming.find(name.trim())?;
        let parameter = &varying.info;
        let with_unit = |value| with_unit(value, parameter.unit);
        let distribution = if let Some((low, high)) = values.split_once("..") {
            check_units(&[low, high], parameter)?;
            let (low, high) = (number(low, parameter)?, number(high, parameter)?);
            if low > high {
                let [low, high] = [low, high].map(with_unit);
                return Err(format!("the range ends at {high}, before it begins at {low}; it must ascend"));
            }
            if !(high - low).is_finite() {
                return Err(too_wide(low, high, parameter));
            }
            any_possible(&[low, low / 2.0 + high / 2.0, high], parameter)?;
            Distribution::Uniform { low, high }
        } else {
            let measured = measured(values, parameter);
            let (mean, deviation) = measured.map_err(|found| format!("a value of `{}` is {found}", parameter.name))?;
            let deviation = deviation.ok_or(expected)?;
            if deviation < 0.0 {
                return Err(format!("the standard deviation is {}; it must be >= 0", with_unit(deviation)));
            }
            any_possible(&[mean], parameter)?;
            if !(mean.abs() + FARTHEST * deviation).is_finite() {
                return Err(format!(
                    "the standard deviation is {}, too large for double precision",
                    with_unit(deviation)
                ));
            }
            Distribution::Normal { mean, deviation }
        };
        Ok(Self { stream: varying.stream(naming.info()), parameter: varying, distribution })
    }

    /// What draws its samples: each by its number, so that it is the same whichever were drawn before it.
    pub fn draws(&self, seed: u64) -> Draws {
        Draws::new(self.distribution, seed, self.stream)
    }
}

/// The samples of one parameter.
pub struct Draws {
    distribution: Distribution,
    generator: ChaCha8Rng,
    /// The sample that the generator is at.
    next: u64,
}

impl Draws {
    /// From the numbers of one stream of the generator.
    pub fn new(distribution: Distribution, seed: u64, stream: u64) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(stream);
        Self { distribution, generator, next: 0 }
    }

    /// The sample with a number.
    pub fn sample(&mut self, index: u64) -> f64 {
        if index != self.next {
            self.generator.set_word_pos(WORDS * u128::from(index));
        }
        self.next = index + 1;
        // Uniform in [0, 1).
        let [first, second] = [(); 2].map(|()| (self.generator.next_u64() >> 11) as f64 * 2_f64.powi(-53));
        match self.distribution {
            Distribution::Uniform { low, high } => low + (high - low) * first,
            // Box & Muller (1958).
            Distribution::Normal { mean, deviation } => {
                let radius = (-2.0 * (1.0 - first).ln()).sqrt();
                mean + deviation * radius * (std::f64::consts::TAU * second).cos()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Random;
    use carvallo_design::WHIPPLE;
    use carvallo_design::conventions::Naming;

    fn parsed(text: &str) -> Result<Random, String> {
        Random::parse(text, &Naming::new(WHIPPLE.info, text.split('=').next()))
    }

    fn samples(text: &str, seed: u64) -> Vec<f64> {
        let random = parsed(text).expect("a distribution");
        let mut draws = random.draws(seed);
        (0..20_000).map(|index| draws.sample(index)).collect()
    }

    #[test]
    fn a_sample_depends_on_its_number_alone() {
        let random = parsed("c=0..1").expect("a distribution");
        let all = samples("c=0..1", 7);
        for index in [19_999, 3, 4, 0, 12_345] {
            assert_eq!(random.draws(7).sample(index), all[index as usize]);
            let mut draws = random.draws(7);
            draws.sample(index / 2);
            assert_eq!(draws.sample(index), all[index as usize]);
        }
        assert_ne!(samples("c=0..1", 8), all);
        assert_ne!(samples("w=0..1", 7), all);
    }

    /// Within five standard errors of 20,000 samples.
    #[test]
    fn samples_have_the_moments_of_their_distribution() {
        let spellings = ["mB=85+-5", "mB=85 ± 5 kg", "mB=85(5)"].map(|text| (text, 85.0, 5.0));
        for (text, mean, deviation) in [("c=0.02..0.12", 0.07, 0.1 / 12_f64.sqrt())].into_iter().chain(spellings) {
            let samples = samples(text, 0);
            let count = samples.len() as f64;
            let found = samples.iter().sum::<f64>() / count;
            assert!((found - mean).abs() < 5.0 * deviation / count.sqrt(), "{text}: {found}");
            let variance = samples.iter().map(|sample| (sample - found).powi(2)).sum::<f64>() / count;
            assert!((variance.sqrt() / deviation - 1.0).abs() < 5.0 / (2.0 * count).sqrt(), "{text}: {variance}");
        }
        assert!(samples("c=0.02..0.12", 1).iter().all(|sample| (0.02..0.12).contains(sample)));
    }

    #[test]
    fn mistakes_are_named() {
        let expected = "expected NAME=LOW..HIGH, NAME=MEAN+-DEVIATION or measured, such as c=0.02..0.12 or mB=85+-5";
        for (text, message) in [
            ("c", expected),
            ("c=1", expected),
            ("c=2..1", "the range ends at 1 m, before it begins at 2 m; it must ascend"),
            ("w=-1e308..1e308", "the range from -1e308 m to 1e308 m is too wide for double precision"),
            ("mB=85+-1e308", "the standard deviation is 1e308 kg, too large for double precision"),
            ("mB=85+/--5", "the standard deviation is -5 kg; it must be >= 0"),
            ("MB=85±5", "`MB` is not a parameter of Whipple; did you mean `mB`?"),
        ] {
            assert_eq!(parsed(text), Err(message.to_owned()), "{text}");
        }
    }
}
