//! Files that results go to. Whether they can be written is tried before the work for them is done.

use std::ffi::OsString;
use std::fs::OpenOptions;
use std::ops::Deref;
use std::path::{Path, PathBuf};

use carvallo_design::Failure;
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

/// Tries whether all files that a command is to write can be written.
///
/// # Errors
/// The first that cannot.
pub fn check(matches: &ArgMatches) -> Result<(), Failure> {
    let Some((_, matches)) = matches.subcommand() else { return Ok(()) };
    for id in matches.ids() {
        // Other options have values of other types.
        let pictures = matches.try_get_many::<Picture>(id.as_str()).ok().flatten();
        let files = matches.try_get_many::<Destination>(id.as_str()).ok().flatten();
        let pictures = pictures.into_iter().flatten().map(Picture::path);
        pictures.chain(files.into_iter().flatten().map(|file| &**file)).try_for_each(check_file)?;
    }
    Ok(())
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
