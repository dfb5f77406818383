//! Bodies joined to a frame of a machine: a rider, a rack, a bag, a motor.

mod body;
mod inertia;
mod join;
mod members;
mod read;

pub use self::body::{Body, Frame};
pub use self::inertia::Inertia;
pub use self::join::add;
pub(crate) use self::join::{join, kind, name};
pub(crate) use self::read::read;
