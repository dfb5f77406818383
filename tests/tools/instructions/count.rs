//! Counting, by callgrind.

use std::io::ErrorKind;
use std::process::{Command, Output};

use crate::EVALUATORS;
use crate::baseline::{Baseline, Count};
use crate::evaluators::{Evaluator, NOT_ON_THIS_PROCESSOR};

/// Counts all evaluators.
pub fn all() -> Result<Baseline, String> {
    if cfg!(debug_assertions) {
        return Err(format!("only the instructions of optimized programs are worth counting: {}", crate::COMMAND));
    }
    let rustc = version("rustc")?;
    let valgrind = version("valgrind")?;
    let mut counts = Vec::new();
    for evaluator in EVALUATORS {
        match each(evaluator)? {
            Some(each) => counts.push(Count { name: evaluator.name.to_owned(), each }),
            None => eprintln!("not counted, since this processor cannot do it: {}", evaluator.name),
        }
    }
    Ok(Baseline { compiler: format!("{rustc}, {}", std::env::consts::ARCH), valgrind, counts })
}

/// Instructions of one call, if the processor can do it.
fn each(evaluator: &Evaluator) -> Result<Option<f64>, String> {
    let Some(once) = collected(evaluator, evaluator.calls)? else { return Ok(None) };
    let twice = collected(evaluator, 2 * evaluator.calls)?;
    Ok(twice.map(|twice| (twice - once) / evaluator.calls as f64))
}

/// Instructions of a process that runs an evaluator so often.
fn collected(evaluator: &Evaluator, calls: usize) -> Result<Option<f64>, String> {
    let program = std::env::current_exe().map_err(|error| format!("this program cannot find itself: {error}"))?;
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]).arg(program);
    let Output { status, stderr, .. } = output(command.args(["run", evaluator.name, &calls.to_string()]))?;
    let said = String::from_utf8_lossy(&stderr);
    if status.code() == Some(NOT_ON_THIS_PROCESSOR.into()) {
        return Ok(None);
    }
    // `==123== Collected : 456`
    let line = said.lines().find_map(|line| line.split_once("Collected :"));
    match line.and_then(|(_, count)| count.trim().parse().ok()) {
        Some(count) if status.success() => Ok(Some(count)),
        _ => Err(format!("valgrind did not count `{}`: {status}\n{said}", evaluator.name)),
    }
}

/// The line with which a program tells its version.
fn version(program: &str) -> Result<String, String> {
    let Output { stdout, .. } = output(Command::new(program).arg("--version"))?;
    Ok(String::from_utf8_lossy(&stdout).lines().next().unwrap_or_default().to_owned())
}

fn output(command: &mut Command) -> Result<Output, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    command.output().map_err(|error| match error.kind() {
        ErrorKind::NotFound => format!("`{program}` is not installed, and is needed to count instructions"),
        _ => format!("`{program}` does not run: {error}"),
    })
}
