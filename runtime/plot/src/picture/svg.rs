//! A drawing as SVG.

use std::fmt::Write as _;

use tiny_skia_path::{Path, PathSegment, Point};

use super::scene::{Anchor, Color, Item, Lettering, Paint, Scene};

impl Scene {
    /// The drawing as SVG.
    pub fn svg(&self) -> String {
        write(self)
    }
}

fn write(Scene { title, width, height, items }: &Scene) -> String {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} \
         {height}\" role=\"img\">\n<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        escaped(title)
    );
    for Item { path, paint, color, text, lettering } in items {
        let Color(red, green, blue) = color;
        let color = format!("#{red:02x}{green:02x}{blue:02x}");
        let style = match paint {
            Paint::Fill => format!("fill=\"{color}\""),
            Paint::Stroke { width, dash } => {
                let dash = dash.map(|[on, off]| format!(" stroke-dasharray=\"{on} {off}\"")).unwrap_or_default();
                format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dash}")
            }
        };
        let label = text.as_ref().map(|text| format!(" aria-label=\"{}\"", escaped(text))).unwrap_or_default();
        if let Some(lettering) = lettering {
            svg.push_str(&written(lettering, &label, &style));
            continue;
        }
        // Writing to a string cannot fail.
        let _ = writeln!(svg, "<path{label} {style} d=\"{}\"/>", data(path));
    }
    svg.push_str("</svg>\n");
    svg
}

/// A text by the fonts of whoever shows the drawing.
fn written(Lettering { text, size, place, anchor, x }: &Lettering, label: &str, style: &str) -> String {
    let anchor = match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let tiny_skia_path::Transform { sx, kx, ky, sy, tx, ty } = place;
    format!(
        "<text{label} {style} font-family=\"Roboto, sans-serif\" font-size=\"{size}\" text-anchor=\"{anchor}\" \
         x=\"{x}\" transform=\"matrix({sx} {ky} {kx} {sy} {tx} {ty})\">{}</text>\n",
        escaped(text)
    )
}

/// The segments of a path, in hundredths of a pixel, which are finer than anyone sees: each from the end of the one before,
/// which takes half the digits that places on the page take.
fn data(path: &Path) -> String {
    let mut data = Data::default();
    let mut start = (0, 0);
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(p) => {
                data.segment('m', &[p]);
                start = data.place;
            }
            PathSegment::LineTo(p) if rounded(p).1 == data.place.1 => data.along('h', rounded(p).0 - data.place.0, p),
            PathSegment::LineTo(p) if rounded(p).0 == data.place.0 => data.along('v', rounded(p).1 - data.place.1, p),
            PathSegment::LineTo(p) => data.segment('l', &[p]),
            PathSegment::QuadTo(p, q) => data.segment('q', &[p, q]),
            PathSegment::CubicTo(p, q, r) => data.segment('c', &[p, q, r]),
            PathSegment::Close => {
                data.command('z');
                data.place = start;
            }
        }
    }
    data.text
}

/// The text of a path up to a place.
#[derive(Default)]
struct Data {
    text: String,
    command: Option<char>,
    /// In hundredths of a pixel, so that nothing adds up that was rounded.
    place: (i64, i64),
}

impl Data {
    /// What is the same as before stands for both, but a close.
    fn command(&mut self, command: char) {
        if self.command != Some(command) || command == 'z' {
            self.text.push(command);
            self.command = Some(command);
        }
    }

    fn segment(&mut self, command: char, points: &[Point]) {
        self.command(command);
        let (x, y) = self.place;
        for &point in points {
            self.place = rounded(point);
            self.number(self.place.0 - x);
            self.number(self.place.1 - y);
        }
    }

    fn along(&mut self, command: char, distance: i64, end: Point) {
        self.command(command);
        self.number(distance);
        self.place = rounded(end);
    }

    /// A number of hundredths, without zeros that say nothing.
    fn number(&mut self, hundredths: i64) {
        if hundredths < 0 {
            self.text.push('-');
        } else if self.text.ends_with(|last: char| last.is_ascii_digit()) {
            self.text.push(' ');
        }
        let (mut whole, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
        // By digits, since a picture has ten thousands of numbers, and formatting them takes more than twice as long.
        let mut digits = [b'0'; 20];
        let mut first = digits.len();
        while whole > 0 || (first == digits.len() && rest == 0) {
            first -= 1;
            digits[first] = b'0' + (whole % 10) as u8;
            whole /= 10;
        }
        self.text.extend(digits[first..].iter().map(|&digit| char::from(digit)));
        if rest > 0 {
            let digit = |number: u64| char::from(b'0' + number as u8);
            self.text.extend(['.', digit(rest / 10)]);
            self.text.extend((rest % 10 > 0).then(|| digit(rest % 10)));
        }
    }
}

fn rounded(Point { x, y }: Point) -> (i64, i64) {
    let hundredths = |value: f32| (100.0 * value).round() as i64;
    (hundredths(x), hundredths(y))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use crate::picture::scene::{Anchor, Color, Paint, Scene, line};

    /// The grammar of paths: from a place, small letters are ways, and a letter that is the same as before is left out.
    #[test]
    fn paths_are_ways_from_point_to_point() {
        let mut scene = Scene::new("a < b".to_owned(), 40.0, 30.5);
        scene.polyline(
            &[(1.0, 2.0), (1.5, 2.25), (3.25, -0.5), (3.25, 10.0), (2.001, 10.0)],
            line(2.0),
            Color(255, 0, 16),
        );
        scene.rectangle([0.0, 0.05, 10.0, 20.0], Paint::Fill, Color(0, 0, 0));
        let expected = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"30.5\" viewBox=\"0 0 40 30.5\" role=\"img\">\n\
                        <title>a &lt; b</title>\n\
                        <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
                        <path fill=\"none\" stroke=\"#ff0010\" stroke-width=\"2\" stroke-linejoin=\"round\" \
                        d=\"m1 2l.5 .25 1.75-2.75v10.5h-1.25\"/>\n\
                        <path fill=\"#000000\" d=\"m0 .05h10v19.95h-10z\"/>\n\
                        </svg>\n";
        assert_eq!(scene.svg(), expected);
    }

    /// A browser has glyphs that the font lacks; what the font has stays a path. An em of the font is as wide as its size.
    #[test]
    fn what_the_font_lacks_is_text() {
        let mut scene = Scene::new(String::new(), 100.0, 50.0);
        scene.text((50.0, 20.0), Anchor::Middle, 10.0, Color(0, 0, 0), "自転<");
        scene.upward_text((50.0, 20.0), 10.0, Color(0, 0, 0), "車");
        scene.text((50.0, 20.0), Anchor::Middle, 10.0, Color(0, 0, 0), "λ");
        let svg = scene.svg();
        let texts: Vec<&str> = svg.lines().filter(|line| line.starts_with("<text ")).collect();
        assert_eq!(texts.len(), 2, "{svg}");
        assert!(texts[0].contains("text-anchor=\"middle\"") && texts[0].ends_with(">自転&lt;</text>"), "{}", texts[0]);
        assert!(texts[1].contains("x=\"5\" transform=\"matrix(0 -1 1 0 50 25)\""), "{}", texts[1]);
        assert!(svg.contains("<path aria-label=\"λ\""), "{svg}");
        assert_eq!(scene.lacking(), "自転車");
    }

    /// Of a thousand steps of a third of a hundredth none is lost, and none adds up.
    #[test]
    fn rounding_does_not_add_up() {
        let points: Vec<(f32, f32)> = (0..=1000).map(|step| (step as f32 / 300.0, 0.0)).collect();
        let mut scene = Scene::new(String::new(), 10.0, 10.0);
        scene.polyline(&points, line(1.0), Color(0, 0, 0));
        let svg = scene.svg();
        let data = svg.split_once("d=\"m0 0h").unwrap().1.split_once('"').unwrap().0;
        let end: f64 = data.split(' ').map(|step| step.parse::<f64>().unwrap()).sum();
        assert!((end - 1000.0 / 300.0).abs() < 0.0051, "{end}");
    }
}
