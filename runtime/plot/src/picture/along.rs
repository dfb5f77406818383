//! Eigenvalues against a parameter: real parts above, frequencies below.

use carvallo_design::Failure;
use carvallo_design::number::{shortest, unit};

use super::critical::Event;
use super::curves::samples;
use super::eigenvalues::{Shown, draw};
use super::panels::panels;
use super::scene::Scene;
use crate::analysis::Rows;
use crate::analysis::along::AlongAnalysis;
use crate::analysis::traced::Traced;

/// The eigenvalues over the range of the parameter; `y` has the real parts that are shown, in 1/s, the second above the first,
/// or is `None` for those that show something of every curve.
///
/// # Errors
/// If eigenvalues cannot be computed at one of the values.
pub fn draw_along(analysis: &AlongAnalysis, y: Option<(f64, f64)>) -> Result<Scene, Failure> {
    let AlongAnalysis { design, parameter, speed, range: [low, high], stability, .. } = analysis;
    let traced = Traced::new(analysis)?;
    let x = (*low, *high);
    let turns = stability.critical_values.iter().map(|critical| critical.value).chain(traced.meetings());
    let rows = Rows::Branches(traced.rows(&samples(x, turns))?);
    let at = speed.map(|speed| format!(" at {} m/s", shortest(speed))).unwrap_or_default();
    let unit = match unit(parameter.unit) {
        unit if unit.is_empty() => unit,
        unit => format!(" {unit}"),
    };
    let across =
        if unit.is_empty() { parameter.name.to_owned() } else { format!("{} ({})", parameter.name, unit.trim()) };
    Ok(draw(&Shown {
        title: format!("Eigenvalues of {} against {}{at}", design.title(), parameter.name),
        x,
        across,
        unit: &unit,
        panels: panels(&rows, y),
        critical: stability
            .critical_values
            .iter()
            .map(|critical| Event { at: critical.value, kind: critical.kind, name: analysis.name(critical) })
            .collect(),
        stable: stability.stable_ranges.iter().map(|range| (range.from, range.to)).collect(),
    }))
}
