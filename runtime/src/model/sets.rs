//! Parameter sets by name.

use super::info::{ModelInfo, SetInfo};

impl ModelInfo {
    /// The parameter set called `name`. Upper and lower case, `_`, `-` and spaces make no difference, unless there are
    /// sets that differ in nothing else: `Pista-Rider` is `pista_rider`.
    #[must_use]
    pub fn set(&self, name: &str) -> Option<&'static SetInfo> {
        let exact = self.sets.iter().find(|set| set.name == name);
        exact.or_else(|| self.sets.iter().find(|set| letters(set.name).eq(letters(name))))
    }
}

/// What counts in a name.
fn letters(name: &str) -> impl Iterator<Item = char> {
    let counts = |letter: &char| !matches!(letter, '_' | '-') && !letter.is_whitespace();
    name.chars().filter(counts).flat_map(char::to_lowercase)
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn set(name: &'static str) -> SetInfo {
        SetInfo { name, docs: "", source: "", values: &[] }
    }

    const INFO: ModelInfo = ModelInfo {
        name: "Bicycle",
        docs: "",
        source: "",
        parameters: &[],
        coordinates: &[],
        forces: &[],
        matrices: &[],
        entries: &[],
        sets: &[set("pista"), set("pista_rider"), set("PistaRider"), set("größe_2")],
        requirements: &[],
        formulas: &[],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn found(name: &str) -> Option<&'static str> {
        INFO.set(name).map(|set| set.name)
    }

    #[test]
    fn case_and_signs_between_words_make_no_difference() {
        for name in ["pista_rider", "PISTA_RIDER", "pista-rider", "Pista Rider", "pistarider"] {
            assert_eq!(found(name), Some("pista_rider"), "{name}");
        }
        assert_eq!(found("GRÖSSE2"), None);
        assert_eq!(found("GRÖßE-2"), Some("größe_2"));
    }

    #[test]
    fn an_exact_name_comes_first() {
        assert_eq!(found("PistaRider"), Some("PistaRider"));
    }

    #[test]
    fn part_of_a_name_is_no_name() {
        for name in ["", "_", "pist", "pista rider 2"] {
            assert_eq!(found(name), None, "{name}");
        }
    }
}
