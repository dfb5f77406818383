//! The addition theorems: sines and cosines of sums and multiples in those of single angles.

use std::collections::HashMap;

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::domains::integer::Integer;
use symbolica::domains::rational::Rational;
use symbolica::transcendental::{sec, tan};

use super::atoms::{call_of, expanded_terms, pi};

/// For each angle in a formula, without its number, the part of it of which all its multiples there are whole ones: for
/// the `t` of `sin(t/2) + cos(t/3)` a sixth.
#[derive(Debug, Default)]
pub struct Angles(HashMap<Atom, Integer>);

/// The theorems double the terms with each summand and each multiple; beyond these they are not used.
const MAX_SUMMANDS: usize = 4;
const MAX_MULTIPLE: i64 = 8;

/// An argument that could expand into more terms, as one that holds expanded tangents can, is a single angle.
const MAX_EXPANDED: f64 = 500.0;

impl Angles {
    /// Those of a formula.
    pub fn of(atom: &Atom) -> Self {
        let mut angles = Self::default();
        angles.note(atom.as_view());
        angles
    }

    fn note(&mut self, view: AtomView<'_>) {
        match view {
            AtomView::Add(sum) => sum.iter().for_each(|term| self.note(term)),
            AtomView::Mul(product) => product.iter().for_each(|factor| self.note(factor)),
            AtomView::Pow(power) => self.note(power.get_base()),
            AtomView::Fun(_) => {
                let called = [Symbol::SIN, Symbol::COS, tan(), sec()].into_iter().find_map(|f| call_of(view, f));
                let Some(argument) = called else { return };
                for (number, angle) in summands(&argument).iter().map(split) {
                    let parts = self.0.entry(angle).or_insert(Integer::one());
                    *parts = parts.lcm(number.denominator_ref());
                }
                self.note(argument.as_view());
            }
            AtomView::Num(_) | AtomView::Var(_) => {}
        }
    }

    /// Sine and cosine of a sum in those of the parts of its angles.
    pub fn sine_and_cosine(&self, argument: &Atom) -> (Atom, Atom) {
        let summands = summands(argument);
        if summands.len() > MAX_SUMMANDS {
            return (argument.sin(), argument.cos());
        }
        let parts = summands.iter().map(|summand| self.multiple(summand));
        // Not from zero on: nearly all sums have one part, and each step takes the engine a while.
        parts.reduce(add).unwrap_or_else(|| (Atom::num(0), Atom::num(1)))
    }

    fn multiple(&self, summand: &Atom) -> (Atom, Atom) {
        let turns = summand / pi() * Atom::num(2);
        if let Ok(quarters) = i64::try_from(turns.as_view()) {
            let [sine, cosine] = [quarters, quarters + 1].map(|quarter| [0, 1, 0, -1][quarter.rem_euclid(4) as usize]);
            return (Atom::num(sine), Atom::num(cosine));
        }
        let (number, angle) = split(summand);
        let parts = Rational::from(self.0.get(&angle).cloned().unwrap_or(Integer::one()));
        let whole = i64::try_from(Atom::num(number * &parts).as_view()).ok().filter(|n| n.abs() <= MAX_MULTIPLE);
        let Some(whole) = whole else { return (summand.sin(), summand.cos()) };
        let part = angle / Atom::num(parts);
        let one = (part.sin(), part.cos());
        let (sine, cosine) = (1..whole.abs()).fold(one.clone(), |sum, _| add(sum, one.clone()));
        if whole < 0 { (-sine, cosine) } else { (sine, cosine) }
    }
}

fn add((sine, cosine): (Atom, Atom), (other_sine, other_cosine): (Atom, Atom)) -> (Atom, Atom) {
    (&sine * &other_cosine + &cosine * &other_sine, cosine * other_cosine - sine * other_sine)
}

/// The terms of an argument once it is expanded.
fn summands(argument: &Atom) -> Vec<Atom> {
    if expanded_terms(argument.as_view()) > MAX_EXPANDED {
        return vec![argument.clone()];
    }
    let argument = argument.expand();
    match argument.as_view() {
        AtomView::Add(sum) => sum.iter().map(|term| term.to_owned()).collect(),
        _ => vec![argument],
    }
}

/// The number in a product, and the rest.
fn split(product: &Atom) -> (Rational, Atom) {
    let factor = match product.as_view() {
        AtomView::Mul(factors) => factors.iter().find_map(|factor| Rational::try_from(factor).ok()),
        _ => None,
    };
    match factor.filter(|number| !number.is_zero()) {
        Some(number) => (number.clone(), product / Atom::num(number)),
        None => (Rational::from(1), product.clone()),
    }
}
