//! The name that was probably meant.

/// The name nearest to `wanted`, if one is near enough to be a slip of the pen: at most one letter in three is missing,
/// superfluous, another one or exchanged with its neighbour, or it is the beginning of the name.
pub fn nearest<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // Of one type for all that names come from.
    nearest_of(wanted, &mut known.into_iter())
}

fn nearest_of<'a>(wanted: &str, known: &mut dyn Iterator<Item = &'a str>) -> Option<&'a str> {
    // Longer names than these are no slips, and would take long to compare.
    if wanted.len() > 64 {
        return None;
    }
    let wanted = lowercase(wanted);
    let near = known.filter_map(|name| Some((distance(&wanted, &lowercase(name))?, name)));
    // Of equals the first: `IBx` is more likely `IBxx` than `IBxz`.
    near.min_by(|a, b| a.0.cmp(&b.0)).map(|(_, name)| name)
}

fn lowercase(name: &str) -> String {
    name.chars().flat_map(char::to_lowercase).collect()
}

/// The number of letters that differ, unless there are too many.
fn distance(wanted: &str, name: &str) -> Option<usize> {
    let distance = strsim::osa_distance(wanted, name);
    let length = wanted.chars().count().max(name.chars().count());
    let is_beginning = wanted.chars().count() >= 3 && name.starts_with(wanted);
    // `ww` differs from `w` by half, and yet is one.
    let is_doubled = without_doubles(wanted) == without_doubles(name);
    (3 * distance <= length || is_beginning || is_doubled).then_some(distance)
}

fn without_doubles(text: &str) -> String {
    let mut last = None;
    text.chars().filter(|c| last.replace(*c) != Some(*c)).collect()
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn slips_are_understood_and_nothing_is_guessed() {
        let names = ["w", "c", "lam", "mR", "IRxx", "mB", "IBxx", "IBxz", "rF"];
        for (wanted, meant) in [
            ("mb", Some("mB")),
            ("ww", Some("w")),
            ("IBx", Some("IBxx")),
            ("r_F", Some("rF")),
            ("IRxxx", Some("IRxx")),
            ("lma", Some("lam")),
            ("b", None),
            ("ic11", None),
            ("C1", None),
            ("M", None),
            ("K0", None),
            ("mG", None),
            ("qqq", None),
        ] {
            assert_eq!(nearest(wanted, names), meant, "{wanted}");
        }
        assert_eq!(nearest("bench", ["browser", "benchmark"]), Some("benchmark"));
        assert_eq!(nearest(&"w".repeat(100_000), names), None);
    }
}
