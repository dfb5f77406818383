//! Accelerations in states of motion, by the names of coordinates.

use carvallo::ModelInfo;
use carvallo_design::Problem;
use carvallo_design::input::{Named, Node, Value};

use super::numbers::{problem, reading, speed};
use crate::given::{Accelerations, Kind};

/// Each a table `{ speed = 5, state = { phi = 0.1, phi_rate = 0 }, forces = { delta = 1 }, values = { phi = 2.3, delta = … } }`.
///
/// # Errors
/// Everything that is wrong with them.
pub fn accelerations(node: &Node, info: &ModelInfo) -> Result<Vec<Accelerations>, Vec<Problem>> {
    let nodes = match &node.value {
        Value::List(nodes) => nodes.as_slice(),
        _ => std::slice::from_ref(node),
    };
    let mut problems = Vec::new();
    let mut found = Vec::new();
    for node in nodes {
        let mut own = Accelerations {
            equations: None,
            speed: f64::NAN,
            positions: vec![0.0; info.coordinates.len()],
            rates: vec![0.0; info.coordinates.len()],
            forces: vec![0.0; info.coordinates.len()],
            values: vec![None; info.coordinates.len()],
        };
        let Value::Table(members) = &node.value else {
            let message = "`accelerations` has no tables; expected `speed`, `state` and `values` in each";
            problems.push(problem(&node.place, message));
            continue;
        };
        for Named { name, node } in members {
            let done = match (name.as_str(), &node.value) {
                ("speed" | "v", _) => speed(node).map(|speed| own.speed = speed).map_err(|found| vec![found]),
                ("equations", Value::Text(text)) => match text.as_str() {
                    "linear" => {
                        own.equations = Some(Kind::Linear);
                        Ok(())
                    }
                    "nonlinear" => {
                        own.equations = Some(Kind::Nonlinear);
                        Ok(())
                    }
                    other => {
                        let message = format!("`equations` is `{other}`; expected linear or nonlinear");
                        Err(vec![problem(&node.place, message)])
                    }
                },
                ("state", Value::Table(members)) => each(members, info, &mut |at, suffix, node, what| {
                    let value = reading(node, what)?.map_or(0.0, |reading| reading.value);
                    match suffix {
                        "" => own.positions[at] = value,
                        "_rate" | "'" | "dot" | "_dot" => own.rates[at] = value,
                        _ => return Err(problem(&node.place, unknown(what, info, "NAME or NAME_rate"))),
                    }
                    Ok(())
                }),
                ("forces", Value::Table(members)) => each(members, info, &mut |at, _, node, what| {
                    own.forces[at] = reading(node, what)?.map_or(0.0, |reading| reading.value);
                    Ok(())
                }),
                ("values", Value::Table(members)) => each(members, info, &mut |at, _, node, what| {
                    own.values[at] = reading(node, what)?;
                    Ok(())
                }),
                ("state" | "forces" | "values", _) => {
                    let coordinate = info.coordinates.first().map_or("", |own| own.name);
                    let message = format!(
                        "`{name}` is no table; expected a number of each coordinate, as {{ {coordinate} = 0.1 }}"
                    );
                    Err(vec![problem(&node.place, message)])
                }
                (other, _) => {
                    let message = format!(
                        "`{other}` is not expected here; expected `speed`, `state`, `forces`, `values`, `equations`"
                    );
                    Err(vec![problem(&node.place, message)])
                }
            };
            problems.extend(done.err().into_iter().flatten());
        }
        // What is wrong with a speed was told.
        if own.speed.is_nan() && !members.iter().any(|member| matches!(member.name.as_str(), "speed" | "v")) {
            problems.push(problem(&node.place, "accelerations have no `speed`"));
        }
        found.push(own);
    }
    if problems.is_empty() { Ok(found) } else { Err(problems) }
}

type Take<'a> = &'a mut dyn FnMut(usize, &str, &Node, &str) -> Result<(), Problem>;

/// The members of a table by the coordinate whose name they begin with, or that of its force, and what stands behind it.
fn each(members: &[Named], info: &ModelInfo, take: Take) -> Result<(), Vec<Problem>> {
    let mut problems = Vec::new();
    for Named { name, node } in members {
        let own = name.strip_prefix('T').unwrap_or(name);
        let names = info.coordinates.iter().enumerate();
        let of = names.filter(|(_, coordinate)| own.starts_with(coordinate.name)).max_by_key(|(_, own)| own.name.len());
        let done = match of {
            Some((at, coordinate)) => take(at, &own[coordinate.name.len()..], node, &format!("`{name}`")),
            None => Err(problem(&node.place, unknown(&format!("`{name}`"), info, "NAME"))),
        };
        problems.extend(done.err());
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

fn unknown(what: &str, info: &ModelInfo, form: &str) -> String {
    let names: Vec<&str> = info.coordinates.iter().map(|coordinate| coordinate.name).collect();
    format!("{what} is of no coordinate of {}; expected {form} with one of {}", info.name, names.join(", "))
}
