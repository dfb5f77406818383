//! What a picture may take the place of.

use std::path::Path;

/// Whether a picture may take the place of what is at a path: nothing, an empty file or a picture, but not other files to which
/// the name of a picture is a link.
pub fn may_be_replaced(path: &Path) -> bool {
    let bytes = path.is_file().then(|| std::fs::read(path).ok()).flatten().unwrap_or_default();
    bytes.is_empty() || bytes.starts_with(b"\x89PNG") || String::from_utf8_lossy(&bytes).contains("<svg")
}
