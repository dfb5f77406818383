//! The range of a parameter that is varied.

use carvallo::{ModelInfo, ParameterInfo};
use carvallo_design::number::with_unit;
use carvallo_design::parameter::{check_units, find, number};
use carvallo_design::{Failure, Place};

/// A parameter that is varied, and between which values.
#[derive(Clone, Debug)]
pub struct Range {
    /// As it was given.
    pub written: String,
    /// Where the parameter is among those of the model.
    pub position: usize,
    /// What it is.
    pub parameter: &'static ParameterInfo,
    /// The least value, in the unit of the parameter.
    pub low: f64,
    /// The largest one.
    pub high: f64,
}

impl Range {
    /// Reads `NAME=LOW:HIGH`.
    ///
    /// # Errors
    /// If it is none, or of no parameter of the model, or if an end is no value that the parameter may have.
    pub fn parse(written: &str, info: &ModelInfo) -> Result<Self, Failure> {
        let fail = |message: String| Failure::at(Place::Option(format!("--vary {written}")), message);
        let parts = written.split_once('=').and_then(|(name, range)| Some((name.trim(), range.split_once(':')?)));
        let Some((name, (low, high))) = parts.filter(|(_, (_, high))| !high.contains(':')) else {
            return Err(fail("expected NAME=LOW:HIGH, such as w=0.9:1.2".to_owned()));
        };
        let position = find(name, info).map_err(fail)?;
        let parameter = &info.parameters[position];
        check_units(&[low.trim(), high.trim()], parameter).map_err(fail)?;
        let [low, high] = [low, high].map(|end| number(end.trim(), parameter));
        let (low, high) = (low.map_err(fail)?, high.map_err(fail)?);
        if low >= high {
            let [low, high] = [low, high].map(|end| with_unit(end, parameter.unit));
            return Err(fail(format!("the range is from {low} to {high}; it must ascend")));
        }
        for end in [low, high] {
            if !parameter.domain.contains(end) {
                let end = with_unit(end, parameter.unit);
                return Err(fail(format!("`{}` is {end}; it must be {}", parameter.name, parameter.domain)));
            }
        }
        Ok(Self { written: written.to_owned(), position, parameter, low, high })
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
