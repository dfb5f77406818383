//! One table of what everything takes: by hand, by peers, by Carvallo, and what no program can do without. Before it stand
//! operations and rounding errors.
//!
//! What is timed, and how, is in `README.md` beside this folder.

mod batches;
mod derivatives;
mod eigenvalues;
mod matrices;
mod motion;
mod stability;
mod systems;
mod table;

use std::process::ExitCode;
use std::time::Duration;

use carvallo_compare::Task;
use carvallo_tests::{designs, operations, rounding};
use table::Table;

const USAGE: &str = "\
usage: cargo bench -p carvallo-bench --bench summary [-- [--quick] [WORD ...]]

  --quick   a tenth of the designs and of the time: for a look, not for figures
  WORD      only tasks whose name contains one of the words";

/// What is measured, and what came out.
struct Summary {
    /// How many distinct designs.
    designs: usize,
    /// How long contenders for one task are timed.
    time: Duration,
    words: Vec<String>,
    table: Table,
}

impl Summary {
    /// Whether something of this name was asked for.
    fn wants(&self, name: &str) -> bool {
        self.words.is_empty() || self.words.iter().any(|word| name.contains(word.as_str()))
    }

    fn run(&mut self, task: Task<'_>) {
        if self.wants(&task.name) {
            eprintln!("timing: {}", task.name);
            let name = task.name.clone();
            self.table.push(name, task.race(self.time));
        }
    }
}

/// Those of the four matrices at so many random designs.
fn operations_and_errors(designs: usize) -> String {
    let report = rounding::four_ways((0..designs as u64).map(designs::numbered)).report().expect("designs");
    let peer = operations::count(include_str!("../../src/peers/symplex/f64.rs"), "matrices").total();
    format!("{report}symplex-build takes {peer} operations, counted in its source\n")
}

fn main() -> ExitCode {
    let mut summary =
        Summary { designs: 1_000_000, time: Duration::from_secs(3), words: Vec::new(), table: Table::default() };
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            // Cargo says so to every benchmark.
            "--bench" => {}
            "--quick" => (summary.designs, summary.time) = (100_000, Duration::from_millis(300)),
            "--help" | "-h" => {
                println!("{USAGE}");
                return ExitCode::SUCCESS;
            }
            flag if flag.starts_with('-') => {
                eprintln!("error: unknown argument `{flag}`\n\n{USAGE}");
                return ExitCode::from(2);
            }
            word => summary.words.push(word.to_owned()),
        }
    }
    if summary.wants("operations and errors of the four matrices") {
        println!("{}", operations_and_errors(summary.designs / 100));
    }
    matrices::add(&mut summary);
    derivatives::add(&mut summary);
    eigenvalues::add(&mut summary);
    stability::add(&mut summary);
    motion::add(&mut summary);
    batches::add(&mut summary);
    print!("{}", summary.table);
    ExitCode::SUCCESS
}
