//! Where a result goes, and in which format: what the ending of a file names, and else what is asked for.

use std::path::Path;

use carvallo_design::{Failure, Place};
use clap::Args;

use crate::destination::Destination;
use crate::endings::Endings;
use crate::options::Format;
use crate::output::typeset::Language;

/// What the names of files end in. Any text may be in a file of text.
const ENDINGS: Endings<Format> = Endings(&[
    ("json", Format::Json),
    ("csv", Format::Csv),
    ("md", Format::Document(Language::Markdown)),
    ("tex", Format::Document(Language::Latex)),
    ("txt", Format::Table),
    ("txt", Format::Document(Language::Markdown)),
    ("txt", Format::Document(Language::Latex)),
]);

/// A file or the standard output, and a format.
#[derive(Args, Clone, Debug)]
pub struct Delivery {
    #[arg(
        long,
        value_enum,
        hide_possible_values = true,
        help = "table, markdown, latex, json or csv [default: what the ending of FILE names, or table]"
    )]
    format: Option<Format>,
    #[arg(
        long,
        value_name = "FILE",
        help = "Where the result goes; .json, .csv, .md, .tex or .txt names the format [default: stdout]"
    )]
    output: Option<Destination>,
}

impl Delivery {
    /// The file, if it is none of the standard output.
    pub fn path(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The format of what is told.
    ///
    /// # Errors
    /// If the ending of the file names another one than is asked for, or none while none is asked for.
    pub fn format(&self) -> Result<Format, Failure> {
        let Some(path) = self.path() else { return Ok(self.format.unwrap_or(Format::Table)) };
        ENDINGS.kind(path, self.format).map_err(|message| self.problem(&message))
    }

    /// That the file cannot be what it was asked to be.
    pub fn problem(&self, message: &str) -> Failure {
        let place = self.output.as_ref().map_or(Place::Nowhere, Destination::place);
        Failure::at(place, message)
    }

    /// That a result takes the place of a result, if of a text.
    ///
    /// # Errors
    /// If something else is there.
    pub fn replaces_result(&self) -> Result<(), Failure> {
        self.output.as_ref().map_or(Ok(()), |output| output.replaces_result())
    }

    /// That source text takes the place of source text that this program wrote, if of anything.
    ///
    /// # Errors
    /// If something else is there.
    pub fn replaces_source(&self) -> Result<(), Failure> {
        self.output.as_ref().map_or(Ok(()), Destination::replaces_source)
    }
}
