//! What is asked for, by names, paths and options.

use std::path::Path;

/// Where the parameters come from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Request {
    /// The name of the model; otherwise a file chooses it, or it is the one of the bicycles.
    pub model: Option<String>,
    /// The name of what ships for the model, a path, or `-` for the standard input; otherwise the first that ships.
    pub parameters: Option<String>,
    /// Values from the command line: the option as it was given, the name and the value.
    pub overrides: Vec<(String, String, String)>,
    /// Laws of feedback from the command line, each with the option as it was given. A file's law for the same force gives way.
    pub feedback: Vec<(String, String)>,
    /// Bodies that are joined to frames, each with the option as it was given: files, or what they are in one line. What the
    /// overrides make of a frame, they are joined to.
    #[cfg(feature = "full")]
    pub bodies: Vec<(String, String)>,
}

impl Request {
    /// Whether the parameters are read from this file, so that nothing must be written there.
    pub fn reads(&self, path: &Path) -> bool {
        let is_same = |name: &String| is_same_file(Path::new(name), path);
        #[cfg(feature = "full")]
        let reads_body = self.bodies.iter().any(|(_, text)| is_same(text));
        #[cfg(not(feature = "full"))]
        let reads_body = false;
        self.parameters.as_ref().is_some_and(is_same) || reads_body
    }
}

/// Whether two paths are of one file, which is there: also by links of both kinds.
pub fn is_same_file(first: &Path, second: &Path) -> bool {
    first.canonicalize().is_ok_and(|first| second.canonicalize().is_ok_and(|second| first == second))
        || is_linked(first, second)
}

/// Whether both are names of one file on a disk.
#[cfg(unix)]
fn is_linked(first: &Path, second: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;

    let id = |path: &Path| path.metadata().ok().filter(|file| file.is_file()).map(|file| (file.dev(), file.ino()));
    id(first).is_some_and(|first| id(second) == Some(first))
}

/// Elsewhere files are not told by numbers.
#[cfg(not(unix))]
fn is_linked(_: &Path, _: &Path) -> bool {
    false
}
