//! Machines that ship, taken for one another.

use std::sync::OnceLock;

use carvallo::ModelInfo;
use carvallo_design::WHIPPLE;
use carvallo_design::input::{Request, load, names};

use super::Convention;

/// So many parameters are told by themselves.
const FEW: usize = 2;

/// The parameters of all others that ship for a model.
pub fn shipped(info: &ModelInfo, values: &[f64]) -> Vec<Convention> {
    let sets = info.sets.iter().map(|set| (set.name, set.values.to_vec()));
    let place = |at: usize| info.position(WHIPPLE.info.parameters[at].name);
    let places: Option<Vec<usize>> = (0..WHIPPLE.info.parameters.len()).map(place).collect();
    let of_bicycle = |places: &Vec<usize>, own: &[f64]| {
        let mut values = values.to_vec();
        places.iter().zip(own).for_each(|(at, value)| values[*at] = *value);
        values
    };
    let all: Vec<(&str, Vec<f64>)> = match places {
        Some(places) => bicycles().iter().map(|(name, own)| (*name, of_bicycle(&places, own))).collect(),
        None => sets.collect(),
    };
    let differing = |own: &[f64]| own.iter().zip(values).filter(|(own, value)| own != value).count();
    let others = all.into_iter().filter(|(_, own)| differing(own) > FEW);
    let convention = |(name, own): (&str, Vec<f64>)| {
        let what = format!("they are of `{name}`, another machine that ships");
        Convention::of_parameters(what, own.into_iter().enumerate().collect()).ranked(1)
    };
    others.map(convention).collect()
}

/// The bicycles with their values, which are read once.
fn bicycles() -> &'static [(&'static str, Vec<f64>)] {
    static BICYCLES: OnceLock<Vec<(&'static str, Vec<f64>)>> = OnceLock::new();
    let values = |name: &'static str| {
        let design = load(&Request { parameters: Some(name.to_owned()), ..Request::default() }).ok()?;
        Some((name, design.values()))
    };
    BICYCLES.get_or_init(|| names(&WHIPPLE).into_iter().filter_map(values).collect())
}
