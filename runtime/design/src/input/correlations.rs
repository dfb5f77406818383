//! How measured parameters vary together: `[correlations]` beside the parameters, with a table for each parameter that has the
//! correlations with others: `c = { lam = -0.99 }`.

use carvallo::Covariance;

use super::tables::{Named, Node, Value};
use crate::design::Given;
use crate::failure::{Place, Problem};
use crate::quantity::{Context, no_names, number};

/// The names of parameters.
pub struct Names<'a> {
    /// Where the parameter of a name is; or that there is none.
    pub find: &'a dyn Fn(&str) -> Result<usize, String>,
    /// What the parameter at a position is called.
    pub name: &'a dyn Fn(usize) -> &'static str,
}

/// The covariance of parameters with these deviations; `None` if none are correlated. Of a parameter with a value of its own from
/// elsewhere nothing is known.
///
/// # Errors
/// Everything that is wrong.
pub fn resolve(
    members: Vec<Named>,
    names: &Names,
    parameters: &[&Given],
    is_set: &dyn Fn(usize) -> bool,
) -> Result<Option<Covariance>, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut pairs: Vec<(usize, usize, f64)> = Vec::new();
    let mut places: Vec<(usize, Place)> = Vec::new();
    for Named { name, node: Node { place, value } } in members {
        let mut problem = |place: &Place, message| problems.push(Problem { place: place.clone(), message });
        let Value::Table(others) = value else {
            problem(&place, format!("`{name}` has no correlations with others, such as `{name} = {{ w = 0.5 }}`"));
            continue;
        };
        let Some(first) = found(&name, &place, names, &mut problem) else { continue };
        places.push((first, place));
        for Named { name: other, node } in others {
            let Some(second) = found(&other, &node.place, names, &mut problem) else { continue };
            let of = format!("the correlation of `{name}` and `{other}`");
            let text = match node.value {
                Value::Text(text) | Value::Number(text) => text,
                _ => String::new(),
            };
            match number(&text, Context { unit: "1", names: &no_names }) {
                Ok(value) if (-1.0..=1.0).contains(&value) && first != second => {
                    let is_same = |&&(a, b, _): &&(usize, usize, f64)| [(a, b), (b, a)].contains(&(first, second));
                    match pairs.iter().find(is_same) {
                        Some((.., other)) if *other != value => {
                            problem(&node.place, format!("{of} is {value}, and elsewhere {other}"));
                        }
                        _ => pairs.push((first, second, value)),
                    }
                }
                Ok(value) if first == second => {
                    problem(&node.place, format!("{of} is {value}; only that with another parameter is given"));
                }
                Ok(value) => problem(&node.place, format!("{of} is {value}; it must be between -1 and 1")),
                Err(_) => problem(&node.place, format!("{of} is `{text}`; expected a number between -1 and 1")),
            }
        }
    }
    let deviations: Vec<f64> =
        parameters.iter().map(|given| given.deviation.as_ref().map_or(0.0, |deviation| deviation.value)).collect();
    pairs.retain(|&(first, second, _)| {
        [first, second].iter().all(|&position| deviations[position] > 0.0 && !is_set(position))
    });
    if !problems.is_empty() {
        return Err(problems);
    }
    if pairs.is_empty() {
        return Ok(None);
    }
    Covariance::of_correlations(&deviations, &pairs).map(Some).map_err(|error| {
        let at = match error {
            carvallo::SensitivityError::NotCorrelations { parameter } => parameter,
            _ => 0,
        };
        let place = places.iter().find(|(position, _)| *position == at).or(places.first());
        let place = place.map_or(Place::Nowhere, |(_, place)| place.clone());
        let name = (names.name)(at);
        let message = format!("`{name}` cannot be correlated so with others: together they have a negative variance");
        vec![Problem { place, message }]
    })
}

fn found(name: &str, place: &Place, names: &Names, problem: &mut dyn FnMut(&Place, String)) -> Option<usize> {
    (names.find)(name).map_err(|message| problem(place, message)).ok()
}
