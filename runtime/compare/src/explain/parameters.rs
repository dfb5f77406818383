//! Guesses at what was done to a parameter wherever it stands.

use carvallo_slips::Formulas;

use super::{AtDesign, Evidence, Guess};

type Change = Box<dyn Fn(&mut [f64])>;

/// Two parameters exchanged, one in the place of another, a sign, a factor of two, and degrees.
pub fn guesses<'a>(evidence: &'a Evidence<'_>) -> impl Iterator<Item = Guess<'a>> + use<'a> {
    let used = |index: &usize| evidence.info.parameters[*index].used;
    let parameters: Vec<usize> = (0..evidence.info.parameters.len()).filter(used).collect();
    evidence.formulas.into_iter().flat_map(move |formulas| {
        changes(evidence, &parameters).into_iter().map(|(what, change)| guess(formulas, what, change))
    })
}

fn changes(evidence: &Evidence<'_>, parameters: &[usize]) -> Vec<(String, Change)> {
    let info = |index: usize| &evidence.info.parameters[index];
    let mut all: Vec<(String, Change)> = Vec::new();
    for (index, &one) in parameters.iter().enumerate() {
        for &other in &parameters[index + 1..] {
            let what = format!("the parameters `{}` and `{}` are swapped", info(one).name, info(other).name);
            all.push((what, Box::new(move |values| values.swap(one, other))));
        }
    }
    for &one in parameters {
        let name = info(one).name;
        let mut scaled = |what: &str, factor: f64| {
            all.push((format!("`{name}` {what}"), Box::new(move |values| values[one] *= factor)));
        };
        scaled("has the opposite sign", -1.0);
        scaled("is taken twice", 2.0);
        scaled("is taken half", 0.5);
        if info(one).unit == "rad" {
            scaled("is taken as degrees", 1_f64.to_radians());
            scaled("is turned into degrees", 1_f64.to_degrees());
        }
        for &other in parameters.iter().filter(|other| **other != one && info(**other).unit == info(one).unit) {
            let what = format!("`{}` stands for `{name}`", info(other).name);
            all.push((what, Box::new(move |values| values[one] = values[other])));
        }
    }
    all
}

fn guess(formulas: &Formulas, what: String, change: Change) -> Guess<'_> {
    let entries = move |at: &AtDesign| {
        let mut parameters = at.parameters.clone();
        change(&mut parameters);
        Some(formulas.values(&parameters).entries)
    };
    Guess { what, of_entries: true, is_another: true, entries: Box::new(entries) }
}
