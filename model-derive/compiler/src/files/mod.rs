//! The ahead-of-time driver: models in files of their own to files of Rust and of C.

mod folder;
mod layout;
mod modules;
mod paths;
mod source;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;
use quote::quote;

use self::folder::{Folder, file_name, find_files};
pub use self::modules::include;
use self::source::{CompiledSource, Source};
use crate::emit::c;

/// Compiles every source in the folder `models/` of `generated` to one file of Rust in its `src/models/`, beside a `mod.rs`
/// for all of them, and to a header and a source of C in its `c/`, beside what they share; with `check` nothing is written.
/// Returns what was done.
///
/// # Errors
/// Mistakes of the sources, files that cannot be read or written, and with `check` every file that is stale, missing
/// or left over.
pub fn regenerate(generated: &Path, check: bool) -> Result<String, String> {
    let command = "cargo regenerate";
    let mut sources = compile_all(&generated.join("models"), "generated/models", command)?;
    // A feature of the crate that the files are in.
    let attribute = quote! {
        cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))
    };
    // Both are told of, though one of them is wrong.
    let results = [
        Folder {
            path: &generated.join("src/models"),
            shown: "generated/src/models",
            command,
            files: write_rust(&mut sources, command, Some(&attribute), true)?,
            extensions: &["rs"],
            is_all_generated: true,
        }
        .run(check),
        Folder {
            path: &generated.join("c"),
            shown: "generated/c",
            command,
            files: write_c(&sources, command),
            extensions: C,
            is_all_generated: true,
        }
        .run(check),
    ];
    let errors: Vec<&str> = results.iter().filter_map(|result| result.as_ref().err()).map(String::as_str).collect();
    if !errors.is_empty() {
        return Err(errors.join("\n"));
    }
    Ok(results.into_iter().flatten().collect::<Vec<_>>().join("\n"))
}

/// A language that models are compiled to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// For crates that depend on the runtime.
    Rust,
    /// C99, which is C++ as well.
    C,
}

impl Language {
    /// The language called so.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "rust" => Some(Self::Rust),
            "c" => Some(Self::C),
            _ => None,
        }
    }

    /// Where a project of one's own has its generated files, if it says nothing else.
    pub fn folder(self) -> &'static str {
        match self {
            Self::Rust => WRITTEN,
            Self::C => "c",
        }
    }
}

/// The same in a project of one's own, to one language: every source in the folder `models` to files in the folder
/// `written`. Files there that were not generated are left alone.
///
/// # Errors
/// As [`regenerate`]; and if a file that is to be written is one that was not generated.
pub fn expand(models: &Path, written: &Path, language: Language, check: bool) -> Result<String, String> {
    let [shown_models, shown_written] = [models, written].map(show);
    let option = if language == Language::C { " --language c" } else { "" };
    let command = match (&*shown_models, &*shown_written) {
        (MODELS, folder) if folder == language.folder() => format!("carvallo-compiler expand{option}"),
        _ => format!("carvallo-compiler expand{option} {shown_models} {shown_written}"),
    };
    let mut sources = compile_all(models, &shown_models, &command)?;
    let (files, extensions) = match language {
        Language::Rust => (write_rust(&mut sources, &command, None, false)?, &["rs"][..]),
        Language::C => (write_c(&sources, &command), C),
    };
    let folder =
        Folder { path: written, shown: &shown_written, command: &command, files, extensions, is_all_generated: false };
    folder.run(check)
}

/// The files of C that a build script writes, by their names: those of the models in these files, and what all of them share.
///
/// # Errors
/// Every mistake of all of them; and two files of one name, which have one name in C.
pub fn include_c(paths: &[PathBuf]) -> Result<BTreeMap<String, String>, String> {
    let sources: Vec<Source> = paths.iter().map(|path| Source { path: path.clone(), shown: show(path) }).collect();
    for (position, source) in sources.iter().enumerate() {
        let has_its_name = |other: &&Source| other.path.file_stem() == source.path.file_stem();
        if let Some(other) = sources[..position].iter().find(has_its_name) {
            let (first, second) = (&other.shown, &source.shown);
            return Err(format!("error: {first} and {second} have one name in C: expected files of different names"));
        }
    }
    let command = "cargo build";
    Ok(write_c(&source::compile_all(&sources, command)?, command))
}

/// Where a crate of one's own has its sources, if it says nothing else.
pub const MODELS: &str = "models";
/// And its generated files.
const WRITTEN: &str = "src/models";
/// How names of files of C end.
const C: &[&str] = &["c", "h"];

/// All models of a folder, in the order of the names of their files.
fn compile_all(models: &Path, shown: &str, command: &str) -> Result<Vec<CompiledSource>, String> {
    let paths = find_files(models, &["rs"]).map_err(|error| format!("error: {shown}: {error}"))?;
    let sources = paths.into_iter().map(|path| Source { shown: format!("{shown}/{}", file_name(&path)), path });
    source::compile_all(&sources.collect::<Vec<_>>(), command)
}

/// The files of Rust, each model with an attribute beside those in its source, and a module that may list the models.
fn write_rust(
    sources: &mut [CompiledSource],
    command: &str,
    attribute: Option<&TokenStream>,
    lists_models: bool,
) -> Result<BTreeMap<String, String>, String> {
    let module = modules::declare(sources, command, lists_models);
    let mut files = BTreeMap::from([("mod.rs".to_string(), module)]);
    for source in sources {
        let text = source.write_rust(attribute)?;
        files.insert(format!("{}.rs", source.module), text);
    }
    Ok(files)
}

/// The files of C, and those that all models share.
fn write_c(sources: &[CompiledSource], command: &str) -> BTreeMap<String, String> {
    let version = env!("CARGO_PKG_VERSION");
    let shared = c::support_files().into_iter().map(|file| {
        let header = format!(
            "/* @generated by carvallo-compiler {version}; do not edit.\n * To write it anew: {command}\n */\n\n"
        );
        (file.name, format!("{header}{}", file.text))
    });
    shared.chain(sources.iter().flat_map(CompiledSource::write_c)).collect()
}

/// A path as it stands in messages and generated files: the same on every system, and without a slash at its end.
fn show(path: &Path) -> String {
    path.components().collect::<std::path::PathBuf>().to_string_lossy().replace('\\', "/")
}
