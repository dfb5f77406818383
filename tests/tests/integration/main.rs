//! Integration tests: results of generated code and of the runtime against facts from outside of both.

mod bicycles;
mod designs;
mod published;
