//! Which compiler this is.

use std::any::TypeId;
use std::hash::{DefaultHasher, Hash as _, Hasher};
use std::sync::LazyLock;

use include_dir::{Dir, DirEntry, include_dir};

/// What this crate is compiled from. A build script could hash it, but would be built with the flags of fuzzing, too.
static SOURCES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/src");

/// A number that changes with whatever answers could depend on: the sources of this crate, and the versions and features of
/// all that it is built of, Symbolica and the compiler of Rust among them.
pub fn identity() -> u64 {
    static IDENTITY: LazyLock<u64> = LazyLock::new(|| {
        /// Cargo tells rustc apart by these what crates are built of, and rustc its types by the crate.
        struct Here;
        let mut hasher = DefaultHasher::new();
        hash(&SOURCES, &mut hasher);
        TypeId::of::<Here>().hash(&mut hasher);
        hasher.finish()
    });
    *IDENTITY
}

fn hash(folder: &Dir<'_>, hasher: &mut impl Hasher) {
    for entry in folder.entries() {
        match entry {
            DirEntry::Dir(folder) => hash(folder, hasher),
            DirEntry::File(file) => {
                file.path().hash(hasher);
                file.contents().hash(hasher);
            }
        }
    }
}
