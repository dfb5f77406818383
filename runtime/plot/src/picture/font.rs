//! The outlines of the text in a drawing, from the one font that ships with the program: Roboto, Apache License 2.0.

use std::sync::LazyLock;

use tiny_skia_path::PathBuilder;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

static FACE: LazyLock<Option<Face>> =
    LazyLock::new(|| Face::parse(include_bytes!("../../fonts/Roboto-Regular.ttf"), 0).ok());

/// The width of a line of text.
pub fn width(text: &str, size: f32) -> f32 {
    let Some(face) = FACE.as_ref() else { return 0.0 };
    let scale = size / f32::from(face.units_per_em());
    text.chars().map(|char| scale * advance(face, glyph(face, char))).sum()
}

/// The outlines of a line of text that starts at the origin.
pub fn outline(text: &str, size: f32) -> PathBuilder {
    let mut pen = Pen { builder: PathBuilder::new(), x: 0.0, scale: 0.0 };
    let Some(face) = FACE.as_ref() else { return pen.builder };
    pen.scale = size / f32::from(face.units_per_em());
    for char in text.chars() {
        let glyph = glyph(face, char);
        face.outline_glyph(glyph, &mut pen);
        pen.x += pen.scale * advance(face, glyph);
    }
    pen.builder
}

/// Characters that the font lacks show as its empty box.
fn glyph(face: &Face, char: char) -> GlyphId {
    face.glyph_index(char).unwrap_or_default()
}

fn advance(face: &Face, glyph: GlyphId) -> f32 {
    face.glyph_hor_advance(glyph).map_or(0.0, f32::from)
}

struct Pen {
    builder: PathBuilder,
    x: f32,
    scale: f32,
}

impl Pen {
    /// Fonts have y up, drawings have it down.
    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + x * self.scale, -y * self.scale)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.builder.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.builder.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}

#[cfg(test)]
mod tests {
    use super::FACE;

    #[test]
    fn the_font_has_what_the_drawings_need() {
        let face = FACE.as_ref().expect("the font parses");
        for char in "λ±−–²·°µ()/αz0123456789".chars() {
            assert!(face.glyph_index(char).is_some(), "{char}");
        }
    }
}
