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
    /// How it is written where the font lacks some of it and others may have it.
    pub lettering: Option<Lettering>,
}

/// A line of text as a font writes it.
#[derive(Clone, Debug)]
pub struct Lettering {
    /// As much of the text as is written.
    pub text: String,
    pub size: f32,
    /// Where its origin goes, and from there its anchor on the baseline.
    pub place: Transform,
    pub anchor: Anchor,
    pub x: f32,
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
        self.glyphs(Transform::from_translate(x - shift, y), anchor, size, color, [&drawn, text]);
    }

    /// A short form of a text, with its baseline from the point on.
    pub(super) fn short_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, [short, text]: [&str; 2]) {
        self.glyphs(Transform::from_translate(x, y), Anchor::Start, size, color, [short, text]);
    }

    /// A title about a point: smaller where it is long, and in two lines where that is not enough.
    pub(super) fn heading(&mut self, point: (f32, f32), color: Color, text: &str) {
        self.short_heading(point, color, [text; 2]);
    }

    /// The same of a short form of a title.
    pub(super) fn short_heading(&mut self, (x, y): (f32, f32), color: Color, [short, text]: [&str; 2]) {
        const SIZES: [f32; 4] = [18.0, 16.0, 14.5, 13.0];
        const LEAST: f32 = SIZES[3];
        let room = 2.0 * x.min(self.width - x) - 2.0 * EDGE;
        let mut line = |line: &str, y: f32, size: f32, text: &str| {
            let drawn = font::fitted(line, size, room);
            let left = Transform::from_translate(x - font::width(&drawn, size) / 2.0, y);
            self.glyphs(left, Anchor::Middle, size, color, [&drawn, text]);
        };
        if let Some(size) = SIZES.into_iter().find(|size| font::width(short, *size) <= room) {
            return line(short, y, size, text);
        }
        let has_room = |at: &usize| font::width(&short[..*at], LEAST) <= room;
        let end = short.match_indices(' ').map(|(at, _)| at).take_while(has_room).last().unwrap_or(short.len());
        let (first, second) = short.split_at(end);
        line(first, y - 9.0, LEAST, text);
        line(second.trim_start(), y + 7.0, LEAST, second.trim_start());
    }

    /// Text that runs upwards, centred at the point.
    pub(super) fn upward_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, text: &str) {
        let shift = font::width(text, size) / 2.0;
        self.glyphs(Transform::from_row(0.0, -1.0, 1.0, 0.0, x, y + shift), Anchor::Middle, size, color, [text; 2]);
    }

    /// Text in the middle of the point, with an edge that keeps what is behind it off its letters.
    pub(super) fn edged_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, edge: Color, text: &str) {
        let place = Transform::from_translate(x - font::width(text, size) / 2.0, y);
        self.edge(place, size, edge, text);
        self.glyphs(place, Anchor::Middle, size, color, [text; 2]);
    }

    /// The same for text that runs upwards.
    pub(super) fn edged_upward_text(&mut self, (x, y): (f32, f32), size: f32, color: Color, edge: Color, text: &str) {
        let place = Transform::from_row(0.0, -1.0, 1.0, 0.0, x, y + font::width(text, size) / 2.0);
        self.edge(place, size, edge, text);
        self.glyphs(place, Anchor::Middle, size, color, [text; 2]);
    }

    fn edge(&mut self, place: Transform, size: f32, color: Color, text: &str) {
        if let Some(path) = font::outline(text, size).finish().and_then(|path| path.transform(place)) {
            let lettering = lettering(text, size, place, Anchor::Middle);
            self.items.push(Item { path, paint: line(5.0), color, text: None, lettering });
        }
    }

    /// A text as it is drawn, and all of it.
    fn glyphs(&mut self, place: Transform, anchor: Anchor, size: f32, color: Color, [drawn, text]: [&str; 2]) {
        if let Some(path) = font::outline(drawn, size).finish().and_then(|path| path.transform(place)) {
            let lettering = lettering(drawn, size, place, anchor);
            self.items.push(Item { path, paint: Paint::Fill, color, text: Some(text.to_owned()), lettering });
        }
    }

    /// The characters that are drawn as boxes where nothing but the paths is shown, each once.
    pub fn lacking(&self) -> String {
        let mut lacking = String::new();
        for char in self.items.iter().filter_map(|item| item.lettering.as_ref()).flat_map(|it| font::lacking(&it.text))
        {
            if !lacking.contains(char) {
                lacking.push(char);
            }
        }
        lacking
    }

    /// Paths of fewer than two points have nothing to paint.
    fn add(&mut self, builder: PathBuilder, paint: Paint, color: Color) {
        if let Some(path) = builder.finish() {
            self.items.push(Item { path, paint, color, text: None, lettering: None });
        }
    }
}

/// What the font lacks some of.
fn lettering(text: &str, size: f32, place: Transform, anchor: Anchor) -> Option<Lettering> {
    let x = match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => font::width(text, size) / 2.0,
        Anchor::End => font::width(text, size),
    };
    (!font::has(text)).then(|| Lettering { text: text.to_owned(), size, place, anchor, x })
}

#[cfg(test)]
mod tests {
    use super::{Color, Scene};

    /// Short titles stand alone; long ones in two lines, within the drawing, and only then are cut.
    #[test]
    fn titles_keep_what_has_room() {
        let headed = |text: &str| {
            let mut scene = Scene::new(String::new(), 400.0, 100.0);
            scene.heading((200.0, 32.0), Color(0, 0, 0), text);
            scene
        };
        let words = "word ".repeat(20);
        for (text, lines, is_cut) in [("word", 1, false), (words.trim_end(), 2, false), (&"word ".repeat(40), 2, true)]
        {
            let scene = headed(text);
            assert_eq!(scene.items.len(), lines);
            let ends = |item: &super::Item| item.path.bounds().left() >= 0.0 && item.path.bounds().right() <= 400.0;
            assert!(scene.items.iter().all(ends));
            let written: Vec<&str> = scene.items.iter().filter_map(|item| item.text.as_deref()).collect();
            assert_eq!(written[0], text);
            let second = written.get(1).map_or(0.0, |line| super::font::width(line, 13.0));
            assert_eq!(second > 400.0, is_cut, "{written:?}");
        }
    }
}
