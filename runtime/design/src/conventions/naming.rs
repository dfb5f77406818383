//! Which parameters are meant by the names of what varies: those of a model, or those of one convention.

use std::borrow::Cow;

use carvallo::{ModelInfo, ParameterInfo};

use super::name::{Name, Need};
use super::read::{has_paper, list};
use super::recognise::{only, with_all};
use super::source::parameter;
use super::twice::PRINTED;
use super::unknown::{changes_nothing, fixed, meant};
use super::{Convention, OTHERS};
use crate::failure::Place;
use crate::input::{Entry, Written, position};
use crate::parameter::find;

/// What names mean that stand beside each other: names of the model, and of the one convention that has all others.
#[derive(Clone, Debug)]
pub struct Naming {
    info: &'static ModelInfo,
    convention: Option<&'static Convention>,
    /// Those that are not the model's.
    foreign: Vec<String>,
}

/// A parameter that varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Varying {
    /// As the model has it, or else the convention.
    pub info: ParameterInfo,
    pub(super) at: At,
    /// The name as it was given, where its values need not be numbers, as those of tyres.
    sizes: Option<String>,
}

/// Where a parameter is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum At {
    /// Among those of the model.
    Model(usize),
    /// Among the names of the convention.
    Convention(&'static Name),
    /// Carried along by files, and held against what it must be.
    Checked(&'static Name),
}

impl Naming {
    /// Of names as they are given.
    pub fn new<'a>(info: &'static ModelInfo, names: impl IntoIterator<Item = &'a str>) -> Self {
        let is_foreign = |name: &&str| position(name, info).is_none();
        let foreign: Vec<String> = names.into_iter().filter(is_foreign).map(str::to_owned).collect();
        let convention = if has_paper(info) { only(&entries(&foreign)) } else { None };
        Self { info, convention, foreign }
    }

    /// The model.
    pub fn info(&self) -> &'static ModelInfo {
        self.info
    }

    /// The convention of those names that are not the model's, if there are any.
    pub fn convention(&self) -> Option<&'static Convention> {
        self.convention
    }

    /// The parameter that a name means.
    ///
    /// # Errors
    /// If there is none: that, and the one that was probably meant; or why its value cannot vary.
    pub fn find(&self, name: &str) -> Result<Varying, String> {
        let own = position(name, self.info);
        let Some(convention) = self.convention else {
            return match own {
                Some(at) => Ok(Varying::of_model(self.info, at)),
                None => Err(self.unknown(name)),
            };
        };
        let prepared = &prepared(name, convention);
        match (convention.known(prepared), own) {
            // What the convention has takes part in it.
            (Some(known), own) if known.is_parameter() => Ok(Varying {
                info: own.map_or_else(|| parameter(known), |at| self.info.parameters[at]),
                at: At::Convention(known),
                sizes: (prepared.as_str() != name).then(|| name.to_owned()),
            }),
            (_, Some(at)) => Ok(Varying::of_model(self.info, at)),
            (Some(known), None) => Err(fixed(name, known).unwrap_or_else(|| self.unknown(name))),
            _ => Err(self.unknown(name)),
        }
    }

    /// The same of a column of a table, which may also be one that must be zero, or equal another.
    ///
    /// # Errors
    /// As of [`find`](Self::find).
    pub fn column(&self, name: &str) -> Result<Varying, String> {
        let known = self.convention.and_then(|convention| convention.known(name));
        match known.filter(|known| matches!(known.need, Need::Zero(_) | Need::Equal(..))) {
            Some(known) if position(name, self.info).is_none() => {
                Ok(Varying { info: parameter(known), at: At::Checked(known), sizes: None })
            }
            _ => self.find(name),
        }
    }

    /// Why a name that others carry along is none of a parameter, as the end of a sentence.
    pub fn ignored(&self, name: &str) -> Option<&'static str> {
        match self.convention?.known(name)?.need {
            Need::Ignored(reason) if position(name, self.info).is_none() => Some(reason),
            _ => None,
        }
    }

    /// What there is to know of a column that may be a little off from what follows from another one, which counts.
    pub fn second(&self, counts: &Varying, other: &Varying) -> Option<String> {
        let (At::Convention(first), At::Convention(second)) = (counts.at, other.at) else { return None };
        let together = self.convention?.together(second.name);
        let is_length = first.printed == Some("mm")
            && together.map_or(second.printed == Some("mm"), |names| names.first() == Some(&second.name));
        let is_second = self.convention?.in_place_of(second.name) == Some(first.name) && is_length;
        let names = together.map_or_else(|| list(&[second.name]), list);
        let (most, stands) = (1e3 * PRINTED, if together.is_some() { "stand" } else { "stands" });
        is_second.then(|| {
            format!("{names} {stands} beside `{}`, which counts; they may disagree by up to {most} mm", first.name)
        })
    }

    fn unknown(&self, name: &str) -> String {
        let without = match find(name, self.info) {
            Ok(_) => return format!("`{name}` is no parameter that can vary"),
            Err(message) => message,
        };
        if !has_paper(self.info) || self.convention.is_some() || without.contains("did you mean") {
            return without;
        }
        let titles = |of: &[&'static Convention]| {
            let titles: Vec<String> = of.iter().map(|it| format!("{} ({})", it.name, it.title)).collect();
            titles.join(" and ")
        };
        match (&with_all(&entries(&[name.to_owned()]))[..], &self.foreign[..]) {
            ([], _) => {
                if without.contains([':', ';']) {
                    return without;
                }
                if let Some(why) = changes_nothing(name) {
                    return why;
                }
                without + &meant(name, self.info).unwrap_or_default()
            }
            (several, [_]) => format!("`{name}` means several things: it is a name of {}", titles(several)),
            (of, foreign) => {
                let others: Vec<&str> = foreign.iter().map(String::as_str).filter(|other| *other != name).collect();
                format!(
                    "`{name}` is a name of {}, and {} of others; all must be of one convention",
                    titles(of),
                    list(&others)
                )
            }
        }
    }
}

impl Varying {
    /// The one at a position of a model.
    pub fn of_model(info: &ModelInfo, at: usize) -> Self {
        Self { info: info.parameters[at], at: At::Model(at), sizes: None }
    }

    /// Where it is among those of the model, if it stands for itself there.
    pub fn position(&self) -> Option<usize> {
        match self.at {
            At::Model(at) => Some(at),
            At::Convention(_) | At::Checked(_) => None,
        }
    }

    /// A number of its own, by which what is drawn for it differs from what is drawn for others; whatever else varies.
    pub fn stream(&self, info: &ModelInfo) -> u64 {
        match info.position(self.info.name) {
            Some(at) => at as u64,
            // Behind those of all models, from the letters of its name (FNV-1a).
            None => {
                let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
                (1 << 63) | self.info.name.bytes().fold(0xcbf2_9ce4_8422_2325, step)
            }
        }
    }

    /// Whether both are the same parameter.
    pub fn is(&self, other: &Self) -> bool {
        self.at == other.at
    }

    /// Whether both are the same parameter, or one of a convention that stands in the place of the other.
    pub fn is_in_place_of(&self, other: &Self, naming: &Naming) -> bool {
        let names = |own: &At| match own {
            At::Convention(name) => Some(name.name),
            At::Model(_) | At::Checked(_) => None,
        };
        let Some([one, other]) = names(&self.at).zip(names(&other.at)).map(|(one, other)| [one, other]) else {
            return self.at == other.at;
        };
        one == other || naming.convention.is_some_and(|convention| convention.are_alternatives(one, other))
    }

    /// Whether its values are written as the sizes of tyres.
    pub fn has_sizes(&self) -> bool {
        self.sizes.is_some()
    }

    /// The text of one of its values as that of a number: `678 mm` of the tyre `28-622`.
    ///
    /// # Errors
    /// If it is no size of a tyre.
    pub fn in_numbers<'t>(&self, text: &'t str, naming: &Naming) -> Result<Cow<'t, str>, String> {
        let (Some(name), Some(convention)) = (&self.sizes, naming.convention) else { return Ok(Cow::Borrowed(text)) };
        let (mut entries, mut problems) = (vec![Entry::from_text(name, Place::Nowhere, text)], Vec::new());
        (convention.prepare)(&mut entries, &mut problems);
        match (problems.pop(), entries.pop().map(|entry| entry.value)) {
            (Some(problem), _) => Err(problem.message),
            (None, Some(Written::Text(text))) => Ok(Cow::Owned(text)),
            _ => Ok(Cow::Borrowed(text)),
        }
    }
}

/// A name that a model or a convention has, if this is one but for its spaces, hyphens and capitals.
pub fn spelled(name: &str, info: &ModelInfo) -> Option<String> {
    let is_known = |name: &str| {
        let of_others = || {
            let mut entry = entry(name);
            super::wheels::measure(&mut entry, &mut Vec::new());
            OTHERS.iter().any(|convention| entry.iter().any(|entry| convention.known(&entry.name).is_some()))
        };
        position(name, info).is_some() || has_paper(info) && of_others()
    };
    let tidy = name.trim().replace([' ', '-'], "_");
    [name.to_owned(), tidy.to_lowercase(), tidy].into_iter().find(|name| is_known(name))
}

/// The parameter of a model that is called so but for capitals and underscores, if there is one alone.
pub fn folded(name: &str, info: &ModelInfo) -> Option<&'static str> {
    if let Some(at) = position(name, info) {
        return Some(info.parameters[at].name);
    }
    let short = |name: &str| name.replace('_', "").to_lowercase();
    let mut found = info.parameters.iter().filter(|parameter| short(parameter.name) == short(name));
    found.next().filter(|_| found.next().is_none()).map(|parameter| parameter.name)
}

/// Gives the entries of a file the names that a model has for them, where all are its own but for capitals, and all in capitals or none,
/// as databases fold them. None is there twice.
pub fn unfold(entries: &mut [Entry], info: &ModelInfo) {
    let is_without = |sign: fn(char) -> bool| !entries.iter().any(|entry| entry.name.contains(sign));
    let names: Option<Vec<&str>> = entries.iter().map(|entry| folded(&entry.name, info)).collect();
    let Some(names) = names.filter(|_| is_without(char::is_uppercase) || is_without(char::is_lowercase)) else {
        return;
    };
    if names.iter().enumerate().any(|(at, name)| names[..at].contains(name)) {
        return;
    }
    for (entry, name) in entries.iter_mut().zip(names).filter(|(entry, _)| position(&entry.name, info).is_none()) {
        entry.renamed.get_or_insert_with(|| entry.name.clone());
        entry.name = name.to_owned();
    }
}

/// A name as a convention has it once its values are numbers: `wheel_diameter` of `wheel`.
pub(super) fn prepared(name: &str, convention: &Convention) -> String {
    let mut entry = entry(name);
    (convention.prepare)(&mut entry, &mut Vec::new());
    entry.pop().map_or_else(|| name.to_owned(), |entry| entry.name)
}

fn entry(name: &str) -> Vec<Entry> {
    vec![Entry::from_text(name, Place::Nowhere, "0")]
}

pub(super) fn entries(names: &[String]) -> Vec<Entry> {
    names.iter().flat_map(|name| entry(name)).collect()
}
