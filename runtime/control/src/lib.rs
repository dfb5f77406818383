#![doc = include_str!("../README.md")]

mod balance;
mod derivatives;
mod feedback;
pub mod files;
mod frequency;
mod lost;
mod margins;
mod modal;
mod ports;
mod response;
mod rest;
mod scaled;
mod signal;
mod state_space;
mod transfer;
mod transmission;
mod zeros;

pub use self::derivatives::StateSpaceDerivative;
pub use self::feedback::{Code, Regulator, Riccati, RiccatiError, Schedule, Weights};
pub use self::frequency::FrequencyResponse;
pub use self::lost::{Lost, Port, lost};
pub use self::margins::{GainMargin, Margins, PhaseMargin};
pub use self::modal::{ModalAnalysis, ModalMeasures};
pub use self::ports::{Output, Ports};
pub use self::response::Response;
pub use self::scaled::ShownIn;
pub use self::signal::{Order, Quantity, Signal};
pub use self::state_space::StateSpace;
pub use self::transfer::TransferFunction;
pub use self::transmission::{singular_values, transmission_zeros};

#[cfg(test)]
mod tests;
