//! What a sweep is asked for.

use std::path::PathBuf;

use carvallo_design::units::Units;
use carvallo_design::{Failure, Shipped, input};

use crate::plan::validate;

/// A sweep as it is asked for, in the words of the command line.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The design that gives all parameters that do not vary.
    pub base: input::Request,
    /// Parameters that vary: `NAME=LOW:HIGH:STEP`, `NAME=LOW:HIGH:N points`, or `NAME=` and a list.
    pub vary: Vec<String>,
    /// Parameters that are drawn: `NAME=LOW..HIGH`, or `NAME=MEAN+-DEVIATION`.
    pub random: Vec<String>,
    /// How many designs are drawn.
    pub samples: Option<u64>,
    /// Another seed draws other designs; without one it is 0.
    pub seed: Option<u64>,
    /// A table of designs, `.csv` or `.parquet`.
    pub designs: Option<PathBuf>,
    /// The speeds of eigenvalues in m/s: `LOW:HIGH:STEP`, a list, or one.
    pub eigenvalues: Option<String>,
    /// What results are in, in the place of the units of the SI.
    pub units: Units,
    /// Where the results go, `.csv` or `.parquet`; without one, as CSV to the standard output.
    pub output: Option<PathBuf>,
    /// Whether a finished or interrupted sweep that is there is replaced.
    pub restart: bool,
    /// Where a map of the stable ranges over two parameters will go, `.svg` or `.png`.
    pub map: Option<PathBuf>,
}

impl Request {
    /// Whether it can be asked of a model, as far as that is known without reading a file.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn check(&self, model: &Shipped) -> Result<(), Failure> {
        validate(self, model).map(drop)
    }
}
