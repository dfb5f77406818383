//! Bodies become part of the frames that they are joined to.

use carvallo::{Covariance, ModelInfo, Sources, Uncertain};

use super::body::{Body, Frame, as_numbers};
use super::inertia::Inertia;
use super::read::read;
use crate::bodies::body;
use crate::design::{Design, Deviation, Given};
use crate::failure::{Failure, Problem};
use crate::input::warnings;
use crate::number::shortest;

/// Changes the parameters of the frames to those with the bodies, and how they vary together: the mass that is added moves the
/// centre and the moments of inertia alike.
///
/// # Errors
/// If a model has no such frame.
pub fn join(
    bodies: &[Body],
    info: &ModelInfo,
    parameters: &mut [Given],
    covariance: &mut Option<Covariance>,
) -> Result<(), Vec<Problem>> {
    let unknown: Vec<Problem> = bodies.iter().filter_map(|body| without_frame(body, info)).collect();
    if !unknown.is_empty() {
        return Err(unknown);
    }
    let sources = Sources::default();
    let values: Vec<f64> = parameters.iter().map(|given| given.value).collect();
    let mut numbers: Vec<Uncertain> = match covariance {
        Some(covariance) => sources.correlated(&values, covariance),
        None => parameters.iter().map(|given| sources.measured(given.value, deviation(given))).collect(),
    };
    for body in bodies {
        let Some(positions) = body.frame.positions(info) else { continue };
        let number = |position: Option<usize>| position.map_or(sources.exact(0.0), |position| numbers[position]);
        let [mass, x, z, xx, yy, zz, xz] = positions.map(number);
        let joined = Inertia { mass, x, z, xx, yy, zz, xz }.with(body.inertia(&sources));
        for (position, number) in positions.into_iter().zip(as_numbers(joined)) {
            let Some(position) = position else { continue };
            numbers[position] = number;
            let deviation = Some(number.deviation()).filter(|&deviation| deviation > 0.0);
            let deviation = deviation.map(|value| Deviation { written: shortest(value), value });
            parameters[position] = Given { written: shortest(number.value()), value: number.value(), deviation };
        }
    }
    *covariance = sources.covariance(&numbers).ok().filter(|together| !together.correlations().is_empty());
    Ok(())
}

/// A design with bodies joined to it: each a file, or what is in it in one line, as `carvallo --add` takes it.
///
/// # Errors
/// Everything that is wrong with the bodies, or that the model has no such frame.
pub fn add(design: Design, bodies: &[String]) -> Result<Design, Failure> {
    let bodies = bodies.iter().map(|text| read(text, text)).collect::<Result<Vec<Body>, Failure>>()?;
    let info = design.model.info;
    let before = design.values();
    let alone = warnings(info, &before, &before);
    let of_bodies: Vec<String> = bodies.iter().flat_map(Body::warnings).collect();
    let Design { mut parameters, mut covariance, warnings: mut told, .. } = design;
    join(&bodies, design.model.info, &mut parameters, &mut covariance).map_err(Failure::Input)?;
    let values: Vec<f64> = parameters.iter().map(|given| given.value).collect();
    let equations = design.model.equations(&values).map_err(Failure::usage)?;
    let (name, kind) = (name(design.name, &bodies), kind(design.kind, &bodies));
    // What was told of the machine alone may hold no more with the bodies.
    told.retain(|warning| !alone.contains(warning));
    let sizes = if of_bodies.is_empty() { &values } else { &before };
    told.extend(warnings(info, sizes, &values));
    told.extend(of_bodies);
    Ok(Design { name, kind, parameters, covariance, equations, warnings: told, ..design })
}

/// What a machine is called with the bodies.
pub fn name(machine: String, bodies: &[Body]) -> String {
    bodies.iter().fold(machine, |name, body| {
        let body = body.name.clone().unwrap_or_else(|| format!("{} kg", shortest(body.mass[0])));
        format!("{name} + {body}")
    })
}

/// What it is: with bodies joined, no longer what was said of it alone, as that it has no rider.
pub fn kind(alone: Option<String>, bodies: &[Body]) -> Option<String> {
    alone.filter(|_| bodies.is_empty())
}

fn deviation(given: &Given) -> f64 {
    given.deviation.as_ref().map_or(0.0, |deviation| deviation.value)
}

fn without_frame(Body { place, frame: frame @ Frame(letter), .. }: &Body, info: &ModelInfo) -> Option<Problem> {
    if frame.positions(info).is_some() {
        return None;
    }
    let name = info.name;
    let frames: Vec<String> = Frame::all(info)
        .iter()
        .map(|letter| format!("`{letter}`, the {}", without_letter(&body(info, letter))))
        .collect();
    let message = match (letter.as_str(), frames.as_slice()) {
        (_, []) => format!("{name} has no frame that a body can be joined to"),
        ("R" | "F", _) if info.position(&format!("m{letter}")).is_some() => format!(
            "a wheel turns, and nothing can be joined to it but what is symmetric about its axle: set `m{letter}`, \
             `I{letter}xx` and `I{letter}yy`; frames are {}",
            frames.join(" and ")
        ),
        _ => format!("{name} has no frame `{letter}`; there is {}", frames.join(" and ")),
    };
    Some(Problem { place: place.clone(), message })
}

/// `rear frame` of `rear frame B`.
fn without_letter(body: &str) -> &str {
    body.rsplit_once(' ').map_or(body, |(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::add;
    use crate::input::{Request, load};

    /// What was told of the machine alone, and is no more so; and what is so of both alone.
    #[test]
    fn warnings_are_those_of_the_whole() {
        let overrides = vec![("--set IByy=25".to_owned(), "IByy".to_owned(), "25".to_owned())];
        let stretched = || load(&Request { overrides: overrides.clone(), ..Request::default() }).unwrap();
        let [warning] = &stretched().warnings[..] else { panic!("one") };
        assert!(warning.starts_with("no rigid body has the inertias of"), "{warning}");
        // A long beam across, of 1/12 m l^2 about both other axes.
        let wide = add(stretched(), &["mass=100 kg, at=(0.3, 0, -0.9), box=(0.1, 3, 0.1)".to_owned()]).unwrap();
        assert_eq!(wide.warnings, [""; 0]);
        let low = add(load(&Request::default()).unwrap(), &["mass=500 kg, at=(0.3, 0, 0.5)".to_owned()]).unwrap();
        assert!(low.warnings.iter().any(|warning| warning.contains("below the ground")), "{:?}", low.warnings);
    }
}
