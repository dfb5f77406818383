//! Eigenvalues against a parameter: real parts above, frequencies below, as dots, since nothing is followed.

use carvallo_design::Failure;
use carvallo_design::number::{fixed, shortest, unit};

use super::axes::{self, Axes, INK};
use super::colors::other;
use super::font;
use super::graph::{range, roomy};
use super::scene::{Anchor, Color, Paint, Scene, dashed};
use crate::analysis::along::{AlongAnalysis, AtValue};

const WIDTH: f32 = 960.0;
const HEIGHT: f32 = 760.0;
const RIGHT: f32 = WIDTH - 28.0;
const BOTTOM: f32 = HEIGHT - 66.0;
const GAP: f32 = 26.0;
const ROW: f32 = 18.0;
const TEXT: f32 = 13.0;
const STABLE: Color = Color(0xdd, 0xf1, 0xde);
/// How many values are shown.
const VALUES: u32 = 601;
/// How far below zero real parts are shown, in multiples of the largest size of the rightmost one.
const BELOW: f64 = 4.0;

/// # Errors
/// If eigenvalues cannot be computed at one of the values.
pub fn draw_along(analysis: &AlongAnalysis, y: Option<(f64, f64)>) -> Result<Scene, Failure> {
    let rows = analysis.rows(VALUES)?;
    let AlongAnalysis { design, parameter, speed, range: ends, stability, .. } = analysis;
    let at = speed.map(|speed| format!(" at {} m/s", shortest(speed))).unwrap_or_default();
    let title = format!("Eigenvalues of {} against {}{at}", design.title(), parameter.name);
    let y = y.unwrap_or_else(|| real_parts(&rows));
    let frequencies = (0.0, roomy(range(rows.iter().flat_map(imaginary_parts).chain([0.0]))).1);
    let left = axes::margin(y).max(axes::margin(frequencies));
    let mut scene = Scene::new(title.clone(), WIDTH, HEIGHT);
    scene.text(((left + RIGHT) / 2.0, 32.0), Anchor::Middle, 18.0, INK, &title);
    let x = (ends[0], ends[1]);
    // The critical values, each in the first row in which it has room.
    let place = |value: f64| left + ((value - x.0) / (x.1 - x.0)) as f32 * (RIGHT - left);
    let mut ends_of_rows: Vec<f32> = Vec::new();
    let mut texts = Vec::new();
    for critical in &stability.critical_values {
        let text = format!("{} {}", analysis.name(critical).replace('_', " "), fixed(critical.value, 4));
        let half = font::width(&text, TEXT) / 2.0;
        let center = place(critical.value).clamp(left + half, RIGHT - half);
        let row = ends_of_rows.iter().position(|end| *end + 8.0 < center - half).unwrap_or(ends_of_rows.len());
        if row == ends_of_rows.len() {
            ends_of_rows.push(0.0);
        }
        ends_of_rows[row] = center + half;
        texts.push((center, row, text));
    }
    let top = 52.0 + ROW * ends_of_rows.len() as f32;
    for (center, row, text) in texts {
        scene.text((center, top - 6.0 - ROW * row as f32), Anchor::Middle, TEXT, INK, &text);
    }
    let split = top + 0.58 * (BOTTOM - top);
    let name = match unit(parameter.unit) {
        unit if unit.is_empty() => parameter.name.to_owned(),
        unit => format!("{} ({unit})", parameter.name),
    };
    let graphs =
        [(top, split - GAP, y, "real part (1/s)", false), (split, BOTTOM, frequencies, "frequency (rad/s)", true)];
    for (top, bottom, y, label, is_last) in graphs {
        let axes = Axes { x, y, area: [left, top, RIGHT, bottom] };
        for range in &stability.stable_ranges {
            scene.rectangle([place(range.from), top, place(range.to), bottom], Paint::Fill, STABLE);
        }
        axes.draw_grid(&mut scene);
        if y.0 < 0.0 && y.1 > 0.0 {
            let zero = [axes.place(x.0, 0.0), axes.place(x.1, 0.0)];
            scene.polyline(&zero, super::scene::line(1.2), INK.lighter(0.4));
        }
        for critical in &stability.critical_values {
            let at = place(critical.value);
            scene.polyline(&[(at, top), (at, bottom)], dashed(1.2, [2.0, 3.0]), INK.lighter(0.3));
        }
        for row in &rows {
            let parts: Vec<f64> = if is_last { imaginary_parts(row).collect() } else { reals(row).collect() };
            for part in parts.into_iter().filter(|part| (y.0..=y.1).contains(part)) {
                scene.circle(axes.place(row.value, part), 1.4, Paint::Fill, other(0));
            }
        }
        axes.draw_frame(&mut scene, is_last.then_some(name.as_str()), label);
    }
    if rows.iter().flat_map(reals).any(|part| !(y.0..=y.1).contains(&part)) {
        let note = format!("Real parts below {} or above {} are not shown.", fixed(y.0, 2), fixed(y.1, 2));
        scene.text((left, HEIGHT - 6.0), Anchor::Start, TEXT, INK, &note);
    }
    Ok(scene)
}

fn reals(row: &AtValue) -> impl Iterator<Item = f64> {
    row.eigenvalues.iter().filter(|value| value.im >= 0.0).map(|value| value.re)
}

fn imaginary_parts(row: &AtValue) -> impl Iterator<Item = f64> {
    row.eigenvalues.iter().filter(|value| value.im > 0.0).map(|value| value.im)
}

/// What is near the axis: the rightmost real parts, and so much below zero.
fn real_parts(rows: &[AtValue]) -> (f64, f64) {
    let rightmost = range(rows.iter().map(|row| reals(row).fold(f64::NEG_INFINITY, f64::max)));
    let all = range(rows.iter().flat_map(reals));
    let size = rightmost.0.abs().max(rightmost.1.abs());
    roomy((all.0.max(-BELOW * size), all.1.max(0.0)))
}
