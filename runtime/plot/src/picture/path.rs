//! The paths of wheels over the ground, to scale, as seen from above: x to the right and y, which is to the right of who
//! rides, downward.

use super::axes::Axes;
use super::graph::{range, write_names};
use super::motion::{BESIDE, LIGHTER};
use super::scene::{Color, Paint, Scene, line};
use crate::analysis::simulation::{self, Motion};

/// The least room left of the graph.
pub const MARGIN: f32 = 84.0;
const TALLEST: f32 = 420.0;
const FLATTEST: f32 = 90.0;
const BELOW: f32 = 62.0;
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
pub fn draw(&Drawn { motion, linear, left, right, top }: &Drawn, scene: &mut Scene) -> f32 {
    let paths = simulation::paths(motion);
    let beside = linear.map(simulation::paths).unwrap_or_default();
    if paths.is_empty() {
        return top;
    }
    let names: Vec<String> = paths.iter().map(|(name, _)| format!("path of the {name}")).collect();
    let named = names.iter().zip(WHEELS).map(|(name, color)| (line(2.2), color, name.as_str()));
    let top = write_names(named, [left, right], top, scene);
    let points: Vec<(f64, f64)> = paths.iter().flat_map(|(_, path)| path.iter().copied()).collect();
    let axes = scaled(&points, left, right, top);
    axes.draw_grid(scene);
    for ((_, path), color) in beside.iter().zip(WHEELS) {
        polyline(path, &axes, BESIDE, color.lighter(LIGHTER), scene);
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

/// Axes on which a metre is as long upward as across, and that show all points: over the whole width, and no taller than they
/// may be. y grows downward.
fn scaled(points: &[(f64, f64)], left: f32, right: f32, top: f32) -> Axes {
    let (x, y) = (range(points.iter().map(|point| point.0)), range(points.iter().map(|point| point.1)));
    let length = |(low, high): (f64, f64)| 1.1 * (high - low) + 2e-3;
    let width = f64::from(right - left);
    let per_pixel = (length(x) / width).max(length(y) / f64::from(TALLEST));
    let height = ((length(y) / per_pixel) as f32).clamp(FLATTEST, TALLEST);
    let about = |(low, high): (f64, f64), pixels: f64| {
        let (middle, half) = ((low + high) / 2.0, per_pixel * pixels / 2.0);
        (middle - half, middle + half)
    };
    let (above, below) = about(y, f64::from(height));
    Axes::even(about(x, width), (below, above), [left, top, right, top + height])
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
