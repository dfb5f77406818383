//! Integration tests: results of generated code and of the runtime against facts from outside of both.

mod bicycles;
mod designs;
mod operations;
mod published;
#[cfg(feature = "compiler")]
mod ui;
