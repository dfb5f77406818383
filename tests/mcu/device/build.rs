//! Compiles the emitted C of the Whipple bicycle, with the compiler of the board; `costs` says its flags.

use std::path::Path;
use std::process::Command;

fn main() {
    let folder = Path::new("../../../generated/c");
    let files = ["whipple", "carvallo_system", "carvallo_trig"].map(|name| folder.join(name).with_extension("c"));
    println!("cargo:rerun-if-changed={}", folder.display());
    let mut build = cc::Build::new();
    build.files(files).std("c99").opt_level_str("s").flag("-ffp-contract=off").warnings_into_errors(true);
    build.compile("whipple");

    // Sines of angles beyond 1e5 rad are those of the C library, which the programs in Rust do without.
    let programs = ["c_matrices_f32", "c_matrices_f64", "c_state_space_f32", "c_state_space_f64"];
    for library in ["libm.a", "libc.a"] {
        let path = output(build.get_compiler().to_command().arg(format!("-print-file-name={library}")));
        for program in programs {
            println!("cargo:rustc-link-arg-bin={program}={}", path.trim());
        }
    }
}

fn output(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    String::from_utf8_lossy(&output.stdout).into_owned()
}
