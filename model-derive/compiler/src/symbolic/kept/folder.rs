//! Where answers are kept.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::super::lock;

/// What cargo lays into a target folder, so that backups leave it out.
const TAG: &str = "CACHEDIR.TAG";

/// The folder for answers, unless `CARVALLO_CACHE` says that there is none.
///
/// A folder for temporary files is none: there, another user could have laid down answers.
pub fn find() -> Option<PathBuf> {
    if env::var("CARVALLO_CACHE").is_ok_and(|wish| is_off(&wish)) {
        return None;
    }
    let target = of_arguments(env::args_os()).or_else(of_environment).map(|target| target.join("carvallo"));
    target.or_else(|| lock::home_folder().map(|folder| folder.join("answers")))
}

fn is_off(wish: &str) -> bool {
    ["off", "no", "false", "0"].iter().any(|off| wish.trim().eq_ignore_ascii_case(off))
}

/// The target folder that the arguments of rustc or rustdoc lie in.
fn of_arguments(arguments: impl IntoIterator<Item = OsString>) -> Option<PathBuf> {
    let mut arguments = arguments.into_iter();
    while let Some(argument) = arguments.next() {
        // With any other argument a path could be anywhere.
        let path = match argument.to_str() {
            Some("--out-dir") => arguments.next(),
            Some("-L") => arguments.next().and_then(|path| path.to_str()?.strip_prefix("dependency=").map(Into::into)),
            _ => None,
        };
        if let Some(target) = path.and_then(|path| of_path(Path::new(&path))) {
            return Some(target);
        }
    }
    None
}

/// The target folder of what is built, where no rustc does that: in a build script, and in an editor, which expands
/// macros by itself.
fn of_environment() -> Option<PathBuf> {
    let script = env::var_os("OUT_DIR").and_then(|folder| of_path(Path::new(&folder)));
    script.or_else(|| {
        let package = env::var_os("CARGO_MANIFEST_DIR")?;
        Path::new(&package).ancestors().map(|folder| folder.join("target")).find(|target| is_target(target))
    })
}

/// The target folder that a path leads into.
fn of_path(path: &Path) -> Option<PathBuf> {
    let path = path.is_absolute().then_some(path)?;
    path.ancestors().find(|folder| is_target(folder)).map(Path::to_owned)
}

fn is_target(folder: &Path) -> bool {
    folder.join(TAG).is_file()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn the_target_folder_is_where_rustc_writes_or_reads() {
        let root = env::temp_dir().join(format!("carvallo-folder-{}", std::process::id()));
        let deps = root.join("target").join("debug").join("deps");
        fs::create_dir_all(&deps).expect("temporary files can be written");
        let arguments = |text: [&str; 4]| {
            let deps = deps.to_str().expect("a name in letters");
            of_arguments(text.map(|argument| argument.replace("DEPS", deps).into()))
        };
        let all = [["rustc", "--out-dir", "DEPS", "-Cdebuginfo=2"], ["rustdoc", "--test", "-L", "dependency=DEPS"]];
        assert_eq!(all.map(arguments), [None, None], "a folder that is not cargo's");
        fs::write(root.join("target").join(TAG), "").expect("it can be written");
        assert_eq!(all.map(arguments), [Some(root.join("target")), Some(root.join("target"))]);
        assert_eq!(arguments(["rustc", "DEPS", "-o", "DEPS"]), None, "a source may lie in any folder");
        assert_eq!(arguments(["rustc", "--out-dir", "debug/deps", "-L"]), None);
        fs::remove_dir_all(root).expect("it is there");
    }

    #[test]
    fn off_is_said_in_several_ways() {
        assert!(["off", "OFF", " no", "false", "0"].into_iter().all(is_off));
        assert!(!["", "on", "1", "yes", "offset"].into_iter().any(is_off));
    }
}
