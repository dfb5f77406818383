//! Every slip of every formula of a model: the one list that is tried.

use carvallo::Expression;

use crate::formulas::{Formulas, Subject, Values};
use crate::slip::{Kind, Slip};
use crate::text::slips;

/// A slip in a formula of a model, or in one that several entries share.
#[derive(Clone, Debug)]
pub struct FormulaSlip {
    /// The formulas that have it: the same text in several places of a matrix.
    pub formulas: Vec<usize>,
    /// The slip.
    pub slip: Slip,
    /// The formula with the slip.
    pub changed: Expression,
    /// Whether it uses itself so, and has no value.
    pub is_circular: bool,
    /// Whether it still makes sense by the units of what is in it, as far as they are known.
    pub makes_sense: bool,
}

impl FormulaSlip {
    /// How unlikely it is.
    pub fn rank(&self) -> u32 {
        if self.makes_sense { self.slip.kind.rank() } else { self.slip.kind.rank_without_sense() }
    }

    /// Makes the values those with the slip, for parameters for which the formulas have the values of `base`; whether there
    /// are any.
    pub fn apply(&self, formulas: &Formulas, parameters: &[f64], base: &Values, own: &mut Values) -> bool {
        if !self.is_circular {
            own.clone_from(base);
            formulas.change(&self.formulas, &self.changed, parameters, own);
        }
        !self.is_circular
    }
}

impl Formulas {
    /// Every slip of every formula, in their order; those of a formula that several entries share in all of them, and in
    /// each alone. An entry that is negative, twice or half as a whole is no slip in its formula, unless several share it.
    pub fn slips(&self) -> Vec<FormulaSlip> {
        let mut found = Vec::new();
        for (at, formula) in self.formulas.iter().enumerate().filter(|(_, formula)| formula.is_tried) {
            let is_shared = formula.shared.len() > 1;
            let is_entry = matches!(formula.subject, Subject::Entry(..));
            let own = formula.text.trim_start_matches('-').len();
            for slip in slips(formula.text, self.names_in(at)) {
                let is_of_all = matches!(slip.kind, Kind::FactorOfTwo | Kind::Negative) && slip.place.len() == own;
                let is_of_one = !(is_entry && is_of_all);
                if !is_of_one && !is_shared {
                    continue;
                }
                // What is no formula any more is nobody's.
                let Some(changed) = self.parse(at, &slip.apply(formula.text)) else { continue };
                let makes_sense = self.makes_sense(at, &changed);
                let mut push = |formulas: Vec<usize>, slip: Slip, changed: Expression| {
                    let is_circular = self.is_circular(&formulas, &changed);
                    found.push(FormulaSlip { formulas, slip, changed, is_circular, makes_sense });
                };
                if is_shared && formula.shared[0] == at {
                    push(formula.shared.clone(), slip.clone(), changed.clone());
                }
                if is_of_one {
                    push(vec![at], slip, changed);
                }
            }
        }
        found
    }
}
