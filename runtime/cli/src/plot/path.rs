//! The paths of wheels over the ground, to scale, as seen from above: x to the right and y, which is to the right of who
//! rides, downward.

use super::axes::{Axes, INK};
use super::font;
use super::motion::LIGHTER;
use super::scene::{Anchor, Color, Paint, Scene, dashed, line};
use crate::simulate::{self, Motion};

/// The least room left of the graph.
pub const MARGIN: f32 = 84.0;
const LEGEND: f32 = 26.0;
const TALLEST: f32 = 420.0;
const FLATTEST: f32 = 90.0;
const BELOW: f32 = 62.0;
const TEXT_SIZE: f32 = 14.0;
const WHEELS: [Color; 2] = [Color(0x22, 0x22, 0x22), Color(0xd0, 0x6a, 0x10)];

/// What is drawn, and where.
pub struct Drawn<'a> {
    pub motion: &'a Motion<'a>,
    pub linear: Option<&'a Motion<'a>>,
    pub left: f32,
    pub right: f32,
    pub top: f32,
}

/// Draws the paths, if there are any; where the picture goes on below.
pub fn draw(Drawn { motion, linear, left, right, top }: &Drawn, scene: &mut Scene) -> f32 {
    let paths = simulate::paths(motion);
    let beside = linear.map(simulate::paths).unwrap_or_default();
    if paths.is_empty() {
        return *top;
    }
    let area = [*left, top + LEGEND, *right, 0.0];
    let axes = scaled(&paths.iter().flat_map(|(_, path)| path.iter().copied()).collect::<Vec<_>>(), area);
    let mut x = *left;
    let base = top + 14.0;
    for ((name, _), color) in paths.iter().zip(WHEELS) {
        scene.polyline(&[(x, base - 5.0), (x + 28.0, base - 5.0)], line(2.2), color);
        let text = format!("path of the {name}");
        scene.text((x + 34.0, base), Anchor::Start, TEXT_SIZE, INK, &text);
        x += 34.0 + font::width(&text, TEXT_SIZE) + 24.0;
    }
    axes.draw_grid(scene);
    for ((_, path), color) in beside.iter().zip(WHEELS) {
        polyline(path, &axes, dashed(1.8, [7.0, 5.0]), color.lighter(LIGHTER), scene);
    }
    for ((_, path), color) in paths.iter().zip(WHEELS) {
        polyline(path, &axes, line(2.2), color, scene);
        if let Some(&(x, y)) = path.first() {
            scene.circle(axes.place(x, y), 3.5, Paint::Fill, color);
        }
    }
    axes.draw_frame(scene, Some("forward at the start, x (m)"), "to the right, y (m)");
    axes.area[3] + BELOW
}

/// Axes on which a metre is as long upward as across, and that show all points: as wide as the area, or narrower where they
/// would become too tall. y grows downward.
fn scaled(points: &[(f64, f64)], [left, top, right, _]: [f32; 4]) -> Axes {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    let (x, y) = (range(&mut points.iter().map(|point| point.0)), range(&mut points.iter().map(|point| point.1)));
    let wide = |(low, high): (f64, f64), least: f64| {
        let room = 0.05 * (high - low) + 1e-3;
        let missing = (least - (high - low + 2.0 * room)).max(0.0) / 2.0;
        (low - room - missing, high + room + missing)
    };
    let x = wide(x, 0.0);
    let y = wide(y, 0.0);
    let (width, height) = (right - left, TALLEST);
    let metres = [(x.1 - x.0) / f64::from(width), (y.1 - y.0) / f64::from(height)].into_iter().fold(0.0, f64::max);
    let x = wide(x, metres * f64::from(width) * 0.999);
    let tall = (((y.1 - y.0) / metres) as f32).clamp(FLATTEST, TALLEST);
    let middle = (y.0 + y.1) / 2.0;
    let half = metres * f64::from(tall) / 2.0;
    // The first of a range is at the bottom of the page.
    Axes {
        x: exact(x, metres * f64::from(width)),
        y: (middle + half, middle - half),
        area: [left, top, right, top + tall],
    }
}

/// A range about the same middle that is so long.
fn exact((low, high): (f64, f64), length: f64) -> (f64, f64) {
    let middle = (low + high) / 2.0;
    (middle - length / 2.0, middle + length / 2.0)
}

/// As much of a path as the axes show.
fn polyline(path: &[(f64, f64)], axes: &Axes, paint: Paint, color: Color, scene: &mut Scene) {
    let is_inside = |&(x, y): &(f64, f64)| (axes.x.0..=axes.x.1).contains(&x) && (axes.y.1..=axes.y.0).contains(&y);
    for piece in path.split(|point| !is_inside(point)) {
        let points: Vec<(f32, f32)> = piece.iter().map(|&(x, y)| axes.place(x, y)).collect();
        if points.len() > 1 {
            scene.polyline(&points, paint, color);
        }
    }
}
