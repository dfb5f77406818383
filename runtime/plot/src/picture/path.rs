//! The paths of wheels over the ground, to scale, as seen from above: x to the right and y, which is to the right of who
//! rides, downward.

use carvallo_design::DisplayUnit;
use carvallo_design::units::Units;

use super::axes::{Axes, margin};
use super::graph::{range, write_names};
use super::motion::{BESIDE, LIGHTER};
use super::scene::{Color, Paint, Scene, line};
use crate::analysis::simulation::{self, Motion};

/// The least room left of the graph.
const MARGIN: f32 = 84.0;
const TALLEST: f32 = 420.0;
const FLATTEST: f32 = 90.0;
const BELOW: f32 = 62.0;
const WHEELS: [Color; 2] = [Color(0x22, 0x22, 0x22), Color(0xd0, 0x6a, 0x10)];

/// The paths of a motion, and those of the linear one beside it.
pub struct Paths {
    own: Vec<(&'static str, Path)>,
    beside: Vec<(&'static str, Path)>,
    unit: DisplayUnit,
}

type Path = Vec<(f64, f64)>;

impl Paths {
    /// In the unit of lengths.
    pub fn new(motion: &Motion, linear: Option<&Motion>, units: &Units) -> Self {
        let paths = [Some(motion), linear].map(|motion| motion.map(simulation::paths).unwrap_or_default());
        let unit = if paths[0].is_empty() { DisplayUnit::declared("m") } else { units.of("m") };
        let in_unit = |path: Path| path.into_iter().map(|(x, y)| (unit.value(x), unit.value(y))).collect();
        let [own, beside] = paths.map(|paths| paths.into_iter().map(|(name, path)| (name, in_unit(path))).collect());
        Self { own, beside, unit }
    }

    /// The room that they need left of the graph, which ends at the right.
    pub fn margin(&self, right: f32) -> f32 {
        if self.own.is_empty() { MARGIN } else { margin(self.axes([MARGIN, right], 0.0).y).max(MARGIN) }
    }

    /// Draws the paths, if there are any; where the picture goes on below.
    pub fn draw(&self, [left, right]: [f32; 2], top: f32, scene: &mut Scene) -> f32 {
        if self.own.is_empty() {
            return top;
        }
        let names: Vec<String> = self.own.iter().map(|(name, _)| format!("path of the {name}")).collect();
        let named = names.iter().zip(WHEELS).map(|(name, color)| (line(2.2), color, name.as_str()));
        let top = write_names(named, [left, right], top, scene);
        let axes = self.axes([left, right], top);
        axes.draw_grid(scene);
        for ((_, path), color) in self.beside.iter().zip(WHEELS) {
            polyline(path, &axes, BESIDE, color.lighter(LIGHTER), scene);
        }
        for ((_, path), color) in self.own.iter().zip(WHEELS) {
            polyline(path, &axes, line(2.2), color, scene);
            if let Some(&(x, y)) = path.first() {
                scene.circle(axes.place(x, y), 3.5, Paint::Fill, color);
            }
        }
        let unit = self.unit.behind_name();
        axes.draw_frame(scene, Some(&format!("forward at the start, x{unit}")), &format!("to the right, y{unit}"));
        axes.area[3] + BELOW
    }

    /// Axes on which a metre is as long upward as across, and that show all points: over the whole width, and no taller than they
    /// may be. y grows downward.
    fn axes(&self, [left, right]: [f32; 2], top: f32) -> Axes {
        let points = || self.own.iter().flat_map(|(_, path)| path);
        let (x, y) = (range(points().map(|point| point.0)), range(points().map(|point| point.1)));
        let length = |(low, high): (f64, f64)| 1.1 * (high - low) + self.unit.value(2e-3);
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
