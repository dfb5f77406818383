//! Equivalent shapes of one formula, all of them made by the engine.

use std::cell::RefCell;
use std::collections::HashMap;

use symbolica::atom::{Atom, AtomCore, AtomView, Indeterminate};

use super::super::atoms::expanded_terms;
use super::super::form::Form;

/// How a formula is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// As the engine has it from the declaration.
    Written,
    /// With common factors in front of sums.
    Collected,
    /// As a product of factors that have none themselves.
    Factored,
    /// Expanded, and then with common factors in front.
    Nested,
    /// Over one denominator, expanded, and then with common factors in front.
    Together,
    /// Sorted by its sines, cosines and roots.
    ByFunctions,
    /// Sorted by what it is linear in, such as masses, with what belongs to each as a product.
    ByLinear,
    /// Sorted by what it divides by, the rest as it is written: sums that stand in other formulas too stay whole.
    ByDivisors,
}

/// Formulas with more operations than this are not rewritten.
const MAX_REWRITTEN: usize = 150;

/// Formulas that could expand into more terms than this are not rewritten, such as fractions in fractions in fractions.
const MAX_EXPANDED: f64 = 300.0;

/// Fractions that stay fractions and could expand into more terms than this are not sorted: each of their coefficients is
/// such a fraction, too, and the engine then takes tens of milliseconds to sort a term.
const MAX_SORTED: f64 = 50.0;

/// What was rewritten before, since the shapes of a formula have many parts in common, with each other and with those of
/// other formulas.
#[derive(Default)]
pub struct Rewritten {
    nested: RefCell<HashMap<Atom, Atom>>,
    factored: RefCell<HashMap<Atom, Atom>>,
}

impl Rewritten {
    fn once(known: &RefCell<HashMap<Atom, Atom>>, atom: &Atom, rewrite: impl FnOnce() -> Atom) -> Atom {
        if let Some(before) = known.borrow().get(atom) {
            return before.clone();
        }
        let after = rewrite();
        known.borrow_mut().insert(atom.clone(), after.clone());
        after
    }

    fn factor(&self, atom: &Atom) -> Atom {
        Self::once(&self.factored, atom, || atom.factor())
    }

    /// The same with common factors in front of every sum in it, in the order that takes the fewest operations.
    fn nested(&self, atom: &Atom) -> Atom {
        atom.replace_map_bottom_up(|view, _, out| {
            if let AtomView::Add(_) = view {
                **out = Self::once(&self.nested, &view.to_owned(), || nest(view));
            }
        })
    }
}

/// Distinct shapes, the cheapest first.
pub fn shapes_of(form: &Form, rewritten: &Rewritten) -> Vec<(Shape, Form)> {
    let atom = &form.0;
    let mut shapes = vec![(Shape::Written, form.clone())];
    let mut add = |shape, atom| {
        if shapes.iter().all(|(_, other)| other.0 != atom) {
            shapes.push((shape, Form(atom)));
        }
    };
    let terms = expanded_terms(atom.as_view());
    // One operation cannot become fewer.
    if (2..=MAX_REWRITTEN).contains(&form.operations()) && terms <= MAX_EXPANDED {
        let divides = atom.count_operations().inversions > 0;
        let flat = if divides { atom.together().expand() } else { atom.expand() };
        if divides_by_a_sum(atom.as_view()) {
            add(Shape::Factored, rewritten.nested(&rewritten.factor(&flat)));
        } else {
            add(Shape::Collected, rewritten.nested(atom));
            add(Shape::Factored, rewritten.nested(&rewritten.factor(atom)));
            add(Shape::Nested, rewritten.nested(&if divides { atom.expand() } else { flat.clone() }));
            add(Shape::ByDivisors, by_divisors(atom, rewritten));
        }
        add(Shape::Together, rewritten.nested(&flat));
        if terms <= MAX_SORTED || !divides_by_a_sum(flat.as_view()) {
            add(Shape::ByFunctions, by_functions(&flat, rewritten));
            add(Shape::ByLinear, rewritten.nested(&by_linear(&flat, rewritten)));
        }
    }
    shapes.sort_by_cached_key(|(_, form)| cost(&form.0));
    shapes
}

fn can_be_rewritten(form: &Form) -> bool {
    form.operations() <= MAX_REWRITTEN && expanded_terms(form.0.as_view()) <= MAX_EXPANDED
}

impl Form {
    /// Whether it divides by a sum, even once it is over one denominator and what can be is cancelled.
    pub(super) fn is_fraction(&self) -> bool {
        divides_by_a_sum(self.0.as_view()) && can_be_rewritten(self) && divides_by_a_sum(self.0.together().as_view())
    }
}

fn divides_by_a_sum(view: AtomView<'_>) -> bool {
    let mut found = false;
    view.visitor(&mut |part| {
        if let AtomView::Pow(power) = part {
            let negative = i64::try_from(power.get_exp()).is_ok_and(|exponent| exponent < 0);
            found |= negative && matches!(power.get_base(), AtomView::Add(_));
        }
        !found
    });
    found
}

/// What a formula takes by itself, in additions: a call counts once however often it occurs.
pub fn cost(atom: &Atom) -> usize {
    let count = atom.count_operations();
    count.additions + count.multiplications + 4 * count.inversions + 20 * functions(atom.as_view()).len()
}

fn cheapest<const N: usize>(forms: [Atom; N]) -> Atom {
    forms.into_iter().min_by_key(cost).unwrap_or_default()
}

/// A sum with common factors in front.
fn nest(sum: AtomView<'_>) -> Atom {
    let functions = functions(sum).into_iter();
    let functions: Vec<_> = functions.filter_map(|function| Indeterminate::try_from(function).ok()).collect();
    let frequent: Option<&[Indeterminate]> = None;
    let horner = sum.collect_horner(frequent);
    let factors = sum.collect_factors();
    let by_functions = match functions.is_empty() {
        true => factors.clone(),
        false => sum.collect_horner(Some(&functions)).collect_factors(),
    };
    cheapest([sum.to_owned(), factors, by_functions, horner.collect_factors(), horner])
}

fn by_functions(flat: &Atom, rewritten: &Rewritten) -> Atom {
    let functions = functions(flat.as_view());
    let collected = flat.collect_multiple_mapped::<i16>(
        &functions,
        |_, _| {},
        |rest, out| {
            let rest = rest.to_owned();
            let [linear, factored] = [by_linear(&rest, rewritten), rewritten.factor(&rest)];
            **out = cheapest([&rest, &linear, &factored].map(|rest| rewritten.nested(rest)));
        },
    );
    rewritten.nested(&collected)
}

/// The function calls in a formula, in an order that does not change.
fn functions(view: AtomView<'_>) -> Vec<Atom> {
    let all = view.get_all_indeterminates(false).into_iter();
    let mut functions: Vec<Atom> =
        all.filter(|view| matches!(view, AtomView::Fun(_))).map(|view| view.to_owned()).collect();
    functions.sort();
    functions
}

fn by_linear(flat: &Atom, rewritten: &Rewritten) -> Atom {
    let AtomView::Add(sum) = flat.as_view() else { return flat.clone() };
    let mut linear: HashMap<Atom, bool> = HashMap::new();
    let mut note = |factor: AtomView<'_>| match factor {
        AtomView::Var(_) => {
            linear.entry(factor.to_owned()).or_insert(true);
        }
        AtomView::Pow(power) => {
            linear.insert(power.get_base().to_owned(), false);
        }
        _ => {}
    };
    for term in sum.iter() {
        match term {
            AtomView::Mul(product) => product.iter().for_each(&mut note),
            other => note(other),
        }
    }
    let linear = chosen(linear);
    flat.collect_multiple_mapped::<i16>(
        &linear,
        |_, _| {},
        |rest, out| {
            let rest = rest.to_owned();
            **out = cheapest([rewritten.factor(&rest), Form(rest).in_sines().0]);
        },
    )
}

/// By the symbols and calls that a formula divides by and nowhere multiplies by.
fn by_divisors(atom: &Atom, rewritten: &Rewritten) -> Atom {
    let plain = |view: AtomView<'_>| matches!(view, AtomView::Var(_) | AtomView::Fun(_));
    let mut divisors: HashMap<Atom, bool> = HashMap::new();
    atom.visitor(&mut |view| match view {
        AtomView::Pow(power) if i64::try_from(power.get_exp()).is_ok_and(|exponent| exponent < 0) => {
            let base = power.get_base();
            if plain(base) {
                divisors.entry(base.to_owned()).or_insert(true);
            }
            !plain(base)
        }
        view if plain(view) => {
            divisors.insert(view.to_owned(), false);
            true
        }
        _ => true,
    });
    let divisors = chosen(divisors);
    let apart = divisors.iter().fold(atom.clone(), |atom, divisor| atom.expand_in(divisor));
    apart.collect_multiple_mapped::<i16>(&divisors, |_, _| {}, |rest, out| **out = rewritten.nested(&rest.to_owned()))
}

/// Those that are marked, in an order that does not change.
fn chosen(marked: HashMap<Atom, bool>) -> Vec<Atom> {
    let mut chosen: Vec<Atom> = marked.into_iter().filter(|(_, mark)| *mark).map(|(atom, _)| atom).collect();
    chosen.sort();
    chosen
}
