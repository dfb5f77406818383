//! Eigenvalues against a parameter: real parts above, frequencies below.

use carvallo_design::Failure;

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
    let AlongAnalysis { design, parameter, range: [low, high], stability, unit, .. } = analysis;
    let traced = Traced::new(analysis)?;
    let x = (*low, *high);
    let turns = stability.critical_values.iter().map(|critical| critical.value).chain(traced.meetings());
    let mut rows = traced.rows(&samples(x, turns))?;
    rows.iter_mut().for_each(|row| row.speed = unit.value(row.speed));
    let rows = Rows::Branches(rows);
    let at = analysis.at_speed(" at ");
    let behind = Some(unit.unit()).filter(|unit| !unit.is_empty()).map(|unit| format!(" {unit}")).unwrap_or_default();
    Ok(draw(&Shown {
        title: format!("Eigenvalues of {} against {}{at}", design.title(), parameter.name),
        x: (unit.value(*low), unit.value(*high)),
        across: analysis.heading(),
        unit: &behind,
        panels: panels(&rows, y),
        critical: stability
            .critical_values
            .iter()
            .map(|critical| Event {
                at: unit.value(critical.value),
                kind: critical.kind,
                name: analysis.name(critical),
            })
            .collect(),
        stable: stability.stable_ranges.iter().map(|range| (unit.value(range.from), unit.value(range.to))).collect(),
    }))
}
