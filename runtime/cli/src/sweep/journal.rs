//! How far a sweep is, on disk: so that it goes on after it was killed, and does nothing twice.
//!
//! The first line names the sweep. Each further line ends a batch: the designs and the bytes that are done by then, and how
//! many of the designs have an error. A line is written only after the bytes that it tells of are on the disk. The last
//! line says that all batches are there.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;

/// The last line of a journal.
const FINISHED: &str = "finished";

/// How far a sweep is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    pub designs: u64,
    pub bytes: u64,
    pub errors: u64,
}

/// The file; nobody else can open it as a journal at the same time.
pub struct Journal {
    file: File,
    /// The ends of the batches.
    pub batches: Vec<Progress>,
    /// How many of them are on the disk.
    saved: usize,
    /// Whether there will be no more.
    pub finished: bool,
}

/// What keeps a journal from being opened.
pub enum Refusal {
    /// Another process has it.
    Busy,
    /// It is of another sweep.
    Foreign(Progress),
    Io(std::io::Error),
}

impl From<std::io::Error> for Refusal {
    fn from(error: std::io::Error) -> Self {
        Self::Io(error)
    }
}

impl Journal {
    /// The journal of a sweep, empty if there is none yet or if it begins anew. What it tells of more bytes than there are
    /// does not count; without a number all of it does. Bytes are counted when nobody else can write them any more.
    pub fn open(
        path: &Path,
        definition: u64,
        bytes: impl FnOnce() -> Option<u64>,
        restart: bool,
    ) -> Result<Self, Refusal> {
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(Refusal::Busy),
            Err(TryLockError::Error(error)) => return Err(error.into()),
        }
        let bytes = bytes();
        let mut text = String::new();
        if !restart {
            // What is not text was not written here, or not completely.
            let mut content = Vec::new();
            file.read_to_end(&mut content)?;
            text = String::from_utf8_lossy(&content).into_owned();
        }
        let first = format!("carvallo sweep {definition:016x}");
        let mut batches: Vec<Progress> = Vec::new();
        let mut finished = false;
        if let Some((line, rest)) = text.split_once('\n') {
            let mut left = rest;
            for line in rest.split_inclusive('\n') {
                let next = line.strip_suffix('\n').and_then(read);
                let Some(next) = next.filter(|next| bytes.is_none_or(|bytes| next.bytes <= bytes)) else { break };
                left = &left[line.len()..];
                batches.push(next);
            }
            if line != first {
                return Err(Refusal::Foreign(batches.last().copied().unwrap_or_default()));
            }
            finished = left.strip_suffix('\n') == Some(FINISHED);
            if !finished {
                file.set_len((text.len() - left.len()) as u64)?;
            }
        } else {
            file.set_len(0)?;
            file.seek(SeekFrom::Start(0))?;
            file.write_all(format!("{first}\n").as_bytes())?;
            file.sync_all()?;
        }
        file.seek(SeekFrom::End(0))?;
        let saved = batches.len();
        Ok(Self { file, batches, saved, finished })
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
        let line = |Progress { designs, bytes, errors }: &Progress| format!("{designs} {bytes} {errors}\n");
        let text: String = self.batches[self.saved..].iter().map(line).collect();
        self.file.write_all(text.as_bytes())?;
        self.file.sync_data()?;
        self.saved = self.batches.len();
        Ok(())
    }

    /// Writes that all batches are there.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(&mut self) -> std::io::Result<()> {
        if !self.finished {
            self.file.write_all(format!("{FINISHED}\n").as_bytes())?;
            self.file.sync_data()?;
            self.finished = true;
        }
        Ok(())
    }
}

fn read(line: &str) -> Option<Progress> {
    let mut numbers = line.split(' ').map(str::parse);
    let mut next = || numbers.next()?.ok();
    let progress = Progress { designs: next()?, bytes: next()?, errors: next()? };
    numbers.next().is_none().then_some(progress)
}
