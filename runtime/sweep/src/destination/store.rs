//! A file of results that goes on growing after a kill, and is complete when it appears.

use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use carvallo_design::{Failure, Place};

use super::journal::{Journal, OpenFailure, Progress, Stamp};
use crate::plan::{ERROR, Plan};
use crate::read::names;
use crate::table::{Format, Heading, parquet_message};
use crate::write::parquet;

/// How much work a kill may cost; more often would wait for the disk.
const SAVED_EVERY: Duration = Duration::from_millis(200);

/// The file while it is not complete: its contents are in FILE.partial, and FILE.journal tells how far they are.
pub struct Store {
    path: PathBuf,
    partial: File,
    journal: Journal,
    saved: Instant,
}

impl Store {
    /// Begins a file, or goes on with it; `None` if it is complete, and was only not told so any more.
    ///
    /// # Errors
    /// If there is a finished file, another sweep's, or one that another process writes; or if it cannot be written.
    pub fn open(path: &Path, plan: &Plan, restart: bool) -> Result<Option<Self>, Failure> {
        let (partial_path, journal_path) = (beside(path, "partial"), beside(path, "journal"));
        if path.is_dir() {
            return Err(refused(path, "it is a directory"));
        }
        if path.exists() && !journal_path.exists() && !restart {
            let replaces = if is_of_sweep(path, plan.format) { "; --restart replaces it" } else { "" };
            return Err(refused(path, &format!("the file exists already{replaces}")));
        }
        if restart && path.exists() && !is_of_sweep(path, plan.format) {
            return Err(refused(path, "the file is no result of a sweep, and is not replaced"));
        }
        let fail = |error| io(path, error);
        let mut renamed = false;
        let length = || {
            let length = std::fs::metadata(&partial_path).ok().map(|metadata| metadata.len());
            renamed = length.is_none() && path.exists() && !restart;
            if renamed { None } else { Some(length.unwrap_or_default()) }
        };
        let journal =
            Journal::open(&journal_path, plan.fingerprint, length, restart).map_err(|refusal| match refusal {
                OpenFailure::Busy => Failure::Run(format!("another sweep is writing {}", path.display())),
                OpenFailure::Foreign(designs) => {
                    let journal = journal_path.display();
                    let done = format!("{journal} is of another sweep, of which {designs} designs are done");
                    refused(path, &format!("{done}; --restart drops it"))
                }
                OpenFailure::Broken(line) => {
                    let journal = journal_path.display();
                    refused(path, &format!("{journal}:{line} is not as it was written; --restart begins anew"))
                }
                OpenFailure::Io(error) => io(&journal_path, error),
            })?;
        if renamed {
            // Killed between the last name and the end of the journal; or what was computed is gone.
            let stamp = std::fs::metadata(path).and_then(|metadata| Stamp::of(&metadata)).map_err(fail)?;
            if journal.finished != Some(stamp) {
                let [partial, journal] = [&partial_path, &journal_path].map(|path| path.display());
                let message =
                    format!("{journal} tells of another file, and {partial} is missing; --restart begins anew");
                return Err(refused(path, &message));
            }
            std::fs::remove_file(&journal_path).map_err(fail)?;
            return Ok(None);
        }
        let mut partial =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&partial_path).map_err(fail)?;
        partial.set_len(journal.progress().bytes).map_err(fail)?;
        partial.seek(SeekFrom::End(0)).map_err(fail)?;
        sync_directory(path).map_err(fail)?;
        Ok(Some(Self { path: path.to_owned(), partial, journal, saved: Instant::now() }))
    }

    /// How far it is.
    pub fn progress(&self) -> Progress {
        self.journal.progress()
    }

    /// Adds a batch.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn add(&mut self, bytes: &[Vec<u8>], designs: usize, errors: usize) -> Result<(), Failure> {
        let write = bytes.iter().try_for_each(|bytes| self.partial.write_all(bytes));
        write.map_err(|error| io(&self.path, error))?;
        let length: usize = bytes.iter().map(Vec::len).sum();
        let Progress { designs: d, bytes: b, errors: e } = self.progress();
        let progress = Progress { designs: d + designs as u64, bytes: b + length as u64, errors: e + errors as u64 };
        self.journal.batches.push(progress);
        if self.saved.elapsed() >= SAVED_EVERY { self.save() } else { Ok(()) }
    }

    fn save(&mut self) -> Result<(), Failure> {
        self.partial.sync_data().and_then(|()| self.journal.save()).map_err(|error| io(&self.path, error))?;
        self.saved = Instant::now();
        Ok(())
    }

    /// Completes the file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(mut self, format: Format, headings: &[Heading]) -> Result<(), Failure> {
        self.save()?;
        let path = &self.path;
        let fail = |error| io(path, error);
        if format == Format::Parquet {
            let message = |error| format!("cannot write {}: {}", path.display(), parquet_message(error));
            let footer = parquet::footer(headings, &mut self.partial, self.journal.lengths());
            let footer = footer.map_err(|error| Failure::Run(message(error)))?;
            self.partial.seek(SeekFrom::End(0)).map_err(fail)?;
            self.partial.write_all(&footer).and_then(|()| self.partial.sync_data()).map_err(fail)?;
        }
        let stamp = self.partial.metadata().and_then(|metadata| Stamp::of(&metadata)).map_err(fail)?;
        self.journal.finish(stamp).map_err(fail)?;
        std::fs::rename(beside(path, "partial"), path).map_err(fail)?;
        sync_directory(path).map_err(fail)?;
        std::fs::remove_file(beside(path, "journal")).map_err(fail)
    }
}

/// Whether a file that is there is what sweeps write, which ends in a column of errors, or has nothing that could be lost.
fn is_of_sweep(path: &Path, format: Format) -> bool {
    let ends_so = |names: Vec<String>| names.len() > 1 && names.last().is_some_and(|name| name == ERROR);
    std::fs::metadata(path)
        .is_ok_and(|metadata| metadata.is_file() && (metadata.len() == 0 || names(path, format).is_ok_and(ends_so)))
}

/// The path with something added to its name.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    name.into()
}

/// Makes sure that names are on the disk, where a directory can be opened for that.
fn sync_directory(path: &Path) -> std::io::Result<()> {
    let directory = path.parent().filter(|directory| !directory.as_os_str().is_empty());
    match File::open(directory.unwrap_or(Path::new("."))) {
        Ok(directory) if cfg!(unix) => directory.sync_all(),
        Err(error) if cfg!(unix) && error.kind() != ErrorKind::PermissionDenied => Err(error),
        _ => Ok(()),
    }
}

fn io(path: &Path, error: std::io::Error) -> Failure {
    Failure::Run(format!("cannot write {}: {error}", path.display()))
}

fn refused(path: &Path, message: &str) -> Failure {
    Failure::at(Place::Option(format!("--output {}", path.display())), message)
}
