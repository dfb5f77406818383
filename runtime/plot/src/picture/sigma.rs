//! Singular values of all transfer functions together, against the frequency by decades.

use super::axes::{self, INK, Scale};
use super::curves::Curve;
use super::graph::{Graph, Line, range, roomy};
use super::motion::COLORS;
use super::scene::{Scene, line};
use crate::analysis::transfer::{AtFrequency, Transfers};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 56.0;
const HEIGHT: f32 = 380.0;
/// The most decibels that are shown below the largest gain.
const DEEPEST: f64 = 240.0;

/// The largest gain over all directions of inputs, the smallest, and those between.
pub fn draw_sigma(transfers: &Transfers) -> Scene {
    let count = transfers.singular_values.iter().map(|at| at.values.len()).max().unwrap_or(0);
    let points = |place: usize| -> Curve {
        let decibels = |at: &AtFrequency| Some((at.frequency.log10(), 20.0 * at.values.get(place)?.log10()));
        transfers.singular_values.iter().filter_map(decibels).filter(|point| point.1.is_finite()).collect()
    };
    let lines: Vec<Line> = (0..count)
        .map(|place| {
            let curve = points(place);
            // What is zero at all frequencies is in no picture of decibels.
            let zero = if curve.is_empty() { " = 0" } else { "" };
            let name = Some(name(place, count) + zero);
            Line { name, color: COLORS[place % COLORS.len()], paint: line(2.2), curve }
        })
        .collect();
    let all = || lines.iter().flat_map(|line| &line.curve);
    let (low, high) = range(all().map(|point| point.1));
    let graph = Graph {
        title: "singular values (dB)".into(),
        height: HEIGHT,
        x: range(all().map(|point| point.0)),
        y: roomy((low.max(high - DEEPEST), high)),
        scales: [Scale::Decades, Scale::Even],
        lines,
        note: None,
    };
    let title = super::transfer_title("Singular values", transfers);
    let left = axes::margin(graph.y);
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 32.0), INK, &title);
    scene.height = graph.draw(Some("frequency ω (rad/s)"), [left, RIGHT], TOP, &mut scene);
    scene
}

fn name(place: usize, count: usize) -> String {
    let what = match place {
        _ if count == 1 => "",
        0 => " largest",
        _ if place + 1 == count => " smallest",
        _ => "",
    };
    format!("σ{}{what}", place + 1)
}
