//! The value that one unknown must have for all numbers to come out as they were given.

use carvallo_design::number::shortest;

use crate::predict::{Predictor, World};
use crate::zero::Zero;

/// Where the search starts, as factors of the value.
const STARTS: [f64; 6] = [1.001, -1.0, 2.0, 0.1, 10.0, 0.0];
const STEPS: usize = 30;

/// The value of an unknown that is `value` here with which everything fits, with the fewest digits that do; `world` makes the
/// matrices of it. By determinants that costs less than by eigenvalues.
pub fn solve(
    predictor: &Predictor,
    value: f64,
    world: &dyn Fn(f64) -> Option<World>,
    is_by_determinants: bool,
) -> Option<f64> {
    if !predictor.has_left() {
        return None;
    }
    let predict = |x: f64| world(x).and_then(|world| predictor.predict_if_tried(&world));
    let scale = if value == 0.0 { 1.0 } else { value };
    let near = value + 1e-3 * scale;
    let by_relations = Told::of_relations(predictor, &world(value)?, &world(near)?)?;
    let told = match by_relations {
        Some(told) => told,
        None if Told::is_by_criticals(predictor, &world(value)?) => {
            Told::of_criticals(predictor, &world(value)?, &world(near)?)?
        }
        None => {
            let of_zeros = || Told::of_zeros(predictor, &world(value)?, &world(near)?);
            let told = if is_by_determinants { of_zeros() } else { None };
            let of_numbers = || Told::of_numbers(predictor, &predict(value)?, &predict(near)?);
            told.or_else(of_numbers)?
        }
    };
    let is_filtered = predictor.is_costly() || matches!(told, Told::Zero(_));
    let is_tried = || !predictor.is_costly() || predictor.spends(1);
    let world_if_tried = |x: f64| if is_tried() { world(x) } else { None };
    let difference = |x: f64| world_if_tried(x).map_or(f64::NAN, |world| told.difference(predictor, &world));
    let may_fit = |x: f64| !is_filtered || world_if_tried(x).is_some_and(|world| predictor.may_fit(&world));
    let fits = |x: f64| world(x).is_some_and(|world| predictor.fits_if_tried(&world));
    let mut tried: Vec<f64> = Vec::new();
    for start in STARTS {
        let Some(x) = root(start * scale, scale, &difference) else { continue };
        if tried.iter().any(|known| (known - x).abs() <= 1e-6 * x.abs()) {
            continue;
        }
        if may_fit(x)
            && let Some(x) = middle(predictor, x, scale, &predict)
            && let Some(x) = simplest(x, scale, &fits)
        {
            return Some(x);
        }
        tried.push(x);
    }
    None
}

/// The value with the fewest digits with which everything fits, beside one that is known nearly and is not zero.
pub fn near(predictor: &Predictor, x: f64, world: &dyn Fn(f64) -> Option<World>) -> Option<f64> {
    let predict = |x: f64| world(x).map(|world| predictor.predict(&world));
    let x = middle(predictor, x, x, &predict)?;
    simplest(x, x, &|x| world(x).is_some_and(|world| predictor.fits(&world)))
}

/// What tells the value best: what is wrong and changes with the unknown by most of its tolerance.
enum Told {
    /// A relation of the entries, which costs little.
    Relation(usize),
    /// What is zero at a critical speed that is given, which costs little.
    Critical(usize),
    /// The determinant that is zero at a real eigenvalue that is given, which costs little.
    Zero(usize),
    /// A number.
    Number(usize),
}

impl Told {
    /// None where something is wrong that does not change with the unknown, and that it does not mend; and no relation where all
    /// of them hold.
    fn of_relations(predictor: &Predictor, here: &World, near: &World) -> Option<Option<Self>> {
        let entries = [here, near].map(|world| predictor.closed_entries(world));
        let (mut told, mut most) = (None, 0.0);
        for (at, relation) in predictor.relations().iter().enumerate() {
            let [off, allowed] = relation.off(&entries[0], here.gravity);
            if off.abs() <= allowed {
                continue;
            }
            let [changed, _] = relation.off(&entries[1], near.gravity);
            let effect = (changed - off).abs() / allowed.max(f64::MIN_POSITIVE);
            if effect == 0.0 {
                return None;
            }
            if effect > most {
                (told, most) = (Some(Self::Relation(at)), effect);
            }
        }
        Some(told)
    }

    /// Whether critical speeds alone are given, of which matrices do not have one.
    fn is_by_criticals(predictor: &Predictor, here: &World) -> bool {
        let entries = predictor.closed_entries(here);
        let criticals = predictor.criticals().iter();
        let mut wrong = criticals.filter(|own| !own.holds(&entries, here.gravity));
        predictor.criticals().len() == predictor.numbers().len()
            && wrong.any(|own| own.off(&entries, here.gravity).is_some())
    }

    /// The first of them; none where what is zero at one of them does not change with the unknown.
    fn of_criticals(predictor: &Predictor, here: &World, near: &World) -> Option<Self> {
        let entries = [here, near].map(|world| predictor.closed_entries(world));
        let mut told = None;
        for (at, own) in predictor.criticals().iter().enumerate() {
            let Some(off) = own.off(&entries[0], here.gravity) else { continue };
            if own.holds(&entries[0], here.gravity) {
                continue;
            }
            if own.off(&entries[1], near.gravity) == Some(off) {
                return None;
            }
            told = told.or(Some(Self::Critical(at)));
        }
        told
    }

    /// The determinant of what is wrong that changes by most of what it may be off; `None` where no real eigenvalue is wrong.
    fn of_zeros(predictor: &Predictor, here: &World, near: &World) -> Option<Self> {
        let entries = [here, near].map(|world| predictor.closed_entries(world));
        let effect = |(at, zero): (usize, &Zero)| {
            let matrices = zero.matrices(&entries[0], here.gravity);
            let [off, allowed] = zero.off(&matrices);
            let change = zero.determinant(&entries[1], near.gravity) - zero.determinant(&entries[0], here.gravity);
            (zero.is_real() && off > allowed).then(|| (at, change.norm() / allowed))
        };
        let all = predictor.zeros().iter().enumerate().filter_map(effect);
        let (at, effect) = all.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (effect > 0.0).then_some(Self::Zero(at))
    }

    fn of_numbers(predictor: &Predictor, here: &[f64], near: &[f64]) -> Option<Self> {
        let effect = |at: usize| (near[at] - here[at]).abs() / predictor.tolerances()[at].max(f64::MIN_POSITIVE);
        let wrong: Vec<usize> = (0..here.len()).filter(|&at| !predictor.agrees(at, here[at])).collect();
        if wrong.iter().any(|&at| effect(at) == 0.0) {
            return None;
        }
        wrong.into_iter().max_by(|&a, &b| effect(a).total_cmp(&effect(b))).map(Self::Number)
    }

    /// By how much it is larger than it should be.
    fn difference(&self, predictor: &Predictor, world: &World) -> f64 {
        match *self {
            Self::Relation(at) => {
                let [off, _] = predictor.relations()[at].off(&predictor.closed_entries(world), world.gravity);
                off
            }
            Self::Critical(at) => {
                let off = predictor.criticals()[at].off(&predictor.closed_entries(world), world.gravity);
                off.unwrap_or(f64::NAN)
            }
            Self::Zero(at) => predictor.zeros()[at].determinant(&predictor.closed_entries(world), world.gravity).re,
            Self::Number(at) => predictor.number(at, world) - predictor.numbers()[at].1.value,
        }
    }
}

/// A zero near a start, by secants.
fn root(start: f64, scale: f64, difference: &dyn Fn(f64) -> f64) -> Option<f64> {
    let (mut a, mut b) = (start, start + 1e-4 * scale);
    let (mut of_a, mut of_b) = (difference(a), difference(b));
    for _ in 0..STEPS {
        if of_b == 0.0 {
            return Some(b);
        }
        let next = b - of_b * (b - a) / (of_b - of_a);
        if !next.is_finite() || next.abs() > 1e6 * scale.abs() {
            // Where rounding alone is left, it does not go on.
            return ((b - a).abs() <= 1e-9 * b.abs()).then_some(b);
        }
        (a, of_a) = (b, of_b);
        (b, of_b) = (next, difference(next));
        if (b - a).abs() <= 4.0 * f64::EPSILON * b.abs() {
            return Some(b);
        }
    }
    ((b - a).abs() <= 1e-9 * b.abs()).then_some(b)
}

/// The middle of what all tolerances allow around a value with which one number comes out, to first order; `None` where they
/// allow nothing in common.
fn middle(predictor: &Predictor, x: f64, scale: f64, predict: &dyn Fn(f64) -> Option<Vec<f64>>) -> Option<f64> {
    let step = 1e-6 * scale.abs().max(x.abs());
    let here = predict(x)?;
    if here.iter().any(|own| own.is_nan()) {
        return None;
    }
    let near = predict(x + step)?;
    let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
    for (at, (_, reading)) in predictor.numbers().iter().enumerate() {
        let (slope, tolerance) = ((near[at] - here[at]) / step, predictor.tolerances()[at]);
        let off = reading.value - here[at];
        // What hardly changes with it says nothing, and is told by what fits.
        if slope.abs() * scale.abs() > tolerance {
            let [a, b] = [off - tolerance, off + tolerance].map(|own| own / slope);
            (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
        }
    }
    let middle = if low.is_finite() && high.is_finite() { x + (low + high) / 2.0 } else { x };
    // To first order they may miss each other by a little.
    (low <= high + step).then_some(middle)
}

/// With the fewest digits that fit; `None` if it fits with none. What is nothing beside the scale is zero or nobody's value.
pub fn simplest(x: f64, scale: f64, fits: &dyn Fn(f64) -> bool) -> Option<f64> {
    const NOTHING: f64 = 1e-9;
    if x.abs() <= NOTHING * scale.abs() {
        return fits(0.0).then_some(0.0);
    }
    let rounded = (0..16).filter_map(|digits| format!("{x:.digits$e}").parse().ok());
    rounded.chain([x]).find(|&x| fits(x))
}

/// How many significant digits a number has.
pub fn digits(value: f64) -> usize {
    let text = format!("{value:e}");
    let mantissa = text.split('e').next().unwrap_or_default();
    mantissa.chars().filter(char::is_ascii_digit).count()
}

/// How one number may have become another: `the other sign`, `one digit too many`, or nothing.
pub fn relation(from: f64, to: f64) -> Option<&'static str> {
    if from == to {
        return None;
    }
    let is = |factor: f64| (to - factor * from).abs() <= 1e-9 * to.abs();
    let factors = [
        (-1.0, "the other sign"),
        (10.0, "the decimal point one place farther to the right"),
        (0.1, "the decimal point one place farther to the left"),
        (100.0, "the decimal point two places farther to the right"),
        (0.01, "the decimal point two places farther to the left"),
        (2.0, "twice the value"),
        (0.5, "half of the value"),
    ];
    if let Some((_, what)) = factors.iter().find(|(factor, _)| from != 0.0 && is(*factor)) {
        return Some(what);
    }
    let [old, new] = [from, to].map(|value| shortest(value).chars().collect::<Vec<char>>());
    let without = |longer: &[char], shorter: &[char]| {
        longer.len() == shorter.len() + 1
            && (0..longer.len()).any(|at| longer[..at] == shorter[..at] && longer[at + 1..] == shorter[at..])
    };
    if without(&new, &old) {
        return Some("one digit too many");
    }
    if without(&old, &new) {
        return Some("one digit too few");
    }
    let differ: Vec<usize> =
        if old.len() == new.len() { (0..old.len()).filter(|&at| old[at] != new[at]).collect() } else { Vec::new() };
    match differ[..] {
        [_] => Some("another digit"),
        [a, b] if b == a + 1 && old[a] == new[b] && old[b] == new[a] => Some("two digits exchanged"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{digits, relation, simplest};

    #[test]
    fn digits_are_counted_without_zeros() {
        assert_eq!([19.2, 0.0051, 100.0, -2.5e-7, 0.30000000000000004].map(digits), [3, 2, 1, 2, 17]);
    }

    /// What arithmetic leaves of a stiffness of 1000 N/m is none, or nobody's value.
    #[test]
    fn what_rounding_leaves_is_no_value() {
        let near_zero = |x: f64| x.abs() < 1e-6;
        let not_zero = |x: f64| x != 0.0;
        assert_eq!([simplest(1e-12, 1e3, &near_zero), simplest(1e-12, 1e3, &not_zero)], [Some(0.0), None]);
    }

    #[test]
    fn slips_of_numbers_are_recognised() {
        for (from, to, expected) in [
            (9.2, 19.2, Some("one digit too many")),
            (0.05892, 0.0589, Some("one digit too few")),
            (-0.9, 0.9, Some("the other sign")),
            (85.0, 8.5, Some("the decimal point one place farther to the left")),
            (0.35, 0.53, Some("two digits exchanged")),
            (85.0, 80.0, Some("another digit")),
            (2.4, 5.17, None),
            (3.0, 3.0, None),
        ] {
            assert_eq!(relation(from, to), expected, "{from} {to}");
        }
    }
}
