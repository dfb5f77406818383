//! Slips of one formula beside those of another one, without evaluating both each time.

use carvallo::Expression;
use carvallo_slips::{FormulaSlip, Values};

use super::curve::at_nodes;
use crate::machine::Machine;

/// What must hold of the entries of matrices, and is tried before these are evaluated.
pub trait Condition {
    /// Whether it may hold for each value of a formula, from the entries at the nodes around that which it has here. `None` where that is
    /// not told more easily than by these.
    fn curve(&self, here: f64, nodes: &[Vec<f64>; 4]) -> Option<Box<dyn Fn(f64) -> bool>>;
}

/// How many pairs may still be compared and evaluated.
pub struct Left {
    pub compared: usize,
    pub evaluated: usize,
}

/// Slips of one formula, or of several that have the same text, with those of another one that are tried beside them, by their places.
pub struct Group<'a> {
    pub firsts: Vec<&'a FormulaSlip>,
    pub seconds: Vec<usize>,
}

/// So many slips are worth a curve: as many evaluations as there are nodes.
const WORTH: usize = 4;

/// Tells the pairs of slips in two formulas, of which all groups are of one, with which all conditions may hold, with the values that they make; the first formula does
/// not depend on the second.
pub fn pairs<'a>(
    machine: &Machine,
    conditions: &[&dyn Condition],
    groups: &[Group<'a>],
    seconds: &[&'a FormulaSlip],
    is_meant: &dyn Fn(&FormulaSlip, &FormulaSlip) -> bool,
    left: &mut Left,
    tell: &mut dyn FnMut(&'a FormulaSlip, &'a FormulaSlip, &Values),
) {
    let Machine { formulas, parameters, values: base, .. } = machine;
    let first = groups.iter().find_map(|group| group.firsts.first());
    let (Some(first), Some(second)) = (first, seconds.first()) else { return };
    let (first, second) = (&first.formulas[..], &second.formulas[..]);
    let uses = |slip: &FormulaSlip, other: &[usize]| other.iter().any(|own| formulas.uses(&slip.changed, *own));
    // What each slip of the second makes of its formula, where that does not depend on the first.
    let value = |own: &&'a FormulaSlip| (!uses(own, first)).then(|| base.of(&own.changed, parameters));
    let seconds: Vec<(&FormulaSlip, Option<f64>)> = seconds.iter().map(|own| (*own, value(own))).collect();
    let here = base.of_formula(formulas, second[0]);
    let mut values: Values = base.clone();
    let each = groups.iter().flat_map(|group| group.firsts.iter().map(move |a| (*a, &group.seconds)));
    for (a, others) in each {
        let others = others.iter().map(|at| &seconds[*at]);
        let mut meant: Vec<&(&FormulaSlip, Option<f64>)> = others.filter(|(b, _)| is_meant(a, b)).collect();
        if meant.is_empty() {
            continue;
        }
        if left.compared < meant.len() {
            return;
        }
        left.compared -= meant.len();
        let uses_second = uses(a, second);
        let mut beside = base.clone();
        if uses_second {
            meant.retain(|(_, value)| value.is_some());
        } else {
            formulas.change(first, &a.changed, parameters, &mut beside);
        }
        if !uses_second && meant.len() > WORTH {
            let nodes = at_nodes(here).map(|value| {
                values.clone_from(&beside);
                formulas.change(second, &Expression::Number(String::new(), value), parameters, &mut values);
                values.entries.clone()
            });
            conditions.iter().all(|condition| {
                if let Some(may_hold) = condition.curve(here, &nodes) {
                    meant.retain(|(b, value)| may_hold(value.unwrap_or_else(|| beside.of(&b.changed, parameters))));
                }
                meant.len() > WORTH
            });
        }
        let affected = uses_second.then(|| formulas.affected(first.iter().chain(second).copied()));
        for (b, _) in meant {
            if left.evaluated == 0 {
                return;
            }
            left.evaluated -= 1;
            values.clone_from(&beside);
            match &affected {
                None => formulas.change(second, &b.changed, parameters, &mut values),
                Some(all) => {
                    let both = [(first, &a.changed), (second, &b.changed)];
                    formulas.change_both(both, all, parameters, &mut values);
                }
            }
            tell(a, b, &values);
        }
    }
}
