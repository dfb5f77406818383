//! A folder of generated files: written, or compared with what would be written.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// What every generated file begins with, behind the sign of a comment.
const GENERATED: &str = "@generated ";

/// The files of one folder.
pub struct Folder<'a> {
    pub path: &'a Path,
    pub shown: &'a str,
    /// What writes the files.
    pub command: &'a str,
    /// The names and texts of all generated files.
    pub files: BTreeMap<String, String>,
    /// How the names of generated files end.
    pub extensions: &'static [&'static str],
    /// Whether there is nothing but generated files in it.
    pub is_all_generated: bool,
}

impl Folder<'_> {
    /// Writes the files or checks them, and returns what was done.
    ///
    /// # Errors
    /// See [`regenerate`](super::regenerate) and [`expand`](super::expand).
    pub fn run(&self, check: bool) -> Result<String, String> {
        let Self { path: folder, shown, files, .. } = self;
        let mend = format!("run `{}` and commit the result", self.command);
        let mut differences = Vec::new();
        let read = |name: &String| fs::read_to_string(folder.join(name)).ok();
        if let Some(name) = files.keys().find(|name| read(name).is_some_and(|text| !is_generated(&text))) {
            return Err(format!("error: {shown}/{name} was not generated: move it, or write to another folder"));
        }
        for (name, text) in files {
            let path = folder.join(name);
            let present = read(name);
            if present.as_ref() == Some(text) {
                continue;
            }
            if check {
                let what = if present.is_some() { "stale" } else { "missing" };
                differences.push(format!("error: {shown}/{name} is {what}: {mend}"));
            } else {
                fs::create_dir_all(folder)
                    .and_then(|()| fs::write(&path, text))
                    .map_err(|error| format!("error: {shown}/{name}: {error}"))?;
                differences.push(format!("wrote {shown}/{name}"));
            }
        }
        for path in self.find_left_over() {
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
            (_, true) => Ok(format!("{} files in {shown}/ are up to date", files.len())),
        }
    }

    /// Generated files that would not be written any more.
    fn find_left_over(&self) -> Vec<PathBuf> {
        let mut paths = find_files(self.path, self.extensions).unwrap_or_default();
        let generated = |path: &Path| fs::read_to_string(path).is_ok_and(|text| is_generated(&text));
        paths.retain(|path| !self.files.contains_key(&file_name(path)) && (self.is_all_generated || generated(path)));
        paths
    }
}

fn is_generated(text: &str) -> bool {
    ["// ", "/* "].iter().any(|comment| text.strip_prefix(comment).is_some_and(|text| text.starts_with(GENERATED)))
}

/// The files of a folder whose names end so, in their order.
pub fn find_files(folder: &Path, extensions: &[&str]) -> std::io::Result<Vec<PathBuf>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extensions.iter().any(|known| extension == *known)) {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

pub fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}
