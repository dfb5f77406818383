//! Hashes the sources of the compiler: what it keeps for a later run is for one compiler alone.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io;
use std::path::{Path, PathBuf};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=src");
    let mut sources = Vec::new();
    find_sources(Path::new("src"), &mut sources)?;
    sources.sort();
    let mut hasher = DefaultHasher::new();
    for path in sources {
        path.hash(&mut hasher);
        std::fs::read(path)?.hash(&mut hasher);
    }
    println!("cargo::rustc-env=CARVALLO_SOURCES={:016x}", hasher.finish());
    Ok(())
}

fn find_sources(folder: &Path, sources: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            find_sources(&path, sources)?;
        } else {
            sources.push(path);
        }
    }
    Ok(())
}
