//! Models compiled ahead of time by Carvallo, and the bicycles that were measured for them.

#![no_std]

mod bicycles;
mod models;

pub use bicycles::{BICYCLES, Bicycle};
pub use models::*;
