//! Which compiler this is.

use std::any::TypeId;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};

/// A number that changes with whatever answers could depend on: the sources of this crate, which the build script hashes,
/// and the versions and features of all that it is built of, Symbolica and the compiler of Rust among them.
pub fn identity() -> u64 {
    /// Cargo tells rustc apart by these what crates are built of, and rustc its types by the crate.
    struct Here;
    let mut hasher = DefaultHasher::new();
    env!("CARVALLO_SOURCES").hash(&mut hasher);
    TypeId::of::<Here>().hash(&mut hasher);
    hasher.finish()
}
