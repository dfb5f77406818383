//! What a message to the user must not show: names and words from inside of the program.

/// Words of the program, of its engine and of Rust's own failures.
const INSIDE: [&str; 18] = [
    "panicked",
    "engine",
    "carvallo::",
    "carvallo_",
    "symbolica",
    "Slot",
    "Temp(",
    "Some(",
    "unwrap",
    "called `",
    "assertion failed",
    "index out of bounds",
    "overflow",
    "unreachable",
    ".rs",
    // In the names of what is derived from mechanisms.
    "_by_",
    "_per_v_",
    "_all",
];

/// # Panics
/// If the message is empty, or shows something that is not in the input.
pub fn look_for(message: &str, input: &str) {
    assert!(!message.trim().is_empty(), "a mistake without a message");
    if let Some(word) = INSIDE.into_iter().find(|word| message.contains(word) && !input.contains(word)) {
        panic!("`{word}` in a message: {message}");
    }
    let numbered = |word: &&str| {
        let digits = word.trim_start_matches(|c: char| c.is_ascii_lowercase() || c == '_');
        digits.len() < word.len() && !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
    };
    let words = message.split(|c: char| !c.is_alphanumeric() && c != '_');
    // Digits may be written with `_` between them.
    let bare = input.replace('_', "");
    let known =
        |word: &&str| input.contains(*word) || bare.contains(*word) || ["f32", "f64", "2e", "e300"].contains(word);
    if let Some(word) = words.filter(numbered).find(|word| !known(word)) {
        panic!("the name `{word}` in a message: {message}");
    }
}
