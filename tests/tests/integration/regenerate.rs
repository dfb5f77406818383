//! The ahead-of-time driver on a folder of its own: what it writes, and what its check finds wrong.

use std::fs;
use std::path::{Path, PathBuf};

use carvallo_compiler::files::{Language, expand, regenerate};

const SOURCE: &str = "carvallo::model! {\n    pub model Rod {\n        parameters { l: m, > 0; m: kg, > 0; }\n        \
                      coordinates { theta: rad; }\n        M = [[m*l^2/3]];\n    }\n}\n";

/// An empty folder with one source, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("carvallo-{name}-{}", std::process::id()));
        fs::create_dir_all(path.join("models")).expect("a folder for the test");
        let folder = Self(path);
        folder.write("models/rod.rs", SOURCE);
        folder
    }

    fn path(&self) -> &Path {
        &self.0
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("a file can be written");
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).expect("a file can be read")
    }

    fn check(&self) -> String {
        regenerate(self.path(), true).expect_err("something is wrong")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Nothing depends on it any more.
        let _ = fs::remove_dir_all(&self.0);
    }
}

const MEND: &str = "run `cargo regenerate` and commit the result";

#[test]
fn what_is_checked_in_is_up_to_date() {
    let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated");
    regenerate(&generated, true).unwrap_or_else(|stale| panic!("{stale}"));
}

#[test]
fn what_was_written_is_up_to_date() {
    let folder = Folder::new("written");
    let done = regenerate(folder.path(), false).expect("it can be written");
    let rust = ["src/models/mod.rs", "src/models/rod.rs"];
    let wrote: Vec<String> = rust.into_iter().chain(C).map(|name| format!("wrote generated/{name}")).collect();
    assert_eq!(done, wrote.join("\n"));
    let done = regenerate(folder.path(), true).expect("it is up to date");
    assert_eq!(done, "2 files in generated/src/models/ are up to date\n8 files in generated/c/ are up to date");
    let text = folder.read("src/models/rod.rs");
    let header: Vec<&str> = text.lines().take(3).collect();
    assert_eq!(header[0], "// @generated from generated/models/rod.rs by carvallo-compiler 0.1.0; do not edit.");
    assert_eq!(header[1], "// To write it anew: cargo regenerate");
    assert!(header[2].starts_with("// Hash of the source: "), "{}", header[2]);
    assert!(text.contains("pub struct Rod<T"), "{text}");
    let list = folder.read("src/models/mod.rs");
    assert!(list.contains("mod rod;\n\npub use rod::*;\n"), "{list}");
    assert!(
        list.ends_with("        [\n            $($function)+::<_, $crate::Rod>(),\n        ]\n    };\n}\n"),
        "{list}"
    );
}

/// What there is of one model in C.
const C: [&str; 8] = [
    "c/carvallo_motion.c",
    "c/carvallo_motion.h",
    "c/carvallo_system.c",
    "c/carvallo_system.h",
    "c/carvallo_trig.c",
    "c/carvallo_trig.h",
    "c/rod.c",
    "c/rod.h",
];

#[test]
fn missing_stale_and_left_over_files_are_named_with_what_mends_them() {
    let folder = Folder::new("wrong");
    let all = ["src/models/mod.rs", "src/models/rod.rs"].into_iter().chain(C);
    let missing: Vec<String> = all.map(|name| format!("error: generated/{name} is missing: {MEND}")).collect();
    assert_eq!(folder.check(), missing.join("\n"));
    assert!(!folder.path().join("src").exists() && !folder.path().join("c").exists(), "a check writes nothing");

    regenerate(folder.path(), false).expect("it can be written");
    folder.write("models/rod.rs", &SOURCE.replace("/3", "/4"));
    let stale = ["src/models/rod.rs", "c/rod.c", "c/rod.h"];
    let stale = stale.map(|name| format!("error: generated/{name} is stale: {MEND}"));
    assert_eq!(folder.check(), stale.join("\n"));

    regenerate(folder.path(), false).expect("it can be written");
    folder.write("src/models/old.rs", "");
    folder.write("c/old.h", "");
    let left_over = ["src/models/old.rs", "c/old.h"];
    let errors = left_over.map(|name| format!("error: generated/{name} is left over, without a source: {MEND}"));
    assert_eq!(folder.check(), errors.join("\n"));
    let done = regenerate(folder.path(), false).expect("it can be written");
    assert_eq!(done, left_over.map(|name| format!("removed generated/{name}, which has no source")).join("\n"));
}

#[test]
fn mistakes_of_a_source_are_shown_where_they_are() {
    let folder = Folder::new("mistake");
    folder.write("models/rod.rs", &SOURCE.replace("m*l^2", "m*L^2"));
    let expected = "generated/models/rod.rs:5:17: error: unknown name `L`: expected a parameter or a definition; did \
                    you mean `l`?\n  |         M = [[m*L^2/3]];\n  |                 ^\n";
    assert_eq!(folder.check(), expected);
    folder.write("models/rod.rs", "fn main() {}");
    let expected = "generated/models/rod.rs:1:1: error: expected one `carvallo::model! { … }` and nothing else\n  \
                    | fn main() {}\n  | ^^\n";
    assert_eq!(folder.check(), expected);
}

#[test]
fn what_cannot_be_split_into_tokens_is_shown_where_it_is() {
    let folder = Folder::new("tokens");
    let cases = [
        (
            SOURCE.replace("[[m*l^2/3]]", "[[m*l²/3]]"),
            "5:18",
            "found `²`: expected names, numbers, texts and signs of Rust",
        ),
        (SOURCE.replace("rad; }", "rad; ]"), "4:35", "`]` closes nothing: expected the other half of what is open"),
        (SOURCE.replace("rad; }", "rad;"), "1:18", "`{` is never closed: expected its other half"),
        (format!("{SOURCE}}}"), "8:1", "`}` closes nothing: expected the other half of what is open"),
        (format!("{SOURCE}/* open"), "8:1", "a comment without an end: expected `*/`"),
        (SOURCE.replace("rad;", "\"rad;"), "4:30", "a text without an end: expected `\"`"),
    ];
    for (source, place, message) in cases {
        folder.write("models/rod.rs", &source);
        let found = folder.check();
        let expected = format!("generated/models/rod.rs:{place}: error: {message}\n");
        assert!(found.starts_with(&expected), "{found}instead of\n{expected}");
    }
}

/// `expand` in a folder as if that were a crate.
fn expanded(folder: &Folder, check: bool) -> Result<String, String> {
    expand(&folder.path().join("models"), &folder.path().join("src/models"), Language::Rust, check)
}

#[test]
fn a_crate_of_ones_own_has_files_without_a_list_and_keeps_what_was_written_by_hand() {
    let folder = Folder::new("own");
    let shown = |name: &str| format!("{}/{name}", folder.path().display());
    let done = expanded(&folder, false).expect("it can be written");
    assert_eq!(done, format!("wrote {}\nwrote {}", shown("src/models/mod.rs"), shown("src/models/rod.rs")));
    let command = format!("carvallo-compiler expand {} {}", shown("models"), shown("src/models"));
    let module = format!(
        "// @generated by carvallo-compiler; do not edit. To write it anew: {command}\n\n//! The models compiled ahead of \
         time.\n\n#[rustfmt::skip]\n#[allow(clippy::pedantic)]\nmod rod;\n\npub use rod::*;\n"
    );
    assert_eq!(folder.read("src/models/mod.rs"), module);
    assert!(folder.read("src/models/rod.rs").contains(&format!("\n// To write it anew: {command}\n")));

    folder.write("src/models/by_hand.rs", "//! Mine.\n");
    folder.write("src/models/old.rs", "// @generated from models/old.rs\n");
    let error = expanded(&folder, true).expect_err("one is left over");
    let mend = format!("run `{command}` and commit the result");
    assert_eq!(error, format!("error: {} is left over, without a source: {mend}", shown("src/models/old.rs")));
    let done = expanded(&folder, false).expect("it can be removed");
    assert_eq!(done, format!("removed {}, which has no source", shown("src/models/old.rs")));
    assert_eq!(folder.read("src/models/by_hand.rs"), "//! Mine.\n");
    assert!(expanded(&folder, true).expect("all is there").starts_with("2 files in "));
}

#[test]
fn nothing_that_was_written_by_hand_is_written_over() {
    let folder = Folder::new("by-hand");
    fs::create_dir_all(folder.path().join("src/models")).expect("a folder for the test");
    folder.write("src/models/rod.rs", "struct Rod;\n");
    let error = expanded(&folder, false).expect_err("that is no generated file");
    assert!(error.ends_with("src/models/rod.rs was not generated: move it, or write to another folder"), "{error}");
    assert_eq!(folder.read("src/models/rod.rs"), "struct Rod;\n");
    assert!(!folder.path().join("src/models/mod.rs").exists(), "all or nothing");
}

#[test]
fn a_file_that_cannot_be_a_module_is_refused() {
    let folder = Folder::new("module");
    folder.write("models/my-rod.rs", SOURCE);
    let error = expanded(&folder, false).expect_err("`my-rod` is no name");
    let expected = "models/my-rod.rs: expected a file named like a module, such as `my_bicycle.rs`";
    assert!(error.starts_with("error: ") && error.ends_with(expected), "{error}");
}

#[test]
fn a_project_of_ones_own_has_files_of_c_and_keeps_what_was_written_by_hand() {
    let folder = Folder::new("own-c");
    let written = folder.path().join("c");
    let expanded = |check| expand(&folder.path().join("models"), &written, Language::C, check);
    let done = expanded(false).expect("it can be written");
    let shown = |name: &str| format!("{}/{name}", folder.path().display());
    assert_eq!(done, C.map(|name| format!("wrote {}", shown(name))).join("\n"));
    let command = format!("carvallo-compiler expand --language c {} {}", shown("models"), shown("c"));
    let header = folder.read("c/rod.h");
    let first = format!(
        "/* @generated from {}/rod.rs by carvallo-compiler 0.1.0; do not edit.\n * To write it anew: {command}\n",
        shown("models")
    );
    assert!(header.starts_with(&first), "{header}");

    folder.write("c/main.c", "int main(void) { return 0; }\n");
    folder.write("c/old.h", "/* @generated from models/old.rs */\n");
    let done = expanded(false).expect("it can be removed");
    assert_eq!(done, format!("removed {}, which has no source", shown("c/old.h")));
    assert!(written.join("main.c").exists());
    folder.write("c/rod.h", "/* Mine. */\n");
    let error = expanded(false).expect_err("that is no generated file");
    assert!(error.ends_with("c/rod.h was not generated: move it, or write to another folder"), "{error}");
}
