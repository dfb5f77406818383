#![doc = include_str!("../README.md")]

mod bicycle;
mod doubts;
mod geometry;
mod names;
mod origins;
pub mod oscillation;
mod part;
mod pendulum;
pub mod rider;
mod table;

use carvallo_design::input::{Raw, load_raw, read_raw};
use carvallo_design::{Design, Failure};

/// A file of measurements to start from, with what each of them is: those of a Batavus Browser.
pub const EXAMPLE: &str = include_str!("example.toml");

/// The parameters of a bicycle from the measurements in a file, or with `-` from the standard input.
///
/// # Errors
/// Everything that is wrong with the file, or that it cannot be read.
pub fn load(path: &str) -> Result<Design, Failure> {
    measure(load_raw(path)?)
}

/// The parameters of a bicycle from the measurements in the contents of a file; the ending of its label tells the format, or
/// else what is in it.
///
/// # Errors
/// Everything that is wrong with it.
pub fn read(label: &str, contents: Vec<u8>) -> Result<Design, Failure> {
    measure(read_raw(label, contents)?)
}

fn measure(raw: Raw) -> Result<Design, Failure> {
    let sources = carvallo::Sources::default();
    let table = table::Table::read(raw, &sources)?;
    let parameters = bicycle::parameters(&table);
    table.finish(parameters)
}
