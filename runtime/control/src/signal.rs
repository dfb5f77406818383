//! What inputs, outputs and states are called, and their units.

use carvallo::CoordinateInfo;
use carvallo::motion::AppliedInfo;

/// An input, an output or a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// Such as `Tdelta`, `phi` or `phi_rate`.
    pub name: String,
    /// In words, such as `steer torque`, `lean` or `lean rate`.
    pub label: String,
    /// As models declare units: `N*m`, `rad/s`, and `1` for a pure number.
    pub unit: String,
}

/// Something that has a position, a rate and an acceleration: a coordinate, or what follows from coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its symbol, such as `phi`.
    pub name: &'static str,
    /// In words, such as `lean`.
    pub label: &'static str,
    /// The unit of its position.
    pub unit: &'static str,
}

/// Which derivative of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// The quantity itself.
    Position,
    /// Its first derivative by the time.
    Rate,
    /// Its second derivative by the time.
    Acceleration,
}

impl Order {
    /// All of them, ascending.
    pub const ALL: [Self; 3] = [Self::Position, Self::Rate, Self::Acceleration];

    /// What stands behind the name of a quantity.
    pub(crate) fn suffix(self) -> &'static str {
        ["", "_rate", "_acceleration"][self as usize]
    }
}

impl Signal {
    /// Its derivative by the time, as the rows of A are of: `phi_rate'`.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let unit = match self.unit.strip_suffix("/s") {
            Some(unit) => format!("{unit}/s^2"),
            None => format!("{}/s", self.unit),
        };
        Self { name: format!("{}'", self.name), label: format!("derivative of {}", self.label), unit }
    }
}

impl Signal {
    /// The unit of a gain by which it follows another signal: `N*m/rad`, `N*m*s/rad`.
    pub fn unit_by(&self, other: &Self) -> String {
        let (of, time) = other.unit.strip_suffix("/s").map_or((other.unit.as_str(), ""), |of| (of, "*s"));
        match (self.unit.as_str(), time, of) {
            ("1", "*s", "1") => "s".to_owned(),
            (unit, time, "1") => format!("{unit}{time}"),
            (unit, time, of) if of.contains(['*', '/']) => format!("{unit}{time}/({of})"),
            (unit, time, of) => format!("{unit}{time}/{of}"),
        }
    }
}

impl From<&AppliedInfo> for Signal {
    fn from(&AppliedInfo { name, label, unit, .. }: &AppliedInfo) -> Self {
        Self { name: name.to_owned(), label: label.to_owned(), unit: unit.to_owned() }
    }
}

impl From<&CoordinateInfo> for Quantity {
    fn from(&CoordinateInfo { name, label, unit, .. }: &CoordinateInfo) -> Self {
        Self { name, label, unit }
    }
}

impl Quantity {
    /// A derivative of it.
    pub(crate) fn signal(&self, order: Order) -> Signal {
        let unit = if self.unit.is_empty() { "1" } else { self.unit };
        Signal {
            name: format!("{}{}", self.name, order.suffix()),
            label: format!("{}{}", self.label, order.suffix().replace('_', " ")),
            unit: format!("{unit}{}", ["", "/s", "/s^2"][order as usize]),
        }
    }

    /// The generalized force on it as a coordinate: a torque on an angle, a force on a length.
    pub(crate) fn force(&self) -> Signal {
        let (letter, what, unit) = match self.unit {
            "rad" => ('T', "torque", "N*m"),
            "m" => ('F', "force", "N"),
            _ => ('F', "force", "1"),
        };
        Signal {
            name: format!("{letter}{}", self.name),
            label: format!("{} {what}", self.label),
            unit: unit.to_owned(),
        }
    }
}
