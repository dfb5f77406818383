#![doc = include_str!("../README.md")]

use std::fmt;
use std::path::{Component, Path, PathBuf};

use carvallo_compiler::{Kept, files, with_answers};

/// Why models are not compiled: their mistakes, each with its file, line and column, or files that cannot be had.
///
/// It is shown as what it says, also where a build script returns it from `main`.
pub struct Error(String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.trim_end())
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Behind the word that `main` puts before it, which would move the first line out of its place.
        write!(f, "the models are not compiled\n{self}")
    }
}

impl std::error::Error for Error {}

/// Compiles all files that a pattern meets, such as `models/*.rs`, from the folder of the package, and writes
/// `models.rs` into `OUT_DIR`, to be included. Cargo runs the script again when one of them is changed, or when the
/// folder that they are in is.
///
/// A model that is not `pub` is for the module that includes it. The crate must know the runtime by the name `carvallo`.
///
/// # Errors
/// All mistakes of all models; a pattern that is none, or that meets no file; and what cannot be read or written.
pub fn compile(models: &str) -> Result<(), Error> {
    let (paths, folder) = begin(models)?;
    compile_to(&paths, &folder)
}

/// Compiles the same files to C99, which is C++ as well: of `models/pendulum.rs`, `pendulum.h` and `pendulum.c`, beside the
/// files that all models share, in the folder `c` of `OUT_DIR`.
///
/// It gives the paths of all files that end with `.c`, for what compiles them, such as the crate `cc`; the headers are in their
/// folder.
///
/// # Errors
/// Those of [`compile`]; and two models in files of one name.
pub fn compile_c(models: &str) -> Result<Vec<PathBuf>, Error> {
    let (paths, folder) = begin(models)?;
    compile_c_to(&paths, &folder.join("c"))
}

/// The files that a pattern meets, at which cargo is told to look, and the folder to write to.
fn begin(models: &str) -> Result<(Vec<PathBuf>, PathBuf), Error> {
    let folder = std::env::var_os("OUT_DIR").ok_or_else(|| Error("no OUT_DIR: expected a build script".into()))?;
    let paths = find(models)?;
    // Before anything can go wrong: what is mended is to be compiled again.
    watched(&paths).iter().for_each(|path| println!("cargo::rerun-if-changed={}", path.display()));
    Ok((paths, folder.into()))
}

/// The files that a pattern meets, in their order.
fn find(models: &str) -> Result<Vec<PathBuf>, Error> {
    let paths = glob::glob(models).map_err(|error| Error(format!("error: the pattern `{models}`: {error}")))?;
    let paths = paths.collect::<Result<Vec<_>, _>>().map_err(|error| Error(format!("error: {error}")))?;
    if paths.is_empty() {
        return Err(Error(format!("error: `{models}` meets no file: expected at least one model")));
    }
    Ok(paths)
}

/// What cargo is to look at: the files, and the folders in which others could appear. Not the package itself: the target
/// folder is in it.
fn watched(paths: &[PathBuf]) -> Vec<PathBuf> {
    let is_inside = |folder: &&Path| folder.components().any(|part| matches!(part, Component::Normal(_)));
    let folders = paths.iter().filter_map(|path| path.parent()).filter(is_inside).map(Path::to_owned);
    let mut watched: Vec<PathBuf> = folders.chain(paths.iter().cloned()).collect();
    watched.sort();
    watched.dedup();
    watched
}

fn compile_to(paths: &[PathBuf], folder: &Path) -> Result<(), Error> {
    let text = with_answers(Kept::of_this_build(), || files::include(paths)).map_err(Error)?;
    write(&folder.join("models.rs"), &text)
}

fn compile_c_to(paths: &[PathBuf], folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let texts = with_answers(Kept::of_this_build(), || files::include_c(paths)).map_err(Error)?;
    std::fs::create_dir_all(folder).map_err(|error| Error(format!("error: {}: {error}", folder.display())))?;
    let mut sources = Vec::new();
    for (name, text) in texts {
        let path = folder.join(name);
        write(&path, &text)?;
        if path.extension().is_some_and(|extension| extension == "c") {
            sources.push(path);
        }
    }
    Ok(sources)
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    std::fs::write(path, text).map_err(|error| Error(format!("error: {}: {error}", path.display())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    const ROD: &str = "carvallo::model! {\n    model Rod {\n        parameters { l: m, > 0; m: kg, > 0; }\n        \
                       coordinates { theta: rad; }\n        M = [[m*l^2/3]];\n    }\n}\n";

    /// A folder with a model, removed at the end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str, model: &str) -> Self {
            let path = std::env::temp_dir().join(format!("carvallo-build-{}-{name}", std::process::id()));
            fs::create_dir_all(path.join("models")).expect("temporary files can be written");
            fs::write(path.join("models/rod.rs"), model).expect("it can be written");
            Self(path)
        }

        fn compiled(&self) -> Result<String, Error> {
            let paths = find(&format!("{}/models/*.rs", self.0.display()))?;
            compile_to(&paths, &self.0)?;
            Ok(fs::read_to_string(self.0.join("models.rs")).expect("it was written"))
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_private_model_is_there_for_the_module_that_includes_it() {
        let text = Folder::new("private", ROD).compiled().expect("the model is right");
        assert!(
            text.starts_with("#[rustfmt::skip]\n#[allow(clippy::pedantic)]\nmod rod {\n// @generated from "),
            "{text}"
        );
        assert!(text.contains("pub(super) struct Rod<T = f64> {"), "{text}");
        assert!(text.ends_with("}\n#[allow(unused_imports)]\npub use rod::*;\n"), "{text}");
    }

    #[test]
    fn the_same_files_are_c_as_well() {
        let folder = Folder::new("c", ROD);
        let paths = find(&format!("{}/models/*.rs", folder.0.display())).expect("a model");
        let sources = compile_c_to(&paths, &folder.0.join("c")).expect("the model is right");
        let names: Vec<_> = sources.iter().map(|path| path.file_name().expect("a name")).collect();
        assert_eq!(names, ["carvallo_motion.c", "carvallo_system.c", "carvallo_trig.c", "rod.c"]);
        let header = fs::read_to_string(folder.0.join("c/rod.h")).expect("it was written");
        assert!(header.contains("\n * To write it anew: cargo build\n"), "{header}");
        assert!(
            header.contains("void rod_f64_matrices(const rod_f64_t *p, rod_f64_matrices_t *matrices);"),
            "{header}"
        );

        let error = compile_c_to(&[paths[0].clone(), "other/rod.rs".into()], &folder.0).expect_err("they clash");
        let shown = format!("error: {} and other/rod.rs have one name in C", paths[0].display());
        assert!(error.to_string().starts_with(&shown), "{error}");
    }

    #[test]
    fn a_mistake_is_shown_where_it_is() {
        let folder = Folder::new("mistake", &ROD.replace("m*l^2", "m*L^2"));
        let error = folder.compiled().expect_err("there is no `L`");
        let shown = format!("{}/models/rod.rs", folder.0.display());
        let expected = format!(
            "{shown}:5:17: error: unknown name `L`: expected a parameter or a definition; did you mean `l`?\n  |         \
             M = [[m*L^2/3]];\n  |                 ^"
        );
        assert_eq!(error.to_string(), expected);
        assert!(format!("{error:?}").ends_with(&format!("\n{expected}")));
    }

    #[test]
    fn a_pattern_that_meets_nothing_is_a_mistake() {
        let error = find("no such folder/*.rs").expect_err("there are no files");
        assert_eq!(error.to_string(), "error: `no such folder/*.rs` meets no file: expected at least one model");
        assert!(find("models/***").is_err());
    }

    #[test]
    fn cargo_looks_at_the_files_and_their_folder_but_not_at_the_package() {
        let watched = |path: &str| -> Vec<String> {
            watched(&[path.into()]).iter().map(|path| path.display().to_string()).collect()
        };
        assert_eq!(watched("models/rod.rs"), ["models", "models/rod.rs"]);
        assert_eq!(watched("rod.rs"), ["rod.rs"]);
    }
}
