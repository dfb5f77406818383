//! The unit that a quantity is shown in.

use crate::number::unit;
use crate::quantity::Scale;

/// The unit that a quantity is shown in, and what its values are multiplied with.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayUnit {
    /// As it can be written behind a number and is read again: `kg*cm^2`.
    pub written: String,
    scale: Option<Scale>,
}

impl DisplayUnit {
    /// That of the values themselves.
    pub fn declared(unit: &str) -> Self {
        Self { written: unit.to_owned(), scale: None }
    }

    #[cfg(feature = "full")]
    pub(crate) fn new(unit: &str, scale: Scale) -> Self {
        Self { written: unit.to_owned(), scale: Some(scale) }
    }

    /// A value in this unit.
    pub fn value(&self, value: f64) -> f64 {
        self.scale.map_or(value, |scale| scale.apply(value))
    }

    /// The value of a number in this unit.
    pub fn back(&self, shown: f64) -> f64 {
        self.scale.map_or(shown, |scale| scale.inverse().apply(shown))
    }

    /// Whether values are in the declared unit.
    pub fn is_declared(&self) -> bool {
        self.scale.is_none()
    }

    /// The unit for people: `kg cm²`.
    pub fn unit(&self) -> String {
        unit(&self.written)
    }
}
