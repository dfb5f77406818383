//! One law: the force on a coordinate as a sum of gains, and what can be wrong with it.

use carvallo::{CoordinateInfo, MatrixName, ModelInfo, States};

use super::parse::{Symbol, parse};
use super::terms::{Motion, Term};
use super::{Gain, Input};
use crate::motion_names::{is_called, of_rate};
use crate::nearest::nearest;
use crate::number::unit;
use crate::quantity::units;

/// More than this is no law that somebody wrote, and would take long.
const LONGEST: usize = 100_000;

/// A force on a coordinate that follows from the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    /// As it was written.
    pub written: String,
    /// What the force acts on.
    pub input: Input,
    /// What it is the sum of.
    pub gains: Vec<Gain>,
}

impl Law {
    /// A law for a model, as `Tdelta = -10*phi_rate + 3*v*phi`.
    ///
    /// # Errors
    /// What is wrong with it, and what was expected.
    pub fn read(text: &str, info: &ModelInfo) -> Result<Self, String> {
        if cfg!(feature = "full") && text.len() > LONGEST {
            return Err(format!("a law of {} bytes: at most {LONGEST} are read", text.len()));
        }
        let example = example(info);
        let (force, law) = text.split_once('=').ok_or_else(|| format!("expected FORCE = LAW, such as {example}"))?;
        let input = Input::called(force.trim(), info)?;
        let read = |of_force| -> Result<Vec<Gain>, String> {
            let sum = parse(law, of_force, &|name| symbol(name, info));
            let sum = sum.map_err(|problem| format!("{problem}; for example {example}"))?;
            let gains = sum.iter().filter(|term| term.value != 0.0 || term.motion.is_none());
            gains.map(|term| gain(term, input, info)).collect()
        };
        // People write `lb*in` for torques. The page, which is small, takes no such forces.
        let gains = match read(false) {
            Err(problem) if cfg!(feature = "full") => read(true).map_err(|_| problem)?,
            gains => gains?,
        };
        if gains.is_empty() {
            return Err("the force is always 0; expected one that follows from the motion".to_owned());
        }
        Ok(Self { written: text.trim().to_owned(), input, gains })
    }

    /// What the force is called, as `Tdelta`, and its unit as models declare it: `N*m` on an angle, `N` on a length, else `1`.
    pub fn force(&self, info: &ModelInfo) -> (String, &'static str) {
        (self.input.names(info).swap_remove(0), self.input.unit(info).unwrap_or("1"))
    }
}

/// What a name stands for in a law.
fn symbol(name: &str, info: &ModelInfo) -> Result<Symbol, String> {
    if name == "v" {
        return Ok(Symbol::Speed);
    }
    let stem = of_rate(name);
    let called = |wanted: &str| info.coordinates.iter().position(|own| is_called(own.name, own.label, wanted));
    // A coordinate may itself end like a rate.
    if let Some((coordinate, is_rate)) =
        called(name).map(|own| (own, false)).or_else(|| stem.and_then(called).map(|own| (own, true)))
    {
        let CoordinateInfo { name, states, .. } = info.coordinates[coordinate];
        return match (states, is_rate) {
            (States::Rate, false) => Err(format!("of `{name}` only the rate is a state; expected `{name}_rate`")),
            (States::Position, true) => Err(format!("of `{name}` only the position is a state; expected `{name}`")),
            _ => Ok(Symbol::Motion(Motion { coordinate, is_rate })),
        };
    }
    if info.position(name).is_some() {
        return Err(format!("`{name}` is a parameter of {}; expected its value: gains are numbers", info.name));
    }
    let names: Vec<String> = info.coordinates.iter().flat_map(of_coordinate).chain(["v".to_owned()]).collect();
    let hint = nearest(name, names.iter().map(String::as_str));
    let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
    Err(format!("`{name}` is neither a position nor a rate of {}{hint}\nthey are {}", info.name, names.join(", ")))
}

/// The positions and rates of a coordinate that are states.
fn of_coordinate(CoordinateInfo { name, states, .. }: &CoordinateInfo) -> Vec<String> {
    let (position, rate) = ((*name).to_owned(), format!("{name}_rate"));
    match states {
        States::Both => vec![position, rate],
        States::Position => vec![position],
        States::Rate => vec![rate],
    }
}

/// A term as what it adds to a matrix.
fn gain(term: &Term, input: Input, info: &ModelInfo) -> Result<Gain, String> {
    let Some(Motion { coordinate: column, is_rate }) = term.motion else {
        return Err(format!(
            "a part of the force does not depend on the motion; expected terms that each have a position or a rate, such as \
             `{}`: a constant force would keep the machine from its reference motion",
            of_coordinate(&info.coordinates[0])[0]
        ));
    };
    let name = info.coordinates[column].name;
    let what = if is_rate { format!("{name}_rate") } else { name.to_owned() };
    let matrix = match (is_rate, term.power) {
        (true, -1) => MatrixName::Cm1,
        (true, 0) => MatrixName::C0,
        (true, 1) => MatrixName::C1,
        (false, 0) => MatrixName::Kc,
        (false, 1) => MatrixName::K1,
        (false, 2) => MatrixName::K2,
        (_, power) => {
            let powers = if is_rate { "a rate has 1/v, 1 and v" } else { "a position has 1, v and v^2" };
            return Err(format!(
                "`{what}` is multiplied by v^{power}; the equations of motion have no such term: {powers}"
            ));
        }
    };
    if !term.value.is_finite() {
        return Err(format!("what multiplies `{what}` is {}; it must be finite", term.value));
    }
    check_unit(term, input, column, is_rate, &what, info)?;
    Ok(Gain { matrix, input, column, value: term.value })
}

/// Whether a gain with a unit makes a force or torque.
fn check_unit(
    term: &Term,
    input: Input,
    column: usize,
    is_rate: bool,
    what: &str,
    info: &ModelInfo,
) -> Result<(), String> {
    let motion = info.coordinates[column].unit;
    // Of given matrices nothing is known.
    let Some(force) = input.unit(info) else { return Ok(()) };
    let (Some(written), true, "rad" | "m") = (term.unit, term.has_unit, motion) else { return Ok(()) };
    let powers = |text: &str| units::in_si(text, false).map_or([0; 3], |(powers, _)| powers);
    let ([force_powers, motion_powers], rate) = ([force, motion].map(powers), i32::from(is_rate));
    let required = [0, 1, 2].map(|index| {
        let speed = [0, 1, -1][index] * term.power;
        let motion = motion_powers[index] - if index == 2 { rate } else { 0 };
        force_powers[index] - motion - speed
    });
    if written == required {
        return Ok(());
    }
    let speed = match term.power {
        0 => String::new(),
        1 => " and v".to_owned(),
        power => format!(" and v^{power}"),
    };
    let expected = in_words(required);
    Err(format!("the unit of what multiplies `{what}`{speed} makes no force in {}; expected {expected}", unit(force)))
}

/// Powers of kilogram, metre and second as `N m s`.
fn in_words([kg, m, s]: [i32; 3]) -> String {
    // A force for each kilogram.
    let parts = [("N", kg), ("m", m - kg), ("s", s + 2 * kg)];
    let text = |(name, power): (&str, i32)| match power {
        0 => None,
        1 => Some(name.to_owned()),
        power => Some(format!("{name}^{power}")),
    };
    parts.into_iter().filter_map(text).collect::<Vec<_>>().join(" ")
}

/// A law for messages.
fn example(info: &ModelInfo) -> String {
    let force = Input::all(info).pop().map(|own| own.names(info).swap_remove(0)).unwrap_or_default();
    let motion = info.coordinates.first().and_then(|own| of_coordinate(own).pop()).unwrap_or_default();
    format!("'{force} = -10*{motion}'")
}
