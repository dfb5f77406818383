//! Critical speeds that stand under the names of one another.

use crate::given::Given;

/// Two critical speeds of two kinds with their names exchanged, and what that is called.
pub fn exchanged(given: &Given) -> Option<(Given, String)> {
    let [first, second] = &given.critical_speeds[..] else { return None };
    let (Some(a), Some(b)) = (first.kind, second.kind) else { return None };
    if a == b {
        return None;
    }
    let told = format!("{} and {} are exchanged", first.name, second.name);
    let mut other = given.clone();
    let [first, second] = &mut other.critical_speeds[..] else { return None };
    std::mem::swap(&mut first.speed, &mut second.speed);
    Some((other, told))
}
