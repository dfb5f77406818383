//! Equations to a [`Program`](crate::program::Program). This folder is the one door to Symbolica: nothing outside it names Symbolica.

mod algebra;
mod angles;
mod derivatives;
mod door;
mod elimination;
mod form;
mod identity;
mod import;
mod lock;
mod optimize;
mod prove;
mod sample;

pub use derivatives::{Derived, Node, derive};
pub use door::{Failure, enter};
pub use form::{Engine, Form, Undefined};
pub use identity::Sign;
pub use optimize::{Place, compile};
pub use prove::{Depth, Proof, multiples, proofs};
pub use sample::Sample;
