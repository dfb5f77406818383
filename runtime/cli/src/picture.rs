//! Files of pictures.

use std::path::Path;

use carvallo_design::Failure;
use carvallo_plot::picture::Scene;

use crate::terminal::{WARNING, note};

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
