//! Eigenvalues and eigenvectors.

use crate::failure::{Failure, answer};
use crate::machine::Machine;
use crate::pointers::{array, fill, require_count, room, shared};
use crate::types::{CarvalloStatus, Complex};

/// The eigenvalues at one speed, in 1/s, sorted by real part, then by imaginary part.
///
/// @param[in] speed The forward speed in m/s; below 0 it runs backwards.
/// @param[out] values The eigenvalues.
/// @param[in] count How many: carvallo_machine_states().
///
/// # Safety
/// It is NULL or a machine; `values` has room for `count` of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_eigenvalues(
    machine: *const Machine,
    speed: f64,
    values: *mut Complex,
    count: usize,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, values) = unsafe { (shared(machine, "machine")?, room(values, count, "values")?) };
        require_count("count", count, machine.model.eigenvalues(), "the eigenvalues of the machine")?;
        fill(values, machine.eigenvalues(speed)?.into_iter().map(Complex::from));
        Ok(())
    })
}

/// The eigenvalues at many speeds, which takes less time than one call for each.
///
/// @param[in] speeds The forward speeds in m/s.
/// @param[in] speed_count How many.
/// @param[out] values The eigenvalues, a row for each speed, sorted as those of carvallo_eigenvalues().
/// @param[in] count How many in all: speed_count * carvallo_machine_states().
/// @return Of the first speed without an answer what is wrong.
///
/// # Safety
/// It is NULL or a machine; `speeds` has `speed_count` numbers; `values` has room for `count` of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_eigenvalues_along(
    machine: *const Machine,
    speeds: *const f64,
    speed_count: usize,
    values: *mut Complex,
    count: usize,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, speeds, values) = unsafe {
            (shared(machine, "machine")?, array(speeds, speed_count, "speeds")?, room(values, count, "values")?)
        };
        let expected = speed_count.saturating_mul(machine.model.eigenvalues());
        require_count("count", count, expected, "the eigenvalues of all speeds")?;
        fill(values, machine.eigenvalues_along(speeds)?.into_iter().map(Complex::from));
        Ok(())
    })
}

/// The eigenvectors of eigenvalues at one speed: of each, a row with a component for each coordinate.
///
/// The largest component of a right one is 1, and the others are relative to it in size and phase. A left one y is scaled by
/// y^H (2 s M + C) x = 1, so that an impulse f excites the mode by y^H f; of multiple eigenvalues its largest component is 1.
///
/// @param[in] speed The forward speed in m/s.
/// @param[in] values Eigenvalues at this speed, all of them, in any order.
/// @param[in] value_count How many: carvallo_machine_states().
/// @param[out] right The right eigenvectors; NULL if they are not wanted.
/// @param[out] left The left eigenvectors; NULL if they are not wanted.
/// @param[in] count How many components in each of them: value_count * carvallo_machine_coordinates().
///
/// # Safety
/// It is NULL or a machine; `values` has `value_count` numbers; `right` and `left` are NULL or have room for `count` of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_eigenvectors(
    machine: *const Machine,
    speed: f64,
    values: *const Complex,
    value_count: usize,
    right: *mut Complex,
    left: *mut Complex,
    count: usize,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, values) = unsafe { (shared(machine, "machine")?, array(values, value_count, "values")?) };
        let states = machine.model.eigenvalues();
        require_count("value_count", value_count, states, "the eigenvalues of the machine")?;
        require_count("count", count, states * machine.model.info.coordinates.len(), "the components of all vectors")?;
        let values: Vec<carvallo::Complex<f64>> = values.iter().map(|value| (*value).into()).collect();
        if let Some(wrong) = values.iter().find(|value| !(value.re.is_finite() && value.im.is_finite())) {
            let message = format!("an eigenvalue is {} + {}i; it must be finite", wrong.re, wrong.im);
            return Err(Failure::new(CarvalloStatus::Invalid, message));
        }
        let shapes = machine.eigenvectors(speed, &values)?;
        if !right.is_null() {
            // SAFETY: the same.
            let right = unsafe { room(right, count, "right") }?;
            fill(right, shapes.iter().flat_map(|shape| shape.right.iter().copied().map(Complex::from)));
        }
        if !left.is_null() {
            // SAFETY: the same.
            let left = unsafe { room(left, count, "left") }?;
            fill(left, shapes.iter().flat_map(|shape| shape.left.iter().copied().map(Complex::from)));
        }
        Ok(())
    })
}
