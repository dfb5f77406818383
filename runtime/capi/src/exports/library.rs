//! The library itself.

use std::ffi::c_char;
use std::ptr;

use crate::failure::{self, value_or};
use crate::machine::{NAMES, sets};
use crate::pointers::text;

/// The version of the library, such as "0.1.0".
// The name is one that nothing else in a program has: all begin with `carvallo_`. That holds for all of these functions.
#[unsafe(no_mangle)]
pub extern "C" fn carvallo_version() -> *const c_char {
    const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
    VERSION.as_ptr().cast()
}

/// What was wrong in the last call of this thread that had no answer, in English; empty if there was none. It is valid until the
/// next call in this thread.
#[unsafe(no_mangle)]
pub extern "C" fn carvallo_message() -> *const c_char {
    failure::message()
}

/// The name of a model that ships, by its index from 0; NULL beyond the last. It is valid as long as the program runs.
#[unsafe(no_mangle)]
pub extern "C" fn carvallo_model_name(index: usize) -> *const c_char {
    NAMES.get(index).map_or(ptr::null(), |name| name.as_ptr())
}

/// The name of a parameter set that ships for a model, or of a bicycle, by its index from 0; NULL beyond the last, and for a
/// model that there is not. It is valid as long as the program runs.
///
/// # Safety
/// The text ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_parameters_name(model: *const c_char, index: usize) -> *const c_char {
    value_or(ptr::null(), || {
        // SAFETY: the caller promises it.
        let model = unsafe { text(model, "model") }?;
        let sets = sets(model)?;
        Ok(sets.get(index).map_or(ptr::null(), |name| name.as_ptr()))
    })
}
