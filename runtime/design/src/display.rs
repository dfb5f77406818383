//! The unit that a quantity is shown in.

use crate::number::unit;
#[cfg(feature = "full")]
use crate::quantity::Scale;

/// The unit that a quantity is shown in, and what its values are multiplied with. Without the feature `full` it is the declared
/// one.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayUnit {
    /// As it can be written behind a number and is read again: `kg*cm^2`.
    pub written: String,
    #[cfg(feature = "full")]
    scale: Option<Scale>,
}

impl DisplayUnit {
    /// That of the values themselves.
    pub fn declared(unit: &str) -> Self {
        Self {
            written: unit.to_owned(),
            #[cfg(feature = "full")]
            scale: None,
        }
    }

    /// The unit for people: `kg cm²`.
    pub fn unit(&self) -> String {
        unit(&self.written)
    }
}

#[cfg(feature = "full")]
impl DisplayUnit {
    pub(crate) fn new(unit: &str, scale: Scale) -> Self {
        Self { written: unit.to_owned(), scale: Some(scale) }
    }

    /// A value in this unit, with no more digits than it takes to be read as the value again: 30, where 29.999999999999996 is
    /// computed.
    pub fn value(&self, value: f64) -> f64 {
        let Some(scale) = self.scale else { return value };
        let exact = scale.apply(value);
        let short = format!("{exact:.14e}").parse().unwrap_or(exact);
        if self.back(short) == value { short } else { exact }
    }

    /// The value of a number in this unit.
    pub fn back(&self, shown: f64) -> f64 {
        self.scale.map_or(shown, |scale| scale.inverse().apply(shown))
    }

    /// Whether values are in the declared unit.
    pub fn is_declared(&self) -> bool {
        self.scale.is_none()
    }

    /// What stands behind the name of a quantity: ` (mm)`, or ` (°/s)` for degrees by second, and nothing for pure numbers.
    pub fn behind_name(&self) -> String {
        match self.symbol() {
            unit if unit.is_empty() => unit,
            unit => format!(" ({unit})"),
        }
    }

    /// What stands behind a number: ` mm`, or `°`.
    pub fn behind_number(&self) -> String {
        match self.symbol() {
            unit if unit.is_empty() || unit == "°" => unit,
            unit => format!(" {unit}"),
        }
    }

    /// The unit for people, with the sign of degrees.
    fn symbol(&self) -> String {
        ["degrees", "degree", "deg"].iter().fold(self.unit(), |unit, name| unit.replace(name, "°"))
    }
}

#[cfg(not(feature = "full"))]
impl DisplayUnit {
    /// A value in this unit.
    pub fn value(&self, value: f64) -> f64 {
        value
    }

    /// The value of a number in this unit.
    pub fn back(&self, shown: f64) -> f64 {
        shown
    }

    /// Whether values are in the declared unit.
    pub fn is_declared(&self) -> bool {
        true
    }
}
