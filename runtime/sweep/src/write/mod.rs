//! Results as bytes, in each of the formats.

pub mod csv;
pub mod parquet;
