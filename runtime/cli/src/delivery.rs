//! Where a result goes, and in which format: what the ending of a file names, and else what is asked for.

use std::path::Path;

use carvallo_design::{Failure, Place};
use clap::Args;

use crate::destination::Destination;
use crate::options::Format;
use crate::output::typeset::Language;

/// What the names of files end in, in words.
const ENDINGS: &str = ".json, .csv, .md, .tex or .txt";

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
        match (format_of(path), self.format) {
            (None, None) => Err(self.problem(&format!("the name must end in {ENDINGS}"))),
            (None, Some(format)) => Ok(format),
            // Any text may be in a file of text.
            (Some(Format::Table), Some(format)) if format.is_read() => Ok(format),
            (Some(named), Some(format)) if named != format => {
                Err(self.problem("the ending of its name is that of another format than --format"))
            }
            (Some(named), _) => Ok(named),
        }
    }

    /// That the file cannot be what it was asked to be.
    pub fn problem(&self, message: &str) -> Failure {
        let path = self.output.as_deref().unwrap_or(Path::new(""));
        Failure::at(Place::Option(format!("--output {}", path.display())), message)
    }
}

/// The format that the ending of a name stands for.
pub fn format_of(path: &Path) -> Option<Format> {
    let ending = path.extension()?.to_str()?.to_ascii_lowercase();
    Some(match ending.as_str() {
        "json" => Format::Json,
        "csv" => Format::Csv,
        "txt" => Format::Table,
        "md" => Format::Document(Language::Markdown),
        "tex" => Format::Document(Language::Latex),
        _ => return None,
    })
}
