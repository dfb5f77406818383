//! The root locus: where the eigenvalues are in the complex plane while the speed grows. The lower half is the mirror image of the
//! upper one, and is left out.

use carvallo::{Mode, ModeValue};
use carvallo_design::Failure;
use carvallo_design::number::{fixed, shortest};

use super::axes::{self, Axes, INK};
use super::colors::color;
use super::curves::{extend, samples};
use super::font;
use super::graph::{range, write_names};
use super::labels::{LINE, Labels, THIN};
use super::scene::{Anchor, Color, Paint, Scene, line};
use crate::analysis::{Analysis, Rows, reach};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 48.0;
const HEIGHT: f32 = 560.0;
const BELOW: f32 = 66.0;
const TEXT_SIZE: f32 = 12.0;
const STABLE: Color = Color(0xee, 0xf8, 0xee);
const WHITE: Color = Color(0xff, 0xff, 0xff);
const DOT: f32 = 3.2;
/// What a dot under a label weighs.
const ON_DOT: f32 = 200.0;
/// A label is no farther from its dot, in pixels.
const NEAR: f32 = 10.0;
/// By so many pixels another dot is clearly closer to it.
const CLEARLY: f32 = 2.0;
/// Eigenvalues so many times farther to the left than the others are to the right or upward are beyond the picture.
const FAR: f64 = 2.5;

/// The eigenvalues between two speeds in m/s, with dots at round speeds; each curve begins with a square.
///
/// # Errors
/// If they cannot be computed at one of the speeds.
pub fn draw_locus(analysis: &Analysis, (low, high): (f64, f64)) -> Result<Scene, Failure> {
    let critical = analysis.critical_speeds().iter().map(|critical| critical.speed);
    let rows = analysis.rows(&samples((low, high), critical.chain(analysis.meetings())))?;
    let values = rows.values();
    let round: Vec<f64> = reach::speeds(high, true).into_iter().filter(|speed| (low..=high).contains(speed)).collect();
    let marked = analysis.rows(&round)?;
    let (x, y) = extents(&values);
    let left = axes::margin(y);
    let name = if matches!(rows, Rows::Modes(_)) { "forward speed" } else { "speed" };
    let unit = &analysis.unit;
    let shown = |speed: f64| shortest(unit.value(speed));
    let title = format!(
        "Root locus of {}: {name} from {} to {} {}",
        analysis.design.title(),
        shown(low),
        shown(high),
        unit.unit()
    );
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 28.0), INK, &title);
    let modes = modes(&values);
    let names: Vec<String> = modes.iter().map(ToString::to_string).collect();
    let named = modes.iter().zip(&names).map(|(mode, name)| (line(2.2), color(*mode), name.as_str()));
    let top = write_names(named, [left, RIGHT], TOP, &mut scene);
    let axes = Axes::even(x, y, [left, top, RIGHT, top + HEIGHT]);
    let [_, _, right, bottom] = axes.area;
    scene.height = bottom + BELOW;
    let zero = axes.place(0.0, 0.0).0.clamp(left, right);
    scene.rectangle([left, top, zero, bottom], Paint::Fill, STABLE);
    axes.draw_grid(&mut scene);
    scene.polyline(&[(zero, top), (zero, bottom)], line(1.2), INK);
    let mut labels = Labels::new(axes.area);
    for mode in &modes {
        for curve in curves(&values, *mode, &axes) {
            labels.avoid_line(&curve, LINE);
            scene.polyline(&curve, line(2.2), color(*mode));
        }
    }
    labels.avoid_line(&[(zero, top), (zero, bottom)], THIN);
    draw_dots(&marked.values(), &shown, labels, &axes, &mut scene);
    if let Some((_, first)) = values.first() {
        for value in first.iter().filter(|value| value.value.im >= 0.0 && is_inside(value, &axes)) {
            let (x, y) = axes.place(value.value.re, value.value.im);
            let square = [x - 4.0, y - 4.0, x + 4.0, y + 4.0];
            scene.rectangle(square, Paint::Fill, WHITE);
            scene.rectangle(square, line(1.8), color(value.mode));
        }
    }
    axes.draw_frame(&mut scene, Some("real part (1/s)"), "imaginary part (1/s)");
    let least = values.iter().flat_map(|(_, values)| *values).map(|value| value.value.re).fold(0.0, f64::min);
    if least < axes.x.0 {
        let note = format!("eigenvalues go on to the left, to {} /s", fixed(least, 1)).replace('-', "−");
        scene.text((left, scene.height), Anchor::Start, TEXT_SIZE, INK, &note);
        scene.height += 16.0;
    }
    Ok(scene)
}

/// From where to where the axes go to show all, but for what is far to the left.
fn extents(rows: &[(f64, &[ModeValue])]) -> ((f64, f64), (f64, f64)) {
    let all = || rows.iter().flat_map(|(_, values)| values.iter().map(|value| value.value));
    let (least, most) = range(all().map(|value| value.re).chain([0.0]));
    let (_, highest) = range(all().map(|value| value.im).chain([0.0]));
    let reach = most.max(highest).max(1e-3 * least.abs());
    let least = least.max(-FAR * reach);
    let room = 0.05 * (most - least);
    let y = if highest > 0.0 { (-0.03 * highest, 1.06 * highest) } else { (-0.1, 1.0) };
    ((least - room, most + room), y)
}

fn is_inside(value: &ModeValue, axes: &Axes) -> bool {
    (axes.x.0..=axes.x.1).contains(&value.value.re) && (axes.y.0..=axes.y.1).contains(&value.value.im)
}

/// The modes that there are, each once.
fn modes(rows: &[(f64, &[ModeValue])]) -> Vec<Mode> {
    let mut modes: Vec<Mode> = rows.iter().flat_map(|(_, values)| values.iter().map(|value| value.mode)).collect();
    modes.sort_unstable();
    modes.dedup();
    modes
}

/// The curves of a mode on the page, in which one of the eigenvalues goes on from row to row; where it had another name or was the lower half
/// of a pair just before, the curve begins there.
fn curves(rows: &[(f64, &[ModeValue])], mode: Mode, axes: &Axes) -> Vec<Vec<(f32, f32)>> {
    let mut all = Vec::new();
    let count = rows.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    for place in 0..count {
        let mut curves = Vec::new();
        let mut before: Option<&ModeValue> = None;
        for (_, values) in rows {
            let value = values.get(place);
            let is_shown = |value: &&ModeValue| value.mode == mode && value.value.im >= 0.0 && is_inside(value, axes);
            let point = |value: &ModeValue| (value.value.re, value.value.im.max(0.0));
            let shown = value.filter(is_shown);
            if let (Some(_), Some(other)) = (shown, before.filter(|other| !is_shown(other) && is_inside(other, axes))) {
                extend(&mut curves, None);
                extend(&mut curves, Some(point(other)));
            }
            extend(&mut curves, shown.map(point));
            before = value;
        }
        let curves = curves.iter().filter(|curve| curve.len() > 1);
        all.extend(curves.map(|curve| curve.iter().map(|&(re, im)| axes.place(re, im)).collect()));
    }
    all
}

/// Dots at round speeds, with their speeds beside them as far as there is room.
fn draw_dots(
    rows: &[(f64, &[ModeValue])],
    shown: &dyn Fn(f64) -> String,
    mut labels: Labels,
    axes: &Axes,
    scene: &mut Scene,
) {
    let mut dots = Vec::new();
    for (speed, values) in rows {
        for value in values.iter().filter(|value| value.value.im >= 0.0 && is_inside(value, axes)) {
            let (x, y) = axes.place(value.value.re, value.value.im);
            scene.circle((x, y), DOT, Paint::Fill, color(value.mode));
            labels.avoid_line(&[(x, y); 2], ON_DOT);
            dots.push(((x, y), shown(*speed)));
        }
    }
    let mut taken: Vec<((f32, f32), String)> = Vec::new();
    for ((x, y), text) in &dots {
        let (x, y) = (*x, *y);
        // Several curves that begin or end at one point, and dots that touch.
        if taken.iter().any(|((other, above), own)| own == text && (x - other).hypot(y - above) < NEAR) {
            continue;
        }
        let Some((left, base)) = labels.beside(&[(x, y); 2], text, TEXT_SIZE) else { continue };
        let (right, top) = (left + font::width(text, TEXT_SIZE), base - TEXT_SIZE);
        let off = |(x, y): (f32, f32)| {
            let [off_x, off_y] = [(left - x).max(x - right), (top - y).max(y - base)].map(|off| off.max(0.0));
            off_x.hypot(off_y)
        };
        // One that is farther away, or closer to another dot, would be taken for that of another.
        let is_of_other = |(other, own): &((f32, f32), String)| own != text && off(*other) + CLEARLY < off((x, y));
        if off((x, y)) < NEAR && !dots.iter().any(is_of_other) {
            scene.text((left, base), Anchor::Start, TEXT_SIZE, INK, text);
            taken.push(((x, y), text.clone()));
        }
    }
}
