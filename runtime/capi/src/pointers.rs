//! What C gives, as what Rust takes: the only place where memory of C is looked at.

use std::ffi::{CStr, c_char};
use std::mem::MaybeUninit;
use std::slice;

use crate::failure::Failure;
use crate::types::CarvalloStatus;

/// What a pointer points to.
///
/// # Safety
/// It is NULL, or points to a value that nothing changes during the call.
pub unsafe fn shared<'a, T>(pointer: *const T, name: &str) -> Result<&'a T, Failure> {
    check(pointer, 1, name)?;
    // SAFETY: it is neither NULL nor out of line, and the caller promises the rest.
    Ok(unsafe { &*pointer })
}

/// What a pointer points to, to be changed.
///
/// # Safety
/// It is NULL, or points to a value that nothing else looks at during the call.
pub unsafe fn exclusive<'a, T>(pointer: *mut T, name: &str) -> Result<&'a mut T, Failure> {
    check(pointer, 1, name)?;
    // SAFETY: as for `shared`.
    Ok(unsafe { &mut *pointer })
}

/// An array to read.
///
/// # Safety
/// The pointer is NULL, or points to so many values that nothing changes during the call.
pub unsafe fn array<'a, T>(pointer: *const T, count: usize, name: &str) -> Result<&'a [T], Failure> {
    if count == 0 {
        return Ok(&[]);
    }
    check(pointer, count, name)?;
    // SAFETY: as for `shared`, and there can be so many.
    Ok(unsafe { slice::from_raw_parts(pointer, count) })
}

/// An array to write, whatever is in it.
///
/// # Safety
/// The pointer is NULL, or points to room for so many values that nothing else looks at during the call.
pub unsafe fn room<'a, T>(pointer: *mut T, count: usize, name: &str) -> Result<&'a mut [MaybeUninit<T>], Failure> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(pointer, count, name)?;
    // SAFETY: as for `array`; a `MaybeUninit` may hold anything.
    Ok(unsafe { slice::from_raw_parts_mut(pointer.cast(), count) })
}

/// A text.
///
/// # Safety
/// The pointer is NULL, or points to bytes that end with a zero and that nothing changes during the call.
pub unsafe fn text<'a>(pointer: *const c_char, name: &str) -> Result<&'a str, Failure> {
    check(pointer, 1, name)?;
    // SAFETY: the caller promises the zero.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str().map_err(|_| {
        Failure::new(CarvalloStatus::UnknownName, format!("`{name}` is no text in UTF-8: {}", text.to_string_lossy()))
    })
}

/// A text, or none for NULL.
///
/// # Safety
/// As for [`text`].
pub unsafe fn optional_text<'a>(pointer: *const c_char, name: &str) -> Result<Option<&'a str>, Failure> {
    // SAFETY: the same.
    if pointer.is_null() { Ok(None) } else { unsafe { text(pointer, name) }.map(Some) }
}

/// Writes one element for each place.
pub fn fill<T>(room: &mut [MaybeUninit<T>], values: impl IntoIterator<Item = T>) {
    room.iter_mut().zip(values).for_each(|(place, value)| {
        place.write(value);
    });
}

/// Whether an array has as many elements as it must have.
pub fn require_count(name: &str, found: usize, expected: usize, what: &str) -> Result<(), Failure> {
    if found == expected {
        return Ok(());
    }
    let message = format!("`{name}` is {found}; it must be {expected}, {what}");
    Err(Failure::new(CarvalloStatus::WrongSize, message))
}

fn check<T>(pointer: *const T, count: usize, name: &str) -> Result<(), Failure> {
    if pointer.is_null() {
        return Err(Failure::new(CarvalloStatus::NullPointer, format!("`{name}` is NULL; it must point to something")));
    }
    if !pointer.is_aligned() {
        let message = format!("`{name}` is {pointer:p}; it must be aligned to {} bytes", align_of::<T>());
        return Err(Failure::new(CarvalloStatus::NullPointer, message));
    }
    match count.checked_mul(size_of::<T>()) {
        Some(bytes) if isize::try_from(bytes).is_ok() => Ok(()),
        _ => {
            let message = format!("`{name}` has {count} elements; no array has so many");
            Err(Failure::new(CarvalloStatus::WrongSize, message))
        }
    }
}
