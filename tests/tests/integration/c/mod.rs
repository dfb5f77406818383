//! The generated C, compiled by the system's compiler and run, against the generated Rust: number by number.

mod driver;
mod expected;
mod motion;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use carvallo::Model;
use carvallo_models::each_model;

use self::expected::Expected;

/// As the guide says for the same bits, and no warning is let through.
const FLAGS: &[&str] = &[
    "-std=c99",
    "-O1",
    "-ffp-contract=off",
    "-Wall",
    "-Wextra",
    "-pedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Werror",
];

/// A folder for what is compiled, removed at the end.
struct Folder(PathBuf);

impl Drop for Folder {
    fn drop(&mut self) {
        // Nothing depends on it any more.
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn generated() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/c")
}

/// The header of each model by the model's name, with what its files are called.
fn headers() -> BTreeMap<String, (String, String)> {
    let mut headers = BTreeMap::new();
    for entry in fs::read_dir(generated()).expect("the generated files") {
        let path = entry.expect("an entry").path();
        let text = fs::read_to_string(&path).expect("a text");
        if let Some(name) = text.split("@brief The model `").nth(1).and_then(|rest| rest.split('`').next()) {
            let file = path.file_stem().expect("a name").to_string_lossy().into_owned();
            headers.insert(name.to_string(), (file, text));
        }
    }
    headers
}

/// The compilers of C that are there.
fn compilers() -> Vec<&'static str> {
    let is_there = |compiler: &&str| {
        let found = Command::new(compiler).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        let found = found.is_ok_and(|status| status.success());
        if !found {
            eprintln!("SKIPPED: the generated C is not compiled by {compiler}, since that is not installed");
        }
        found
    };
    ["cc", "clang"].into_iter().filter(is_there).collect()
}

/// Compiles a program with all models, and gives it what it reads.
fn run(compiler: &str, program: &str, input: &str) -> String {
    let folder = Folder(std::env::temp_dir().join(format!("carvallo-c-{compiler}-{}", std::process::id())));
    fs::create_dir_all(&folder.0).expect("a folder for the test");
    fs::write(folder.0.join("main.c"), program).expect("a file can be written");
    let mut sources: Vec<PathBuf> =
        fs::read_dir(generated()).expect("the generated files").map(|entry| entry.expect("an entry").path()).collect();
    sources.retain(|path| path.extension().is_some_and(|extension| extension == "c"));
    let compiled = Command::new(compiler)
        .args(FLAGS)
        .arg("-I")
        .arg(generated())
        .arg(folder.0.join("main.c"))
        .args(sources)
        .args(["-lm", "-o"])
        .arg(folder.0.join("main"))
        .output()
        .expect("the compiler runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    // From a file: what is written while nothing is read would wait for ever.
    fs::write(folder.0.join("input"), input).expect("a file can be written");
    let input = fs::File::open(folder.0.join("input")).expect("it is there");
    let output = Command::new(folder.0.join("main")).stdin(input).output().expect("the program runs");
    assert!(output.status.success(), "{:?}", output.status);
    String::from_utf8(output.stdout).expect("numbers")
}

/// Every output of every model in both precisions: matrices and derivatives to the last bit, systems and state spaces too but
/// for the sign of zeros, codes by what they say.
#[test]
fn c_computes_what_rust_computes() {
    let compilers = compilers();
    if compilers.is_empty() {
        return;
    }
    fn expect<const N: usize, M: Model<N, Scalar = f64>>() -> Expected {
        Expected::of::<N, M>()
    }
    let headers = headers();
    let all = each_model!(expect);
    assert_eq!(headers.len(), all.len(), "a header for each model");
    let program = driver::write(all.iter().map(|expected| {
        let (file, header) = &headers[expected.model];
        (expected, &**file, &**header)
    }));
    let input: String = all.iter().map(|expected| expected.input.as_str()).collect();
    for compiler in compilers {
        let output = run(compiler, &program, &input);
        let mut found = output.lines();
        for expected in &all {
            for (what, word) in &expected.words {
                let line = found.next().unwrap_or_default();
                assert_eq!(line, word, "{}: {what}, compiled by {compiler}", expected.model);
            }
        }
        assert_eq!(found.next(), None);
    }
    for expected in &all {
        let moves = headers[expected.model].1.contains("_f64_motion_rates(");
        assert_eq!(moves, expected.motions.is_some(), "{}", expected.model);
    }
    // There is something to compare.
    assert!(all.iter().all(|expected| expected.words.len() > 100));
}

/// Names that C has for something else or does not have, and a text that would end a comment and begin another.
#[cfg(feature = "compiler")]
const AWKWARD: &str = "carvallo::model! {
    /// Ends */ here /* with \\lambda, @param and https://a.b.
    pub model Awkward {
        parameters { int: m, > 0.1; \u{3bb}: kg, in [0, 7]; matrices: m, > 0; p: 1; g: N/kg, >= 0; }
        let exp = \u{3bb}*int;
        coordinates { theta: rad; }
        M = [[exp*matrices + exp*int*sqrt(1 + p^2)*1e60]];
        Kc = [[\u{3bb}*g*int*tan(p)]];
        require \u{3bb} - exp/matrices > 0.1 kg;
    }
}
";

#[cfg(feature = "compiler")]
#[test]
fn names_and_texts_are_what_c_can_have() {
    if compilers().is_empty() {
        return;
    }
    let folder = Folder(std::env::temp_dir().join(format!("carvallo-c-names-{}", std::process::id())));
    fs::create_dir_all(folder.0.join("models")).expect("a folder for the test");
    fs::write(folder.0.join("models/awkward.rs"), AWKWARD).expect("a file can be written");
    let written = folder.0.join("c");
    carvallo_compiler::files::expand(&folder.0.join("models"), &written, carvallo_compiler::files::Language::C, false)
        .unwrap_or_else(|error| panic!("{error}"));
    let header = fs::read_to_string(written.join("awkward.h")).expect("it was written");
    assert!(header.contains("double int_;") && header.contains("float u03bb;"), "{header}");
    for flags in [FLAGS, &["-x", "c++", "-std=c++20", "-Wall", "-Wextra", "-Werror"]] {
        for compiler in compilers() {
            let compiled =
                Command::new(compiler).args(flags).arg("-fsyntax-only").arg(written.join("awkward.c")).output();
            let compiled = compiled.expect("the compiler runs");
            let message = String::from_utf8_lossy(&compiled.stderr);
            // Not every compiler of C has one of C++ beside it.
            let has_none = message.contains("cc1plus") || message.contains("not recognized");
            assert!(compiled.status.success() || has_none, "{compiler}: {message}");
        }
    }
}
