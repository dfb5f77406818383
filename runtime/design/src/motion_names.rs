//! What people call the motions of a machine, beside their names in its model.

/// Words that stand for those of labels.
const WORDS: [(&str, &str); 4] = [("roll", "lean"), ("steering", "steer"), ("handlebar", "steer"), ("heading", "yaw")];

/// What stands behind a name for its rate, the longer before what they end with.
const RATES: [&str; 5] = ["_rate", " rate", "_dot", "dot", "'"];

/// Whether what somebody wrote is a name, or a label in letters of either case: `roll` is the lean, and `steering_torque` the steer
/// torque.
///
/// ```
/// use carvallo_design::is_called;
///
/// assert!(is_called("phi", "lean", "roll") && is_called("Tdelta", "steer torque", "steering_torque"));
/// assert!(!is_called("phi", "lean", "steer"));
/// ```
#[must_use]
pub fn is_called(name: &str, label: &str, written: &str) -> bool {
    let written = written.trim();
    written == name || written.eq_ignore_ascii_case(label) || in_words(written) == in_words(label)
}

/// The name of what a rate is of, as of `phi_rate`, `phi_dot`, `phidot` and `phi'`; `None` of what does not end so.
#[must_use]
pub fn of_rate(written: &str) -> Option<&str> {
    RATES.iter().find_map(|ending| written.strip_suffix(ending)).filter(|stem| !stem.is_empty())
}

/// The words of a name, each as labels have it.
fn in_words(text: &str) -> String {
    let text = text.to_lowercase();
    let usual = |word| WORDS.iter().find(|(written, _)| *written == word).map_or(word, |(_, usual)| *usual);
    text.split(['_', ' ']).map(usual).collect::<Vec<_>>().join(" ")
}
