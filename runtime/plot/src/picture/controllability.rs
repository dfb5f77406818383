//! Modal controllability and observability against the speed: a graph for each input and output, a curve for each mode.

use carvallo::Mode;
use carvallo_control::{ModalMeasures, Signal};
use carvallo_design::DisplayUnit;

use super::axes::{self, INK, Scale};
use super::colors::color;
use super::curves::Curve;
use super::graph::{Graph, Line, range};
use super::scene::{Anchor, Scene, line};
use crate::analysis::controllability::{AtSpeed, Controllability};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 52.0;
const HEIGHT: f32 = 200.0;
const TEXT_SIZE: f32 = 14.0;
/// Where a mode is lost the logarithm of its cosine has no end: as far as it is shown.
const LEAST: f64 = -4.0;
const ROOM: f64 = 0.15;

/// The cosines in rows that are close to each other.
pub fn draw_controllability(controllability: &Controllability, rows: &[AtSpeed]) -> Scene {
    let unit = &controllability.analysis.unit;
    let x = range(rows.iter().map(|row| unit.value(row.speed)));
    let inputs = controllability.inputs.iter().enumerate().map(|(place, signal)| {
        let curves = lines(rows, unit, &|measures| measures.controllability[place]);
        (format!("controllability by {}", described(signal)), curves)
    });
    let outputs = controllability.outputs.iter().enumerate().map(|(place, signal)| {
        let curves = lines(rows, unit, &|measures| measures.observability[place]);
        (format!("observability in {}", described(signal)), curves)
    });
    let graphs = inputs.chain(outputs).map(|(name, lines)| {
        let scales = [Scale::Even, Scale::Decades];
        (name, Graph { title: "cosine".into(), height: HEIGHT, x, y: (LEAST - ROOM, ROOM), scales, lines, note: None })
    });
    let graphs: Vec<(String, Graph)> = graphs.collect();
    let title = format!("Modes of {} between inputs and outputs", controllability.analysis.design.title());
    let left = axes::margin((-9999.0, 9999.0));
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 30.0), INK, &title);
    let label = format!("forward speed v ({})", unit.unit());
    let mut top = TOP;
    for (index, (name, graph)) in graphs.iter().enumerate() {
        scene.text((RIGHT, top + 14.0), Anchor::End, TEXT_SIZE, INK, name);
        let is_last = index + 1 == graphs.len();
        top = graph.draw(is_last.then_some(label.as_str()), [left, RIGHT], top, &mut scene);
    }
    scene.height = top;
    scene
}

fn described(signal: &Signal) -> String {
    if signal.label == signal.name { signal.name.clone() } else { format!("{} {}", signal.label, signal.name) }
}

/// Of each eigenvalue, of pairs one, a line for each stretch in which it has one name; the first of a name is named.
fn lines(rows: &[AtSpeed], unit: &DisplayUnit, measure: &dyn Fn(&ModalMeasures) -> f64) -> Vec<Line> {
    let count = rows.iter().map(|row| row.modes.len()).max().unwrap_or(0);
    let mut lines: Vec<Line> = Vec::new();
    for place in 0..count {
        let mut current: Option<(Mode, Curve)> = None;
        for row in rows {
            let point = row.modes.get(place).filter(|(mode, _)| mode.value.im >= 0.0);
            let point = point.map(|(mode, measures)| {
                (mode.mode, (unit.value(row.speed), measure(measures).log10().max(LEAST - 1.0)))
            });
            match (&mut current, point) {
                (Some((mode, curve)), Some((own, point))) if *mode == own => curve.push(point),
                (_, point) => {
                    if let Some((mode, curve)) = current.take() {
                        add(&mut lines, mode, curve);
                    }
                    current = point.map(|(mode, point)| (mode, vec![point]));
                }
            }
        }
        if let Some((mode, curve)) = current {
            add(&mut lines, mode, curve);
        }
    }
    lines
}

fn add(lines: &mut Vec<Line>, mode: Mode, curve: Curve) {
    let name = mode.to_string();
    let is_new = lines.iter().all(|line| line.name.as_ref() != Some(&name));
    lines.push(Line { name: is_new.then_some(name), color: color(mode), paint: line(2.2), curve });
}
