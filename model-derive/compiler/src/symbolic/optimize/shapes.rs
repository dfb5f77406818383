//! Equivalent shapes of one formula, all of them made by the engine.

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

/// The shapes of formulas, each found once.
#[derive(Default)]
pub struct Shapes {
    known: HashMap<Form, Vec<(Shape, Form)>>,
}

/// A shape that takes so many operations more than another by itself is not tried in its place.
const MAX_WORSE: usize = 3;

impl Shapes {
    /// A formula in a shape; without one, or if it has no such shape of its own, in the one that is cheapest by itself.
    pub fn shaped(&mut self, form: &Form, shape: Option<Shape>) -> Form {
        if shape == Some(Shape::Written) {
            return form.clone();
        }
        let shapes = self.of(form);
        let found = shape.and_then(|shape| shapes.iter().find(|(other, _)| *other == shape));
        found.unwrap_or(&shapes[0]).1.clone()
    }

    /// The shapes of a formula that may be worth a try.
    pub fn worthwhile(&mut self, form: &Form) -> Vec<Shape> {
        let shapes = self.of(form);
        let most = cost(&shapes[0].1.0) + MAX_WORSE;
        shapes.iter().filter(|(_, form)| cost(&form.0) <= most).map(|(shape, _)| *shape).collect()
    }

    /// Whether a formula into which a definition is put takes fewer operations than both.
    pub fn merges(&mut self, formula: &Form, definition: &Form, merged: &Form) -> bool {
        let [formula, merged] = [formula, merged].map(|form| self.of(form)[0].1.operations());
        merged < formula + definition.operations()
    }

    fn of(&mut self, form: &Form) -> &[(Shape, Form)] {
        self.known.entry(form.clone()).or_insert_with(|| shapes_of(form))
    }
}

/// Distinct shapes, the cheapest first.
pub(super) fn shapes_of(form: &Form) -> Vec<(Shape, Form)> {
    let atom = &form.0;
    let mut shapes = vec![(Shape::Written, form.clone())];
    let mut add = |shape, atom| {
        if shapes.iter().all(|(_, other)| other.0 != atom) {
            shapes.push((shape, Form(atom)));
        }
    };
    // One operation cannot become fewer.
    if form.operations() > 1 && can_be_rewritten(form) {
        let divides = atom.count_operations().inversions > 0;
        let flat = if divides { atom.together().expand() } else { atom.expand() };
        if divides_by_a_sum(atom.as_view()) {
            add(Shape::Factored, nested(&flat.factor()));
        } else {
            add(Shape::Collected, nested(atom));
            add(Shape::Factored, nested(&atom.factor()));
            add(Shape::Nested, nested(&atom.expand()));
            add(Shape::ByDivisors, by_divisors(atom));
        }
        add(Shape::Together, nested(&flat));
        add(Shape::ByFunctions, by_functions(&flat));
        add(Shape::ByLinear, nested(&by_linear(&flat)));
    }
    shapes.sort_by_key(|(_, form)| cost(&form.0));
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
fn cost(atom: &Atom) -> usize {
    let count = atom.count_operations();
    count.additions + count.multiplications + 4 * count.inversions + 20 * functions(atom.as_view()).len()
}

fn cheapest<const N: usize>(forms: [Atom; N]) -> Atom {
    forms.into_iter().min_by_key(cost).unwrap_or_default()
}

/// The same with common factors in front of every sum in it, in the order that takes the fewest operations.
fn nested(atom: &Atom) -> Atom {
    atom.replace_map_bottom_up(|view, _, out| {
        if let AtomView::Add(_) = view {
            let frequent: Option<&[Indeterminate]> = None;
            let functions = functions(view).into_iter();
            let functions: Vec<_> = functions.filter_map(|function| Indeterminate::try_from(function).ok()).collect();
            let horner = view.collect_horner(frequent);
            **out = cheapest([
                view.to_owned(),
                view.collect_factors(),
                view.collect_horner(Some(&functions)).collect_factors(),
                horner.collect_factors(),
                horner,
            ]);
        }
    })
}

fn by_functions(flat: &Atom) -> Atom {
    let functions = functions(flat.as_view());
    let collected = flat.collect_multiple_mapped::<i16>(
        &functions,
        |_, _| {},
        |rest, out| {
            let rest = rest.to_owned();
            **out = cheapest([nested(&rest), nested(&by_linear(&rest)), nested(&rest.factor())]);
        },
    );
    nested(&collected)
}

/// The function calls in a formula, in an order that does not change.
fn functions(view: AtomView<'_>) -> Vec<Atom> {
    let all = view.get_all_indeterminates(false).into_iter();
    let mut functions: Vec<Atom> =
        all.filter(|view| matches!(view, AtomView::Fun(_))).map(|view| view.to_owned()).collect();
    functions.sort();
    functions
}

fn by_linear(flat: &Atom) -> Atom {
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
        |rest, out| **out = cheapest([rest.factor(), Form(rest.to_owned()).in_sines().0]),
    )
}

/// By the symbols and calls that a formula divides by and nowhere multiplies by.
fn by_divisors(atom: &Atom) -> Atom {
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
    apart.collect_multiple_mapped::<i16>(&divisors, |_, _| {}, |rest, out| **out = nested(&rest.to_owned()))
}

/// Those that are marked, in an order that does not change.
fn chosen(marked: HashMap<Atom, bool>) -> Vec<Atom> {
    let mut chosen: Vec<Atom> = marked.into_iter().filter(|(_, mark)| *mark).map(|(atom, _)| atom).collect();
    chosen.sort();
    chosen
}
