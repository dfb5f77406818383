//! The outlines of the text in a drawing, from the one font that ships with the program: a part of Roboto, Apache License
//! 2.0.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::LazyLock;

use tiny_skia_path::{Path, PathBuilder, PathSegment, Point};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

static FONT: LazyLock<Font> = LazyLock::new(|| {
    let face = Face::parse(include_bytes!("../../fonts/Roboto-Subset.ttf"), 0);
    face.map_or_else(|_| Font::default(), |face| Font::of(&face))
});

/// The glyphs of characters, read once: a picture has a thousand.
#[derive(Default)]
struct Font {
    units_per_em: f32,
    glyphs: HashMap<char, Glyph>,
    /// The empty box of what the font lacks.
    missing: Glyph,
}

/// A glyph, in units of the font.
#[derive(Default)]
struct Glyph {
    /// From where it begins to where the next one does.
    advance: f32,
    /// A space has none.
    outline: Option<Path>,
}

impl Font {
    fn of(face: &Face) -> Self {
        let glyph = |id: GlyphId| {
            let mut pen = Pen(PathBuilder::new());
            face.outline_glyph(id, &mut pen);
            Glyph { advance: face.glyph_hor_advance(id).map_or(0.0, f32::from), outline: pen.0.finish() }
        };
        let mut glyphs = HashMap::new();
        for table in face.tables().cmap.into_iter().flat_map(|cmap| cmap.subtables).filter(|table| table.is_unicode()) {
            table.codepoints(|code| {
                if let (Some(char), Some(id)) = (char::from_u32(code), table.glyph_index(code)) {
                    glyphs.entry(char).or_insert_with(|| glyph(id));
                }
            });
        }
        Self { units_per_em: f32::from(face.units_per_em()), glyphs, missing: glyph(GlyphId(0)) }
    }

    fn glyph(&self, char: char) -> &Glyph {
        self.glyphs.get(&char).unwrap_or(&self.missing)
    }

    /// From where a glyph begins to where the next one does. Most of what the font lacks is as wide as it is high.
    fn advance(&self, char: char) -> f32 {
        self.glyphs.get(&char).map_or(self.units_per_em, |glyph| glyph.advance)
    }
}

/// The width of a line of text.
pub fn width(text: &str, size: f32) -> f32 {
    let scale = size / FONT.units_per_em;
    text.chars().map(|char| scale * FONT.advance(char)).sum()
}

/// Names of which none has more room than that, so that those which differ still do: what ends in dots alike has its beginning,
/// dots, and the rest from shortly before where it differs.
pub fn apart(names: &[&str], size: f32, room: f32) -> Vec<String> {
    let short: Vec<Cow<str>> = names.iter().map(|name| fitted(name, size, room)).collect();
    let kept = |(at, name): (usize, &&str)| {
        let others = names.iter().zip(&short).filter(|(other, same)| *other != name && **same == short[at]);
        let common = others.map(|(other, _)| name.chars().zip(other.chars()).take_while(|(a, b)| a == b).count()).max();
        common.map_or_else(|| short[at].clone().into_owned(), |common| without_middle(name, common, size, room))
    };
    names.iter().enumerate().map(kept).collect()
}

/// As much of the beginning of a name as has room before the rest, which begins shortly before a place.
fn without_middle(name: &str, place: usize, size: f32, room: f32) -> String {
    const BEFORE: usize = 8;
    let rest: String = name.chars().skip(place.saturating_sub(BEFORE)).collect();
    let rest = fitted(&rest, size, room / 2.0);
    fitted(name, size, room - width(&rest, size)).into_owned() + &rest
}

/// A line of text, or as much of it as has room, with dots behind it.
pub fn fitted(text: &str, size: f32, room: f32) -> Cow<'_, str> {
    const DOTS: &str = "...";
    if width(text, size) <= room {
        return Cow::Borrowed(text);
    }
    let mut left = room - width(DOTS, size);
    let has_room = |char: &char| {
        left -= width(char.encode_utf8(&mut [0; 4]), size);
        left >= 0.0
    };
    let kept: String = text.chars().take_while(has_room).collect();
    Cow::Owned(kept.trim_end().to_owned() + DOTS)
}

/// A text in lines that have room: broken between words, and within a word that is longer than a line.
pub fn lines(text: &str, size: f32, room: f32) -> Vec<&str> {
    let (mut lines, mut rest) = (Vec::new(), text);
    while width(rest, size) > room {
        let has_room = |at: &usize| width(&rest[..*at], size) <= room;
        let word = rest.match_indices(' ').map(|(at, _)| at).take_while(has_room).last();
        let letter = || rest.char_indices().map(|(at, _)| at).skip(1).take_while(has_room).last();
        let Some(end) = word.filter(|end| *end > 0).or_else(letter) else { break };
        let (line, others) = rest.split_at(end);
        lines.push(line);
        rest = others.trim_start();
    }
    lines.push(rest);
    lines
}

/// The outlines of a line of text that starts at the origin.
pub fn outline(text: &str, size: f32) -> PathBuilder {
    let scale = size / FONT.units_per_em;
    let mut builder = PathBuilder::new();
    let mut x = 0.0;
    for char in text.chars() {
        let Glyph { outline, .. } = FONT.glyph(char);
        // Fonts have y up, drawings have it down.
        let place = |point: Point| (x + point.x * scale, -point.y * scale);
        for segment in outline.iter().flat_map(Path::segments) {
            match segment {
                PathSegment::MoveTo(p) => {
                    let (x, y) = place(p);
                    builder.move_to(x, y);
                }
                PathSegment::LineTo(p) => {
                    let (x, y) = place(p);
                    builder.line_to(x, y);
                }
                PathSegment::QuadTo(p, q) => {
                    let ((x1, y1), (x, y)) = (place(p), place(q));
                    builder.quad_to(x1, y1, x, y);
                }
                PathSegment::CubicTo(p, q, r) => {
                    let ((x1, y1), (x2, y2), (x, y)) = (place(p), place(q), place(r));
                    builder.cubic_to(x1, y1, x2, y2, x, y);
                }
                PathSegment::Close => builder.close(),
            }
        }
        x += scale * FONT.advance(char);
    }
    builder
}

/// Draws a glyph as a path.
struct Pen(PathBuilder);

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.0.close();
    }
}

/// The characters of a text that the font lacks.
pub fn lacking(text: &str) -> impl Iterator<Item = char> {
    text.chars().filter(|char| !FONT.glyphs.contains_key(char))
}

/// Whether the font has all characters of a text.
pub fn has(text: &str) -> bool {
    lacking(text).next().is_none()
}

#[cfg(test)]
mod tests {
    use super::{apart, has, outline, width};

    #[test]
    fn the_font_has_what_names_are_written_in() {
        for text in ["λφδψθ²³°µ·×±−–—′″√∂≤≥≈∞", "Çağlar Šťastný Łódź Ø", "велосипед", "ποδήλατο", "Nguyễn", "e\u{301}"]
        {
            assert!(has(text), "{text}");
        }
        assert!(!has("自"));
    }

    /// In the table `hmtx` of Roboto a digit has 1151 units of 1/2048, a point 540 and the Greek letter lambda 1135.
    #[test]
    fn widths_are_those_of_the_font() {
        assert!((width("2.5", 204.8) - (2.0 * 115.1 + 54.0)).abs() < 1e-3, "{}", width("2.5", 204.8));
        assert!((width("λ", 204.8) - 113.5).abs() < 1e-3, "{}", width("λ", 204.8));
    }

    /// Names with the same beginning, of which one is the beginning of another; and short ones, which stay as they are.
    #[test]
    fn what_differs_is_kept() {
        let long = "a name of a bicycle that is much too long for the room beside the lines of a picture";
        let names = [&format!("{long}, one"), &format!("{long}, two"), &format!("{long}, one more"), "short", long];
        let short = apart(&names, 13.0, 200.0);
        for (at, name) in short.iter().enumerate() {
            assert!(width(name, 13.0) <= 200.0 && !short[..at].contains(name), "{short:?}");
        }
        assert_eq!((&*short[3], short[1].ends_with(", two")), ("short", true));
        assert!(short[0].starts_with("a name of") && short[0].contains("..."), "{short:?}");
    }

    /// What the font lacks is seen all the same, and keeps its place.
    #[test]
    fn what_is_missing_is_a_box() {
        assert!(width("自", 10.0) > 1.0);
        assert!(outline("自", 10.0).finish().is_some() && outline(" ", 10.0).finish().is_none());
    }
}
