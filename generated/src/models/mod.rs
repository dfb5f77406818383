//! The models compiled ahead of time.

mod whipple;

pub use whipple::Whipple;
