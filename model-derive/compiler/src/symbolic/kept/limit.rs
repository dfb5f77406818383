//! How much is kept.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Of the files in a folder that come to more bytes than this, those go that were not used for longest, until half of it
/// is left. The answers for a bicycle with derivatives come to some tenths of a megabyte.
const BYTES: u64 = 64 << 20;

/// Holds a folder to the limit.
pub fn apply(folder: &Path) {
    hold_to(folder, BYTES);
}

fn hold_to(folder: &Path, limit: u64) {
    let mut files = list(folder);
    let mut bytes: u64 = files.iter().map(|(_, size, _)| size).sum();
    if bytes <= limit {
        return;
    }
    files.sort();
    for (_, size, path) in files {
        if bytes <= limit / 2 {
            break;
        }
        // Another process may have been there before.
        let _ = fs::remove_file(path);
        bytes -= size;
    }
}

/// When each file was last used, its size and its path.
fn list(folder: &Path) -> Vec<(SystemTime, u64, PathBuf)> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let file = |entry: fs::DirEntry| {
        let metadata = entry.metadata().ok().filter(fs::Metadata::is_file)?;
        Some((metadata.modified().ok()?, metadata.len(), entry.path()))
    };
    entries.filter_map(file).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn what_was_not_used_for_longest_goes_first() {
        let folder = std::env::temp_dir().join(format!("carvallo-limit-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("temporary files can be written");
        let start = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000);
        // From the one used last to the one used first.
        for (age, name) in ["a", "b", "c", "d", "e"].into_iter().enumerate() {
            let path = folder.join(name);
            fs::write(&path, [0; 100]).expect("it can be written");
            let file = fs::OpenOptions::new().append(true).open(&path).expect("it is there");
            file.set_modified(start - Duration::from_secs(age as u64)).expect("it can be set");
        }
        let left = || {
            let mut names: Vec<_> = list(&folder).into_iter().map(|(_, _, path)| path).collect();
            names.sort();
            names.into_iter().map(|path| path.file_name().expect("a name").to_string_lossy().into_owned()).collect()
        };
        hold_to(&folder, 500);
        assert_eq!(Vec::<String>::len(&left()), 5);
        hold_to(&folder, 499);
        assert_eq!(left(), ["a", "b"]);
        fs::remove_dir_all(folder).expect("it is there");
    }
}
