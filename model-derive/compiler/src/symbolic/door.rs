//! The one way into Symbolica: one thread of one process of a user at a time.
//!
//! Without a licence key Symbolica allows a user one thread, and aborts the process in which a second one starts. So
//! every use runs on a thread of its own, whose end gives the permit back, behind a lock that holds across the threads
//! of this process and across processes. Whoever finds it taken waits.

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Mutex, Once, PoisonError};
use std::thread;

use nanoserde::{DeBin, SerBin};

use super::engine::Engine;
use super::failure::EngineFailure;
use super::kept::{Kept, Question};
use super::lock::Lock;

/// Formulas nest, and the engine walks them by recursion.
const STACK: usize = 256 << 20;
const THREAD: &str = "carvallo-symbolic";

static TURN: Mutex<()> = Mutex::new(());

/// Asks the engine what `work` finds in something, or whoever keeps its answers. `asked` is what other work is not called.
///
/// # Errors
/// Those of the work, of which none is kept; and if the lock cannot be had, or if the engine panics.
pub fn ask<Q, A, E>(asked: &str, of: Q, work: impl FnOnce(&Engine, &Q) -> Result<A, E> + Send + 'static) -> Result<A, E>
where
    Q: SerBin + Send + 'static,
    A: SerBin + DeBin + Send + 'static,
    E: From<EngineFailure> + Send + 'static,
{
    let Some(kept) = Kept::now() else { return enter(move |engine| work(engine, &of))? };
    let question = Question::new(asked, &of);
    if let Some(answer) = kept.find(&question) {
        return Ok(answer);
    }
    enter(move |engine| {
        // Whoever had the engine before may have asked the same: cargo and an editor do.
        kept.find(&question).map_or_else(|| work(engine, &of).inspect(|answer| kept.keep(&question, answer)), Ok)
    })?
}

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
    use std::fs;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::super::kept::with_answers;
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

    /// What comes of a question, and how often the engine was asked for it.
    fn asked(kept: &Kept, question: Vec<usize>, succeeds: bool) -> (Result<Vec<usize>, String>, usize) {
        let count = Arc::new(AtomicUsize::new(0));
        let counted = count.clone();
        let answer = with_answers(Some(kept.clone()), || {
            ask("doubles", question, move |_, numbers: &Vec<usize>| {
                counted.fetch_add(1, Ordering::Relaxed);
                if succeeds { Ok(numbers.iter().map(|number| 2 * number).collect()) } else { Err(Wrong("no".into())) }
            })
        });
        (answer.map_err(|Wrong(why)| why), count.load(Ordering::Relaxed))
    }

    struct Wrong(String);

    impl From<EngineFailure> for Wrong {
        fn from(failure: EngineFailure) -> Self {
            Self(failure.to_string())
        }
    }

    #[test]
    fn a_question_is_asked_once_and_again_where_its_answer_is_damaged_or_failed() {
        let folder = std::env::temp_dir().join(format!("carvallo-asked-{}", std::process::id()));
        let kept = Kept::in_folder(&folder);
        assert_eq!(asked(&kept, vec![1], false), (Err("no".into()), 1));
        assert_eq!(asked(&kept, vec![1], true), (Ok(vec![2]), 1), "failures are not kept");
        assert_eq!(asked(&kept, vec![1], true), (Ok(vec![2]), 0));
        assert_eq!(asked(&kept, vec![1, 3], true), (Ok(vec![2, 6]), 1), "another question");
        for entry in fs::read_dir(&folder).expect("answers are there") {
            let path = entry.expect("an answer").path();
            let mut bytes = fs::read(&path).expect("it can be read");
            let last = bytes.len() - 1;
            bytes[last] ^= 1;
            fs::write(&path, bytes).expect("it can be written");
        }
        assert_eq!(asked(&kept, vec![1], true), (Ok(vec![2]), 1), "the answer is damaged");
        assert_eq!(asked(&kept, vec![1], true), (Ok(vec![2]), 0), "and is mended");
        fs::remove_dir_all(folder).expect("it is there");
    }

    #[test]
    fn without_a_folder_to_write_to_answers_are_given_all_the_same() {
        let file = std::env::temp_dir().join(format!("carvallo-no-folder-{}", std::process::id()));
        fs::write(&file, "").expect("temporary files can be written");
        let kept = Kept::in_folder(file.join("in a file"));
        assert_eq!(asked(&kept, vec![5], true), (Ok(vec![10]), 1));
        assert_eq!(asked(&kept, vec![5], true), (Ok(vec![10]), 1));
        fs::remove_file(file).expect("it is there");
    }
}
