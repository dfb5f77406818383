//! Files of pictures.

use std::fs::OpenOptions;
use std::path::Path;

use carvallo_design::Failure;
use carvallo_plot::picture::Scene;

use crate::terminal::{WARNING, note};

/// Tries whether a drawing can be written, before the work for it is done. Nothing is left of a file that was not there.
///
/// # Errors
/// If the file cannot be written.
pub fn check(path: &Path) -> Result<(), Failure> {
    let fail = |error| Failure::Run(format!("cannot write {}: {error}", path.display()));
    let kind = std::fs::metadata(path);
    // Opening a pipe would wait for its reader.
    if kind.as_ref().is_ok_and(|kind| !kind.is_file() && !kind.is_dir()) {
        return Ok(());
    }
    OpenOptions::new().write(true).create(true).truncate(false).open(path).map_err(fail)?;
    if kind.is_ok() { Ok(()) } else { std::fs::remove_file(path).map_err(fail) }
}

/// Writes a drawing in the format that the ending of the path names: PNG, or else SVG.
///
/// # Errors
/// If the file cannot be written.
pub fn save(scene: &Scene, path: &Path) -> Result<(), Failure> {
    let fail = |error: String| Failure::Run(format!("cannot write {}: {error}", path.display()));
    let bytes = match path.extension() {
        Some(ending) if ending.eq_ignore_ascii_case("png") => {
            let lacking = scene.lacking();
            if !lacking.is_empty() {
                let told = format!("the font of pictures lacks `{lacking}`, for which boxes stand in PNG");
                note(WARNING, "note", &format!("{}: {told}; SVG has them as text", path.display()));
            }
            scene.png().map_err(fail)?
        }
        _ => scene.svg().into_bytes(),
    };
    std::fs::write(path, bytes).map_err(|error| fail(error.to_string()))
}
