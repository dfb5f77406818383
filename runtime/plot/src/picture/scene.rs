//! A drawing as a list of paths, text included: SVG and PNG then show the same, whatever fonts a machine has.

use tiny_skia_path::{Path, PathBuilder, Rect, Transform};

use super::font;

/// What stays free between a text and the edge of a drawing.
const EDGE: f32 = 2.0;

/// Red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

impl Color {
    /// The same colour mixed with white; 0 leaves it, 1 is white.
    pub fn lighter(self, share: f32) -> Self {
        let mix = |channel: u8| (f32::from(channel) + (255.0 - f32::from(channel)) * share).round() as u8;
        Self(mix(self.0), mix(self.1), mix(self.2))
    }
}

/// How a path is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Paint {
    /// Its inside.
    Fill,
    /// Its line.
    Stroke {
        /// In pixels.
        width: f32,
        /// Lengths of dash and gap.
        dash: Option<[f32; 2]>,
    },
}

/// A solid line.
pub const fn line(width: f32) -> Paint {
    Paint::Stroke { width, dash: None }
}

/// A dashed line.
pub const fn dashed(width: f32, dash: [f32; 2]) -> Paint {
    Paint::Stroke { width, dash: Some(dash) }
}

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// One path.
#[derive(Debug)]
pub struct Item {
    pub path: Path,
    pub paint: Paint,
    pub color: Color,
    /// The text that the path draws, for readers that cannot see it.
    pub text: Option<String>,
}

/// A drawing; x to the right and y down, in pixels.
#[derive(Debug)]
pub struct Scene {
    /// What it shows.
    pub title: String,
    /// In pixels.
    pub width: f32,
    /// In pixels.
    pub height: f32,
    /// In painting order.
    pub(super) items: Vec<Item>,
}

impl Scene {
    pub(super) fn new(title: String, width: f32, height: f32) -> Self {
        Self { title, width, height, items: Vec::new() }
    }

    pub(super) fn polyline(&mut self, points: &[(f32, f32)], paint: Paint, color: Color) {
        let mut builder = PathBuilder::new();
        for (index, &(x, y)) in points.iter().enumerate() {
            if index == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
        }
        self.add(builder, paint, color);
    }

    pub(super) fn circle(&mut self, (x, y): (f32, f32), radius: f32, paint: Paint, color: Color) {
        let mut builder = PathBuilder::new();
        builder.push_circle(x, y, radius);
        self.add(builder, paint, color);
    }

    pub(super) fn rectangle(&mut self, [left, top, right, bottom]: [f32; 4], paint: Paint, color: Color) {
        let mut builder = PathBuilder::new();
        if let Some(rectangle) = Rect::from_ltrb(left, top, right, bottom) {
            builder.push_rect(rectangle);
        }
        self.add(builder, paint, color);
    }

    /// Filled rectangles of one colour, each left, top, right, bottom, as one path.
    pub(super) fn rectangles(&mut self, rectangles: &[[f32; 4]], color: Color) {
        let mut builder = PathBuilder::new();
        for &[left, top, right, bottom] in rectangles {
            if let Some(rectangle) = Rect::from_ltrb(left, top, right, bottom) {
                builder.push_rect(rectangle);
            }
        }
        self.add(builder, Paint::Fill, color);
    }

    /// Text with its baseline at the point; what would leave the drawing ends in dots.
    pub(super) fn text(&mut self, (x, y): (f32, f32), anchor: Anchor, size: f32, color: Color, text: &str) {
        let room = match anchor {
            Anchor::Start => self.width - x,
            Anchor::Middle => 2.0 * x.min(self.width - x),
            Anchor::End => x,
        };
        let drawn = font::fitted(text, size, room - EDGE);
        let shift = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => font::width(&drawn, size) / 2.0,
            Anchor::End => font::width(&drawn, size),
        };
        self.glyphs(Transform::from_translate(x - shift, y), size, color, [&drawn, text]);
    }

    /// Text that begins at the point, and ends in dots where it has no more room.
    pub(super) fn text_within(&mut self, (x, y): (f32, f32), room: f32, size: f32, color: Color, text: &str) {
        let drawn = font::fitted(text, size, room);
        self.glyphs(Transform::from_translate(x, y), size, color, [&drawn, text]);
    }

    /// Text that runs upwards, centred at the point.
    pub(super) fn upward_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, text: &str) {
        let shift = font::width(text, size) / 2.0;
        self.glyphs(Transform::from_row(0.0, -1.0, 1.0, 0.0, x, y + shift), size, color, [text; 2]);
    }

    /// Text in the middle of the point, with an edge that keeps what is behind it off its letters.
    pub(super) fn edged_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, edge: Color, text: &str) {
        let place = Transform::from_translate(x - font::width(text, size) / 2.0, y);
        self.edge(place, size, edge, text);
        self.glyphs(place, size, color, [text; 2]);
    }

    /// The same for text that runs upwards.
    pub(super) fn edged_upward_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, edge: Color, text: &str) {
        let place = Transform::from_row(0.0, -1.0, 1.0, 0.0, x, y + font::width(text, size) / 2.0);
        self.edge(place, size, edge, text);
        self.glyphs(place, size, color, [text; 2]);
    }

    fn edge(&mut self, place: Transform, size: f32, color: Color, text: &str) {
        if let Some(path) = font::outline(text, size).finish().and_then(|path| path.transform(place)) {
            self.items.push(Item { path, paint: line(5.0), color, text: None });
        }
    }

    /// A text as it is drawn, and all of it.
    fn glyphs(&mut self, place: Transform, size: f32, color: Color, [drawn, text]: [&str; 2]) {
        if let Some(path) = font::outline(drawn, size).finish().and_then(|path| path.transform(place)) {
            self.items.push(Item { path, paint: Paint::Fill, color, text: Some(text.to_owned()) });
        }
    }

    /// Paths of fewer than two points have nothing to paint.
    fn add(&mut self, builder: PathBuilder, paint: Paint, color: Color) {
        if let Some(path) = builder.finish() {
            self.items.push(Item { path, paint, color, text: None });
        }
    }
}
