//! What a misspelt word most likely means.

/// The candidate that a misspelt word most likely means, if any is near enough.
pub fn find_nearest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let distance = |candidate: &str| {
        // Letters of the wrong case are the smallest mistake.
        if candidate.eq_ignore_ascii_case(word) { 0 } else { strsim::osa_distance(candidate, word) }
    };
    // One letter in a name of two or less is another name.
    let length = word.chars().count();
    let limit = if length < 3 { 0 } else { (length / 3).max(1) };
    candidates
        .map(|candidate| (distance(candidate), candidate))
        .filter(|(d, _)| *d <= limit)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

/// How a message that refuses a word ends if another one is probably meant.
pub fn ask_for(meant: &str) -> String {
    format!("; did you mean `{meant}`?")
}
