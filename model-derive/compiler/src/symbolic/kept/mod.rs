//! Answers of the engine that are kept for the next time.
//!
//! What the engine is asked are formulas, without the places where they stand, and the same question always has the same
//! answer. So it is answers that are kept, and not generated code: everything that has a place in the user's source is
//! made anew each time, and a declaration that is changed asks only what is new in it. Failures are not kept.

mod compiler;
mod entry;
mod folder;
mod limit;

use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use nanoserde::{DeBin, SerBin};

use self::entry::{decode, encode, name};

/// A folder with answers, one file for each. Any number of processes can use it at once.
#[derive(Clone, Debug)]
pub struct Kept {
    folder: PathBuf,
}

/// A file that is read is marked as used, but not more often than this.
const USED: Duration = Duration::from_secs(24 * 60 * 60);

thread_local! {
    static NOW: RefCell<Option<Kept>> = const { RefCell::new(None) };
}

impl Kept {
    /// Keeps answers in a folder, which is made when there is one to keep.
    pub fn in_folder(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Keeps answers in the target folder of the build that this process is a part of; where none is found, in the
    /// folder that has the lock. Nowhere if the environment says `CARVALLO_CACHE=off`.
    pub fn of_this_build() -> Option<Self> {
        folder::find().map(Self::in_folder)
    }

    /// What this thread uses now.
    pub(super) fn now() -> Option<Self> {
        NOW.with_borrow(Clone::clone)
    }

    /// The answer to a question, if it is kept and sound.
    pub(super) fn find<A: DeBin>(&self, question: &Question) -> Option<A> {
        let path = self.path(question);
        let answer = decode(&fs::read(&path).ok()?, &question.0)?;
        mark_used(&path);
        Some(answer)
    }

    /// Keeps an answer. That it could not be kept, as on a disk that is full, is no mistake: it will be found again.
    pub(super) fn keep(&self, question: &Question, answer: &impl SerBin) {
        let entry = encode(&question.0, answer);
        let _ = fs::create_dir_all(&self.folder).and_then(|()| entry::write(&self.path(question), &entry));
        limit::apply(&self.folder);
    }

    fn path(&self, question: &Question) -> PathBuf {
        self.folder.join(name(&question.0))
    }
}

/// Does `work` with the answers of `kept`, or with none.
pub fn with_answers<T>(kept: Option<Kept>, work: impl FnOnce() -> T) -> T {
    /// Puts back what was there before, also if the work panics.
    struct Before(Option<Kept>);
    impl Drop for Before {
        fn drop(&mut self) {
            NOW.set(self.0.take());
        }
    }
    let _before = Before(NOW.replace(kept));
    work()
}

/// All that an answer depends on: the compiler, what is asked, and of what.
pub(super) struct Question(Vec<u8>);

impl Question {
    pub(super) fn new(asked: &str, of: &impl SerBin) -> Self {
        let mut bytes = Vec::new();
        compiler::identity().ser_bin(&mut bytes);
        asked.len().ser_bin(&mut bytes);
        bytes.extend(asked.as_bytes());
        of.ser_bin(&mut bytes);
        Self(bytes)
    }
}

/// Puts off the day when a file is the one that was not used for longest.
fn mark_used(path: &Path) {
    let now = SystemTime::now();
    let modified = fs::metadata(path).and_then(|metadata| metadata.modified());
    if modified.is_ok_and(|then| now.duration_since(then).is_ok_and(|age| age > USED))
        && let Ok(file) = fs::OpenOptions::new().append(true).open(path)
    {
        let _ = file.set_modified(now);
    }
}
