//! Ctrl-C, while Rust computes.

use std::cell::{Cell, RefCell};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use pyo3::prelude::*;

/// Between two looks at whether the user pressed it.
const PATIENCE: Duration = Duration::from_millis(50);

/// Looks now and then whether the user pressed it.
pub struct Signals {
    seen: Cell<Instant>,
    raised: RefCell<Option<PyErr>>,
}

impl Signals {
    pub fn new() -> Self {
        Self { seen: Cell::new(Instant::now()), raised: RefCell::new(None) }
    }

    /// Whether to go on.
    pub fn look(&self) -> ControlFlow<()> {
        if self.seen.get().elapsed() <= PATIENCE {
            return ControlFlow::Continue(());
        }
        self.seen.set(Instant::now());
        match Python::attach(|py| py.check_signals()) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                self.raised.replace(Some(error));
                ControlFlow::Break(())
            }
        }
    }

    /// What Ctrl-C raised, if it was pressed.
    pub fn finish(self) -> PyResult<()> {
        self.raised.into_inner().map_or(Ok(()), Err)
    }
}
