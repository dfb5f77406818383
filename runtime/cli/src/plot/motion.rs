//! A motion against time: positions by their units, the speed, and below them the paths of wheels.

use super::axes::{self, Axes, INK};
use super::curves::{Curve, clip};
use super::font;
use super::path;
use super::scene::{Anchor, Color, Paint, Scene, dashed, line};
use crate::simulate::{Motion, Quantity};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 56.0;
const LEGEND: f32 = 26.0;
/// The heights of a graph and of what is below it.
const GRAPH: f32 = 220.0;
const FLAT: f32 = 160.0;
const BELOW: f32 = 40.0;
const TITLE_BELOW: f32 = 30.0;
const TEXT_SIZE: f32 = 14.0;
/// Curves of a linear motion beside a nonlinear one are lighter, and dashed.
pub const LIGHTER: f32 = 0.35;
const COLORS: [Color; 6] = [
    Color(0x1f, 0x6f, 0xb4),
    Color(0xc0, 0x28, 0x3c),
    Color(0x2e, 0x7d, 0x32),
    Color(0xb4, 0x6a, 0x00),
    Color(0x7a, 0x3f, 0x9d),
    Color(0x55, 0x5d, 0x66),
];

/// A graph: what its vertical axis shows, and the curves in it.
struct Graph {
    title: &'static str,
    height: f32,
    curves: Vec<Named>,
}

/// A curve in data, and beside it that of the linear motion.
struct Named {
    name: String,
    color: Color,
    curve: Curve,
    linear: Curve,
}

/// A motion, and the linear one of the same state where it is not that itself.
pub fn draw_motion(motion: &Motion, linear: Option<&Motion>) -> Scene {
    let graphs = graphs(motion, linear);
    let title = format!("Motion of {}", motion.design.title());
    let end = motion.rows.last().map_or(1.0, |row| row.t);
    let extents: Vec<(f64, f64)> = graphs.iter().map(extent).collect();
    let left = extents.iter().map(|extent| axes::margin(*extent)).fold(path::MARGIN, f32::max);
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.text(((left + RIGHT) / 2.0, 32.0), Anchor::Middle, 18.0, INK, &title);
    let mut top = TOP;
    for (index, (graph, y)) in graphs.iter().zip(extents).enumerate() {
        write_legend(graph, motion, linear.is_some() && index == 0, (left, top), &mut scene);
        top += LEGEND;
        let axes = Axes { x: (0.0, end), y, area: [left, top, RIGHT, top + graph.height] };
        axes.draw_grid(&mut scene);
        for named in &graph.curves {
            draw(&named.linear, &axes, dashed(1.8, [7.0, 5.0]), named.color.lighter(LIGHTER), &mut scene);
            draw(&named.curve, &axes, line(2.2), named.color, &mut scene);
        }
        let is_last = index + 1 == graphs.len();
        axes.draw_frame(&mut scene, Some(if is_last { "time t (s)" } else { "" }), graph.title);
        top += graph.height + BELOW + if is_last { TITLE_BELOW } else { 0.0 };
    }
    let drawn = path::Drawn { motion, linear, left, right: RIGHT, top };
    scene.height = path::draw(&drawn, &mut scene) + 12.0;
    scene
}

/// Of a bicycle lean and steer, and the speed; of anything else all positions, those of one unit in one graph.
fn graphs(motion: &Motion, linear: Option<&Motion>) -> Vec<Graph> {
    let is_bicycle = motion.position("thetaR").is_some();
    let shown = |quantity: &&Quantity| !is_bicycle || matches!(quantity.name, "phi" | "delta");
    let mut graphs: Vec<Graph> = Vec::new();
    for quantity in motion.quantities.iter().filter(shown) {
        let (title, scale) = match quantity.unit {
            "rad" => ("angles (°)", 1_f64.to_degrees()),
            "m" => ("positions (m)", 1.0),
            _ => ("positions", 1.0),
        };
        let place = match graphs.iter().position(|graph| graph.title == title) {
            Some(place) => place,
            None => {
                graphs.push(Graph { title, height: GRAPH, curves: Vec::new() });
                graphs.len() - 1
            }
        };
        let curve = |motion: &Motion| -> Curve {
            let Some(place) = motion.position(quantity.name) else { return Curve::new() };
            motion.rows.iter().map(|row| (row.t, scale * row.positions[place])).collect()
        };
        let name = if quantity.label == quantity.name {
            quantity.name.to_owned()
        } else {
            format!("{} {}", quantity.label, quantity.name)
        };
        let color = COLORS[graphs[place].curves.len() % COLORS.len()];
        let linear = linear.map(curve).unwrap_or_default();
        graphs[place].curves.push(Named { name, color, curve: curve(motion), linear });
    }
    let speed =
        |motion: &Motion| -> Curve { motion.rows.iter().filter_map(|row| Some((row.t, motion.speed(row)?))).collect() };
    if is_bicycle {
        let linear = linear.map(speed).unwrap_or_default();
        let named = Named { name: "forward speed".to_owned(), color: INK, curve: speed(motion), linear };
        graphs.push(Graph { title: "v (m/s)", height: FLAT, curves: vec![named] });
    }
    graphs
}

/// What the vertical axis shows: all of the motion itself, and of a linear one beside it no more than it takes to see how that
/// leaves.
fn extent(graph: &Graph) -> (f64, f64) {
    let all = |of: fn(&Named) -> &Curve| {
        let values = graph.curves.iter().flat_map(of).map(|(_, value)| *value);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    let (low, high) = all(|named| &named.curve);
    let (linear_low, linear_high) = all(|named| &named.linear);
    let room = (high - low).max(1e-6);
    let low = low.min(linear_low.max(low - 0.5 * room));
    let high = high.max(linear_high.min(high + 0.5 * room));
    // What hardly changes is shown as that.
    let least = 0.1 * high.abs().max(low.abs()).max(1e-5);
    let missing = (least - (high - low)).max(0.0) / 2.0;
    let room = 0.06 * (high - low).max(least);
    (low - missing - room, high + missing + room)
}

fn draw(curve: &[(f64, f64)], axes: &Axes, paint: Paint, color: Color, scene: &mut Scene) {
    for piece in clip(curve, axes.y) {
        let points: Vec<(f32, f32)> = piece.into_iter().map(|(x, y)| axes.place(x, y)).collect();
        scene.polyline(&points, paint, color);
    }
}

/// Above a graph, its curves by their names; above the first one also what is dashed.
fn write_legend(graph: &Graph, motion: &Motion, has_linear: bool, (left, top): (f32, f32), scene: &mut Scene) {
    let base = top + 14.0;
    let mut x = left;
    let mut entry = |paint: Paint, color: Color, text: &str, scene: &mut Scene| {
        scene.polyline(&[(x, base - 5.0), (x + 28.0, base - 5.0)], paint, color);
        scene.text((x + 34.0, base), Anchor::Start, TEXT_SIZE, INK, text);
        x += 34.0 + font::width(text, TEXT_SIZE) + 24.0;
    };
    for named in &graph.curves {
        entry(line(2.2), named.color, &named.name, scene);
    }
    if has_linear {
        let text = if motion.is_linear { "linear" } else { "the same by the linear equations" };
        entry(dashed(1.8, [7.0, 5.0]), INK.lighter(LIGHTER), text, scene);
    }
}
