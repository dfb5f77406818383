//! Machines and their parameters.

use std::ffi::c_char;
use std::ptr;

use carvallo::{MatrixName, States};

use crate::failure::{Failure, answer, value_or};
use crate::machine::Machine;
use crate::pointers::{array, exclusive, fill, optional_text, require_count, room, shared, text};
use crate::types::{CarvalloStates, CarvalloStatus, Matrices};

/// The most coordinates of given matrices.
const MOST: usize = carvallo_design::matrices::MOST;

/// A machine that ships, or from a file.
///
/// @param[in] model The name of a model, such as "Whipple" or "Motorcycle"; NULL for that which the file names, or else
/// "Whipple".
/// @param[in] parameters The name of what ships for the model, such as "benchmark" or "pista", or the path of a file in any of the
/// forms that the command line reads; NULL for the first that ships.
/// @param[out] machine The machine, which carvallo_machine_free() frees; NULL without an answer.
///
/// # Safety
/// Texts end with a zero; `machine` points to a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_new(
    model: *const c_char,
    parameters: *const c_char,
    machine: *mut *mut Machine,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let machine = unsafe { exclusive(machine, "machine") }?;
        *machine = ptr::null_mut();
        // SAFETY: the same.
        let (model, parameters) = unsafe { (optional_text(model, "model")?, optional_text(parameters, "parameters")?) };
        *machine = Box::into_raw(Box::new(Machine::load(model, parameters)?));
        Ok(())
    })
}

/// A machine of given matrices, which are copied. Its parameters are their entries, such as "M_12" (with more than nine
/// coordinates "M_1_12"), and "g".
///
/// @param[in] matrices The matrices.
/// @param[out] machine The machine, which carvallo_machine_free() frees; NULL without an answer.
///
/// # Safety
/// Each matrix points to n * n numbers, and the states to n; `machine` points to a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_of_matrices(
    matrices: *const Matrices,
    machine: *mut *mut Machine,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, given) = unsafe { (exclusive(machine, "machine")?, shared(matrices, "matrices")?) };
        *machine = ptr::null_mut();
        let Matrices { n, m, cm1, c0, c1, kc, k0, k1, k2, gravity, states } = *given;
        if !(1..=MOST).contains(&n) {
            let message = format!("`matrices->n` is {n}; it must be from 1 to {MOST}");
            return Err(Failure::new(CarvalloStatus::WrongSize, message));
        }
        let mut all = Vec::new();
        for (name, entries) in MatrixName::ALL.into_iter().zip([m, cm1, c0, c1, kc, k0, k1, k2]) {
            if !entries.is_null() || name == MatrixName::M {
                let label = format!("matrices->{}", format!("{name:?}").to_lowercase());
                // SAFETY: the caller promises as many numbers.
                all.push((name, unsafe { array(entries, n * n, &label) }?));
            }
        }
        let states = if states.is_null() {
            vec![States::Both; n]
        } else {
            // SAFETY: the caller promises as many codes.
            let codes = unsafe { array(states, n, "matrices->states") }?;
            codes.iter().map(|code| states_of(*code)).collect::<Result<_, _>>()?
        };
        *machine = Box::into_raw(Box::new(Machine::of_matrices(&all, states, gravity)?));
        Ok(())
    })
}

fn states_of(code: i32) -> Result<States, Failure> {
    CarvalloStates::of(code).ok_or_else(|| {
        let message =
            format!("an element of `matrices->states` is {code}; it must be one of carvallo_states_t, 0 to 2");
        Failure::new(CarvalloStatus::Invalid, message)
    })
}

/// Frees a machine; NULL is none.
///
/// # Safety
/// It is NULL or a machine that was not freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_free(machine: *mut Machine) {
    if !machine.is_null() {
        // SAFETY: it is from `Box::into_raw`, and the caller promises that it is freed once.
        drop(unsafe { Box::from_raw(machine) });
    }
}

/// The number n of coordinates, and of rows and columns of each matrix; 0 for NULL.
///
/// # Safety
/// It is NULL or a machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_coordinates(machine: *const Machine) -> usize {
    // SAFETY: the caller promises it.
    value_or(0, || Ok(unsafe { shared(machine, "machine") }?.model.info.coordinates.len()))
}

/// The name of a coordinate, such as "phi", by its index from 0; NULL beyond the last. It is valid as long as the machine.
///
/// # Safety
/// It is NULL or a machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_coordinate_name(machine: *const Machine, index: usize) -> *const c_char {
    // SAFETY: the caller promises it.
    value_or(ptr::null(), || Ok(unsafe { shared(machine, "machine") }?.coordinate(index)?.as_ptr()))
}

/// The number of states, and of eigenvalues; 0 for NULL.
///
/// # Safety
/// It is NULL or a machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_states(machine: *const Machine) -> usize {
    // SAFETY: the caller promises it.
    value_or(0, || Ok(unsafe { shared(machine, "machine") }?.model.eigenvalues()))
}

/// The number of parameters; 0 for NULL.
///
/// # Safety
/// It is NULL or a machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_parameters(machine: *const Machine) -> usize {
    // SAFETY: the caller promises it.
    value_or(0, || Ok(unsafe { shared(machine, "machine") }?.values.len()))
}

/// The name of a parameter, by its index from 0; NULL beyond the last. It is valid as long as the machine.
///
/// # Safety
/// It is NULL or a machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_parameter_name(machine: *const Machine, index: usize) -> *const c_char {
    // SAFETY: the caller promises it.
    value_or(ptr::null(), || Ok(unsafe { shared(machine, "machine") }?.parameter(index)?[0].as_ptr()))
}

/// The unit of a parameter, such as "kg*m^2", or "1" for pure numbers; NULL beyond the last. It is valid as long as the machine.
///
/// # Safety
/// It is NULL or a machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_parameter_unit(machine: *const Machine, index: usize) -> *const c_char {
    // SAFETY: the caller promises it.
    value_or(ptr::null(), || Ok(unsafe { shared(machine, "machine") }?.parameter(index)?[1].as_ptr()))
}

/// The value of a parameter.
///
/// @param[in] name Its name.
/// @param[out] value Its value, in its unit.
///
/// # Safety
/// It is NULL or a machine; the text ends with a zero; `value` points to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_get(
    machine: *const Machine,
    name: *const c_char,
    value: *mut f64,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, name, value) =
            unsafe { (shared(machine, "machine")?, text(name, "name")?, room(value, 1, "value")?) };
        fill(value, [machine.values[machine.position(name)?]]);
        Ok(())
    })
}

/// Sets a parameter. It is judged with all others by the next function that computes something, so that several can be set one
/// after the other.
///
/// @param[in] name Its name.
/// @param[in] value Its value, in its unit.
///
/// # Safety
/// It is NULL or a machine that nothing else looks at; the text ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_set(
    machine: *mut Machine,
    name: *const c_char,
    value: f64,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, name) = unsafe { (exclusive(machine, "machine")?, text(name, "name")?) };
        let position = machine.position(name)?;
        machine.values[position] = value;
        Ok(())
    })
}

/// One of the matrices.
///
/// @param[in] name "M", "C-1", "C0", "C1", "Kc", "K0", "K1" or "K2".
/// @param[out] entries Its entries, row by row; zero for a matrix that the machine has not.
/// @param[in] count How many: n * n.
///
/// # Safety
/// It is NULL or a machine; the text ends with a zero; `entries` has room for `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_machine_matrix(
    machine: *const Machine,
    name: *const c_char,
    entries: *mut f64,
    count: usize,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (machine, name, entries) =
            unsafe { (shared(machine, "machine")?, text(name, "name")?, room(entries, count, "entries")?) };
        let size = machine.model.info.coordinates.len();
        require_count("count", count, size * size, "the entries of the matrix")?;
        fill(entries, machine.matrix(name)?);
        Ok(())
    })
}

/// The matrices A and B of the state-space form x' = A x + B f at one speed. The states x are the positions, then the rates, of
/// those coordinates that have them; the inputs f are the forces of all coordinates. With p states and n coordinates:
///
/// @param[in] speed The forward speed in m/s.
/// @param[out] a The entries of A, p rows of p; NULL if they are not wanted.
/// @param[in] a_count How many: p * p.
/// @param[out] b The entries of B, p rows of n; NULL if they are not wanted.
/// @param[in] b_count How many: p * n.
///
/// # Safety
/// It is NULL or a machine; `a` and `b` are NULL or have room for so many numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_state_space(
    machine: *const Machine,
    speed: f64,
    a: *mut f64,
    a_count: usize,
    b: *mut f64,
    b_count: usize,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what this points to.
        let machine = unsafe { shared(machine, "machine") }?;
        let states = machine.model.eigenvalues();
        let inputs = machine.model.info.coordinates.len();
        let mut wanted = Vec::new();
        for (pointer, count, expected, names, what) in [
            (a, a_count, states * states, ["a", "a_count"], "the entries of A"),
            (b, b_count, states * inputs, ["b", "b_count"], "the entries of B"),
        ] {
            if pointer.is_null() {
                wanted.push(None);
                continue;
            }
            require_count(names[1], count, expected, what)?;
            // SAFETY: the same.
            wanted.push(Some(unsafe { room(pointer, count, names[0]) }?));
        }
        for (place, entries) in wanted.into_iter().zip(machine.state_space(speed)?) {
            if let Some(place) = place {
                fill(place, entries);
            }
        }
        Ok(())
    })
}
