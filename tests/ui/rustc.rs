//! What rustc shows of mistakes, for one case of each kind of span; what is said is tested in the compiler, for all cases.
//!
//! After a change: `UPDATE=1 cargo test --workspace --test rustc`, then read what it changed.
//!
//! Cargo is asked for the whole workspace, so that it takes the macro that it built for the other tests.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

#[test]
fn mistakes_are_shown_where_they_are() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let update = std::env::var_os("UPDATE").is_some_and(|value| value == "1");
    let mut differences = String::new();
    let mut shown = shown(folder);
    for case in cases() {
        let path = folder.join(format!("{case}.stderr"));
        let expected = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
        let found = shown.remove(&case.replace('/', "-")).unwrap_or_default();
        assert!(!found.is_empty(), "nothing is said of {case}");
        if found != expected && update {
            fs::write(&path, found).unwrap_or_else(|error| panic!("{case}.stderr: {error}"));
        } else if found != expected {
            differences += &format!("\n--- {case}: expected\n{expected}--- found\n{found}");
        }
    }
    let mend =
        "if this is what should be shown, run `UPDATE=1 cargo test --workspace --test rustc` and read what it changes";
    assert!(differences.is_empty(), "messages differ: {mend}\n{differences}");
}

/// The cases that the manifest lists as programs.
fn cases() -> Vec<&'static str> {
    let paths = include_str!("Cargo.toml").lines().filter_map(|line| line.strip_prefix("path = \""));
    let cases: Vec<_> = paths.filter_map(|path| path.strip_suffix(".rs\"")).filter(|path| path.contains('/')).collect();
    assert!(!cases.is_empty(), "the manifest lists no programs");
    cases
}

/// What is said of each program, by its name.
fn shown(folder: &Path) -> BTreeMap<String, String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args([
        "check",
        "--workspace",
        "--features",
        "carvallo-ui/mistakes",
        "--keep-going",
        "--message-format",
        "json",
    ]);
    cargo.args(cases().iter().flat_map(|case| ["--bin".into(), case.replace('/', "-")]));
    let output = cargo.current_dir(folder).output().expect("cargo runs");
    let mut shown = BTreeMap::<String, Vec<String>>::new();
    // Symbolica prints a notice between.
    for line in String::from_utf8_lossy(&output.stdout).lines().filter(|line| line.starts_with('{')) {
        let line: Value = serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
        let message = &line["message"];
        // The last message of a program, that there were errors, is at no place.
        if line["reason"] == "compiler-message" && message["spans"].as_array().is_some_and(|spans| !spans.is_empty()) {
            let [name, text] =
                [&line["target"]["name"], &message["rendered"]].map(|text| text.as_str().unwrap_or_default());
            shown
                .entry(name.into())
                .or_default()
                .push(text.replace("--> tests/ui/", "--> ").trim_end().to_owned() + "\n");
        }
    }
    assert!(!shown.is_empty(), "cargo says nothing of them: {}", String::from_utf8_lossy(&output.stderr));
    shown.into_iter().map(|(name, messages)| (name, messages.join("\n"))).collect()
}
