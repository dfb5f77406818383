//! Names as symbols: `IBxx` is I with the index Bxx, `lam` with the symbol λ is that letter.

/// What a name looks like in formulas: a letter or a word, with indices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    pub base: Part,
    pub indices: Vec<Part>,
}

/// A part of a symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// The name of a Greek letter, such as `lambda`.
    Greek(&'static str),
    /// Letters and digits that stand for themselves, each.
    Letters(String),
    /// A word, upright.
    Word(String),
}

/// The Greek letters of formulas with their names, which LaTeX and Typst share.
const GREEK: [(&str, &str); 34] = [
    ("α", "alpha"),
    ("β", "beta"),
    ("γ", "gamma"),
    ("δ", "delta"),
    ("ε", "epsilon"),
    ("ζ", "zeta"),
    ("η", "eta"),
    ("θ", "theta"),
    ("ι", "iota"),
    ("κ", "kappa"),
    ("λ", "lambda"),
    ("μ", "mu"),
    ("ν", "nu"),
    ("ξ", "xi"),
    ("π", "pi"),
    ("ρ", "rho"),
    ("σ", "sigma"),
    ("τ", "tau"),
    ("υ", "upsilon"),
    ("φ", "phi"),
    ("χ", "chi"),
    ("ψ", "psi"),
    ("ω", "omega"),
    ("Γ", "Gamma"),
    ("Δ", "Delta"),
    ("Θ", "Theta"),
    ("Λ", "Lambda"),
    ("Ξ", "Xi"),
    ("Π", "Pi"),
    ("Σ", "Sigma"),
    ("Υ", "Upsilon"),
    ("Φ", "Phi"),
    ("Ψ", "Psi"),
    ("Ω", "Omega"),
];

impl Symbol {
    /// The symbol of a name. Behind underscores stand indices, and so do letters and digits behind the first letter:
    /// `J_xx`, `Jxx` and `l1`, `deltaF`, `kθ`; a name of small letters is a word.
    pub fn of(name: &str) -> Self {
        let mut parts = name.split('_').filter(|part| !part.is_empty());
        let first = parts.next().unwrap_or(name);
        let (base, rest) = split(first);
        let greek = GREEK.iter().find(|(letter, _)| *letter == rest).map(|(_, name)| Part::Greek(name));
        let rest = greek.or_else(|| (!rest.is_empty()).then(|| Part::Letters(rest.into())));
        Self { base, indices: rest.into_iter().chain(parts.map(index)).collect() }
    }
}

/// The first letter of a name, and what follows it.
fn split(name: &str) -> (Part, &str) {
    let ends = |rest: &str| !rest.starts_with(char::is_lowercase);
    // Of names that begin alike, as eta and theta do not, the longest.
    let greek = GREEK.iter().filter_map(|&(letter, spelt)| {
        let by_letter = name.strip_prefix(letter);
        let rest = by_letter.or_else(|| name.strip_prefix(spelt).filter(|rest| ends(rest)))?;
        Some((Part::Greek(spelt), rest))
    });
    if let Some(found) = greek.min_by_key(|(_, rest)| rest.len()) {
        return found;
    }
    if name.chars().count() > 2 && name.chars().all(char::is_lowercase) {
        return (Part::Word(name.into()), "");
    }
    let (letter, rest) = name.split_at(name.chars().next().map_or(0, char::len_utf8));
    (Part::Letters(letter.into()), rest)
}

/// An index by itself: a Greek letter, a word, or letters such as those of two axes.
fn index(part: &str) -> Part {
    match split(part) {
        (greek @ Part::Greek(_), "") => greek,
        // Axes, as in products of inertia.
        _ if part.chars().all(|c| matches!(c, 'x' | 'y' | 'z')) => Part::Letters(part.into()),
        _ if part.chars().count() > 1 && part.chars().skip(1).all(char::is_lowercase) => Part::Word(part.into()),
        _ => Part::Letters(part.into()),
    }
}
