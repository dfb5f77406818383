//! The program `carvallo`.

use std::process::ExitCode;

fn main() -> ExitCode {
    carvallo_cli::main()
}
