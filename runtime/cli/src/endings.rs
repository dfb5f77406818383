//! What the names of files end in, held against what is written to them.

use std::path::Path;

/// All that some command writes: of another format than the one that is asked for, an ending is a slip.
const KNOWN: [&str; 18] = [
    "json", "csv", "md", "tex", "txt", "npz", "mat", "parquet", "toml", "yaml", "yml", "py", "m", "rs", "c", "h",
    "svg", "png",
];

/// The endings of the files of a command, without the dot, each with what is written there. An ending may have several,
/// of which the first is meant where none is asked for.
pub struct Endings<K: 'static>(pub &'static [(&'static str, K)]);

impl<K: Copy + PartialEq> Endings<K> {
    /// What is written to a file: what is asked for, and else what the ending of its name says.
    ///
    /// # Errors
    /// Which endings are possible, if it has the ending of something else, or none that tells while nothing is asked for.
    pub fn kind(&self, path: &Path, asked: Option<K>) -> Result<K, String> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
        let named = || self.0.iter().filter(|(own, _)| *own == ending).map(|(_, kind)| *kind);
        match asked {
            None => named().next().ok_or_else(|| format!("the name must end in {}", self.words(|_| true))),
            Some(asked) if named().any(|kind| kind == asked) => Ok(asked),
            Some(asked) if KNOWN.contains(&&*ending) => {
                let own = self.words(|kind| kind == asked);
                Err(format!("the ending of its name is that of another format than --format; it must be {own}"))
            }
            Some(asked) => Ok(asked),
        }
    }

    /// The endings of what is meant, in words.
    fn words(&self, is_meant: impl Fn(K) -> bool) -> String {
        let mut endings: Vec<String> = Vec::new();
        for (ending, _) in self.0.iter().filter(|(_, kind)| is_meant(*kind)) {
            let ending = format!(".{ending}");
            if !endings.contains(&ending) {
                endings.push(ending);
            }
        }
        match &endings[..] {
            [others @ .., last] if !others.is_empty() => format!("{} or {last}", others.join(", ")),
            endings => endings.concat(),
        }
    }
}
