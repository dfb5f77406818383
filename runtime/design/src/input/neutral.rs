//! Values for what a file does not give, where it is known that they change nothing.

use carvallo::ModelInfo;

use crate::design::Given;
use crate::failure::Problem;
use crate::model::{Equations, Shipped, WHIPPLE};
use crate::number::shortest;

/// The gravitational field strength on earth in N/kg, as the benchmark has it.
const GRAVITY: f64 = 9.81;

/// Two radii in m that are as good as any other, where that is so.
const RADII: [f64; 2] = [0.1, 0.2];

/// What a parameter is that is not given, if that is known whatever the others are: no matrix depends on it, or it is
/// gravity.
pub fn default(position: usize, info: &ModelInfo) -> Option<f64> {
    let parameter = &info.parameters[position];
    let value = if info.gravity == Some(position) { GRAVITY } else { 0.0 };
    let is_known = !parameter.used || info.gravity == Some(position);
    (is_known && parameter.domain.contains(value)).then_some(value)
}

/// What is said of parameters that got a default value.
pub fn note(label: &str, positions: &[usize], info: &ModelInfo) -> Vec<String> {
    let (mut gravity, unused): (Vec<usize>, Vec<usize>) = positions.iter().partition(|at| info.gravity == Some(**at));
    // Of given matrices, none may depend on it.
    gravity.retain(|at| info.parameters[*at].used);
    let mut notes = Vec::new();
    if !unused.is_empty() {
        let (are, them) = if unused.len() == 1 { ("is", "it") } else { ("are", "them") };
        notes.push(format!("{label}: {} {are} not given; no matrix depends on {them}", names(&unused, info)));
    }
    if !gravity.is_empty() {
        let names = names(&gravity, info);
        notes.push(format!("{label}: {names} is not given: it is {GRAVITY} N/kg unless --gravity says otherwise"));
    }
    notes
}

/// Whether a model without some parameters is that of the shipped bicycles: they are 0 among the values, and the equations
/// of motion are the same.
pub fn is_whipple_without(model: &Shipped, missing: &[usize], values: &[f64]) -> bool {
    let (wide, narrow) = (model.info, WHIPPLE.info);
    let has_zero = |&position: &usize| wide.parameters[position].domain.contains(0.0);
    let is_extra = |&position: &usize| narrow.position(wide.parameters[position].name).is_none();
    let shared = narrow.parameters.iter().map(|parameter| Some(values[wide.position(parameter.name)?]));
    let Some(shared) = shared.collect::<Option<Vec<f64>>>() else { return false };
    missing.iter().all(has_zero)
        && missing.iter().all(is_extra)
        && match (model.equations(values), WHIPPLE.equations(&shared)) {
            (Ok(wide), Ok(narrow)) => are_same(&*wide, &*narrow),
            _ => false,
        }
}

/// Replaces wheel radii of 0 where any radius gives the same equations of motion, as of wheels without mass and inertia.
///
/// # Errors
/// That they must not be 0.
pub fn replace_radii(
    label: &str,
    model: &Shipped,
    parameters: &mut [Given],
    zero: Vec<(usize, Problem)>,
) -> Result<Vec<String>, Vec<Problem>> {
    if zero.is_empty() {
        return Ok(Vec::new());
    }
    let with = |radius: f64| {
        let value =
            |(at, given): (usize, &Given)| if zero.iter().any(|(zero, _)| *zero == at) { radius } else { given.value };
        model.equations(&parameters.iter().enumerate().map(value).collect::<Vec<f64>>())
    };
    match RADII.map(with) {
        [Ok(first), Ok(second)] if are_same(&*first, &*second) => {}
        _ => return Err(zero.into_iter().map(|(_, problem)| problem).collect()),
    }
    let positions: Vec<usize> = zero.iter().map(|(position, _)| *position).collect();
    for position in &positions {
        parameters[*position] = Given { written: shortest(RADII[0]), value: RADII[0], deviation: None };
    }
    let (names, radius) = (names(&positions, model.info), RADII[0]);
    let are = if positions.len() == 1 { "is" } else { "are" };
    Ok(vec![format!(
        "{label}: {names} {are} 0; any radius gives the same equations of motion, and {radius} m is taken"
    )])
}

fn are_same(first: &dyn Equations, second: &dyn Equations) -> bool {
    first.matrices().iter().zip(&second.matrices()).all(|((_, first), (_, second))| {
        let entries = || first.iter().flatten().zip(second.iter().flatten());
        let largest = entries().fold(0.0, |largest: f64, (a, b)| largest.max(a.abs()).max(b.abs()));
        first.len() == second.len() && entries().all(|(a, b)| (a - b).abs() <= 1e-12 * largest)
    })
}

/// `` `IByy`, `IHyy` ``
pub fn names(positions: &[usize], info: &ModelInfo) -> String {
    positions.iter().map(|at| format!("`{}`", info.parameters[*at].name)).collect::<Vec<_>>().join(", ")
}
