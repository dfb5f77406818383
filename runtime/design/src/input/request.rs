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

/// Whether two paths are of one file, which is there.
pub fn is_same_file(first: &Path, second: &Path) -> bool {
    first.canonicalize().is_ok_and(|first| second.canonicalize().is_ok_and(|second| first == second))
}
