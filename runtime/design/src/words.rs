//! Messages in the words of whoever calls.

/// A message in other words: each of those of the command line, such as `--speeds`, becomes what stands beside it. The first
/// that fits is taken, so that one which begins another has to stand behind it.
///
/// ```
/// use carvallo_design::in_words;
///
/// let words = [("--speeds", "the call"), ("--speed", "`v`")];
/// assert_eq!(in_words("the speeds come from --speeds", &words), "the speeds come from the call");
/// assert_eq!(in_words("it follows from --speed", &words), "it follows from `v`");
/// ```
#[must_use]
pub fn in_words(message: &str, words: &[(&str, &str)]) -> String {
    let mut said = String::with_capacity(message.len());
    let mut rest = message;
    while let Some(next) = rest.chars().next() {
        let (from, to) = words.iter().find(|(from, _)| rest.starts_with(from)).copied().unwrap_or_default();
        if from.is_empty() {
            said.push(next);
            rest = &rest[next.len_utf8()..];
        } else {
            said.push_str(to);
            rest = &rest[from.len()..];
        }
    }
    said
}

#[cfg(test)]
mod tests {
    use super::in_words;

    #[test]
    fn takes_the_first_that_fits_wherever_it_is() {
        let words = [("--model ", "the model "), ("--set ", ""), ("λ", "l")];
        assert_eq!(in_words("--set λ=1: it is of --model Coin, not λ", &words), "l=1: it is of the model Coin, not l");
        assert_eq!(in_words("a -- b", &words), "a -- b");
        assert_eq!(in_words("", &words), "");
    }
}
