//! The lock that makes Carvallo's processes wait for each other, and what they say where waiting is not enough.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read as _, Seek as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// Held by one process of a user at a time; the end of the process gives it back even if it is killed.
///
/// While it is held the file names its holder. A name that nobody took out is left by a process that ended in between,
/// as Symbolica ends one that it refuses a thread: that one could say nothing more, so the next one does.
#[derive(Debug)]
pub struct Lock(File);

/// Waiting is silent for so long; a bicycle takes a fraction of a second.
const PATIENCE: Duration = Duration::from_secs(10);

const CUT_SHORT: &str = "\
note: the last process in which Carvallo used Symbolica ended before Symbolica was done.
      If Symbolica said that the thread allowance is in use: end the other program of yours that uses Symbolica,
      or get a licence key, https://symbolica.io/license/";

impl Lock {
    /// Waits until the lock is free, and says so if that takes long.
    ///
    /// # Errors
    /// If there is no folder with a file to lock.
    pub fn take() -> io::Result<Self> {
        let (lock, cut_short) = Self::take_in(folders())?;
        if cut_short {
            eprintln!("{CUT_SHORT}");
        }
        Ok(lock)
    }

    /// Takes the lock in the first folder where that can be done; and whether its last holder was cut short.
    fn take_in(folders: impl IntoIterator<Item = PathBuf>) -> io::Result<(Self, bool)> {
        let mut last = io::Error::other("no folder for a lock file");
        for folder in folders {
            match wait(&folder) {
                Ok(mut file) => {
                    let mut holder = String::new();
                    // A file that can only be read locks as well, and names nobody.
                    let _ = file.read_to_string(&mut holder).and_then(|_| name_holder(&mut file));
                    return Ok((Self(file), !holder.is_empty()));
                }
                Err(error) => last = io::Error::new(error.kind(), format!("{}: {error}", folder.display())),
            }
        }
        Err(last)
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = self.0.set_len(0);
    }
}

/// The user's cache folder, and where there is none to write to, one for temporary files: the permit is a user's, so
/// every process of the user must come to the same folder.
fn folders() -> impl Iterator<Item = PathBuf> {
    let user = std::env::var("USER").or_else(|_| std::env::var("USERNAME")).unwrap_or_else(|_| "anyone".into());
    home_folder().into_iter().chain([std::env::temp_dir().join(format!("carvallo-{user}"))])
}

/// The user's cache folder.
pub fn home_folder() -> Option<PathBuf> {
    std::env::home_dir().map(|home| home.join(".cache").join("carvallo"))
}

/// The locked file of a folder.
fn wait(folder: &Path) -> io::Result<File> {
    let path = folder.join("symbolica.lock");
    let file = open(folder, &path)?;
    let (done, waiting) = mpsc::channel::<()>();
    thread::Builder::new().spawn(move || {
        if waiting.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
            let holder = fs::read_to_string(path).ok().filter(|holder| !holder.is_empty());
            let holder = holder.unwrap_or_else(|| "another process".into());
            eprintln!("note: waiting for Symbolica, which Carvallo uses in {holder} now");
        }
    })?;
    uninterrupted(|| file.lock())?;
    drop(done);
    Ok(file)
}

/// Goes on after a signal: giving up for one would mean to enter by another folder, past the holder of this lock.
fn uninterrupted(mut call: impl FnMut() -> io::Result<()>) -> io::Result<()> {
    loop {
        match call() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            result => return result,
        }
    }
}

/// Opens the file; one of another user's, or on a file system that cannot be written to, only to be read.
fn open(folder: &Path, path: &Path) -> io::Result<File> {
    fs::create_dir_all(folder)
        .and_then(|()| OpenOptions::new().create(true).truncate(false).read(true).write(true).open(path))
        .or_else(|error| File::open(path).map_err(|_| error))
}

fn name_holder(file: &mut File) -> io::Result<()> {
    file.set_len(0)?;
    file.rewind()?;
    write!(file, "process {}", std::process::id())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of the test's own.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("carvallo-lock-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("temporary files can be written");
        folder
    }

    #[test]
    fn a_holder_that_was_cut_short_is_noticed_once() {
        let folder = folder("cut");
        let cut_short = || Lock::take_in([folder.clone()]).map(|(lock, cut_short)| (drop(lock), cut_short).1);
        assert!(!cut_short().expect("the first"));
        assert!(!cut_short().expect("after one that ended well"));
        fs::write(folder.join("symbolica.lock"), "process 7").expect("it can be written");
        assert!(cut_short().expect("after one that did not"));
        assert!(!cut_short().expect("after one that noticed"));
        fs::remove_dir_all(folder).expect("it is there");
    }

    #[test]
    fn a_signal_does_not_end_the_wait() {
        let mut results = [Err(io::ErrorKind::Interrupted.into()), Ok(())].into_iter();
        assert!(uninterrupted(|| results.next().expect("no third call")).is_ok());
        assert!(uninterrupted(|| Err(io::ErrorKind::Unsupported.into())).is_err());
    }

    #[test]
    fn what_cannot_be_a_folder_is_passed_over() {
        let folder = folder("over");
        let file = folder.join("file");
        fs::write(&file, "").expect("it can be written");
        let _lock = Lock::take_in([file.clone(), folder.clone()]).expect("the second folder is one");
        assert!(folder.join("symbolica.lock").exists());
        let error = Lock::take_in([file.clone()]).expect_err("it is a file");
        assert!(error.to_string().starts_with(&*file.to_string_lossy()), "{error}");
        fs::remove_dir_all(folder).expect("it is there");
    }
}
