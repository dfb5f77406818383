//! Files that results go to. Whether they can be written is tried before the work for them is done.

use std::ffi::OsString;
use std::fs::OpenOptions;
use std::ops::Deref;
use std::path::{Path, PathBuf};

use carvallo_design::input::{Request, is_same_file, load};
use carvallo_design::{Failure, Place};
use clap::ArgMatches;

use crate::options::Picture;

/// What texts of results have of which commands write files: the title of a table in any language, or a member of JSON.
const MARKS: [&str; 8] = [
    "Motion by the ",
    "Steady turns ",
    "State space x' =",
    "Gains K of ",
    "\n  \"equations\": ",
    "\n  \"families\": ",
    "\n  \"A\": ",
    "\n  \"regulators\": ",
];
/// The same of the headers of CSV.
const HEADERS: [&str; 4] = ["_acceleration (", "capsize_speed (", "of,", "),eigenvalue 1 re (1/s),"];

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

impl Destination {
    /// Where it was asked for.
    pub fn place(&self) -> Place {
        Place::Option(format!("--output {}", self.0.display()))
    }

    /// That parameters take the place of parameters, if of anything: a program by hand is no result.
    ///
    /// # Errors
    /// If something else is there.
    pub fn replaces_parameters(&self) -> Result<(), Failure> {
        let request = Request { parameters: Some(self.0.display().to_string()), ..Request::default() };
        self.replaces("no file of parameters", |_| load(&request).is_ok())
    }

    /// That source text takes the place of source text that this program wrote, if of anything.
    ///
    /// # Errors
    /// If something else is there.
    pub fn replaces_source(&self) -> Result<(), Failure> {
        self.replaces("nothing that this program wrote", |text| text.contains("Written by Carvallo;"))
    }

    /// That a result takes the place of a result, if of a text.
    ///
    /// # Errors
    /// If something else is there.
    pub fn replaces_result(&self) -> Result<(), Failure> {
        self.replaces("no result of this program", |text| {
            let header = text.lines().next().unwrap_or_default();
            let is_table = MARKS.iter().any(|mark| text.contains(mark));
            is_table || HEADERS.iter().any(|mark| header.contains(mark)) || text.contains('\0')
        })
    }

    fn replaces(&self, what: &str, is_own: impl Fn(&str) -> bool) -> Result<(), Failure> {
        // What is no file, as a pipe, or cannot be read is told where it is written.
        let Some(bytes) = self.0.is_file().then(|| std::fs::read(&self.0).ok()).flatten() else { return Ok(()) };
        let text = String::from_utf8_lossy(&bytes);
        if text.trim().is_empty() || is_own(&text) {
            return Ok(());
        }
        let message = format!("this file is there, and is {what}: give another name, or remove it");
        Err(Failure::at(self.place(), message))
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
