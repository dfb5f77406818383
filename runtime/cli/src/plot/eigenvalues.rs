//! Eigenvalues against speed, as figure 4 of Meijaard et al. (2007) shows them.

use carvallo::Mode;

use super::axes::{self, Axes, INK};
use super::critical;
use super::curves::{Curve, Pair, alone, clip, extent, pairs, samples};
use super::font;
use super::labels::{LINE, Labels};
use super::ordered;
use super::scene::{Anchor, Color, Paint, Scene, dashed, line};
use crate::analysis::{Analysis, Eigenvalues, ModeRow, Row, Rows};
use crate::failure::Failure;

const WIDTH: f32 = 960.0;
const HEIGHT: f32 = 640.0;
const RIGHT: f32 = WIDTH - 28.0;
const BOTTOM: f32 = HEIGHT - 66.0;
const LABEL_SIZE: f32 = 15.0;
const STABLE: Color = Color(0xdd, 0xf1, 0xde);
const STABLE_TEXT: Color = Color(0x2e, 0x7d, 0x32);

/// The eigenvalues between two speeds, the second above the first.
///
/// # Errors
/// If they cannot be computed at one of the speeds.
pub fn eigenvalues(analysis: &Analysis, (low, high): (f64, f64)) -> Result<Scene, Failure> {
    let rows = analysis.rows(&samples(analysis, low, high))?;
    let (speed, extent) = match &rows {
        Rows::Modes(rows) => {
            ("forward speed", extent(rows.iter().flat_map(|row| row.values.iter().map(|mode| mode.value))))
        }
        Rows::Sorted(rows) => ("speed", extent(rows.iter().flat_map(|row| row.values.values.iter().copied()))),
    };
    let title = format!("Eigenvalues of {} against {speed}", analysis.design.title());
    let mut scene = Scene::new(title.clone(), WIDTH, HEIGHT);
    let left = axes::margin((-extent, extent));
    scene.text(((left + RIGHT) / 2.0, 32.0), Anchor::Middle, 18.0, INK, &title);
    let mut axes = Axes { x: (low, high), y: (-extent, extent), area: [left, 0.0, RIGHT, BOTTOM] };
    let critical = critical::critical(analysis, &axes);
    let top = 56.0 + critical::height(&critical);
    axes.area[1] = top;

    let mut labels = Labels::new(axes.area);
    let stable = stable_ranges(analysis, &axes);
    for &(left, right) in &stable {
        scene.rectangle([left, top, right, BOTTOM], Paint::Fill, STABLE);
    }
    axes.grid(&mut scene);
    stable_labels(&stable, &mut scene, &mut labels);
    let (_, zero) = axes.place(low, 0.0);
    labels.avoid_line(&[(left, zero), (RIGHT, zero)], LINE);
    critical::avoid(&critical, &axes, &mut labels);
    // Labels know the curves, and critical speeds the labels, but curves are painted over critical speeds.
    let mut curves = Scene::new(title, WIDTH, HEIGHT);
    match &rows {
        Rows::Modes(rows) => modes(rows, &axes, &mut curves, &mut labels),
        Rows::Sorted(rows) => sorted(rows, &axes, &mut curves, &mut labels),
    }
    critical::draw(&critical, &axes, &labels, &mut scene);
    scene.items.append(&mut curves.items);
    axes.frame(&mut scene, &format!("{speed} v (m/s)"), "eigenvalue λ (1/s)");
    Ok(scene)
}

/// Where the stable ranges begin and end on the page.
fn stable_ranges(analysis: &Analysis, axes: &Axes) -> Vec<(f32, f32)> {
    let ranges = analysis.stable_ranges().iter();
    let visible = ranges.map(|range| (range.from.max(axes.x.0), range.to.unwrap_or(axes.x.1).min(axes.x.1)));
    visible.filter(|(from, to)| from < to).map(|(from, to)| (axes.place(from, 0.0).0, axes.place(to, 0.0).0)).collect()
}

/// Across where there is room, upwards where there is little.
fn stable_labels(ranges: &[(f32, f32)], scene: &mut Scene, labels: &mut Labels) {
    let width = font::width("stable", LABEL_SIZE);
    for (left, right) in ranges {
        let middle = (left + right) / 2.0;
        if right - left > width + 10.0 {
            scene.text((middle, BOTTOM - 10.0), Anchor::Middle, LABEL_SIZE, STABLE_TEXT, "stable");
            labels.avoid_box([middle - width / 2.0, BOTTOM - 26.0, middle + width / 2.0, BOTTOM]);
        } else if right - left > LABEL_SIZE {
            scene.upward_text((middle + 5.0, BOTTOM - 12.0 - width / 2.0), LABEL_SIZE, STABLE_TEXT, "stable");
            labels.avoid_box([middle - 8.0, BOTTOM - 16.0 - width, middle + 8.0, BOTTOM]);
        }
    }
}

/// The colour of a mode, and of the critical speed that it has.
pub fn color(mode: Mode) -> Color {
    match mode {
        Mode::Castering => Color(0x1f, 0x6f, 0xb4),
        Mode::Capsize => Color(0xb4, 0x6a, 0x00),
        Mode::Weave => Color(0xc0, 0x28, 0x3c),
        Mode::Real => Color(0x55, 0x5d, 0x66),
        Mode::Oscillatory => Color(0x7a, 0x3f, 0x9d),
    }
}

/// Real parts as lines, imaginary parts dashed and lighter, and one label for each.
fn modes(rows: &[ModeRow], axes: &Axes, scene: &mut Scene, labels: &mut Labels) {
    let mut to_label = Vec::new();
    let pairs = pairs(rows);
    for Pair { modes: (first, second), real, imaginary } in &pairs {
        // Where two modes form a pair, the first shows as a border of the second.
        for points in lines(real, axes) {
            if first != second {
                scene.polyline(&points, line(6.0), color(*first));
                scene.polyline(&points, line(2.4), color(*second));
            }
            labels.avoid_line(&points, LINE);
        }
        let name = if first == second { first.to_string() } else { format!("{first}/{second}") };
        let lines = lines(imaginary, axes);
        for points in &lines {
            scene.polyline(points, dashed(1.8, [7.0, 5.0]), color(*second).lighter(0.35));
            labels.avoid_line(points, LINE);
        }
        let text = format!("{name}, imaginary part");
        to_label.push(Label { line: longest(lines), color: color(*second).lighter(0.35), text });
    }
    for mode in [Mode::Castering, Mode::Capsize, Mode::Weave] {
        let lines = lines(&alone(rows, mode), axes);
        for points in &lines {
            scene.polyline(points, line(2.4), color(mode));
            labels.avoid_line(points, LINE);
        }
        let oscillates = pairs.iter().any(|pair| pair.modes == (mode, mode));
        let text = if oscillates { format!("{mode}, real part") } else { mode.to_string() };
        to_label.push(Label { line: longest(lines), color: color(mode), text });
    }
    name(to_label, scene, labels);
}

/// Real parts as lines, imaginary parts dashed and lighter, all of them in one colour.
fn sorted(rows: &[Row<Eigenvalues>], axes: &Axes, scene: &mut Scene, labels: &mut Labels) {
    let color = color(Mode::Castering);
    let mut to_label = Vec::new();
    for (curves, paint, color, text) in [
        (ordered::imaginary(rows), dashed(1.8, [7.0, 5.0]), color.lighter(0.35), "imaginary parts"),
        (ordered::real(rows), line(2.4), color, "real parts"),
    ] {
        let lines = lines(&curves, axes);
        for points in &lines {
            scene.polyline(points, paint, color);
            labels.avoid_line(points, LINE);
        }
        to_label.push(Label { line: longest(lines), color, text: text.to_owned() });
    }
    name(to_label, scene, labels);
}

/// What a line is called.
struct Label {
    line: Vec<(f32, f32)>,
    color: Color,
    text: String,
}

/// Labels come last: they keep off every line.
fn name(to_label: Vec<Label>, scene: &mut Scene, labels: &mut Labels) {
    for Label { line, color, text } in to_label {
        if let Some(place) = labels.beside(&line, &text, LABEL_SIZE) {
            scene.text(place, Anchor::Start, LABEL_SIZE, color, &text);
        }
    }
}

/// The parts of the curves that the axes show, on the page.
fn lines(curves: &[Curve], axes: &Axes) -> Vec<Vec<(f32, f32)>> {
    let pieces = curves.iter().flat_map(|curve| clip(curve, axes.y));
    pieces.map(|piece| piece.into_iter().map(|(x, y)| axes.place(x, y)).collect()).collect()
}

fn longest(lines: Vec<Vec<(f32, f32)>>) -> Vec<(f32, f32)> {
    let length = |points: &[(f32, f32)]| -> f32 {
        points.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum()
    };
    lines.into_iter().max_by(|a, b| length(a).total_cmp(&length(b))).unwrap_or_default()
}
