//! Processors, and how a program is built and run for one.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A board that qemu has.
pub struct Board {
    pub name: &'static str,
    machine: &'static str,
    flags: &'static str,
    /// What the compiler of C is told of the processor.
    c_flags: &'static str,
}

/// The Cortex-M4F computes `f64` by software.
pub const BOARDS: &[Board] = &[
    Board { name: "M4F", machine: "mps2-an386", flags: "", c_flags: "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16" },
    Board {
        name: "M7",
        machine: "mps2-an500",
        flags: " -C target-cpu=cortex-m7 -C target-feature=+fp-armv8d16",
        c_flags: "-mcpu=cortex-m7 -mfpu=fpv5-d16",
    },
];

/// What a task takes on a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    pub board: String,
    pub task: String,
    /// Bytes of the whole program, and of the stack.
    pub flash: u64,
    pub stack: u64,
    /// Instructions of one run.
    pub instructions: u64,
}

const TARGET: &str = "thumbv7em-none-eabihf";

/// What one tick of the clock of the boards (25 MHz) is in instructions, of which qemu runs one each ns.
const INSTRUCTIONS_IN_A_TICK: u64 = 40;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

impl Board {
    fn target(&self) -> PathBuf {
        let folder =
            std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| folder().join("../../target/mcu"), PathBuf::from);
        folder.join(self.name)
    }

    /// Builds the programs of all tasks.
    pub fn build(&self) -> Result<(), String> {
        let device = folder().join("device");
        let flags = format!("-C link-arg=-Tlink.x -C link-arg=-L{}{}", device.display(), self.flags);
        let mut cargo = Command::new("cargo");
        cargo.current_dir(folder()).args(["build", "--quiet", "--release", "--package=device", "--target", TARGET]);
        cargo.env("CARGO_TARGET_DIR", self.target()).env("RUSTFLAGS", flags);
        cargo.env("CFLAGS_thumbv7em_none_eabihf", format!("{} -mfloat-abi=hard", self.c_flags));
        output(&mut cargo).map(|_| ())
    }

    /// Runs the program of a task, which does it so often, and has to come to these bits.
    pub fn measure(&self, task: &str, times: u64, expected: &[u64]) -> Result<Measured, String> {
        let at = |what: String| format!("{task} on {}: {what}", self.name);
        let program = self.target().join(TARGET).join("release").join(task);
        let symbols = output(Command::new("arm-none-eabi-nm").arg("--demangle").arg(&program))?;
        if let Some(panic) = symbols.lines().find(|symbol| symbol.contains("core::panicking")) {
            return Err(at(format!("a panic is linked: {panic}")));
        }
        let mut qemu = Command::new("timeout");
        qemu.args([
            "60",
            "qemu-system-arm",
            "-machine",
            self.machine,
            "-nographic",
            "-monitor",
            "none",
            "-serial",
            "none",
        ]);
        qemu.args(["-semihosting-config", "enable=on,target=native", "-icount", "shift=0", "-kernel"]).arg(&program);
        let said = output(&mut qemu)?;
        let numbers = |word: &str| {
            let rows = said.lines().filter_map(|line| line.split_once(' ').filter(|(first, _)| *first == word));
            rows.map(|(_, digits)| u64::from_str_radix(digits, 16)).collect::<Result<Vec<_>, _>>()
        };
        let numbers = |word: &str| numbers(word).map_err(|error| at(format!("{said}: {error}")));
        let bits = numbers("bits")?;
        if bits != expected {
            return Err(at(format!("{bits:x?} came out, and {expected:x?} on the host")));
        }
        let single = |word: &str| numbers(word)?.first().copied().ok_or_else(|| at(format!("no {word} in {said:?}")));
        Ok(Measured {
            board: self.name.to_string(),
            task: task.to_string(),
            flash: flash(&program)?,
            stack: single("stack")?,
            instructions: (single("ticks")? * INSTRUCTIONS_IN_A_TICK + times / 2) / times,
        })
    }
}

/// Code, constants and initial values of variables, in bytes.
fn flash(program: &Path) -> Result<u64, String> {
    let table = output(Command::new("arm-none-eabi-size").arg(program))?;
    let row = table.lines().nth(1).unwrap_or_default().split_whitespace();
    let sizes: Vec<u64> = row.take(2).filter_map(|size| size.parse().ok()).collect();
    if sizes.len() == 2 { Ok(sizes.iter().sum()) } else { Err(format!("sizes are not to be read: {table}")) }
}

fn output(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| format!("{name}: {error}"))?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(said);
    }
    Err(format!("{command:?}: {}\n{said}{}", output.status, String::from_utf8_lossy(&output.stderr)))
}
