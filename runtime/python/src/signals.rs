//! Ctrl-C, and what functions of the user's raise, while Rust computes.

use std::cell::{Cell, RefCell};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use carvallo_design::Failure;
use pyo3::prelude::*;

use crate::loaded::raise;

/// Between two looks at whether the user pressed Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(50);

/// Looks now and then whether the user pressed Ctrl-C.
pub struct Signals {
    seen: Cell<Instant>,
    raised: RefCell<Option<PyErr>>,
}

impl Signals {
    pub fn new() -> Self {
        Self { seen: Cell::new(Instant::now()), raised: RefCell::new(None) }
    }

    /// Ends the computation for what a function of the user's raised; the first of them counts.
    pub fn raise(&self, error: PyErr) {
        self.raised.borrow_mut().get_or_insert(error);
    }

    /// Whether something was raised.
    pub fn is_raised(&self) -> bool {
        self.raised.borrow().is_some()
    }

    /// Whether to go on.
    pub fn look(&self) -> ControlFlow<()> {
        if self.is_raised() {
            return ControlFlow::Break(());
        }
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

    /// What was raised, as KeyboardInterrupt by Ctrl-C.
    pub fn finish(self) -> PyResult<()> {
        self.raised.into_inner().map_or(Ok(()), Err)
    }
}

/// What is computed while others run, and until Ctrl-C ends it.
pub fn listening<T: Send>(py: Python<'_>, compute: impl FnOnce(&Signals) -> Result<T, Failure> + Send) -> PyResult<T> {
    py.detach(|| {
        let signals = Signals::new();
        let computed = compute(&signals);
        signals.finish()?;
        computed.map_err(raise)
    })
}
