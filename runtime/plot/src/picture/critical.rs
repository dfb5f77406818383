//! Critical speeds, or values of a parameter, in a graph: a line for each, and its value above the frame.

use carvallo::{CriticalKind, Mode};
use carvallo_design::number::fixed;

use super::axes::{Axes, INK};
use super::colors::color;
use super::font;
use super::labels::{Labels, THIN};
use super::scene::{Anchor, Color, Paint, Scene, dashed};

const SIZE: f32 = 13.0;
/// The height of a row of values.
const ROW: f32 = 19.0;
const WHITE: Color = Color(0xff, 0xff, 0xff);

/// What is critical: where, what happens there, and what that is called.
pub struct Event {
    pub at: f64,
    pub kind: CriticalKind,
    pub name: &'static str,
}

/// A critical speed or value with its text, and the row above the frame that has room for it.
pub struct Critical {
    at: f64,
    text: String,
    color: Color,
    /// The middle of the text on the page.
    x: f32,
    width: f32,
    row: u8,
}

/// Those that the axes show; only their horizontal extent matters here.
pub fn critical(events: &[Event], axes: &Axes) -> Vec<Critical> {
    let mut placed: Vec<Critical> = Vec::new();
    for &Event { at, kind, name } in events {
        if !(axes.x.0..=axes.x.1).contains(&at) {
            continue;
        }
        let color = match kind {
            CriticalKind::Weave if name == "wobble" => color(Mode::Wobble),
            CriticalKind::Weave => color(Mode::Weave),
            CriticalKind::Capsize => color(Mode::Capsize),
            CriticalKind::DoubleRoot => INK.lighter(0.3),
        };
        let text = format!("{} {}", name.replace('_', " "), fixed(at, 4)).replace('-', "−");
        let width = font::width(&text, SIZE);
        // Nothing stands out of the frame.
        let [left, _, right, _] = axes.area;
        let x = axes.place(at, 0.0).0.clamp(left + width / 2.0, right - width / 2.0);
        let has_room = |row: &u8| {
            let mut others = placed.iter().filter(|other| other.row == *row);
            others.all(|other| (other.x - x).abs() > (other.width + width) / 2.0 + 10.0)
        };
        let row = (0..8).find(has_room).unwrap_or(8);
        placed.push(Critical { at, text, color, x, width, row });
    }
    placed
}

/// The height that the values need above the frame.
pub fn height(critical: &[Critical]) -> f32 {
    let rows = critical.iter().map(|critical| critical.row + 1).max().unwrap_or(0);
    f32::from(rows) * ROW
}

/// Keeps labels off the lines, where there is room.
pub fn avoid(critical: &[Critical], axes: &Axes, labels: &mut Labels) {
    let [_, top, _, bottom] = axes.area;
    for Critical { at, .. } in critical {
        let (x, _) = axes.place(*at, 0.0);
        labels.avoid_line(&[(x, top), (x, bottom)], THIN);
    }
}

/// The lines, which make way for the labels that had no room beside them; in the first graph they begin at the values.
pub fn draw_lines(critical: &[Critical], axes: &Axes, labels: &Labels, is_first: bool, scene: &mut Scene) {
    let [_, top, _, bottom] = axes.area;
    for Critical { at, color, row, .. } in critical {
        let (x, _) = axes.place(*at, 0.0);
        let mut from = if is_first { base(top, *row) + 4.0 } else { top };
        for (to, next) in labels.crossed_at(x).into_iter().chain([(bottom, bottom)]) {
            scene.polyline(&[(x, from), (x, to)], dashed(1.2, [2.0, 3.0]), color.lighter(0.2));
            from = next;
        }
    }
}

/// The values above the frame.
pub fn write_values(critical: &[Critical], top: f32, scene: &mut Scene) {
    for Critical { text, color, x, width, row, .. } in critical {
        // The line of a value in a higher row may pass behind this one.
        let (base, half) = (base(top, *row), width / 2.0 + 3.0);
        scene.rectangle([x - half, base - 12.0, x + half, base + 4.0], Paint::Fill, WHITE);
        scene.text((*x, base), Anchor::Middle, SIZE, *color, text);
    }
}

/// The baseline of the values in a row.
fn base(top: f32, row: u8) -> f32 {
    top - 8.0 - f32::from(row) * ROW
}
