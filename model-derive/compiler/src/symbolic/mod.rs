//! Equations to a [`Program`](crate::program::Program). This folder is the one door to Symbolica: nothing outside it
//! names Symbolica.

mod algebra;
mod angles;
mod atoms;
mod derivatives;
mod door;
mod failure;
mod form;
mod identity;
mod import;
mod lock;
mod optimize;
mod prove;
mod sample;
mod vertex_elimination;

pub use derivatives::{Derived, Node, derive};
pub use door::{EngineFailure, enter};
pub use failure::{Failure, Place, Undefined};
pub use form::{Engine, Form};
pub use identity::Sign;
pub use optimize::compile;
pub use prove::{Depth, Proof, multiples, proofs};
pub use sample::Sample;
