//! Graphs of eigenvalues against the speed, or a parameter.

use super::axes::{self, Axes, INK};
use super::beyond;
use super::critical::{self, Event};
use super::curves::{Curve, clip};
use super::font;
use super::labels::{LINE, Labels};
use super::panels::Panel;
use super::scene::{Anchor, Color, Paint, Scene, line};
use super::series::Series;

const WIDTH: f32 = 960.0;
const HEIGHT: f32 = 640.0;
const RIGHT: f32 = WIDTH - 28.0;
/// Of a picture with several graphs, and what is between them.
const HEIGHT_OF_SEVERAL: f32 = 800.0;
const GAP: f32 = 26.0;
/// What is below the graphs.
const BELOW: f32 = 66.0;
const LABEL_SIZE: f32 = 15.0;
/// A label that is further from its line than this is joined to it.
const FAR: f32 = 14.0;
const STABLE: Color = Color(0xdd, 0xf1, 0xde);
const STABLE_TEXT: Color = Color(0x2e, 0x7d, 0x32);
const WHITE: Color = Color(0xff, 0xff, 0xff);

/// Graphs of eigenvalues against something.
pub struct Shown<'a> {
    pub title: String,
    /// What the horizontal axis shows, what stands below it, and its unit behind a space.
    pub x: (f64, f64),
    pub across: String,
    pub unit: &'a str,
    pub panels: Vec<Panel>,
    pub critical: Vec<Event>,
    /// From where to where the motion is stable.
    pub stable: Vec<(f64, f64)>,
}

/// One graph below the other.
pub fn draw(Shown { title, x: (low, high), across, unit, panels, critical: events, stable: ranges }: &Shown) -> Scene {
    let (low, high) = (*low, *high);
    let left = panels.iter().map(|panel| axes::margin(panel.y)).fold(0.0, f32::max);
    let notes: Vec<String> = panels
        .iter()
        .flat_map(|Panel { series, y, name, .. }| beyond::note(series, *y, unit, *name, RIGHT - left))
        .collect();
    let page = if panels.len() > 1 { HEIGHT_OF_SEVERAL } else { HEIGHT };
    let bottom = page - BELOW;
    let height = page + beyond::ROW * notes.len() as f32;
    let mut scene = Scene::new(title.clone(), WIDTH, height);
    scene.heading(((left + RIGHT) / 2.0, 32.0), INK, title);
    let critical = critical::critical(events, &Axes::even((low, high), (0.0, 1.0), [left, 0.0, RIGHT, bottom]));
    let top = 56.0 + critical::height(&critical);

    let room = bottom - top - GAP * (panels.len() - 1) as f32;
    let mut without_room = Vec::new();
    let mut from = top;
    for (index, Panel { series, y, label, share, .. }) in panels.iter().enumerate() {
        let (is_first, is_last) = (index == 0, index + 1 == panels.len());
        let to = if is_last { bottom } else { from + share * room };
        let axes = Axes::even((low, high), *y, [left, from, RIGHT, to]);
        let mut labels = Labels::new(axes.area);
        let stable = stable_ranges(ranges, &axes);
        for &(left, right) in &stable {
            scene.rectangle([left, from, right, to], Paint::Fill, STABLE);
        }
        axes.draw_grid(&mut scene);
        if y.0 < 0.0 && y.1 > 0.0 {
            let (_, zero) = axes.place(low, 0.0);
            labels.avoid_line(&[(left, zero), (RIGHT, zero)], LINE);
        }
        critical::avoid(&critical, &axes, &mut labels);
        // Labels know the curves, and critical speeds the labels, but curves are painted over critical speeds.
        let mut curves = Scene::new(title.clone(), WIDTH, height);
        let to_label = draw_curves(series, &axes, &mut curves, &mut labels);
        if is_first {
            write_stable_labels(&stable, &axes, &mut curves, &mut labels);
        }
        without_room.extend(write_labels(to_label, &mut curves, &mut labels));
        critical::draw_lines(&critical, &axes, &labels, is_first, &mut scene);
        scene.items.append(&mut curves.items);
        if is_first {
            critical::write_values(&critical, top, &mut scene);
        }
        axes.draw_frame(&mut scene, is_last.then_some(across.as_str()), label);
        from = to + GAP;
    }
    beyond::write(&notes, left, page - 4.0, &mut scene);
    write_legend(&without_room, left, &mut scene);
    scene
}

/// Where the stable ranges begin and end on the page.
fn stable_ranges(ranges: &[(f64, f64)], axes: &Axes) -> Vec<(f32, f32)> {
    let visible = ranges.iter().map(|(from, to)| (from.max(axes.x.0), to.min(axes.x.1)));
    visible.filter(|(from, to)| from < to).map(|(from, to)| (axes.place(from, 0.0).0, axes.place(to, 0.0).0)).collect()
}

/// Across where there is room, upwards where there is little; clear of the curves, or else over them with an edge.
fn write_stable_labels(ranges: &[(f32, f32)], axes: &Axes, scene: &mut Scene, labels: &mut Labels) {
    let [_, top, _, bottom] = axes.area;
    let width = font::width("stable", LABEL_SIZE);
    for &(left, right) in ranges {
        let room = [left + 3.0, top, right - 3.0, bottom - 4.0];
        if right - left > width + 10.0 {
            let (x, y) = labels.inside(room, (width, LABEL_SIZE));
            scene.edged_text((x, y + 5.0), LABEL_SIZE, STABLE_TEXT, STABLE, "stable");
        } else if right - left > LABEL_SIZE + 4.0 {
            let (x, y) = labels.inside(room, (LABEL_SIZE - 2.0, width));
            scene.edged_upward_text((x + 5.0, y), LABEL_SIZE, STABLE_TEXT, STABLE, "stable");
        }
    }
}

/// The curves as far as the axes show them, with what they are called.
fn draw_curves(series: &[Series], axes: &Axes, scene: &mut Scene, labels: &mut Labels) -> Vec<Label> {
    let mut to_label = Vec::new();
    for Series { name, color, paint, border, has_label, curves } in series {
        let lines = lines(curves, axes);
        for points in &lines {
            if let Some(border) = border {
                scene.polyline(points, line(6.0), *border);
            }
            scene.polyline(points, *paint, *color);
            beyond::draw_heads(points, axes, *color, scene);
            labels.avoid_line(points, LINE);
        }
        if *has_label {
            to_label.push(Label { line: longest(lines), color: *color, paint: *paint, text: name.clone() });
        }
    }
    to_label
}

/// What a line is called.
struct Label {
    line: Vec<(f32, f32)>,
    color: Color,
    paint: Paint,
    text: String,
}

/// Labels come last: they keep off every line, or have an edge that does. A label that has room only away from its line is
/// joined to it; those that have none beside their lines are returned.
fn write_labels(to_label: Vec<Label>, scene: &mut Scene, labels: &mut Labels) -> Vec<Label> {
    let mut without_room = Vec::new();
    for label in to_label {
        let Label { line: points, color, text, .. } = &label;
        let Some((left, base)) = labels.beside(points, text, LABEL_SIZE) else {
            // What lies outside of the axes is told below the graph.
            if !points.is_empty() {
                without_room.push(label);
            }
            continue;
        };
        let width = font::width(text, LABEL_SIZE);
        let bounds = [left, base - LABEL_SIZE, left + width, base + 4.0];
        if let Some(leader) = leader(bounds, points) {
            scene.polyline(&leader, line(1.0), *color);
        }
        if labels.is_clear(bounds) {
            scene.text((left, base), Anchor::Start, LABEL_SIZE, *color, text);
        } else {
            scene.edged_text((left + width / 2.0, base), LABEL_SIZE, *color, WHITE, text);
        }
    }
    without_room
}

/// A line from a label to the nearest point of what it names, if that is not right beside it.
fn leader([left, top, right, bottom]: [f32; 4], points: &[(f32, f32)]) -> Option<[(f32, f32); 2]> {
    let edge = |(x, y): (f32, f32)| (x.clamp(left - 2.0, right + 2.0), y.clamp(top, bottom));
    let distance = |&(x, y): &(f32, f32)| {
        let (from_x, from_y) = edge((x, y));
        (x - from_x).hypot(y - from_y)
    };
    let nearest = *points.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(&nearest) > FAR).then(|| [edge(nearest), nearest])
}

/// Below everything, the lines that no label has room beside, each with its name.
fn write_legend(without_room: &[Label], left: f32, scene: &mut Scene) {
    if without_room.is_empty() {
        return;
    }
    let (mut x, base) = (left, scene.height - 4.0);
    scene.height += beyond::ROW;
    for Label { color, paint, text, .. } in without_room {
        scene.polyline(&[(x, base - 4.5), (x + 28.0, base - 4.5)], *paint, *color);
        scene.text((x + 34.0, base), Anchor::Start, 13.0, *color, text);
        x += 34.0 + font::width(text, 13.0) + 22.0;
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
