//! Files to take away, byte for byte as the command line writes them.

use carvallo_design::{Failure, file};
use carvallo_plot::analysis::{Analysis, reach};
use carvallo_plot::data;
use serde::Serialize;

use crate::motion::{Asked, move_by};
use crate::question::missing;

/// A file that was written.
#[derive(Serialize)]
pub struct Written {
    contents: String,
}

/// Writes one of
///
/// - `toml`: the parameters, as `carvallo show` prints them;
/// - `json` and `csv`: as `carvallo analyze --format` prints them;
/// - `motion csv`: as `carvallo simulate --format` prints it, with steps of its own.
///
/// # Errors
/// That there is no such file, or no such motion.
pub fn write(analysis: &Analysis, kind: &str, asked: Option<&Asked>) -> Result<Written, Failure> {
    let asked = || asked.ok_or_else(|| missing("motion"));
    let contents = match kind {
        "toml" => file::write(&analysis.design, &str::to_owned),
        "json" | "csv" => {
            let rows = analysis.rows(&reach::speeds(analysis.reach, false))?;
            text(|output| match kind {
                "json" => data::analysis::write_json(analysis, &rows, None, output),
                _ => data::analysis::write_csv(analysis, &rows, output),
            })?
        }
        "motion csv" => {
            move_by(&analysis.design, asked()?, None, &mut |motion| text(|to| data::motion::write_csv(motion, to)))?
        }
        _ => return Err(Failure::usage(format!("there is no file `{kind}`"))),
    };
    Ok(Written { contents })
}

fn text(write: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    write(&mut bytes).map_err(|error| Failure::Run(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Failure::Run(error.to_string()))
}
