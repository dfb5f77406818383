//! Equations to a [`Program`](crate::program::Program). This folder is the one door to Symbolica: nothing outside it names Symbolica.

mod door;
mod form;
mod import;
mod lock;
mod optimize;

pub use door::{Failure, enter};
pub use form::{Engine, Form, Undefined};
pub use optimize::{Place, compile};
