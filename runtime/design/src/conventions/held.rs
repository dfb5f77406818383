//! Which of the parameters that stand in each other's place are kept: what varies, or else what is set, or else what is given.

use super::{Alternatives, Convention};

/// The names of a convention by what makes them count.
#[derive(Clone, Copy, Debug)]
pub struct Ranks<'a> {
    /// What varies.
    pub varied: &'a [&'static str],
    /// What was set by options.
    pub set: &'a [&'static str],
    /// What a file has.
    pub given: &'a [&'static str],
}

impl Convention {
    /// The names that are kept of those that stand in each other's place: of each group one, with those that it needs.
    pub(super) fn held(&self, ranks: Ranks) -> Vec<&'static str> {
        let options: Vec<_> = self.alternatives.iter().map(|group| option(group, ranks)).collect();
        let is_given = |name: &str| !ranks.varied.contains(&name) && !ranks.set.contains(&name);
        // The size of both wheels gives way where one of them has its own.
        let gives_way = |name: &str| options.iter().copied().flatten().any(|other| self.are_alternatives(name, other));
        let kept = |(group, option): (&Alternatives, &&'static [&'static str])| {
            let is_shared = option.iter().any(|name| is_given(name) && gives_way(name));
            if is_shared { group.first().copied().unwrap_or_default() } else { *option }
        };
        self.alternatives.iter().zip(&options).flat_map(kept).copied().collect()
    }

    /// Whether it has a name that others can stand in the place of.
    pub(super) fn has_alternatives(&self, name: &str) -> bool {
        self.alternatives.iter().any(|group| group.iter().any(|option| option.contains(&name)))
    }

    /// Whether two names say something only together.
    pub(super) fn needs(&self, one: &str, other: &str) -> bool {
        let has_both = |option: &&[&str]| option.contains(&one) && option.contains(&other);
        self.alternatives.iter().any(|group| group.iter().any(has_both))
    }

    /// The names with which one tells something only together, if it does.
    pub(super) fn together(&self, name: &str) -> Option<&'static [&'static str]> {
        let mut options = self.alternatives.iter().flat_map(|group| group.iter().copied());
        options.find(|option| option.len() > 1 && option.contains(&name))
    }

    /// What a name stands in the place of, if anything.
    pub(super) fn in_place_of(&self, name: &str) -> Option<&'static str> {
        let group = self.alternatives.iter().find(|group| group.iter().any(|option| option.contains(&name)))?;
        group.first().and_then(|option| option.first()).copied().filter(|first| *first != name)
    }

    /// Whether two names cannot both be kept.
    pub(super) fn are_alternatives(&self, one: &str, other: &str) -> bool {
        let option = |group: &Alternatives, name: &str| group.iter().position(|option| option.contains(&name));
        self.alternatives.iter().any(|group| {
            let both = option(group, one).zip(option(group, other));
            both.is_some_and(|(one, other)| one != other)
        })
    }
}

fn option(group: &Alternatives, Ranks { varied, set, given }: Ranks) -> &'static [&'static str] {
    let any = |names: &[&str]| group.iter().find(|option| option.iter().any(|name| names.contains(name)));
    let whole = || group.iter().find(|option| option.iter().all(|name| given.contains(name)));
    any(varied).or_else(|| any(set)).or_else(whole).or(group.first()).copied().unwrap_or_default()
}
