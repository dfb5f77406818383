//! Equations to a [`Program`](crate::program::Program). This folder is the one door to Symbolica: nothing outside it
//! names Symbolica.

mod angles;
mod arithmetic;
mod atoms;
mod derivatives;
mod door;
mod engine;
mod export;
mod failure;
mod form;
mod identity;
mod instructions;
mod kept;
mod lock;
mod optimize;
mod powers;
mod prove;
mod sample;
mod vertex_elimination;

pub use derivatives::{Differentiated, Node, Wanted, derive};
pub use door::{ask, enter};
pub use engine::Engine;
pub use failure::{EngineFailure, Failure, Place, Undefined};
pub use form::Form;
pub use identity::Sign;
pub use kept::{Kept, with_answers};
pub use optimize::{Found, compile, finish, finish_derivatives};
pub use powers::{PowerTerm, Sorted, sort_by_powers};
pub use prove::{Depth, Proof, find_multiples, prove_equal};
pub use sample::Sample;
