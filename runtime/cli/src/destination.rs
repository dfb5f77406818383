//! Files that results go to. Whether they can be written is tried before the work for them is done.

use std::ffi::OsString;
use std::fs::OpenOptions;
use std::ops::Deref;
use std::path::{Path, PathBuf};

use carvallo_design::Failure;
use carvallo_design::input::is_same_file;
use clap::ArgMatches;

use crate::options::Picture;

/// A file that a command writes at its end.
#[derive(Clone, Debug)]
pub struct Destination(pub PathBuf);

impl From<OsString> for Destination {
    fn from(path: OsString) -> Self {
        Self(path.into())
    }
}

impl Deref for Destination {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.0
    }
}

/// Tries whether all files that a command is to write can be written, each once.
///
/// # Errors
/// The first that cannot; or that two results go to one file.
pub fn check(matches: &ArgMatches) -> Result<(), Failure> {
    let Some((_, matches)) = matches.subcommand() else { return Ok(()) };
    let mut paths: Vec<&Path> = Vec::new();
    for id in matches.ids() {
        // Other options have values of other types.
        let pictures = matches.try_get_many::<Picture>(id.as_str()).ok().flatten();
        let files = matches.try_get_many::<Destination>(id.as_str()).ok().flatten();
        paths.extend(pictures.into_iter().flatten().map(Picture::path));
        paths.extend(files.into_iter().flatten().map(|file| &**file));
    }
    for (at, path) in paths.iter().enumerate() {
        let is_kept = !path.exists() || path.is_file();
        if is_kept && paths[..at].iter().any(|other| place(other) == place(path) || is_same_file(other, path)) {
            return Err(Failure::usage(format!("two results go to {}: give each a file of its own", path.display())));
        }
    }
    paths.into_iter().try_for_each(check_file)
}

/// Where a file is or will be, however the way there is written.
fn place(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match (folder.canonicalize(), path.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => path.to_owned(),
    }
}

/// Nothing is left of a file that was not there.
fn check_file(path: &Path) -> Result<(), Failure> {
    let fail = |error| Failure::Run(format!("cannot write {}: {error}", path.display()));
    let kind = std::fs::metadata(path);
    // Opening a pipe would wait for its reader.
    if kind.as_ref().is_ok_and(|kind| !kind.is_file() && !kind.is_dir()) {
        return Ok(());
    }
    OpenOptions::new().write(true).create(true).truncate(false).open(path).map_err(fail)?;
    if kind.is_ok() { Ok(()) } else { std::fs::remove_file(path).map_err(fail) }
}
