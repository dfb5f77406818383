//! Models compiled ahead of time by Carvallo, and the bicycles that were measured for them.

#![no_std]

mod models;

pub use models::Whipple;
