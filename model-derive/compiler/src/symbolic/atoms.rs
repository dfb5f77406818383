//! What the parts of this folder ask of Symbolica's formulas.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::symbol;

/// The number π.
pub fn pi() -> Atom {
    symbol_at(0).to_atom()
}

/// The symbol of the parameter at a position.
pub fn parameter(index: usize) -> Symbol {
    symbol_at(index + 1)
}

/// The symbol at a position of the one sequence that there is. The engine looks symbols up by their names, which takes
/// longer than most of what is done with them.
pub fn symbol_at(index: usize) -> Symbol {
    let mut symbols = SYMBOLS.lock().unwrap_or_else(PoisonError::into_inner);
    while symbols.len() <= index {
        let next = symbols.len();
        symbols.push(symbol!(format!("carvallo::x{next}")));
    }
    symbols[index]
}

/// All symbols so far: they live as long as the process.
static SYMBOLS: Mutex<Vec<Symbol>> = Mutex::new(Vec::new());

/// The operations and calls that a formula takes as it stands.
pub fn operations(atom: &Atom) -> usize {
    let count = atom.count_operations();
    count.additions + count.multiplications + count.inversions + count.function_calls
}

/// The argument, if `view` is a call of `function`.
pub fn call_of(view: AtomView<'_>, function: Symbol) -> Option<Atom> {
    let AtomView::Fun(call) = view else { return None };
    let argument = call.iter().next().filter(|_| call.get_symbol() == function)?;
    Some(argument.to_owned())
}

/// At most about so many terms stand in the numerator once all is expanded over one denominator.
pub fn expanded_terms(view: AtomView<'_>) -> f64 {
    let mut divisors = Divisors::new();
    let terms = terms(view, 1, &mut divisors);
    divisors.into_values().fold(terms, |terms, (divisor, power)| terms * terms_of_power(divisor, power))
}

/// For each divisor its terms and its power.
type Divisors = HashMap<Atom, (f64, u64)>;

/// The terms of a numerator; the divisors are noted, equal ones once. All stands inside a power.
fn terms(view: AtomView<'_>, power: u64, divisors: &mut Divisors) -> f64 {
    match view {
        AtomView::Add(sum) => sum.iter().map(|term| terms(term, power, divisors)).sum(),
        AtomView::Mul(product) => product.iter().map(|factor| terms(factor, power, divisors)).product(),
        AtomView::Pow(whole) => {
            let (base, exponent) = whole.get_base_exp();
            // A root is a symbol like any other.
            let Ok(exponent) = i64::try_from(exponent) else { return 1.0 };
            let inner = power.saturating_mul(exponent.unsigned_abs());
            let base_terms = terms(base, inner, divisors);
            if exponent > 0 {
                return terms_of_power(base_terms, exponent.unsigned_abs());
            }
            let (_, known) = divisors.entry(base.to_owned()).or_insert((base_terms, inner));
            *known = inner.max(*known);
            1.0
        }
        AtomView::Num(_) | AtomView::Var(_) | AtomView::Fun(_) => 1.0,
    }
}

/// A power with more factors than this has more terms than anyone asks for.
const MANY_TERMS: u64 = 5_000;

/// As many as there are ways to choose the factors of a term: n + t - 1 over n.
fn terms_of_power(terms: f64, power: u64) -> f64 {
    (1..=power.min(MANY_TERMS)).fold(1.0, |all, n| all * (terms + n as f64 - 1.0) / n as f64)
}
