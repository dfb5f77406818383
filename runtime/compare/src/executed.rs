//! Instructions that are executed, counted by callgrind.
//!
//! The program runs itself under valgrind, comes to the same comparison again, and there does nothing but one side's loop, so
//! often as it is told: what it takes beside that falls out of the difference of two such runs.

use std::fmt;
use std::io::ErrorKind;
use std::process::Command;

use serde::Serialize;

use crate::side::{Code, Side};

/// What tells a run of the program that it is one, and what it is to do.
const TOLD: &str = "CARVALLO_COMPARE_EXECUTES";
/// Loops of the first run; of the second they are twice as many.
const LOOPS: usize = 50;

/// How many instructions a side executes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Executed {
    /// The side.
    pub name: String,
    /// `f64` or `f32`.
    pub scalar: &'static str,
    /// For a design, in a loop over several of them.
    pub instructions: f64,
}

/// How many instructions all sides execute, those in `f64` first. It reads as a table by [`Display`](fmt::Display).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Instructions {
    /// One after the other.
    pub sides: Vec<Executed>,
    /// Whether the program was compiled with optimization.
    pub optimized: bool,
}

/// Why nothing was counted.
#[derive(Debug)]
pub enum NotCounted {
    /// Valgrind is not installed.
    NoValgrind,
    /// The program does not come to the comparison when it is run again, or valgrind does not count it: what it said.
    Failed(String),
}

impl fmt::Display for NotCounted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoValgrind => f.write_str("executed instructions were NOT counted: valgrind is not installed"),
            Self::Failed(said) => write!(f, "executed instructions were NOT counted: {said}"),
        }
    }
}

impl std::error::Error for NotCounted {}

impl Instructions {
    /// Counts those of all sides over some designs, of a comparison that is called so; or, in a run that is told to, runs one side
    /// and ends the program.
    pub(crate) fn of(comparison: &str, sides: &[Side], designs: &[Vec<f64>]) -> Result<Self, NotCounted> {
        let double = sides.iter().map(|side| (side, "f64", Some(&side.double)));
        let single = sides.iter().map(|side| (side, "f32", side.single.as_ref()));
        let all: Vec<(&Side, &'static str, &Code)> =
            double.chain(single).filter_map(|(side, scalar, code)| Some((side, scalar, code?))).collect();
        if let Ok(told) = std::env::var(TOLD) {
            for (side, scalar, code) in &all {
                let own = format!("{comparison} {} {scalar} ", side.name);
                if let Some(loops) = told.strip_prefix(&own).and_then(|loops| loops.parse().ok()) {
                    let mut run = (code.each)(designs);
                    (0..loops).for_each(|_: usize| run());
                    std::process::exit(0);
                }
            }
            return Err(NotCounted::Failed("this run counts another comparison".to_owned()));
        }
        let each = |(side, scalar, _): &(&Side, &'static str, &Code)| {
            let counted = |loops: usize| collected(&format!("{comparison} {} {scalar} {loops}", side.name));
            let instructions = (counted(2 * LOOPS)? - counted(LOOPS)?) / (LOOPS * designs.len()) as f64;
            Ok(Executed { name: side.name.clone(), scalar, instructions })
        };
        let sides = all.iter().map(each).collect::<Result<_, _>>()?;
        Ok(Self { sides, optimized: !cfg!(debug_assertions) })
    }

    /// As JSON, indented.
    #[must_use]
    pub fn to_json(&self) -> String {
        // Strings and finite numbers can all be written.
        serde_json::to_string_pretty(self).expect("values that JSON has")
    }
}

/// Instructions of a run of this program that is told what to do: as it runs now, and of tests the one that asks for it.
fn collected(told: &str) -> Result<f64, NotCounted> {
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => NotCounted::NoValgrind,
        _ => NotCounted::Failed(error.to_string()),
    };
    let program = std::env::current_exe().map_err(|error| NotCounted::Failed(error.to_string()))?;
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]).arg(program).env(TOLD, told);
    // The harness of tests calls the thread of a test by its name.
    match std::thread::current().name() {
        Some(test) if test != "main" => command.args([test, "--exact", "--test-threads=1"]),
        _ => command.args(std::env::args_os().skip(1)),
    };
    let output = command.output().map_err(failed)?;
    let said = String::from_utf8_lossy(&output.stderr);
    // `==123== Collected : 456`
    let line = said.lines().find_map(|line| line.split_once("Collected :"));
    match line.and_then(|(_, count)| count.trim().parse().ok()) {
        Some(count) if output.status.success() => Ok(count),
        _ => Err(NotCounted::Failed(format!("valgrind ended with {}\n{said}", output.status))),
    }
}

impl fmt::Display for Instructions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.optimized {
            writeln!(f, "(without optimization: counts mean something with --release)")?;
        }
        writeln!(f, "instructions that are executed for a design, in a loop, by callgrind")?;
        self.sides.iter().try_for_each(|Executed { name, scalar, instructions }| {
            writeln!(f, "  {scalar}  {name:32} {instructions:>10.1}")
        })
    }
}
