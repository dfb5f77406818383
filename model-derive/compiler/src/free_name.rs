//! Names that nothing else has.

use std::collections::HashSet;

/// The name, with as many underscores behind it as set it apart from those that are taken; then it is taken, too.
pub fn take_free_name(name: &str, taken: &mut HashSet<String>) -> String {
    let mut free = name.to_string();
    while !taken.insert(free.clone()) {
        free.push('_');
    }
    free
}
