//! Builds a program for each task and processor, runs it under qemu, holds its numbers against those of the host, bit by
//! bit, and what it takes against `costs.tsv`.
//!
//! Needs the target thumbv7em-none-eabihf (rustup), qemu-system-arm, gcc-arm-none-eabi and libnewlib-arm-none-eabi.

mod board;
mod table;

use std::process::ExitCode;

use board::{BOARDS, Measured};
use tasks::Task;

const USAGE: &str = "usage, in tests/mcu: cargo run --release [-- --check | --write]
  (nothing)  measures, beside what costs.tsv has
  --check    the same, and fails if anything has grown
  --write    makes what is measured the new costs.tsv";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => measure().and_then(|found| table::compare(&found)).map(|_| ()),
        ["--check"] => measure().and_then(|found| match table::compare(&found)? {
            grown if grown.is_empty() => Ok(()),
            grown => Err(format!("it takes more than before:\n{}", grown.join("\n"))),
        }),
        ["--write"] => measure().and_then(|found| table::write(&found)),
        ["--help" | "-h"] => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        _ => Err(format!("unknown arguments {arguments:?}\n{USAGE}")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// All tasks on all boards.
fn measure() -> Result<Vec<Measured>, String> {
    let mut found = Vec::new();
    for board in BOARDS {
        board.build()?;
        found.push(one::<tasks::Empty>(board)?);
        found.push(one::<tasks::MatricesF32>(board)?);
        found.push(one::<tasks::MatricesF64>(board)?);
        found.push(one::<tasks::StateSpaceF32>(board)?);
        found.push(one::<tasks::StateSpaceF64>(board)?);
        found.push(one::<tasks::Eigenvalues>(board)?);
        found.push(one::<tasks::EigenvaluesF32>(board)?);
        found.push(one::<tasks::ParametersToEigenvalues>(board)?);
        found.push(one::<tasks::CriticalSpeeds>(board)?);
        found.push(one::<tasks::AccelerationsF32>(board)?);
        found.push(one::<tasks::ControlF32>(board)?);
        found.push(one::<tasks::RideF32>(board)?);
        found.push(like::<tasks::MatricesF32>(board, "c_matrices_f32")?);
        found.push(like::<tasks::MatricesF64>(board, "c_matrices_f64")?);
        found.push(like::<tasks::StateSpaceF32>(board, "c_state_space_f32")?);
        found.push(like::<tasks::StateSpaceF64>(board, "c_state_space_f64")?);
    }
    Ok(found)
}

fn one<T: Task>(board: &board::Board) -> Result<Measured, String> {
    like::<T>(board, T::NAME)
}

/// A task, or a program that has to come to the same.
fn like<T: Task>(board: &board::Board, name: &str) -> Result<Measured, String> {
    let mut expected = Vec::new();
    T::bits(&T::run(&T::input()), &mut |bits| expected.push(bits));
    if expected.is_empty() && T::NAME != tasks::Empty::NAME {
        return Err(format!("{}: nothing comes out on the host", T::NAME));
    }
    board.measure(name, T::TIMES.into(), &expected)
}
