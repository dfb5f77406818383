//! Critical speeds and stable ranges.

use std::ptr;

use crate::failure::{answer, value_or};
use crate::machine::Machine;
use crate::pointers::{exclusive, fill, require_count, room, shared};
use crate::types::{CarvalloStatus, CarvalloVerdict, CriticalSpeed, Range, Stability};

/// All critical speeds and stable ranges of a machine, for any number of coordinates. They are not scanned for: see the page on
/// stability of the guide.
///
/// @param[out] stability The answer, which carvallo_stability_free() frees, and which does not change with the machine; NULL without
/// one.
///
/// # Safety
/// It is NULL or a machine; `stability` points to a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_stability_new(
    machine: *const Machine,
    stability: *mut *mut Stability,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what this points to.
        let stability = unsafe { exclusive(stability, "stability") }?;
        *stability = ptr::null_mut();
        // SAFETY: the same.
        let machine = unsafe { shared(machine, "machine") }?;
        *stability = Box::into_raw(Box::new(machine.stability()?));
        Ok(())
    })
}

/// Frees an answer; NULL is none.
///
/// # Safety
/// It is NULL or one that was not freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_stability_free(stability: *mut Stability) {
    if !stability.is_null() {
        // SAFETY: it is from `Box::into_raw`, and the caller promises that it is freed once.
        drop(unsafe { Box::from_raw(stability) });
    }
}

/// All critical speeds above zero, ascending, those of double roots among them. They are valid as long as the answer.
///
/// @param[out] count How many.
/// @return The first of them; NULL if there is none.
///
/// # Safety
/// It is NULL or an answer; `count` points to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_stability_critical_speeds(
    stability: *const Stability,
    count: *mut usize,
) -> *const CriticalSpeed {
    // SAFETY: the caller promises what these point to.
    unsafe { list(stability, count, |stability| &stability.critical_speeds) }
}

/// The ranges of speed in which the motion is stable, ascending. They are valid as long as the answer.
///
/// @param[out] count How many.
/// @return The first of them; NULL if there is none.
///
/// # Safety
/// It is NULL or an answer; `count` points to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_stability_stable_ranges(
    stability: *const Stability,
    count: *mut usize,
) -> *const Range {
    // SAFETY: the caller promises what these point to.
    unsafe { list(stability, count, |stability| &stability.stable_ranges) }
}

/// The ranges of speed in which a critical speed may be missing, ascending: none, but where eigenvalues are so close to the
/// imaginary axis that rounding decides. They are valid as long as the answer.
///
/// @param[out] count How many.
/// @return The first of them; NULL if there is none.
///
/// # Safety
/// It is NULL or an answer; `count` points to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_stability_undecided(stability: *const Stability, count: *mut usize) -> *const Range {
    // SAFETY: the caller promises what these point to.
    unsafe { list(stability, count, |stability| &stability.undecided) }
}

/// # Safety
/// They are NULL, or point to an answer and a number.
unsafe fn list<'a, T: 'a>(
    stability: *const Stability,
    count: *mut usize,
    of: impl FnOnce(&'a Stability) -> &'a Vec<T>,
) -> *const T {
    value_or(ptr::null(), || {
        // SAFETY: the caller promises what this points to.
        let count = unsafe { exclusive(count, "count") }?;
        *count = 0;
        // SAFETY: the same.
        let list = of(unsafe { shared(stability, "stability") }?);
        *count = list.len();
        Ok(if list.is_empty() { ptr::null() } else { list.as_ptr() })
    })
}

/// Whether the motion is stable at a speed: stable in stable ranges, marginal at their ends.
///
/// @param[in] speed The forward speed in m/s, from 0.
/// @param[out] verdict The answer.
///
/// # Safety
/// It is NULL or an answer; `verdict` points to one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_stability_verdict(
    stability: *const Stability,
    speed: f64,
    verdict: *mut CarvalloVerdict,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (stability, verdict) = unsafe { (shared(stability, "stability")?, room(verdict, 1, "verdict")?) };
        fill(verdict, [stability.found.verdict(speed)?.into()]);
        Ok(())
    })
}

/// The derivatives of a critical speed with respect to each parameter, exact: in m/s by the unit of the parameter.
///
/// @param[in] stability The stability of a machine; what was set of the machine since then does not count.
/// @param[in] index Which of its critical speeds, from 0.
/// @param[out] derivatives The derivatives, in the order of the parameters.
/// @param[in] count How many: carvallo_machine_parameters().
/// @return CARVALLO_STATUS_NO_ANSWER if there are none: for a model without derivatives, or where two critical speeds meet.
///
/// # Safety
/// It is NULL or an answer; `derivatives` has room for `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_critical_speed_derivatives(
    stability: *const Stability,
    index: usize,
    derivatives: *mut f64,
    count: usize,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (stability, derivatives) =
            unsafe { (shared(stability, "stability")?, room(derivatives, count, "derivatives")?) };
        require_count("count", count, stability.values.len(), "the parameters of the machine")?;
        fill(derivatives, stability.derivatives(index)?);
        Ok(())
    })
}
