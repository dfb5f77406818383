//! What the axes do not show of the curves: marks where these leave, and a note below the graph.

use carvallo_design::number::shortest;

use super::axes::{Axes, INK};
use super::font;
use super::scene::{Anchor, Color, Paint, Scene};
use super::series::Series;

const SIZE: f32 = 13.0;
/// The height of a line of the note.
pub const ROW: f32 = 19.0;

/// The lines of the note; none if the axes show every curve. The unit, behind a space, is that of the horizontal axis; of several
/// graphs each says which it is for.
pub fn note(series: &[Series], y: (f64, f64), unit: &str, graph: Option<&str>, width: f32) -> Vec<String> {
    let mut parts: Vec<String> = series.iter().flat_map(|series| beyond(series, y, unit)).collect();
    let Some(first) = parts.first_mut() else { return parts };
    let graph = graph.map(|graph| format!(" of {graph}")).unwrap_or_default();
    *first = format!("Beyond the axes{graph}: {first}");
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if font::width(&format!("{line}; {part}"), SIZE) <= width => *line = format!("{line}; {part}"),
            Some(line) => {
                line.push(';');
                lines.push(part);
            }
            None => lines.push(part),
        }
    }
    lines
}

/// How far a series goes on above and below the axes.
fn beyond(series: &Series, (low, high): (f64, f64), unit: &str) -> Vec<String> {
    let points = || series.curves.iter().flatten().copied();
    let by_value = |a: &(f64, f64), b: &(f64, f64)| a.1.total_cmp(&b.1);
    let (Some(least), Some(most)) = (points().min_by(by_value), points().max_by(by_value)) else { return Vec::new() };
    let name = &series.name;
    if least.1 > high || most.1 < low {
        return vec![format!("all of {name}, {} to {}", three_digits(least.1), three_digits(most.1))];
    }
    let ends = [(least, least.1 < low), (most, most.1 > high)];
    let left = ends.into_iter().filter(|(_, is_beyond)| *is_beyond);
    left.map(|((at, value), _)| format!("{name} to {} at {}{unit}", three_digits(value), three_digits(at))).collect()
}

fn three_digits(value: f64) -> String {
    shortest(format!("{value:.2e}").parse().unwrap_or(value)).replace('-', "−")
}

/// Writes the note, from the height of its first line on.
pub fn write(lines: &[String], left: f32, top: f32, scene: &mut Scene) {
    let mut base = top;
    for text in lines {
        scene.text((left, base), Anchor::Start, SIZE, INK, text);
        base += ROW;
    }
}

/// A head where a line, cut at the upper or lower edge, leaves the axes.
pub fn draw_heads(points: &[(f32, f32)], axes: &Axes, color: Color, scene: &mut Scene) {
    let [_, top, _, bottom] = axes.area;
    for (x, y) in [points.first(), points.last()].into_iter().flatten().copied() {
        for (edge, outward) in [(top, -1.0), (bottom, 1.0)] {
            // Frequencies end at zero where they do, and not since the axis does.
            let is_end = outward > 0.0 && axes.y.0 == 0.0;
            if (y - edge).abs() < 0.01 && !is_end {
                let head = [(x, y), (x - 5.0, y - 9.0 * outward), (x + 5.0, y - 9.0 * outward)];
                scene.polyline(&head, Paint::Fill, color);
            }
        }
    }
}
