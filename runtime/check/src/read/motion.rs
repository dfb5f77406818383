//! Accelerations in states of motion, by the names of coordinates.

use carvallo::ModelInfo;
use carvallo_design::input::{Named, Node, Value};
use carvallo_design::{Problem, is_called, of_rate};

use super::numbers::{problem, reading, speed};
use crate::given::{Accelerations, Kind};

/// What stands behind the name of a coordinate for its acceleration, and for its force.
const ACCELERATIONS: [&str; 9] =
    ["''", "_ddot", "ddot", "_dd", "dd", "_acceleration", " acceleration", "_accel", "_acc"];
const FORCES: [&str; 6] = ["_torque", " torque", "_moment", " moment", "_force", " force"];

/// Accelerations that are said not to be known, by their state and coordinate.
pub type Unknown = Vec<(usize, usize)>;

/// Each a table `{ speed = 5, state = { phi = 0.1, phi_rate = 0 }, forces = { delta = 1 }, values = { phi = 2.3, delta = … } }`;
/// those without a speed at that of the file. And what is not known.
///
/// # Errors
/// Everything that is wrong with them.
pub fn accelerations(
    node: &Node,
    info: &ModelInfo,
    of_file: Option<f64>,
) -> Result<(Vec<Accelerations>, Unknown), Vec<Problem>> {
    let nodes = match &node.value {
        Value::List(nodes) => nodes.as_slice(),
        _ => std::slice::from_ref(node),
    };
    if !nodes.iter().any(|node| matches!(node.value, Value::Table(_))) {
        let message = "`accelerations` has no tables; expected `speed`, `state` and `values` in each";
        return Err(vec![problem(&node.place, message)]);
    }
    let mut problems = Vec::new();
    let (mut found, mut unknown) = (Vec::new(), Vec::new());
    for node in nodes {
        let mut own = Accelerations {
            equations: None,
            speed: of_file.unwrap_or(f64::NAN),
            positions: vec![0.0; info.coordinates.len()],
            rates: vec![0.0; info.coordinates.len()],
            forces: vec![0.0; info.coordinates.len()],
            values: vec![None; info.coordinates.len()],
        };
        let Value::Table(members) = &node.value else {
            let message = "one of `accelerations` is no table; expected `speed`, `state` and `values` in each";
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
                ("state", Value::Table(members)) => each(members, info, "NAME or NAME_rate", &mut |written, node| {
                    let (values, at) = match position(written, info) {
                        Some(at) => (&mut own.positions, at),
                        None => (&mut own.rates, of_rate(written).and_then(|stem| position(stem, info))?),
                    };
                    Some(known(node, written).map(|value| values[at] = value))
                }),
                ("forces", Value::Table(members)) => each(members, info, "NAME", &mut |written, node| {
                    let stem = FORCES.iter().find_map(|ending| written.strip_suffix(ending)).unwrap_or(written);
                    let at = position(stem, info).or_else(|| position(stem.strip_prefix('T')?, info))?;
                    Some(known(node, written).map(|value| own.forces[at] = value))
                }),
                ("values", Value::Table(members)) => each(members, info, "NAME", &mut |written, node| {
                    let stem = ACCELERATIONS.iter().find_map(|ending| written.strip_suffix(ending));
                    let at = position(written, info).or_else(|| position(stem?, info))?;
                    Some(reading(node, &format!("`{written}`")).map(|value| {
                        unknown.extend(value.is_none().then_some((found.len(), at)));
                        own.values[at] = value;
                    }))
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
        if own.speed.is_nan()
            && of_file.is_none()
            && !members.iter().any(|member| matches!(member.name.as_str(), "speed" | "v"))
        {
            problems.push(problem(&node.place, "accelerations have no `speed`"));
        }
        found.push(own);
    }
    if problems.is_empty() { Ok((found, unknown)) } else { Err(problems) }
}

/// A number of what accelerations are in, or under: what is not known has none.
fn known(node: &Node, written: &str) -> Result<f64, Problem> {
    let unknown =
        || problem(&node.place, format!("`{written}` is not known; accelerations are those of one number, such as 0"));
    reading(node, &format!("`{written}`"))?.map(|own| own.value).ok_or_else(unknown)
}

/// What takes the number of a name, if it knows this.
type Take<'a> = &'a mut dyn FnMut(&str, &Node) -> Option<Result<(), Problem>>;

/// The members of a table.
fn each(members: &[Named], info: &ModelInfo, form: &str, take: Take) -> Result<(), Vec<Problem>> {
    let unknown = |Named { name, node }: &Named| {
        let names: Vec<&str> = info.coordinates.iter().map(|coordinate| coordinate.name).collect();
        let (model, names) = (info.name, names.join(", "));
        problem(&node.place, format!("`{name}` is of no coordinate of {model}; expected {form} with one of {names}"))
    };
    let done = |own: &Named| take(&own.name, &own.node).unwrap_or_else(|| Err(unknown(own))).err();
    let problems: Vec<Problem> = members.iter().filter_map(done).collect();
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// The coordinate that somebody calls so: `phi`, `lean`, `roll`.
fn position(written: &str, info: &ModelInfo) -> Option<usize> {
    info.coordinates.iter().position(|own| is_called(own.name, own.label, written))
}
