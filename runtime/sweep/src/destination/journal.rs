//! How far a sweep is, on disk: so that it goes on after it was killed, and does nothing twice.
//!
//! The first line names the sweep. Each further line ends a batch: the designs and the bytes that are done by then, and how
//! many of the designs have an error. A line is written only after the bytes that it tells of are on the disk. The last
//! line says that all batches are there, and tells the file that gets the name of the result. Each of these lines ends in
//! a checksum of itself and of all before it.

use std::fs::{File, Metadata, OpenOptions, TryLockError};
use std::hash::Hasher as _;
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;
use std::time::UNIX_EPOCH;

use twox_hash::XxHash64;

/// The last line of a journal.
const FINISHED: &str = "finished";

/// How far a sweep is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    pub designs: u64,
    pub bytes: u64,
    pub errors: u64,
}

/// What a file keeps when it is given another name: its length in bytes, and when it was last written, in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    length: u64,
    modified: u128,
}

impl Stamp {
    /// # Errors
    /// If it is not known when the file was written.
    pub fn of(metadata: &Metadata) -> std::io::Result<Self> {
        let modified = metadata.modified()?.duration_since(UNIX_EPOCH).map_or(0, |time| time.as_nanos());
        Ok(Self { length: metadata.len(), modified })
    }
}

/// The file; nobody else can open it as a journal at the same time.
pub struct Journal {
    file: File,
    /// The ends of the batches.
    pub batches: Vec<Progress>,
    /// How many of them are on the disk.
    saved: usize,
    /// The checksum of the last line on the disk.
    checksum: u64,
    /// The complete file, if there will be no more batches.
    pub finished: Option<Stamp>,
}

/// What keeps a journal from being opened.
pub enum OpenFailure {
    /// Another process has it.
    Busy,
    /// It is of another sweep, of which so many designs are done.
    Foreign(u64),
    /// The line with a number, from 1 on, is not as it was written.
    Broken(usize),
    Io(std::io::Error),
}

impl From<std::io::Error> for OpenFailure {
    fn from(error: std::io::Error) -> Self {
        Self::Io(error)
    }
}

impl Journal {
    /// The journal of a sweep, empty if there is none yet or if it begins anew. What it tells of more bytes than there are
    /// does not count, nor does a last line that was not written to its end; without a number of bytes nothing is changed.
    /// Bytes are counted when nobody else can write them any more.
    pub fn open(
        path: &Path,
        fingerprint: u64,
        bytes: impl FnOnce() -> Option<u64>,
        restart: bool,
    ) -> Result<Self, OpenFailure> {
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(OpenFailure::Busy),
            Err(TryLockError::Error(error)) => return Err(error.into()),
        }
        let bytes = bytes();
        let mut content = Vec::new();
        if !restart {
            file.read_to_end(&mut content)?;
        }
        let first = format!("carvallo sweep {fingerprint:016x}\n");
        let mut journal = Self { file, batches: Vec::new(), saved: 0, checksum: fingerprint, finished: None };
        let mut lines = content.split_inclusive(|&byte| byte == b'\n').filter(|line| line.ends_with(b"\n"));
        match lines.next() {
            None => {
                journal.file.set_len(0)?;
                journal.file.seek(SeekFrom::Start(0))?;
                journal.file.write_all(first.as_bytes())?;
                journal.file.sync_all()?;
            }
            Some(line) if line != first.as_bytes() => {
                let designs = |line| std::str::from_utf8(line).ok()?.split(' ').next()?.parse().ok();
                return Err(OpenFailure::Foreign(lines.filter_map(designs).next_back().unwrap_or_default()));
            }
            Some(_) => {
                let length = first.len() + journal.replay(lines, bytes)?;
                if bytes.is_some() {
                    journal.file.set_len(length as u64)?;
                }
            }
        }
        journal.file.seek(SeekFrom::End(0))?;
        journal.saved = journal.batches.len();
        Ok(journal)
    }

    /// Takes in the lines below the first one as far as they count; how many bytes they have.
    fn replay<'a>(&mut self, lines: impl Iterator<Item = &'a [u8]>, bytes: Option<u64>) -> Result<usize, OpenFailure> {
        let mut length = 0;
        for (index, line) in lines.enumerate() {
            // What is not text was not written here.
            let text = std::str::from_utf8(line).unwrap_or_default();
            match self.read(text).ok_or(OpenFailure::Broken(index + 2))? {
                (Line::Batch(next), checksum) if bytes.is_none_or(|bytes| next.bytes <= bytes) => {
                    self.batches.push(next);
                    self.checksum = checksum;
                }
                (Line::Finished(stamp), _) if bytes.is_none() => {
                    self.finished = Some(stamp);
                    break;
                }
                _ => break,
            }
            length += line.len();
        }
        Ok(length)
    }

    /// A line after those that were read, with its checksum; `None` if it is not as it was written.
    fn read(&self, line: &str) -> Option<(Line, u64)> {
        let (text, found) = line.strip_suffix('\n')?.rsplit_once(' ')?;
        let checksum = checksum(self.checksum, text);
        if found != format!("{checksum:016x}") {
            return None;
        }
        let mut words = text.split(' ');
        let line = match words.next()? {
            FINISHED => {
                Line::Finished(Stamp { length: words.next()?.parse().ok()?, modified: words.next()?.parse().ok()? })
            }
            designs => {
                let mut next = || words.next()?.parse().ok();
                Line::Batch(Progress { designs: designs.parse().ok()?, bytes: next()?, errors: next()? })
            }
        };
        Some((line, checksum))
    }

    /// How far the sweep is.
    pub fn progress(&self) -> Progress {
        self.batches.last().copied().unwrap_or_default()
    }

    /// The lengths of the batches in bytes.
    pub fn lengths(&self) -> impl Iterator<Item = u64> {
        let before = [0].into_iter().chain(self.batches.iter().map(|batch| batch.bytes));
        self.batches.iter().zip(before).map(|(batch, before)| batch.bytes - before)
    }

    /// Writes what is not on the disk yet; the bytes that it tells of must be.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn save(&mut self) -> std::io::Result<()> {
        let lines: Vec<String> = self.batches[self.saved..].iter().map(Progress::line).collect();
        self.write(&lines)?;
        self.saved = self.batches.len();
        Ok(())
    }

    /// Writes that all batches are there, and in which file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(&mut self, Stamp { length, modified }: Stamp) -> std::io::Result<()> {
        self.write(&[format!("{FINISHED} {length} {modified}")])
    }

    fn write(&mut self, lines: &[String]) -> std::io::Result<()> {
        let mut text = String::new();
        for line in lines {
            self.checksum = checksum(self.checksum, line);
            text.push_str(&format!("{line} {:016x}\n", self.checksum));
        }
        self.file.write_all(text.as_bytes())?;
        self.file.sync_data()
    }
}

/// What a line tells.
enum Line {
    Batch(Progress),
    Finished(Stamp),
}

impl Progress {
    fn line(&self) -> String {
        let Self { designs, bytes, errors } = self;
        format!("{designs} {bytes} {errors}")
    }
}

/// Of a line, and of all before it by the last checksum.
fn checksum(before: u64, line: &str) -> u64 {
    let mut hasher = XxHash64::with_seed(before);
    hasher.write(line.as_bytes());
    hasher.finish()
}
