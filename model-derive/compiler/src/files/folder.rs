//! A folder of generated files: written, or compared with what would be written.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;

use super::modules;
use super::source::{self, Source};

/// What every generated file begins with.
const GENERATED: &str = "// @generated ";

/// The sources of one folder, and the files that they become in another.
pub struct Job<'a> {
    pub models: &'a Path,
    pub shown_models: &'a str,
    pub written: &'a Path,
    pub shown_written: &'a str,
    /// What writes the files.
    pub command: &'a str,
    /// An attribute of every model beside those in its source.
    pub attribute: Option<TokenStream>,
    /// Whether `mod.rs` has a list of the models, and the folder nothing but generated files.
    pub lists_models: bool,
}

impl Job<'_> {
    /// Writes the files or checks them, and returns what was done.
    ///
    /// # Errors
    /// See [`regenerate`](super::regenerate) and [`expand`](super::expand).
    pub fn run(&self, check: bool) -> Result<String, String> {
        let Self { written, shown_written: shown, .. } = *self;
        let wanted = self.wanted()?;
        let mend = format!("run `{}` and commit the result", self.command);
        let mut differences = Vec::new();
        let read = |name: &String| fs::read_to_string(written.join(name)).ok();
        if let Some(name) = wanted.keys().find(|name| read(name).is_some_and(|text| !text.starts_with(GENERATED))) {
            return Err(format!("error: {shown}/{name} was not generated: move it, or write to another folder"));
        }
        for (name, text) in &wanted {
            let path = written.join(name);
            let present = read(name);
            if present.as_ref() == Some(text) {
                continue;
            }
            if check {
                let what = if present.is_some() { "stale" } else { "missing" };
                differences.push(format!("error: {shown}/{name} is {what}: {mend}"));
            } else {
                fs::create_dir_all(written)
                    .and_then(|()| fs::write(&path, text))
                    .map_err(|error| format!("error: {shown}/{name}: {error}"))?;
                differences.push(format!("wrote {shown}/{name}"));
            }
        }
        for path in self.find_left_over(&wanted) {
            let name = file_name(&path);
            if check {
                differences.push(format!("error: {shown}/{name} is left over, without a source: {mend}"));
            } else {
                fs::remove_file(&path).map_err(|error| format!("error: {shown}/{name}: {error}"))?;
                differences.push(format!("removed {shown}/{name}, which has no source"));
            }
        }
        match (check, differences.is_empty()) {
            (true, false) => Err(differences.join("\n")),
            (false, false) => Ok(differences.join("\n")),
            (_, true) => Ok(format!("{} files in {shown}/ are up to date", wanted.len())),
        }
    }

    /// The names and texts of all generated files.
    fn wanted(&self) -> Result<BTreeMap<String, String>, String> {
        let shown = self.shown_models;
        let paths = rust_files(self.models).map_err(|error| format!("error: {shown}: {error}"))?;
        let sources = paths.into_iter().map(|path| Source { shown: format!("{shown}/{}", file_name(&path)), path });
        let generated = source::compile_all(&sources.collect::<Vec<_>>(), self.command, self.attribute.as_ref())?;
        let module = modules::declare(&generated, self.command, self.lists_models);
        let mut files: BTreeMap<String, String> =
            generated.into_iter().map(|generated| (format!("{}.rs", generated.module), generated.text)).collect();
        files.insert("mod.rs".into(), module);
        Ok(files)
    }

    /// Generated files that would not be written any more.
    fn find_left_over(&self, wanted: &BTreeMap<String, String>) -> Vec<PathBuf> {
        let mut paths = rust_files(self.written).unwrap_or_default();
        let generated = |path: &Path| fs::read_to_string(path).is_ok_and(|text| text.starts_with(GENERATED));
        paths.retain(|path| !wanted.contains_key(&file_name(path)) && (self.lists_models || generated(path)));
        paths
    }
}

fn rust_files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
