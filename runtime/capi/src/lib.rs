//! Carvallo as a C library: the machines that ship, by name, and given matrices, with their eigenvalues, critical speeds and
//! stable ranges. `include/carvallo.h` is written from this crate, and is its documentation for C.
//!
//! `exports/` has the functions of C, which turn what C gives into what is safe and the answers into numbers and codes; all
//! else is safe Rust. Nothing that panics reaches C.

mod batch;
mod exports;
mod failure;
mod machine;
mod pointers;
mod types;

pub use exports::*;
pub use machine::Machine;
pub use types::{
    CarvalloChange, CarvalloKind, CarvalloStates, CarvalloStatus, CarvalloVerdict, Column, Complex, CriticalSpeed,
    Matrices, Range, Stability, Summary,
};
