//! Why a call has no answer: a code, and a message that stays with the thread.

use std::any::Any;
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

use carvallo_design::in_words;

use crate::types::CarvalloStatus;

/// What the command line calls things, and C.
const WORDS: [(&str, &str); 8] = [
    ("the speeds come from --speeds", "the speeds are arguments of functions"),
    ("--eigenvalues takes speeds", "functions take speeds"),
    ("--gravity", "a file"),
    ("but --model is ", "but `model` is "),
    ("`--model ", "the model `"),
    ("--model ", "`model` "),
    ("--set ", ""),
    ("\n`carvallo bicycles` lists the bicycles", ""),
];

/// What is wrong.
#[derive(Debug)]
pub struct Failure {
    pub status: CarvalloStatus,
    pub message: String,
}

impl Failure {
    pub fn new(status: CarvalloStatus, message: impl ToString) -> Self {
        Self { status, message: in_words(&message.to_string(), &WORDS) }
    }
}

/// What a machine cannot be asked, as where its mass matrix is singular.
impl From<carvallo::SystemError> for Failure {
    fn from(error: carvallo::SystemError) -> Self {
        Self::new(CarvalloStatus::NoAnswer, error)
    }
}

thread_local! {
    static MESSAGE: RefCell<CString> = RefCell::default();
}

/// The message of the last call in this thread that had no answer.
pub fn message() -> *const c_char {
    MESSAGE.with_borrow(|message| message.as_ptr())
}

/// The code of what a function of C does, whose message is kept.
pub fn answer(body: impl FnOnce() -> Result<(), Failure>) -> CarvalloStatus {
    let Failure { status, message } = match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(())) => return CarvalloStatus::Ok,
        Ok(Err(failure)) => failure,
        Err(panic) => {
            Failure::new(CarvalloStatus::Panicked, format!("a mistake in the library: {}", text(panic.as_ref())))
        }
    };
    let message = c_text(&message);
    // In a thread that ends there may be no place for it any more.
    let _ = MESSAGE.try_with(|kept| kept.replace(message));
    status
}

/// What is there whatever happens, such as a number that is zero without an answer.
pub fn value_or<T>(otherwise: T, body: impl FnOnce() -> Result<T, Failure>) -> T {
    let mut found = None;
    answer(|| body().map(|value| found = Some(value)));
    found.unwrap_or(otherwise)
}

/// A text as C has it: what it cannot hold is left out.
pub fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', "")).unwrap_or_else(|_| CStr::to_owned(c""))
}

fn text(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("it panicked")
}
