//! The state at the beginning: `phi=5 deg`, `phi_rate=0.5`.

use std::f64::consts::FRAC_PI_2;

use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Mistake, Reason, no_names, unquoted};
use carvallo_design::{Place, Problem, is_called, nearest, of_rate};

use super::motion::Quantity;

/// What an initial state may be given by.
#[derive(Clone, Debug)]
pub struct Givable {
    /// What moves.
    pub quantity: Quantity,
    /// Why the position cannot be given, if it cannot, as the end of a sentence.
    pub position: Result<(), &'static str>,
    /// The same of the rate.
    pub rate: Result<(), &'static str>,
}

/// Positions and rates in the order of what may be given, zero where nothing is.
#[derive(Clone, Debug, PartialEq)]
pub struct Initial {
    /// In SI units.
    pub positions: Vec<f64>,
    /// In SI units.
    pub rates: Vec<f64>,
    /// What is probably in another unit than was meant.
    pub doubts: Vec<String>,
}

/// # Errors
/// Everything that is wrong.
pub fn initial(options: &[String], givable: &[Givable], model: &str) -> Result<Initial, Vec<Problem>> {
    let [positions, rates] = [(); 2].map(|()| vec![0.0; givable.len()]);
    let mut state = Initial { positions, rates, doubts: Vec::new() };
    let mut given = vec![[false; 2]; givable.len()];
    let mut problems = Vec::new();
    for option in options {
        let place = || Place::Option(format!("--initial {option}"));
        let read = split(option, givable, model).and_then(|(index, is_rate, text)| {
            let value = value(text, &givable[index].quantity, is_rate)?;
            if std::mem::replace(&mut given[index][usize::from(is_rate)], true) {
                return Err("it is given twice".to_owned());
            }
            let doubt = if is_rate { None } else { doubt(text, &givable[index].quantity) };
            state.doubts.extend(doubt);
            Ok((index, is_rate, value))
        });
        match read {
            Ok((index, true, value)) => state.rates[index] = value,
            Ok((index, false, value)) => state.positions[index] = value,
            Err(message) => problems.push(Problem { place: place(), message }),
        }
    }
    if problems.is_empty() { Ok(state) } else { Err(problems) }
}

/// Which quantity is given, whether it is its rate, and the text of the value.
fn split<'a>(option: &'a str, givable: &[Givable], model: &str) -> Result<(usize, bool, &'a str), String> {
    let (name, text) = option.split_once('=').ok_or("expected NAME=VALUE, such as phi=0.1 or phi_rate=0.5")?;
    let name = name.trim();
    let called = |stem: &str| {
        let is_called = |givable: &Givable| is_called(givable.quantity.name, givable.quantity.label, stem);
        givable.iter().position(is_called)
    };
    // A position may itself end like a rate.
    let found = called(name).map(|index| (index, false));
    let Some((index, is_rate)) = found.or_else(|| Some((called(of_rate(name)?)?, true))) else {
        return Err(unknown(name, givable, model));
    };
    let (can_be, what) = match is_rate {
        true => (givable[index].rate, "rate"),
        false => (givable[index].position, "position"),
    };
    can_be.map_err(|reason| format!("the {what} of `{}` cannot be given: {reason}", givable[index].quantity.name))?;
    Ok((index, is_rate, text))
}

fn unknown(name: &str, givable: &[Givable], model: &str) -> String {
    if matches!(name, "v" | "speed") {
        return "the speed is given by --speed".to_owned();
    }
    let positions = givable.iter().filter(|givable| givable.position.is_ok()).map(|givable| givable.quantity.name);
    let rates = givable.iter().filter(|givable| givable.rate.is_ok());
    let rates = rates.map(|givable| format!("{}_rate", givable.quantity.name));
    let names: Vec<String> = positions.map(str::to_owned).chain(rates).collect();
    let hint = nearest(name, names.iter().map(String::as_str));
    let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
    format!("`{name}` is no position or rate of {model}{hint}\nthey are {}", names.join(", "))
}

/// What is to be known of the text of a position that seems to be in degrees: a plain number of radians by which nothing leans and
/// nothing is steered. Wheels may have turned by any angle, and machines go anywhere.
pub fn doubt(text: &str, quantity: &Quantity) -> Option<String> {
    let text = text.trim();
    let radians: f64 = text.parse().ok().filter(|radians: &f64| quantity.unit == "rad" && radians.abs() > FRAC_PI_2)?;
    let may_be_any = ["wheel", "yaw"].iter().any(|word| quantity.label.contains(word));
    let degrees = shortest((10.0 * radians.to_degrees()).round() / 10.0);
    let message =
        format!("`{}` is {text} rad, which is {degrees} degrees; for degrees write `{text} deg`", quantity.name);
    (!may_be_any).then_some(message)
}

/// The value of a position or a rate in SI units.
///
/// # Errors
/// What is wrong with it.
pub fn value(text: &str, quantity: &Quantity, is_rate: bool) -> Result<f64, String> {
    let text = unquoted(text);
    let unit = if is_rate { quantity.unit_per_time(1) } else { quantity.unit.to_owned() };
    quantity::number(text, Context { unit: &unit, names: &no_names }).map_err(|Mistake { reason, .. }| match reason {
        Reason::Unit(found) => {
            let or = match (quantity.unit, is_rate) {
                ("rad", true) => ", or in deg/s",
                ("rad", false) => ", or in degrees as `18 deg`",
                _ => "",
            };
            format!("`{text}`: `{found}` is no unit for it; it is in {unit}{or}")
        }
        Reason::Other(reason) => format!("`{text}` must be a finite number: {reason}"),
    })
}

#[cfg(test)]
mod tests {
    use super::{Givable, doubt, initial};
    use crate::analysis::simulation::Quantity;

    fn read(options: &[&str]) -> Result<(Vec<f64>, Vec<f64>), Vec<String>> {
        let free =
            |name, label, unit| Givable { quantity: Quantity::new(name, label, unit), position: Ok(()), rate: Ok(()) };
        let follows = Givable { rate: Err("it follows"), ..free("psi", "yaw", "rad") };
        let givable = [free("phi", "lean", "rad"), free("y", "y", "m"), follows];
        let options: Vec<String> = options.iter().map(|option| (*option).to_owned()).collect();
        initial(&options, &givable, "a model")
            .map(|state| (state.positions, state.rates))
            .map_err(|problems| problems.into_iter().map(|problem| problem.to_string()).collect())
    }

    #[test]
    fn values_have_units() {
        let degrees = |count: f64| count * std::f64::consts::PI / 180.0;
        let given = read(&["phi=2 deg", "lean_rate=3 deg/s", "y = 10 cm", "y_rate=-1 km/h"]);
        assert_eq!(given, Ok((vec![degrees(2.0), 0.1, 0.0], vec![degrees(3.0), -1.0 / 3.6, 0.0])));
        assert_eq!(read(&["phi_rate=pi/10"]).map(|(_, rates)| rates[0]), Ok(std::f64::consts::PI / 10.0));
        for rate in ["phi'=0.5 rad/s", "phi_dot=0.5", "phidot=0.5", "roll_rate=0.5", "Lean rate = '0.5 rad/s'"] {
            assert_eq!(read(&[rate]).map(|(_, rates)| rates[0]), Ok(0.5), "{rate}");
        }
        assert_eq!(read(&["heading='2 deg'", "roll=0"]).map(|(positions, _)| positions[2]), Ok(degrees(2.0)));
    }

    #[test]
    fn degrees_without_a_unit_are_doubted() {
        let lean = Quantity::new("phi", "lean", "rad");
        let told = "`phi` is 5 rad, which is 286.5 degrees; for degrees write `5 deg`";
        assert_eq!(doubt(" 5", &lean).as_deref(), Some(told));
        for text in ["1.5", "-1.5", "5 deg", "pi", "5 rad"] {
            assert_eq!(doubt(text, &lean), None, "{text}");
        }
        for (name, label, unit) in [("thetaR", "rear wheel", "rad"), ("psi", "yaw", "rad"), ("x", "x", "m")] {
            assert_eq!(doubt("5", &Quantity::new(name, label, unit)), None);
        }
    }

    #[test]
    fn mistakes_are_told_together() {
        let found =
            read(&["phi", "ph=1", "phi=5 kg", "phi_rate=1 m/s", "psi_rate=1", "y=1", "y=2", "v=3"]).unwrap_err();
        let expected = [
            "--initial phi: expected NAME=VALUE, such as phi=0.1 or phi_rate=0.5",
            "--initial ph=1: `ph` is no position or rate of a model; did you mean `phi`?\nthey are phi, y, psi, phi_rate, y_rate",
            "--initial phi=5 kg: `5 kg`: `kg` is no unit for it; it is in rad, or in degrees as `18 deg`",
            "--initial phi_rate=1 m/s: `1 m/s`: `m/s` is no unit for it; it is in rad/s, or in deg/s",
            "--initial psi_rate=1: the rate of `psi` cannot be given: it follows",
            "--initial y=2: it is given twice",
            "--initial v=3: the speed is given by --speed",
        ];
        assert_eq!(found, expected);
    }
}
