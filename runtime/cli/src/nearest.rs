//! The name that was probably meant.

/// The name nearest to `wanted`, if one is near enough to be a slip of the pen.
pub fn nearest<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = wanted.to_lowercase();
    let near = known.into_iter().map(|name| (strsim::jaro_winkler(&wanted, &name.to_lowercase()), name));
    // Of equals the first: `IBx` is more likely `IBxx` than `IBxz`.
    near.filter(|&(likeness, _)| likeness > 0.7).min_by(|a, b| b.0.total_cmp(&a.0)).map(|(_, name)| name)
}
