//! The functions that the page calls. Text goes in and out as UTF-8 in the module's memory, numbers go out as doubles.
//!
//! A question is written to the place that [`reserve`] returns and asked by [`ask`]; until the next question its answer stays
//! where [`text`] and [`numbers`] say. The memory may move whenever a function is called: views of it are to be made anew.
#![expect(
    unsafe_code,
    reason = "an exported name could be that of another function; these are the only ones of the module"
)]

use std::cell::RefCell;

use crate::answer::{Answer, answer};

thread_local! {
    static QUESTION: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Answer> = RefCell::new(Answer::default());
}

/// Where the bytes of a question are to be written.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    QUESTION.with_borrow_mut(|question| {
        question.clear();
        question.resize(length, 0);
        question.as_mut_ptr()
    })
}

/// Answers the question that was written.
#[unsafe(no_mangle)]
pub extern "C" fn ask() {
    let question = QUESTION.take();
    ANSWER.set(answer(&question));
}

/// Where the text of the answer is: JSON.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.text.as_ptr())
}

/// How many bytes it has.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    ANSWER.with_borrow(|answer| answer.text.len())
}

/// Where the numbers of the answer are: doubles.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    ANSWER.with_borrow(|answer| answer.numbers.as_ptr())
}

/// How many there are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers_length() -> usize {
    ANSWER.with_borrow(|answer| answer.numbers.len())
}
