//! Motions in time.

mod linear;
