//! Answers of the engine that are kept: the same bytes with them, without them, and with a part of them; and what
//! processes do that keep the same ones at once.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use carvallo_compiler::{Driver, Kept, expand, with_answers};
use quote::quote;

/// Formulas with derivatives and claims; a mechanism that rolls; and one with springs.
const SOURCES: [&str; 3] = [
    include_str!("../../../generated/models/whipple.rs"),
    include_str!("../../../generated/models/rolling_disc.rs"),
    include_str!("../../../generated/models/pendulum.rs"),
];

/// The environment of a process that is to expand the models with answers in this folder.
const FOLDER: &str = "CARVALLO_TEST_ANSWERS";

/// What a declaration comes to, with the answers in a folder or with none.
fn expanded(source: &str, folder: Option<&Path>) -> String {
    let (_, body) = source.split_once('{').expect("an opening brace");
    let (declaration, _) = body.rsplit_once('}').expect("a closing brace");
    let tokens = declaration.parse().expect("tokens");
    let driver = Driver::Macro { runtime: quote!(::carvallo) };
    let code = with_answers(folder.map(Kept::in_folder), || expand(tokens, &driver));
    code.expect("the model compiles").to_string()
}

/// A folder that is removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = env::temp_dir().join(format!("carvallo-kept-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        Self(path)
    }

    /// All files with their bytes.
    fn files(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        let files = fs::read_dir(&self.0).expect("there are answers").map(|entry| entry.expect("a file").path());
        files.map(|path| (path.clone(), fs::read(path).expect("a file can be read"))).collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn the_same_bytes_with_answers_without_them_and_with_a_part_of_them() {
    for source in SOURCES {
        let folder = Folder::new("bytes");
        let without = expanded(source, None);
        assert_eq!(expanded(source, Some(&folder.0)), without, "while answers are kept");
        let kept = folder.files();
        assert!(!kept.is_empty());
        assert_eq!(expanded(source, Some(&folder.0)), without, "with all of them");
        for remainder in 0..2 {
            kept.keys().skip(remainder).step_by(2).for_each(|path| fs::remove_file(path).expect("it is there"));
            assert_eq!(expanded(source, Some(&folder.0)), without, "with every second one");
            assert_eq!(folder.files(), kept);
        }
    }
}

#[test]
fn what_is_damaged_is_found_again() {
    let folder = Folder::new("damaged");
    let [source, ..] = SOURCES;
    let without = expanded(source, Some(&folder.0));
    let kept = folder.files();
    for (number, (path, bytes)) in kept.iter().enumerate() {
        let mut damaged = bytes.clone();
        match number % 3 {
            0 => damaged.truncate(bytes.len() / 2),
            1 => damaged[bytes.len() * 3 / 4] ^= 4,
            _ => damaged.clear(),
        }
        fs::write(path, damaged).expect("it can be written");
    }
    assert_eq!(expanded(source, Some(&folder.0)), without);
    assert_eq!(folder.files(), kept);
}

#[test]
fn a_declaration_that_is_changed_is_derived_anew() {
    let folder = Folder::new("changed");
    let [.., source] = SOURCES;
    let first = expanded(source, Some(&folder.0));
    let kept = folder.files();
    let changed = source.replace("m*l^2", "m*l^2/3");
    assert_ne!(changed, source, "the pendulum has its mass at the end");
    let code = expanded(&changed, Some(&folder.0));
    assert_ne!(code, first);
    assert_eq!(code, expanded(&changed, None));
    assert!(folder.files().len() > kept.len());
    // What is only said of the formulas asks nothing.
    let (kept, told) = (folder.files(), source.replace("///", "/// Also:"));
    assert_ne!(expanded(&told, Some(&folder.0)), first);
    assert_eq!(folder.files(), kept);
}

#[test]
fn processes_at_once_keep_the_same_answers() {
    let folder = Folder::new("at-once");
    let test = "kept::expands_for_another_process";
    let start = || {
        let mut process = Command::new(env::current_exe().expect("the path of this program"));
        let process = process.args(["--exact", test, "--ignored", "--nocapture"]).env(FOLDER, &folder.0);
        process.stdout(Stdio::piped()).spawn().expect("it starts")
    };
    let processes = [(); 3].map(|()| start());
    let expected = SOURCES.map(|source| expanded(source, None)).concat();
    for process in processes {
        let output = process.wait_with_output().expect("it ends");
        assert!(output.status.success(), "{output:?}");
        let printed = String::from_utf8(output.stdout).expect("text");
        assert!(printed.contains(&expected), "another code: {printed}");
    }
    let unfinished = |path: &&PathBuf| path.extension().is_some();
    assert_eq!(folder.files().keys().filter(unfinished).count(), 0, "files that were not finished");
    assert_eq!(SOURCES.map(|source| expanded(source, Some(&folder.0))).concat(), expected);
}

#[test]
#[ignore = "a part of `processes_at_once_keep_the_same_answers`"]
fn expands_for_another_process() {
    let folder = PathBuf::from(env::var_os(FOLDER).expect("a folder for the answers"));
    print!("{}", SOURCES.map(|source| expanded(source, Some(&folder))).concat());
}
