//! Pictures, as SVG or PNG from one drawing.

mod along;
mod axes;
mod beyond;
mod colors;
mod critical;
mod curves;
mod eigenvalues;
mod font;
mod graph;
mod labels;
mod map;
mod marks;
mod motion;
mod panels;
mod path;
mod png;
mod scene;
mod series;
mod side_view;
mod svg;
mod tornado;
mod turns;

use std::fs::OpenOptions;
use std::path::Path;

use crate::failure::Failure;

pub use self::along::draw_along;
pub use self::curves::extent;
pub use self::eigenvalues::{Limits, draw_eigenvalues};
pub use self::map::{MapAxis, MapCell, draw_map};
pub use self::motion::draw_motion;
pub use self::scene::Scene;
pub use self::side_view::draw_side_view;
pub use self::tornado::draw_tornado;
pub use self::turns::draw_turns;

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
        Some(ending) if ending.eq_ignore_ascii_case("png") => png::write(scene).map_err(fail)?,
        _ => svg::write(scene).into_bytes(),
    };
    std::fs::write(path, bytes).map_err(|error| fail(error.to_string()))
}
