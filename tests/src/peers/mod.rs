//! What others would use for the same tasks, for the benchmarks.

pub mod symplex;
