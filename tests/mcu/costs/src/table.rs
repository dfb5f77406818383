//! What was measured before.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::board::Measured;

const HEAD: &str = "board\ttask\tflash\tstack\tinstructions";

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../costs.tsv")
}

/// Bytes and instructions depend on the compiler.
fn compiler() -> Result<String, String> {
    let output = Command::new("rustc").arg("--version").output().map_err(|error| format!("rustc: {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_string())
}

pub fn write(found: &[Measured]) -> Result<(), String> {
    let row = |Measured { board, task, flash, stack, instructions }: &Measured| {
        format!("{board}\t{task}\t{flash}\t{stack}\t{instructions}\n")
    };
    let rows: String = found.iter().map(row).collect();
    let text = format!(
        "# What tasks take on microcontrollers: bytes of flash of the whole program, bytes of stack, instructions.\n\
         # To measure anew, in tests/mcu: cargo run --release -- --write\n# compiler: {}\n{HEAD}\n{rows}",
        compiler()?
    );
    fs::write(file(), text).map_err(|error| format!("{}: {error}", file().display()))
}

/// Prints what was found beside what is written, and gives what has grown or is not in both; nothing, if that is of another
/// compiler.
pub fn compare(found: &[Measured]) -> Result<Vec<String>, String> {
    let text = fs::read_to_string(file()).map_err(|error| format!("{}: {error}", file().display()))?;
    let bad = |line: &str| format!("{}: `{line}` is no row of `{HEAD}`", file().display());
    let rows = text.lines().filter(|line| !line.starts_with('#') && *line != HEAD);
    let written = rows.map(|line| read(line).ok_or_else(|| bad(line))).collect::<Result<Vec<_>, _>>()?;
    let mut grown = Vec::new();
    println!("{:<7}{:<26}{:>20}{:>20}{:>20}", "board", "task", "flash (B)", "stack (B)", "instructions");
    for now in found {
        let Measured { board, task, .. } = now;
        let Some(before) = written.iter().find(|row| row.board == *board && row.task == *task) else {
            grown.push(format!("{task} on {board} is not in the table"));
            continue;
        };
        let pairs = [
            ("flash", before.flash, now.flash),
            ("stack", before.stack, now.stack),
            ("instructions", before.instructions, now.instructions),
        ];
        let cells: String =
            pairs.iter().map(|(_, before, now)| format!("{:>20}", format!("{before} -> {now}"))).collect();
        println!("{board:<7}{task:<26}{cells}");
        let more = pairs.iter().filter(|(_, before, now)| now > before);
        grown.extend(
            more.map(|(what, before, now)| format!("{task} on {board}: {what} {now} in the place of {before}")),
        );
    }
    let is_found = |row: &Measured| found.iter().any(|now| now.board == row.board && now.task == row.task);
    grown.extend(written.iter().filter(|row| !is_found(row)).map(|row| format!("{} was not measured", row.task)));
    let compiler = compiler()?;
    if !text.contains(&format!("# compiler: {compiler}\n")) {
        println!("The table is of another compiler than `{compiler}`: that they differ is no mistake.");
        return Ok(Vec::new());
    }
    Ok(grown)
}

fn read(line: &str) -> Option<Measured> {
    let cells: Vec<&str> = line.split('\t').collect();
    let [board, task, flash, stack, instructions] = cells[..] else { return None };
    let number = |cell: &str| cell.parse().ok();
    Some(Measured {
        board: board.to_string(),
        task: task.to_string(),
        flash: number(flash)?,
        stack: number(stack)?,
        instructions: number(instructions)?,
    })
}
