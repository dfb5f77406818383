//! The ahead-of-time driver: models in files of their own to files of Rust.

mod folder;
mod layout;
mod modules;
mod paths;
mod source;

use std::path::Path;

use quote::quote;

use self::folder::Job;
pub use self::modules::include;

/// Compiles every source in the folder `models/` of `generated` to one file in its `src/models/`, beside a `mod.rs`
/// for all of them; with `check` nothing is written. Returns what was done.
///
/// # Errors
/// Mistakes of the sources, files that cannot be read or written, and with `check` every file that is stale, missing
/// or left over.
pub fn regenerate(generated: &Path, check: bool) -> Result<String, String> {
    let job = Job {
        models: &generated.join("models"),
        shown_models: "generated/models",
        written: &generated.join("src/models"),
        shown_written: "generated/src/models",
        command: "cargo regenerate",
        // A feature of the crate that the files are in.
        attribute: Some(quote! {
            cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))
        }),
        lists_models: true,
    };
    job.run(check)
}

/// The same in a crate of one's own: every source in the folder `models` to a file in the folder `written`. Files there
/// that were not generated are left alone.
///
/// # Errors
/// As [`regenerate`]; and if a file that is to be written is one that was not generated.
pub fn expand(models: &Path, written: &Path, check: bool) -> Result<String, String> {
    let [shown_models, shown_written] = [models, written].map(show);
    let command = match (&*shown_models, &*shown_written) {
        (MODELS, WRITTEN) => "carvallo-compiler expand".to_string(),
        _ => format!("carvallo-compiler expand {shown_models} {shown_written}"),
    };
    let (shown_models, shown_written) = (&*shown_models, &*shown_written);
    let (attribute, lists_models) = (None, false);
    Job { models, shown_models, written, shown_written, command: &command, attribute, lists_models }.run(check)
}

/// Where a crate of one's own has its sources, if it says nothing else.
pub const MODELS: &str = "models";
/// And its generated files.
pub const WRITTEN: &str = "src/models";

/// A path as it stands in messages and generated files: the same on every system, and without a slash at its end.
fn show(path: &Path) -> String {
    path.components().collect::<std::path::PathBuf>().to_string_lossy().replace('\\', "/")
}
