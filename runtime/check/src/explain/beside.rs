//! Slips of one formula beside those of another one, without evaluating both each time.

use carvallo::Expression;
use carvallo_slips::{FormulaSlip, Values};

use crate::machine::Machine;

/// What must hold of the entries of matrices, and is tried before everything else.
pub trait Condition {
    /// Whether it does for these.
    fn holds(&self, entries: &[f64]) -> bool;

    /// Whether it may hold for each value of a formula, around that which it has here; `entries` makes the matrices of another one.
    /// `None` where that is not told more easily than by these.
    fn curve(&self, here: f64, entries: &mut dyn FnMut(f64) -> Vec<f64>) -> Option<Box<dyn Fn(f64) -> bool>>;
}

/// How many pairs may still be compared and evaluated.
pub struct Left {
    pub compared: usize,
    pub evaluated: usize,
}

/// Slips that are all of the same formulas.
pub type Slips<'a, 'b> = &'b [&'a FormulaSlip];

/// Tells the pairs of slips in two formulas with which a condition holds that is made of some of the formulas that change; the first
/// formula does not depend on the second.
pub fn pairs<'a>(
    machine: &Machine,
    condition: &dyn Condition,
    made_of: &[usize],
    [firsts, seconds]: [Slips<'a, '_>; 2],
    is_meant: &dyn Fn(&FormulaSlip, &FormulaSlip) -> bool,
    left: &mut Left,
    tell: &mut dyn FnMut(&'a FormulaSlip, &'a FormulaSlip),
) {
    let Machine { formulas, parameters, values: base, .. } = machine;
    let (Some(first), Some(second)) = (firsts.first(), seconds.first()) else { return };
    let (first, second) = (&first.formulas[..], &second.formulas[..]);
    let uses = |slip: &FormulaSlip, other: &[usize]| other.iter().any(|own| formulas.uses(&slip.changed, *own));
    // What each slip of the second makes of its formula, where that does not depend on the first.
    let value = |own: &&'a FormulaSlip| (!uses(own, first)).then(|| base.of(&own.changed, parameters));
    let seconds: Vec<(&FormulaSlip, Option<f64>)> = seconds.iter().map(|own| (*own, value(own))).collect();
    let here = base.of_formula(formulas, second[0]);
    let mut values: Values = base.clone();
    for &a in firsts {
        if !seconds.iter().any(|(b, _)| is_meant(a, b)) {
            continue;
        }
        let of_first = (first, &a.changed);
        let uses_second = uses(a, second);
        let mut curve = None;
        let mut beside = base.clone();
        if !uses_second {
            formulas.change(first, &a.changed, parameters, &mut beside);
            curve = condition.curve(here, &mut |value| {
                let number = Expression::Number(String::new(), value);
                values.clone_from(base);
                formulas.change_both([of_first, (second, &number)], made_of, parameters, &mut values);
                values.entries.clone()
            });
        }
        for &(b, value) in seconds.iter().filter(|(b, _)| is_meant(a, b)) {
            if left.compared == 0 || left.evaluated == 0 {
                return;
            }
            left.compared -= 1;
            let of_second = || value.unwrap_or_else(|| beside.of(&b.changed, parameters));
            if curve.as_ref().is_some_and(|may_hold| !may_hold(of_second())) || (uses_second && value.is_none()) {
                continue;
            }
            left.evaluated -= 1;
            values.clone_from(base);
            formulas.change_both([of_first, (second, &b.changed)], made_of, parameters, &mut values);
            if condition.holds(&values.entries) {
                tell(a, b);
            }
        }
    }
}
