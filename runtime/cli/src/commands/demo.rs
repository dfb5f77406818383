//! `carvallo` without arguments: a first look.

use std::path::PathBuf;

use carvallo_design::Failure;
use carvallo_design::input::DEFAULT_BICYCLE;
use carvallo_plot::analysis::Analysis;
use carvallo_plot::analysis::reach;
use carvallo_plot::picture::{Limits, draw_eigenvalues};

use crate::options::DesignOptions;
use crate::output;
use crate::picture;
use crate::terminal::print;

/// The benchmark bicycle and its picture, and how to go on.
pub fn run() -> Result<(), Failure> {
    let analysis = Analysis::new(DesignOptions::default().load()?)?;
    let rows = analysis.rows(&reach::speeds(analysis.reach, true))?;
    let mut text = output::render_table(&analysis, &rows, None);
    text.push('\n');
    text.push_str(&output::draw_sketch(&analysis, analysis.reach)?);
    let path = picture_directory().map(|directory| directory.join(format!("{DEFAULT_BICYCLE}.svg")));
    let limits = Limits { x: (0.0, analysis.reach), y: None };
    // Nobody asked for the picture, so that what keeps it from being written is no failure.
    match path.filter(|path| draw_eigenvalues(&analysis, limits).and_then(|scene| picture::save(&scene, path)).is_ok())
    {
        Some(path) => {
            let here = std::env::current_dir().unwrap_or_default();
            // Cargo was told the place of the workspace where it was run from elsewhere, and would have to be told again.
            let (path, program) = match path.strip_prefix(here) {
                Ok(path) => (path, "cargo run --release --".to_owned()),
                Err(_) => (&*path, std::env::current_exe().unwrap_or_default().display().to_string()),
            };
            text.push_str(&format!("\nPicture: {}\nMore:    {program} --help\n", path.display()));
        }
        None => text.push_str("\nPicture: carvallo analyze --plot benchmark.svg\nMore:    carvallo --help\n"),
    }
    print(&text)
}

/// Where cargo keeps what it builds, if it is cargo that runs the program from there. Elsewhere nothing is written unasked.
fn picture_directory() -> Option<PathBuf> {
    // Cargo tells a program that it runs the name of its package.
    std::env::var_os("CARGO_PKG_NAME").filter(|name| name == env!("CARGO_PKG_NAME"))?;
    let executable = std::env::current_exe().ok()?;
    let target = executable.parent()?.parent()?;
    let directory = target.join("carvallo");
    (target.join("CACHEDIR.TAG").exists() && std::fs::create_dir_all(&directory).is_ok()).then_some(directory)
}
