//! Eigenvalues against speed, as figure 4 of Meijaard et al. (2007) shows them.

use carvallo::CriticalSpeed;
use carvallo_design::Failure;

use super::critical::Event;
use super::curves::samples;
use super::eigenvalues::{Shown, draw};
use super::panels::panels;
use super::scene::Scene;
use crate::analysis::{Analysis, Rows, name};

/// What the axes show.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The speeds in m/s, the second above the first.
    pub x: (f64, f64),
    /// The eigenvalues in 1/s, the second above the first; `None` for those that show something of every curve.
    pub y: Option<(f64, f64)>,
}

/// The eigenvalues between two speeds.
///
/// # Errors
/// If they cannot be computed at one of the speeds.
pub fn draw_eigenvalues(analysis: &Analysis, limits: Limits) -> Result<Scene, Failure> {
    let critical = analysis.critical_speeds();
    let turns = critical.iter().map(|critical| critical.speed).chain(analysis.meetings());
    let rows = analysis.rows(&samples(limits.x, turns))?;
    let speed = if matches!(rows, Rows::Modes(_)) { "forward speed" } else { "speed" };
    let unit = &analysis.unit;
    let rows = rows.shown_in(unit);
    let event = |critical: &CriticalSpeed| Event {
        at: unit.value(critical.speed),
        kind: critical.kind,
        name: name(critical, analysis.design.info()),
    };
    let stable = analysis.stable_ranges().iter();
    let stable = stable.map(|range| (unit.value(range.from), range.to.map_or(f64::INFINITY, |to| unit.value(to))));
    Ok(draw(&Shown {
        title: format!("Eigenvalues of {} against {speed}", analysis.design.title()),
        x: (unit.value(limits.x.0), unit.value(limits.x.1)),
        across: format!("{speed} v ({})", unit.unit()),
        unit: &format!(" {}", unit.unit()),
        panels: panels(&rows, limits.y),
        critical: critical.iter().map(event).collect(),
        stable: stable.collect(),
    }))
}
