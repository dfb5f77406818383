//! Two slips in one formula.

use std::ops::Range;

use carvallo::Expression;

use crate::formulas::{Formulas, Values};
use crate::list::FormulaSlip;
use crate::slip::{Kind, Slip};
use crate::words::terms;

/// Two slips in one formula, the first of which stands before the second.
#[derive(Clone, Debug)]
pub struct DoubleSlip {
    /// The formulas that have them: the same text in several places of a matrix.
    pub formulas: Vec<usize>,
    /// The slips, in the order of the text.
    pub slips: [Slip; 2],
}

impl DoubleSlip {
    /// The formula with both.
    pub fn apply(&self, formula: &str) -> String {
        let [first, second] = &self.slips;
        first.apply(&second.apply(formula))
    }

    /// How unlikely they are.
    pub fn rank(&self) -> u32 {
        self.slips.iter().map(|slip| if is_likely(slip) { 2 } else { 5 }).sum()
    }
}

fn is_likely(slip: &Slip) -> bool {
    !matches!(slip.kind, Kind::OtherName | Kind::SumOrProduct)
}

/// A slip with what the formula is with it alone, and the term of it that it stands in, if it is in one.
struct Single<'a> {
    slip: &'a Slip,
    value: f64,
    term: Option<usize>,
}

impl Formulas {
    /// The pairs of slips in a formula, or in one that several have, which make this value of it, within a tolerance, each with the
    /// formula that it makes. In one term one at most is another name altogether, or a sum for a product.
    pub fn doubles(
        &self,
        slips: &[FormulaSlip],
        formulas: &[usize],
        (parameters, values): (&[f64], &Values),
        (value, tolerance): (f64, f64),
    ) -> Vec<(DoubleSlip, Expression)> {
        let text = self.formulas[formulas[0]].text;
        let here = self.parse(formulas[0], text).map_or(f64::NAN, |own| values.of(&own, parameters));
        let terms = terms(text);
        let single = |own: &'_ FormulaSlip| -> (f64, Option<usize>) {
            let is_in = |term: &Range<usize>| term.start <= own.slip.place.start && own.slip.place.end <= term.end;
            (values.of(&own.changed, parameters), terms.iter().position(is_in))
        };
        let own = slips.iter().filter(|slip| slip.formulas == formulas[..1]);
        let mut singles: Vec<Single> = own
            .map(|own| {
                let (value, term) = single(own);
                Single { slip: &own.slip, value, term }
            })
            .collect();
        singles.sort_by_key(|own| own.slip.place.start);
        let mut found = Vec::new();
        for (at, first) in singles.iter().enumerate() {
            for second in &singles[at + 1..] {
                if first.slip.place.end > second.slip.place.start {
                    continue;
                }
                match first.term.zip(second.term) {
                    // Terms are added, so that it is known what both make.
                    Some((a, b)) if a != b => {
                        let both = first.value + second.value - here;
                        let rounding = 1e-9 * (first.value.abs() + second.value.abs() + here.abs());
                        if (both - value).abs() > tolerance + rounding {
                            continue;
                        }
                    }
                    _ if !(is_likely(first.slip) || is_likely(second.slip)) => continue,
                    _ => {}
                }
                let slips = [first.slip.clone(), second.slip.clone()];
                let double = DoubleSlip { formulas: formulas.to_vec(), slips };
                let Some(changed) = self.parse(formulas[0], &double.apply(text)) else { continue };
                let is_off = (values.of(&changed, parameters) - value).abs() > tolerance;
                if !is_off && !self.is_circular(formulas, &changed) {
                    found.push((double, changed));
                }
            }
        }
        found
    }
}
