//! The range of a parameter that is varied.

use carvallo::{ModelInfo, ParameterInfo};
use carvallo_design::conventions::{Naming, Varying};
use carvallo_design::parameter::ends;
use carvallo_design::{Failure, Place};

/// A parameter that is varied, and between which values.
#[derive(Clone, Debug)]
pub struct Range {
    /// As it was given.
    pub written: String,
    /// What it is: one of the model, or of a convention of bicycles.
    pub parameter: ParameterInfo,
    /// The least value, in the unit of the parameter.
    pub low: f64,
    /// The largest one.
    pub high: f64,
    pub(crate) varying: Varying,
}

impl Range {
    /// Reads ranges `NAME=LOW:HIGH`. Names that are not those of the model are all of one convention.
    ///
    /// # Errors
    /// Everything that is none, or of no parameter, or an end that is no value which the parameter may have.
    pub fn parse(written: &[String], info: &'static ModelInfo) -> Result<Vec<Self>, Failure> {
        let naming = naming(written.iter().map(String::as_str), info);
        let (mut ranges, mut problems) = (Vec::new(), Vec::new());
        for written in written {
            match Self::read(written, &naming) {
                Ok(range) => ranges.push(range),
                Err(Failure::Input(found)) => problems.extend(found),
                Err(failure) => return Err(failure),
            }
        }
        if problems.is_empty() { Ok(ranges) } else { Err(Failure::Input(problems)) }
    }

    fn read(written: &str, naming: &Naming) -> Result<Self, Failure> {
        let fail = |message: String| Failure::at(Place::Option(format!("--vary {written}")), message);
        let parts = written.split_once('=').and_then(|(name, range)| Some((name.trim(), range.split_once(':')?)));
        let Some((name, (low, high))) = parts.filter(|(_, (_, high))| !high.contains(':')) else {
            return Err(fail("expected NAME=LOW:HIGH, such as w=0.9:1.2".to_owned()));
        };
        let varying = naming.find(name).map_err(fail)?;
        let parameter = varying.info;
        let low = varying.in_numbers(low.trim(), naming).map_err(fail)?;
        let high = varying.in_numbers(high.trim(), naming).map_err(fail)?;
        let [low, high] = ends([&low, &high], &parameter).map_err(fail)?;
        Ok(Self { written: written.to_owned(), parameter, low, high, varying })
    }

    /// The value at a share of the range, exactly the ends at 0 and 1.
    pub(crate) fn at(&self, share: f64) -> f64 {
        match share {
            share if share <= 0.0 => self.low,
            share if share >= 1.0 => self.high,
            share => (self.low + share * (self.high - self.low)).clamp(self.low, self.high),
        }
    }

    /// The share of the range at which a value is, or the end that it is beyond.
    pub(crate) fn share(&self, value: f64) -> f64 {
        ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }
}

/// What the names before the signs of equality mean.
pub(crate) fn naming<'a>(written: impl Iterator<Item = &'a str>, info: &'static ModelInfo) -> Naming {
    Naming::new(info, written.map(|text| text.split('=').next().unwrap_or_default().trim()))
}
