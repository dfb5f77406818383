//! The one way into Symbolica: one thread of one process of a user at a time.
//!
//! Without a licence key Symbolica allows a user one thread, and aborts the process in which a second one starts. So
//! every use runs on a thread of its own, whose end gives the permit back, behind a lock that holds across the threads
//! of this process and across processes. Whoever finds it taken waits.

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Mutex, Once, PoisonError};
use std::thread;

use super::engine::Engine;
use super::failure::EngineFailure;
use super::lock::Lock;

/// Formulas nest, and the engine walks them by recursion.
const STACK: usize = 256 << 20;
const THREAD: &str = "carvallo-symbolic";

static TURN: Mutex<()> = Mutex::new(());

/// Runs `work` with the engine, once it is free.
///
/// # Errors
/// If the lock cannot be had, or if the engine panics.
pub fn enter<T: Send + 'static>(work: impl FnOnce(&Engine) -> T + Send + 'static) -> Result<T, EngineFailure> {
    quiet_panics();
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let _lock = Lock::take().map_err(|error| EngineFailure::System(error.to_string()))?;
    let run = move || panic::catch_unwind(AssertUnwindSafe(|| work(&Engine::start())));
    let thread = thread::Builder::new().name(THREAD.into()).stack_size(STACK).spawn(run);
    let thread = thread.map_err(|error| EngineFailure::System(error.to_string()))?;
    // Joining waits for the thread's own storage to be dropped, and with it the permit, before the lock opens.
    match thread.join() {
        Ok(Ok(value)) => Ok(value),
        Ok(Err(payload)) | Err(payload) => Err(EngineFailure::Stopped(message(payload.as_ref()))),
    }
}

fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().copied().or(payload.downcast_ref::<String>().map(String::as_str));
    text.unwrap_or("it stopped without a message").to_string()
}

/// Keeps the panics of the engine's thread off the terminal: they are reported as errors of the model.
fn quiet_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if thread::current().name() != Some(THREAD) {
                previous(info);
            }
        }));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_take_turns() {
        let threads: Vec<_> = (0..4)
            .map(|index| {
                thread::spawn(move || enter(move |engine| engine.parameter(index).derivative(index).is_zero()))
            })
            .collect();
        for thread in threads {
            let entered = thread.join().expect("the door does not panic");
            assert!(!entered.expect("the engine works"), "the derivative of x by x is 1");
        }
    }

    #[test]
    fn a_panic_inside_is_a_failure_outside_and_the_door_opens_again() {
        let failure = enter(|_| panic!("no {}", "way")).expect_err("it panicked");
        assert_eq!(failure.to_string(), "the symbolic engine failed on this model: no way");
        assert!(enter(|engine| engine.parameter(0).is_zero()).is_ok());
    }
}
