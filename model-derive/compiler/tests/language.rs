//! The language that the program is asked for.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Without angles, so that the engine has little to do.
const SOURCE: &str = "carvallo::model! {\n    model Weight {\n        parameters { m: kg, > 0; }\n        \
                      coordinates { x: m; }\n        M = [[m]];\n    }\n}\n";

/// A folder with a model, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        let path = std::env::temp_dir().join(format!("carvallo-language-{}", std::process::id()));
        fs::create_dir_all(path.join("models")).expect("temporary files can be written");
        fs::write(path.join("models/weight.rs"), SOURCE).expect("it can be written");
        Self(path)
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carvallo-compiler"));
        command.current_dir(&self.0).args(arguments).output().expect("it runs")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn the_language_stands_behind_or_beside_its_option_and_decides_what_is_written() {
    let folder = Folder::new();
    let is_there = |name: &str| Path::new(&folder.0).join(name).exists();
    for (arguments, written, other) in [
        (&["expand", "--language", "c"][..], "c/weight.h", "src/models/weight.rs"),
        (&["expand", "--language=C", "models", "csrc"], "csrc/weight.c", "src/models/weight.rs"),
        (&["--language", "rust", "expand"], "src/models/weight.rs", "src/models/weight.h"),
    ] {
        let output = folder.run(arguments);
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(is_there(written) && !is_there(other), "{arguments:?}");
    }
    assert!(folder.run(&["expand", "--check", "--language", "c"]).status.success());
    fs::write(folder.0.join("c/weight.h"), "/* @generated */\n").expect("it can be written");
    let output = folder.run(&["expand", "--check", "--language", "c"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && said.contains("run `carvallo-compiler expand --language c`"), "{said}");

    for arguments in [
        &["expand", "--language", "fortran"][..],
        &["expand", "--language"],
        &["expand", "--language="],
        &["regenerate", "--language", "c"],
    ] {
        let output = folder.run(arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let expected = format!("error: unexpected arguments `{}`", arguments.join(" "));
        assert!(output.status.code() == Some(2) && said.starts_with(&expected), "{arguments:?}: {said}");
    }
}
