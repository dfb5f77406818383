//! A drawing as SVG.

use std::fmt::Write as _;

use tiny_skia_path::{Path, PathSegment, Point};

use super::scene::{Color, Item, Paint, Scene};

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
    for Item { path, paint, color, text } in items {
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
        // Writing to a string cannot fail.
        let _ = writeln!(svg, "<path{label} {style} d=\"{}\"/>", data(path));
    }
    svg.push_str("</svg>\n");
    svg
}

fn data(path: &Path) -> String {
    let mut data = String::new();
    for segment in path.segments() {
        let (command, points) = match segment {
            PathSegment::MoveTo(p) => ('M', vec![p]),
            PathSegment::LineTo(p) => ('L', vec![p]),
            PathSegment::QuadTo(p, q) => ('Q', vec![p, q]),
            PathSegment::CubicTo(p, q, r) => ('C', vec![p, q, r]),
            PathSegment::Close => ('Z', vec![]),
        };
        data.push(command);
        for (index, Point { x, y }) in points.into_iter().enumerate() {
            let space = if index == 0 { "" } else { " " };
            let _ = write!(data, "{space}{} {}", hundredths(x), hundredths(y));
        }
    }
    data
}

/// A hundredth of a pixel is finer than anyone sees.
fn hundredths(value: f32) -> f32 {
    (value * 100.0).round() / 100.0 + 0.0
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
