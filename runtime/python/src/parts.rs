//! Much work in parts: by several threads, without Python's lock, and until Ctrl-C.

use std::ops::Range;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use pyo3::exceptions::{PyOverflowError, PyValueError};
use pyo3::prelude::*;

use crate::signals::Signals;

static CORES: OnceLock<usize> = OnceLock::new();

/// Less than this is done at once: other threads would begin when it is over.
const AT_ONCE: usize = 256;

/// A number of threads that was asked for.
#[derive(Clone, Copy)]
pub struct Threads(usize);

impl<'a, 'py> FromPyObject<'a, 'py> for Threads {
    type Error = PyErr;

    fn extract(asked: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        match asked.extract::<usize>() {
            Ok(threads) if threads > 0 => Ok(Self(threads)),
            Err(error) if !error.is_instance_of::<PyOverflowError>(asked.py()) => Err(error),
            Ok(_) | Err(_) => Err(PyValueError::new_err(format!("`threads` is {}; it must be >= 1", asked.str()?))),
        }
    }
}

/// How many threads to use: as many as there are cores, unless it is said. To ask for the cores takes longer than the eigenvalues of
/// a design, and is done once.
pub fn threads(asked: Option<Threads>) -> usize {
    match asked {
        Some(Threads(threads)) => threads,
        None => *CORES.get_or_init(|| thread::available_parallelism().map_or(1, |cores| cores.get())),
    }
}

/// Does `work` for the numbers from 0 to `count`, in parts of up to `size`, and gives what it gives for each part, in their
/// order. Whatever the number of threads, the results are the same.
///
/// # Errors
/// The first that the work has, as a ValueError; or what a handler of a signal raises, as KeyboardInterrupt.
pub fn in_parts<T: Send + Sync>(
    py: Python<'_>,
    count: usize,
    size: usize,
    threads: usize,
    work: impl Fn(Range<usize>) -> Result<T, String> + Sync,
) -> PyResult<Vec<T>> {
    let size = size.max(1);
    if count <= size && count <= AT_ONCE {
        return Ok(vec![work(0..count).map_err(PyValueError::new_err)?]);
    }
    let parts = count.div_ceil(size);
    let results: Vec<OnceLock<Result<T, String>>> = (0..parts).map(|_| OnceLock::new()).collect();
    let (next, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
    // Parts are taken in their order: before one that fails all others are done, and the first failure is the same always.
    let do_next = || {
        let part = next.fetch_add(1, Ordering::Relaxed);
        if part >= parts || stop.load(Ordering::Relaxed) {
            return false;
        }
        let result = work(part * size..count.min((part + 1) * size));
        stop.fetch_or(result.is_err(), Ordering::Relaxed);
        results[part].set(result).is_ok()
    };
    py.detach(|| {
        thread::scope(|scope| {
            for _ in 1..threads.min(parts) {
                scope.spawn(|| while do_next() {});
            }
            let signals = Signals::new();
            while do_next() {
                if signals.look().is_break() {
                    stop.store(true, Ordering::Relaxed);
                }
            }
            signals.finish()
        })
    })?;
    results.into_iter().filter_map(OnceLock::into_inner).collect::<Result<_, _>>().map_err(PyValueError::new_err)
}
