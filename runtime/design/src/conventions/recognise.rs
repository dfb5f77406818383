//! In which convention a file is, or some names are, by the names alone.

use carvallo::ModelInfo;

use super::geometry::GEOMETRY;
use super::moore::MOORE;
use super::{Convention, OTHERS};
use crate::input::{Entry, position};

/// So many names that only a convention has tell it, even if most others are missing.
const TELLING: usize = 3;

/// The convention of which a file has the largest part of what is needed, if that is larger than of the paper's.
pub fn recognise(entries: &[Entry], info: &ModelInfo) -> Option<&'static Convention> {
    let needed: Vec<usize> =
        (0..info.parameters.len()).filter(|&at| info.parameters[at].used && info.gravity != Some(at)).collect();
    let is_given = |at: &&usize| entries.iter().any(|entry| position(&entry.name, info) == Some(**at));
    let paper = share(needed.iter().filter(is_given).count(), needed.len());
    let shares = OTHERS.into_iter().map(|convention| (convention, share_of(convention, entries, info)));
    let best = shares.max_by(|(_, a), (_, b)| a.total_cmp(b)).filter(|(_, share)| *share > paper);
    best.map(|(convention, _)| convention)
}

/// What Moore and Peterson call alike and mean alike, beside the names of the paper.
const ALIKE: [&str; 2] = ["rr", "rf"];

/// The conventions that have all of these names, and a parameter among them.
pub fn with_all(names: &[Entry]) -> Vec<&'static Convention> {
    let has_all = |convention: &&Convention| {
        let mut names = names.to_vec();
        (convention.prepare)(&mut names, &mut Vec::new());
        names.iter().all(|entry| convention.known(&entry.name).is_some())
            && names.iter().any(|entry| convention.parameter(&entry.name).is_some())
    };
    OTHERS.into_iter().filter(has_all).collect()
}

/// The convention that some names are of, if they mean the same in all that have them.
pub fn only(names: &[Entry]) -> Option<&'static Convention> {
    match with_all(names)[..] {
        [convention] => Some(convention),
        // Names that mean the same everywhere.
        [.., convention] if convention.name == GEOMETRY.name => Some(convention),
        [convention, other] if convention.is_of_gyrostats() && other.is_of_gyrostats() => Some(convention),
        [convention, ..] if convention.name == MOORE.name => {
            names.iter().all(|entry| ALIKE.contains(&entry.name.as_str())).then_some(convention)
        }
        _ => None,
    }
}

/// How much of what a convention needs is given; zero if that may be a few names in a file of something else.
fn share_of(convention: &Convention, entries: &[Entry], info: &ModelInfo) -> f64 {
    let mut entries = entries.to_vec();
    (convention.prepare)(&mut entries, &mut Vec::new());
    let parameters = || entries.iter().filter_map(|entry| Some((entry, convention.parameter(&entry.name)?)));
    // Names that the paper has, too, say nothing by themselves.
    let telling = parameters().filter(|(entry, _)| position(&entry.name, info).is_none()).count();
    let is_given = |group: &Vec<&str>| parameters().any(|(_, parameter)| group.contains(&parameter.name));
    let groups = convention.needed();
    let share = share(groups.iter().filter(|group| is_given(group)).count(), groups.len());
    if telling >= TELLING || telling > 0 && share > 0.5 { share } else { 0.0 }
}

fn share(given: usize, all: usize) -> f64 {
    given as f64 / all.max(1) as f64
}
