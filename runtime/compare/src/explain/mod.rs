//! What explains the entries in which a function by hand differs.
//!
//! A guess says what all entries would be if somebody had made one mistake: with a matrix ([`matrices`]), a coordinate
//! ([`coordinates`]), an entry ([`entries`]), a parameter ([`parameters`]), or a term of a formula ([`terms`]). A guess explains the entries that it gives as the function by
//! hand has them, at several designs; as few guesses as explain all are told.

mod coordinates;
mod doubles;
mod entries;
mod factor;
mod matrices;
mod parameters;
mod terms;

use carvallo::{MatrixName, ModelInfo};
use carvallo_slips::{Formulas, Values, index, place};
use serde::Serialize;

use self::factor::Factor;

/// A matrix, a row and a column.
type Place = (MatrixName, usize, usize);

/// Of its terms, how much an entry may differ and still be the same formula. Rounding stays far below it.
pub const SAME: f64 = 1e-9;
/// How many guesses that explain the same are told.
const ALIKE: usize = 3;

/// What explains some of the entries that differ.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Explanation {
    /// The entries, such as `C1_12`.
    pub entries: Vec<String>,
    /// What was done, as far as can be told; others than the first explain the same entries as well.
    pub causes: Vec<String>,
}

/// What is known of a function by hand at some designs.
pub struct Evidence<'a> {
    pub info: &'static ModelInfo,
    /// The formulas of the model, if they can be evaluated.
    pub formulas: Option<&'a Formulas>,
    pub designs: Vec<AtDesign>,
    /// Of its terms, how much an entry may differ and still be the same.
    pub same: f64,
}

/// Parameters, and for each entry of the matrices its value, the size of its terms, and what is by hand.
pub struct AtDesign {
    pub parameters: Vec<f64>,
    /// The values of the formulas, if they can be evaluated.
    pub values: Values,
    pub exact: Vec<f64>,
    pub sizes: Vec<f64>,
    pub by_hand: Vec<f64>,
}

impl AtDesign {
    /// Whether a value for an entry is what is by hand, but for so much of its terms.
    fn is_by_hand(&self, entry: usize, value: f64, same: f64) -> bool {
        (self.by_hand[entry] - value).abs() <= same * (self.sizes[entry] + value.abs())
    }
}

/// All entries at a design; nothing where there are none.
type Entries<'a> = Box<dyn Fn(&AtDesign) -> Option<Vec<f64>> + 'a>;

/// One mistake.
struct Guess<'a> {
    what: String,
    /// Whether it explains single entries, or must be right for all of them.
    of_entries: bool,
    /// Whether it is told beside another guess that explains the same, and not only in other words.
    is_another: bool,
    /// Those with that mistake.
    entries: Entries<'a>,
}

impl Guess<'_> {
    /// That entries are others, those at the places that `from` gives for them, times a factor.
    fn moved(
        n: usize,
        what: String,
        factor: Factor,
        from: impl Fn(Place) -> Option<Place> + 'static,
    ) -> Guess<'static> {
        let entries = move |at: &AtDesign| {
            let entry = |index: usize| match from(place(index, n)) {
                Some(from) => factor.at(at) * at.exact[position(n, from)],
                None => at.exact[index],
            };
            Some((0..at.exact.len()).map(entry).collect())
        };
        Guess { what, of_entries: false, is_another: true, entries: Box::new(entries) }
    }
}

/// A guess that explains something.
struct Right {
    what: String,
    is_another: bool,
    explained: Vec<usize>,
    /// How many entries it gives otherwise that are right by hand.
    broken: usize,
    rank: usize,
}

/// The entries that differ and what explains them, and those that nothing explains.
pub fn explain(evidence: &Evidence<'_>) -> (Vec<Explanation>, Vec<String>) {
    let mut wrong = evidence.wrong();
    let mut matrices: Vec<MatrixName> = wrong.iter().map(|entry| place(*entry, evidence.n()).0).collect();
    matrices.dedup();
    // From the plainest on.
    let mut guesses: Vec<Guess<'_>> = matrices::guesses(evidence, &matrices);
    guesses.extend(coordinates::guesses(evidence));
    guesses.extend(entries::guesses(evidence, &wrong));
    guesses.extend(parameters::guesses(evidence));
    guesses.extend(terms::guesses(evidence));
    let right = guesses.iter().enumerate().filter_map(|(rank, guess)| evidence.judge(guess, &wrong, rank));
    let right: Vec<Right> = right.collect();
    let mut explanations = Vec::new();
    while let Some(best) = best(&right, &wrong) {
        let entries = explained(best, &wrong);
        let is_same =
            |other: &&Right| other.is_another && other.broken == best.broken && explained(other, &wrong) == entries;
        let same = right.iter().filter(is_same);
        let mut causes = vec![best.what.clone()];
        same.for_each(|other| {
            if causes.len() < ALIKE && !causes.contains(&other.what) {
                causes.push(other.what.clone());
            }
        });
        wrong.retain(|entry| !entries.contains(entry));
        explanations.push(Explanation { entries: evidence.names(&entries), causes });
    }
    if let Some(formulas) = evidence.formulas.filter(|_| !wrong.is_empty()) {
        let slips = formulas.slips();
        wrong.retain(|entry| {
            let found = doubles::explain(evidence, &slips, *entry);
            let is_left = found.is_none();
            explanations.extend(found);
            is_left
        });
    }
    (explanations, evidence.names(&wrong))
}

/// The guess that explains most of what is wrong; of those the one that breaks least, and of those the plainest.
fn best<'a>(right: &'a [Right], wrong: &[usize]) -> Option<&'a Right> {
    let explains = right.iter().filter(|guess| !explained(guess, wrong).is_empty());
    explains.min_by_key(|guess| (wrong.len() - explained(guess, wrong).len(), guess.broken, guess.rank))
}

fn explained(guess: &Right, wrong: &[usize]) -> Vec<usize> {
    guess.explained.iter().filter(|entry| wrong.contains(entry)).copied().collect()
}

impl Evidence<'_> {
    fn n(&self) -> usize {
        self.info.coordinates.len()
    }

    fn names(&self, entries: &[usize]) -> Vec<String> {
        entries.iter().map(|entry| entry_name(self.n(), *entry)).collect()
    }

    /// The entries that differ.
    fn wrong(&self) -> Vec<usize> {
        let differs = |entry: &usize| self.designs.iter().any(|at| !at.is_by_hand(*entry, at.exact[*entry], self.same));
        (0..MatrixName::ALL.len() * self.n() * self.n()).filter(differs).collect()
    }

    fn judge(&self, guess: &Guess<'_>, wrong: &[usize], rank: usize) -> Option<Right> {
        let mut explained = wrong.to_vec();
        let mut broken: Vec<usize> = Vec::new();
        for at in &self.designs {
            let entries = (guess.entries)(at)?;
            explained.retain(|entry| at.is_by_hand(*entry, entries[*entry], self.same));
            if explained.is_empty() {
                return None;
            }
            let breaks = |entry: &usize| !wrong.contains(entry) && !at.is_by_hand(*entry, entries[*entry], self.same);
            broken.extend((0..entries.len()).filter(breaks));
        }
        broken.sort_unstable();
        broken.dedup();
        let broken = broken.len();
        let Guess { what, of_entries, is_another, .. } = guess;
        (*of_entries || broken == 0).then(|| Right {
            what: what.clone(),
            is_another: *is_another,
            explained,
            broken,
            rank,
        })
    }
}

/// Reads `C1_12`.
pub fn entry_name(n: usize, position: usize) -> String {
    let (matrix, row, column) = place(position, n);
    carvallo_slips::entry_name(matrix, row, column)
}

fn position(n: usize, (matrix, row, column): Place) -> usize {
    index(matrix, row, column, n)
}
