//! Responses in time: the outputs of one unit in one graph.

use carvallo_control::Signal;
use carvallo_design::number::unit;

use super::axes::{self, EVEN, INK};
use super::graph::{Graph, Line, range, roomy};
use super::motion::COLORS;
use super::scene::{Scene, line};
use crate::analysis::response::Responses;

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 56.0;
const HEIGHT: f32 = 260.0;

/// All outputs against the time.
pub fn draw_response(responses: &Responses) -> Scene {
    let Responses { design, space, response, .. } = responses;
    let end = response.times.last().copied().unwrap_or(1.0);
    let mut graphs: Vec<Graph> = Vec::new();
    for (place, signal) in space.outputs.iter().enumerate() {
        let (title, scale) = axis(signal);
        let values = response.times.iter().zip(&response.outputs).map(|(time, values)| (*time, scale * values[place]));
        let line = Line {
            name: Some(format!("{} {}", signal.label, signal.name)),
            color: COLORS[place % COLORS.len()],
            paint: line(2.2),
            curve: values.collect(),
        };
        match graphs.iter_mut().find(|graph| graph.title == title) {
            Some(graph) => graph.lines.push(line),
            None => graphs.push(Graph {
                title: title.into(),
                height: HEIGHT,
                x: (0.0, end),
                y: (0.0, 0.0),
                scales: EVEN,
                lines: vec![line],
                note: None,
            }),
        }
    }
    for graph in &mut graphs {
        graph.y = roomy(range(graph.lines.iter().flat_map(|line| line.curve.iter().map(|point| point.1)).chain([0.0])));
    }
    let speed = space.speed_text().map(|speed| format!(" at {speed}"));
    let title = format!("{}{}: {}", design.title(), speed.unwrap_or_default(), lower(&responses.title()));
    let left = graphs.iter().map(|graph| axes::margin(graph.y)).fold(0.0, f32::max);
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 32.0), INK, &title);
    let mut top = TOP;
    for (index, graph) in graphs.iter().enumerate() {
        let is_last = index + 1 == graphs.len();
        top = graph.draw(is_last.then_some("time t (s)"), [left, RIGHT], top, &mut scene);
    }
    scene.height = top;
    scene
}

/// What the axis of an output shows, and what its values are multiplied with.
fn axis(signal: &Signal) -> (String, f64) {
    let degrees = 1_f64.to_degrees();
    let (title, scale) = match signal.unit.as_str() {
        "rad" => ("angles (°)", degrees),
        "rad/s" => ("rates (°/s)", degrees),
        "rad/s^2" => ("accelerations (°/s²)", degrees),
        "m" => ("positions (m)", 1.0),
        "m/s" => ("velocities (m/s)", 1.0),
        "m/s^2" => ("accelerations (m/s²)", 1.0),
        "1" => ("outputs", 1.0),
        other => return (format!("outputs ({})", unit(other)), 1.0),
    };
    (title.to_owned(), scale)
}

/// A title as the end of another one.
fn lower(title: &str) -> String {
    title.replacen("Response", "response", 1)
}
