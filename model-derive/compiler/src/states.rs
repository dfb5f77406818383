//! Which of the position and the rate of a coordinate are states of the motion, which all stages use.

use nanoserde::{DeBin, SerBin};

/// What the motion goes on from, of one coordinate.
#[derive(Clone, Copy, Debug, DeBin, Default, PartialEq, Eq, SerBin)]
pub enum States {
    /// Its position and its rate.
    #[default]
    Both,
    /// A coordinate of first order.
    Position,
    /// One of which no position matters.
    Rate,
}

impl States {
    /// As it is written in a declaration, behind `only`.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "position" => Some(Self::Position),
            "rate" => Some(Self::Rate),
            _ => None,
        }
    }
}
