//! Writes `include/carvallo.h` from the functions of the C library, or compares it with them.
//!
//! From the root of the repository, with `--check` behind it to compare:
//! `cargo run --locked --manifest-path runtime/capi/header/Cargo.toml --target-dir target/header --`

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use cbindgen::{Builder, Config};

/// What has something that C sees, in the order of the header.
const SOURCES: [&str; 7] = [
    "types",
    "machine",
    "exports/library",
    "exports/machine",
    "exports/eigenvalues",
    "exports/stability",
    "exports/batch",
];

fn main() -> ExitCode {
    let is_check = match &std::env::args().skip(1).collect::<Vec<_>>()[..] {
        [] => false,
        [check] if check == "--check" => true,
        other => return fail(&format!("unexpected arguments `{}`: expected `--check` or nothing", other.join(" "))),
    };
    let text = match write() {
        Ok(text) => text,
        Err(error) => return fail(&error),
    };
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../include/carvallo.h");
    if is_check {
        if fs::read_to_string(&path).is_ok_and(|present| present == text) {
            return ExitCode::SUCCESS;
        }
        return fail(
            "runtime/capi/include/carvallo.h is not what the functions are: run `cargo run --locked --manifest-path \
             runtime/capi/header/Cargo.toml --target-dir target/header` and commit the result",
        );
    }
    match fs::write(&path, text) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&format!("{}: {error}", path.display())),
    }
}

fn write() -> Result<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let config = Config::from_file(folder.join("cbindgen.toml"))?;
    let builder = SOURCES.iter().fold(Builder::new().with_config(config), |builder, source| {
        builder.with_src(folder.join(format!("src/{source}.rs")))
    });
    let mut text = Vec::new();
    builder.generate().map_err(|error| error.to_string())?.write(&mut text);
    // Constants are called after their type, but without its ending.
    Ok(String::from_utf8_lossy(&text).replace("_T_", "_"))
}

fn fail(message: &str) -> ExitCode {
    eprintln!("error: {message}");
    ExitCode::FAILURE
}
