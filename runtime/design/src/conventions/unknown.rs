//! Names that a model does not have: whose they are, or what was probably meant.

use carvallo::{ModelInfo, ParameterInfo};

use super::OTHERS;
use super::name::{Name, Need};
use super::naming::{Naming, entries, prepared};
use super::read::{has_paper, list};
use super::recognise::{only, with_all};
use crate::nearest::nearest;

/// More parameters than this are not named.
const LISTED: usize = 6;

/// Of a name that a model does not have, whose it is or what was probably meant, as the end of a sentence.
pub fn hint(name: &str, info: &ModelInfo) -> Option<String> {
    if !has_paper(info) {
        return None;
    }
    if let Some(convention) = only(&entries(&[name.to_owned()])) {
        return Some(format!(
            "; it is one of {}, in which a file has all parameters; `--set {name}=…` changes it of another bicycle",
            convention.title
        ));
    }
    meant(name, info)
}

/// Whether a name that is set beside others, and is none of a model's, is one of a convention; otherwise why it cannot be set, if it
/// is of several.
///
/// # Errors
/// If it is none of one.
pub fn settable<'a>(
    name: &str,
    set: impl Iterator<Item = &'a str>,
    info: &'static ModelInfo,
) -> Result<(), Option<String>> {
    let is_known = |name: &str| has_paper(info) && !with_all(&entries(&[name.to_owned()])).is_empty();
    match is_known(name) {
        true => Naming::new(info, set.filter(|name| is_known(name))).find(name).map(drop).map_err(Some),
        false => Err(changes_nothing(name).filter(|_| has_paper(info))),
    }
}

/// Why a name that others have cannot vary, if one of them has it so.
pub(super) fn changes_nothing(name: &str) -> Option<String> {
    OTHERS.iter().find_map(|convention| fixed(name, convention.known(&prepared(name, convention))?))
}

/// What was probably meant by a name that nobody has, as the end of a sentence.
pub(super) fn meant(name: &str, info: &ModelInfo) -> Option<String> {
    if name.eq_ignore_ascii_case("caster") || name.eq_ignore_ascii_case("castor") {
        return Some("; did you mean `trail`, a length, or `caster_angle`, the tilt of the steer axis?".to_owned());
    }
    let names = OTHERS.iter().flat_map(|convention| convention.names).filter(|known| known.is_parameter());
    match nearest(name, names.map(|known| known.name)) {
        Some(meant) if meant != name => Some(format!("; did you mean `{meant}`?")),
        Some(_) => None,
        None => described(name, info),
    }
}

/// The parameters of a model whose descriptions have all words of a name, if they are few, as the end of a sentence.
fn described(name: &str, info: &ModelInfo) -> Option<String> {
    let words = |text: &str| -> Vec<String> {
        let words = text.split(|sign: char| !sign.is_alphanumeric()).filter(|word| word.len() > 2);
        words.map(str::to_lowercase).collect()
    };
    let wanted = words(name);
    let has_all = |own: &&ParameterInfo| {
        let own = words(own.docs);
        wanted.iter().all(|word| own.contains(word))
    };
    let found: Vec<&str> = info.parameters.iter().filter(has_all).map(|own| own.name).collect();
    let is_telling = !wanted.is_empty() && (1..=LISTED).contains(&found.len());
    is_telling.then(|| match found[..] {
        [one] => format!("; did you mean `{one}`?"),
        _ => format!("; did you mean one of {}?", list(&found)),
    })
}

/// Why the value of a name that others have cannot vary, if it cannot.
pub(super) fn fixed(name: &str, known: &Name) -> Option<String> {
    match known.need {
        Need::Zero(reason) => Some(format!("`{name}` is always 0: {reason}")),
        Need::Equal(other, reason) => Some(format!("`{name}` is that of `{other}`: {reason}")),
        Need::Ignored(reason) => Some(format!("`{name}` changes nothing: {reason}")),
        _ => None,
    }
}
