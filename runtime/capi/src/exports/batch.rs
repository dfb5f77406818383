//! Many designs, by columns.

use crate::batch::Designs;
use crate::failure::{Failure, answer};
use crate::machine::Machine;
use crate::pointers::{array, require_count, room, shared, text};
use crate::types::{CarvalloStatus, Column, Complex, CriticalSpeed, Summary};

/// The eigenvalues of many designs at one speed.
///
/// @param[in] machine What the designs have for the parameters without a column.
/// @param[in] columns The parameters that differ.
/// @param[in] column_count How many.
/// @param[in] designs How many designs there are: the length of each column.
/// @param[in] speed The forward speed in m/s.
/// @param[in] threads How many threads compute; 0 for as many as there are cores. The answers are the same with any number.
/// @param[out] values The eigenvalues, a row for each design; zero where it has no answer.
/// @param[in] count How many in all: designs * carvallo_machine_states().
/// @param[out] statuses For each design whether it has an answer.
///
/// # Safety
/// It is NULL or a machine; each column has a name and `designs` numbers; `values` has room for `count` of them, and `statuses` for
/// `designs`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_batch_eigenvalues(
    machine: *const Machine,
    columns: *const Column,
    column_count: usize,
    designs: usize,
    speed: f64,
    threads: usize,
    values: *mut Complex,
    count: usize,
    statuses: *mut CarvalloStatus,
) -> CarvalloStatus {
    answer(|| {
        // SAFETY: the caller promises what these pointers point to.
        let (batch, values, statuses) = unsafe {
            let batch = read(machine, columns, column_count, designs, threads)?;
            (batch, room(values, count, "values")?, room(statuses, designs, "statuses")?)
        };
        let expected = designs.saturating_mul(batch.machine.model.eigenvalues());
        require_count("count", count, expected, "the eigenvalues of all designs")?;
        batch.eigenvalues(speed, values, statuses);
        Ok(())
    })
}

/// The stability of many designs.
///
/// @param[in] machine What the designs have for the parameters without a column.
/// @param[in] columns The parameters that differ.
/// @param[in] column_count How many.
/// @param[in] designs How many designs there are: the length of each column.
/// @param[in] threads How many threads compute; 0 for as many as there are cores. The answers are the same with any number.
/// @param[out] summaries For each design how many critical speeds and stable ranges it has, and the first of these.
/// @param[out] critical_speeds The first critical speeds, a row for each design; all zero beyond those that there are. NULL if they
/// are not wanted.
/// @param[in] most How many there are in a row.
///
/// # Safety
/// It is NULL or a machine; each column has a name and `designs` numbers; `summaries` has room for `designs` of them, and
/// `critical_speeds` is NULL or has it for designs * most.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carvallo_batch_stability(
    machine: *const Machine,
    columns: *const Column,
    column_count: usize,
    designs: usize,
    threads: usize,
    summaries: *mut Summary,
    critical_speeds: *mut CriticalSpeed,
    most: usize,
) -> CarvalloStatus {
    answer(|| {
        let most = if critical_speeds.is_null() { 0 } else { most };
        let Some(count) = designs.checked_mul(most) else {
            return Err(Failure::new(
                CarvalloStatus::WrongSize,
                format!("`most` is {most}; no array has so many rows"),
            ));
        };
        // SAFETY: the caller promises what these pointers point to.
        let (batch, summaries, critical_speeds) = unsafe {
            let batch = read(machine, columns, column_count, designs, threads)?;
            let critical_speeds = room(critical_speeds, count, "critical_speeds")?;
            (batch, room(summaries, designs, "summaries")?, critical_speeds)
        };
        batch.stability(summaries, critical_speeds, most);
        Ok(())
    })
}

/// # Safety
/// They are NULL, or a machine and columns of so many numbers.
unsafe fn read<'a>(
    machine: *const Machine,
    columns: *const Column,
    column_count: usize,
    count: usize,
    threads: usize,
) -> Result<Designs<'a>, Failure> {
    // SAFETY: the caller promises what these pointers point to.
    let (machine, columns) = unsafe { (shared(machine, "machine")?, array(columns, column_count, "columns")?) };
    let mut places: Vec<(usize, &[f64])> = Vec::with_capacity(columns.len());
    for (index, Column { name, values }) in columns.iter().enumerate() {
        // SAFETY: the same.
        let name = unsafe { text(*name, &format!("columns[{index}].name")) }?;
        let place = machine.position(name)?;
        if places.iter().any(|(other, _)| *other == place) {
            let message = format!("there are two columns of `{name}`; there must be one");
            return Err(Failure::new(CarvalloStatus::Invalid, message));
        }
        // SAFETY: the same.
        places.push((place, unsafe { array(*values, count, &format!("columns[{index}].values")) }?));
    }
    Ok(Designs { machine, columns: places, count, threads })
}
