//! Steady turns as JSON; its form is documented in `docs/simulate.md`, and stays.

use std::io::{Result, Write};

use carvallo::turns::Turn;
use serde::Serialize;

use crate::analysis::simulation::Quantity;
use crate::analysis::turns::{Families, end, verdict};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    families: Vec<Curve>,
}

#[derive(Serialize)]
struct Curve {
    /// Nothing for a curve that begins elsewhere.
    capsize_speed: Option<f64>,
    begin: String,
    end: String,
    turns: Vec<Line<OneTurn>>,
}

#[derive(Serialize)]
struct OneTurn {
    speed: f64,
    /// Nothing for straight running.
    radius: Option<f64>,
    positions: Members<f64>,
    rates: Members<f64>,
    verdict: &'static str,
    eigenvalues: Vec<Parts>,
}

/// # Errors
/// If it cannot be written.
pub fn write_json(families: &Families, output: &mut dyn Write) -> Result<()> {
    let design = families.design;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let turn = |turn: &Turn| {
        let named = |told: &[(usize, Quantity)], values: &[f64]| {
            // Adding zero turns -0 into 0.
            Members(told.iter().map(|(place, told)| (told.name, values[*place] + 0.0)).collect())
        };
        Line(OneTurn {
            speed: turn.speed,
            radius: turn.radius.is_finite().then_some(turn.radius),
            positions: named(&families.positions, &turn.positions),
            rates: named(&families.rates, &turn.rates),
            verdict: verdict(turn),
            eigenvalues: turn.eigenvalues.iter().copied().map(Parts::from).collect(),
        })
    };
    let curves = families.families.iter().map(|family| Curve {
        capsize_speed: family.capsize,
        begin: end(family.begin),
        end: end(family.end),
        turns: family.turns.iter().map(turn).collect(),
    });
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        families: curves.collect(),
    };
    write_document(&document, output)
}
