//! One of several graphs above each other, with its lines named above it.

use std::borrow::Cow;

use super::axes::{Axes, INK, Scale};
use super::curves::{Curve, clip};
use super::font;
use super::scene::{Anchor, Color, Paint, Scene};

/// The room of the names above a graph, and below it of the numbers and what they are, if they stand there.
const NAMES: f32 = 26.0;
/// From one line of names to the next, and between two names.
const LINE_OF_NAMES: f32 = 20.0;
const BETWEEN: f32 = 24.0;
const NUMBERS: f32 = 70.0;
const GAP: f32 = 16.0;
const TEXT_SIZE: f32 = 14.0;

/// A graph.
pub struct Graph {
    /// What its vertical axis shows.
    pub title: Cow<'static, str>,
    pub height: f32,
    pub x: (f64, f64),
    pub y: (f64, f64),
    /// Of both axes.
    pub scales: [Scale; 2],
    /// In painting order.
    pub lines: Vec<Line>,
    /// What else stands among the names, with the way it is painted.
    pub note: Option<(Paint, Color, &'static str)>,
}

/// A curve in data; without a name it belongs to another one.
pub struct Line {
    pub name: Option<String>,
    pub color: Color,
    pub paint: Paint,
    pub curve: Curve,
}

impl Graph {
    /// Draws it from a height on the page, between left and right; the height below it. Without a label for the horizontal axis
    /// another graph goes on below, which has it.
    pub fn draw(&self, x_label: Option<&str>, [left, right]: [f32; 2], top: f32, scene: &mut Scene) -> f32 {
        let named = self.lines.iter().filter_map(|line| Some((line.paint, line.color, line.name.as_deref()?)));
        let top = write_names(named.chain(self.note), [left, right], top, scene);
        let axes = Axes { x: self.x, y: self.y, area: [left, top, right, top + self.height], scales: self.scales };
        axes.draw_grid(scene);
        for line in &self.lines {
            for piece in clip(&line.curve, axes.y) {
                let points: Vec<(f32, f32)> = piece.into_iter().map(|(x, y)| axes.place(x, y)).collect();
                scene.polyline(&points, line.paint, line.color);
            }
        }
        axes.draw_frame(scene, x_label, &self.title);
        top + self.height + if x_label.is_some() { NUMBERS } else { GAP }
    }
}

/// What lines are called, side by side, or where there are too many for one line of text, below each other in columns; the height below
/// all of it, [`NAMES`] further down than one line.
pub fn write_names<'a>(
    names: impl Iterator<Item = (Paint, Color, &'a str)>,
    [left, right]: [f32; 2],
    top: f32,
    scene: &mut Scene,
) -> f32 {
    let names: Vec<_> = names.collect();
    let widths: Vec<f32> = names.iter().map(|(_, _, name)| 34.0 + font::width(name, TEXT_SIZE) + BETWEEN).collect();
    let widest = widths.iter().fold(1.0, |widest: f32, width| widest.max(*width));
    let fits = widths.iter().sum::<f32>() - BETWEEN <= right - left;
    let columns = if fits { names.len() } else { ((right - left + BETWEEN) / widest).max(1.0) as usize };
    let mut x = left;
    for (index, (paint, color, name)) in names.iter().enumerate() {
        if index % columns == 0 {
            x = left;
        }
        let base = top + 14.0 + LINE_OF_NAMES * (index / columns) as f32;
        scene.polyline(&[(x, base - 5.0), (x + 28.0, base - 5.0)], *paint, *color);
        scene.text((x + 34.0, base), Anchor::Start, TEXT_SIZE, INK, name);
        x += if fits { widths[index] } else { widest };
    }
    top + NAMES + LINE_OF_NAMES * (names.len().saturating_sub(1) / columns.max(1)) as f32
}

/// A range with some room at both ends; what hardly changes is shown as that.
pub fn roomy((low, high): (f64, f64)) -> (f64, f64) {
    if low == 0.0 && high == 0.0 {
        return (-1.0, 1.0);
    }
    let least = 0.1 * high.abs().max(low.abs()).max(1e-5);
    let missing = (least - (high - low)).max(0.0) / 2.0;
    let room = 0.06 * (high - low).max(least);
    (low - missing - room, high + missing + room)
}

/// The least and the largest of some values.
pub fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}
