//! Maps: where in the speeds two parameters put the stable range, each design as a cell of colour.

mod scale;

use std::ops::Range;

use carvallo::{ParameterInfo, StableRange};
use carvallo_design::DisplayUnit;

use self::scale::{ENDLESS, ERROR, Scale, Shade, UNSTABLE};
use super::axes::{self, Axes, INK};
use super::font;
use super::scene::{Anchor, Color, Paint, Scene, line};

const HEIGHT: f32 = 560.0;
const SIDE: f32 = 400.0;
const TOP: f32 = 84.0;
const TEXT: f32 = 13.0;
/// From there to the next panel.
const BETWEEN: f32 = 24.0;

/// The most designs that a map shows: more show nothing that fewer would not.
pub const MOST_CELLS: usize = 1_000_000;

/// One parameter of a map.
pub struct MapAxis {
    label: String,
    /// In the unit of the label.
    values: Vec<f64>,
    /// Where the design is that was varied, if there is one.
    base: Option<f64>,
}

/// What there is of one design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MapCell {
    /// Its first stable range.
    Stable(StableRange),
    /// It has none.
    Unstable,
    /// It has no results.
    Error,
}

impl MapAxis {
    /// Of a parameter with values in its unit, and in what they are shown; `base` is that of the design that was varied, if there is
    /// one.
    pub fn new(info: &ParameterInfo, values: &[f64], base: Option<f64>, shown: &DisplayUnit) -> Self {
        let label = label(info);
        let unit = if shown.written == "deg" { "°".to_owned() } else { shown.unit() };
        let label = if unit.is_empty() { label } else { format!("{label} ({unit})") };
        let values = values.iter().map(|value| shown.value(*value)).collect();
        Self { label, values, base: base.map(|base| shown.value(base)) }
    }

    /// Where the cells of the values end: in the middle between neighbours.
    fn edges(&self) -> Vec<Range<f64>> {
        let mut order: Vec<usize> = (0..self.values.len()).collect();
        order.sort_by(|a, b| self.values[*a].total_cmp(&self.values[*b]));
        let sorted: Vec<f64> = order.iter().map(|index| self.values[*index]).collect();
        let half = |pair: &[f64]| (pair[1] - pair[0]) / 2.0;
        let gaps: Vec<f64> = sorted.windows(2).map(half).collect();
        let at = |index: usize| gaps.get(index).copied();
        let mut edges = vec![0.0..0.0; sorted.len()];
        for (place, index) in order.into_iter().enumerate() {
            let below = place.checked_sub(1).and_then(at).or(at(place)).unwrap_or(0.0);
            let above = at(place).or(place.checked_sub(1).and_then(at)).unwrap_or(0.0);
            edges[index] = sorted[place] - below..sorted[place] + above;
        }
        edges
    }

    fn extent(edges: &[Range<f64>]) -> (f64, f64) {
        edges
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), edge| (low.min(edge.start), high.max(edge.end)))
    }
}

/// What the parameter is, as far as its documentation says so in a few words, and its symbol.
fn label(info: &ParameterInfo) -> String {
    let docs = info.docs.trim().split([':', '.', ',', ';', '\n']).next().unwrap_or_default();
    let mut chars = docs.chars();
    match chars.next() {
        // A name that says it all is not said twice.
        Some(_) if letters(docs) == letters(info.symbol) => docs.to_lowercase(),
        Some(first) if docs.chars().count() <= 50 => {
            format!("{}{} {}", first.to_lowercase(), chars.as_str(), info.symbol)
        }
        _ => info.symbol.to_owned(),
    }
}

fn letters(text: &str) -> String {
    text.chars().filter(|sign| !matches!(sign, ' ' | '_' | '-')).collect::<String>().to_lowercase()
}

/// What a panel shows of the stable ranges.
struct Panel {
    title: &'static str,
    value: fn(&StableRange) -> Option<f64>,
}

const PANELS: [Panel; 2] = [
    Panel { title: "stable from", value: |range| Some(range.from) },
    Panel { title: "width of the stable range", value: |range| range.to.map(|to| to - range.from) },
];

/// Two panels: where the stable range begins, and how wide it is. Of the axes the first is horizontal; the cells of each of
/// its values stand together. Speeds are shown in a unit.
pub fn draw_map(name: &str, axes: &[MapAxis], cells: &[MapCell], speed: &DisplayUnit) -> Scene {
    let [x_axis, y_axis] = axes else { return Scene::new(String::new(), 1.0, 1.0) };
    let edges = [x_axis.edges(), y_axis.edges()];
    let [x_range, y_range] = [MapAxis::extent(&edges[0]), MapAxis::extent(&edges[1])];
    let left = axes::margin(y_range);
    let scales = PANELS.each_ref().map(|panel| Scale::of(values(panel, cells, speed)));
    let [first_right, second_right] = scales.each_ref().map(Scale::room);
    let second_left = left + SIDE + first_right + BETWEEN + left;
    let width = second_left + SIDE + second_right;
    let title = format!("Stability of {name} over two parameters");
    let mut scene = Scene::new(title.clone(), width, HEIGHT);
    scene.heading((width / 2.0, 30.0), INK, &title);
    for ((panel, scale), left) in PANELS.iter().zip(scales).zip([left, second_left]) {
        let area = [left, TOP, left + SIDE, TOP + SIDE - 40.0];
        let axes = Axes::even(x_range, y_range, area);
        scene.text(
            (left + SIDE / 2.0, TOP - 14.0),
            Anchor::Middle,
            15.0,
            INK,
            &format!("{} ({})", panel.title, speed.unit()),
        );
        fill(&mut scene, &axes, &edges, cells, |cell| match cell {
            MapCell::Stable(range) => {
                (panel.value)(range).map_or(Shade::Endless, |value| scale.shade(speed.value(value)))
            }
            MapCell::Unstable => Shade::Unstable,
            MapCell::Error => Shade::Error,
        });
        if let (Some(x), Some(y)) = (x_axis.base, y_axis.base) {
            mark_base(&mut scene, &axes, (x, y));
        }
        axes.draw_frame(&mut scene, Some(&x_axis.label), &y_axis.label);
        scale.draw(&mut scene, area);
    }
    let x = draw_legend(&mut scene, cells, left);
    let is_marked =
        |axis: &MapAxis, (low, high): (f64, f64)| axis.base.is_some_and(|base| (low..=high).contains(&base));
    if is_marked(x_axis, x_range) && is_marked(y_axis, y_range) {
        let y = HEIGHT - 34.0;
        draw_cross(&mut scene, (x + 8.0, y));
        scene.text((x + 24.0, y + 5.0), Anchor::Start, TEXT, INK, name);
    }
    scene
}

/// What a panel shows in colours.
fn values(panel: &Panel, cells: &[MapCell], speed: &DisplayUnit) -> impl Iterator<Item = f64> {
    cells.iter().filter_map(|cell| match cell {
        MapCell::Stable(range) => (panel.value)(range).map(|value| speed.value(value)),
        _ => None,
    })
}

/// Cells of one shade become one path, and neighbours one above the other one rectangle.
fn fill(
    scene: &mut Scene,
    axes: &Axes,
    [x, y]: &[Vec<Range<f64>>; 2],
    cells: &[MapCell],
    shade: impl Fn(&MapCell) -> Shade,
) {
    let mut painted: Vec<(Shade, Vec<[f32; 4]>)> = Vec::new();
    for (across, column) in x.iter().zip(cells.chunks(y.len())) {
        let mut runs: Vec<(Shade, Range<f64>)> = Vec::new();
        for (upright, cell) in y.iter().zip(column) {
            let shade = shade(cell);
            match runs.last_mut() {
                Some((last, run)) if *last == shade && run.end == upright.start => run.end = upright.end,
                _ => runs.push((shade, upright.clone())),
            }
        }
        for (shade, run) in runs {
            let (left, bottom) = axes.place(across.start, run.start);
            let (right, top) = axes.place(across.end, run.end);
            // Cells overlap a little, so that nothing shines through between them.
            let [_, _, most_right, _] = axes.area;
            let rectangle = [left, (top - 0.4).max(axes.area[1]), (right + 0.4).min(most_right), bottom];
            match painted.iter_mut().find(|(other, _)| *other == shade) {
                Some((_, rectangles)) => rectangles.push(rectangle),
                None => painted.push((shade, vec![rectangle])),
            }
        }
    }
    for (shade, rectangles) in painted {
        scene.rectangles(&rectangles, shade.color());
    }
}

/// A cross where the design is that was varied, if the map shows it.
fn mark_base(scene: &mut Scene, axes: &Axes, (x, y): (f64, f64)) {
    if (axes.x.0..=axes.x.1).contains(&x) && (axes.y.0..=axes.y.1).contains(&y) {
        draw_cross(scene, axes.place(x, y));
    }
}

fn draw_cross(scene: &mut Scene, (x, y): (f32, f32)) {
    for (width, color) in [(5.0, Color(0xff, 0xff, 0xff)), (2.0, INK)] {
        scene.polyline(&[(x - 6.0, y), (x + 6.0, y)], line(width), color);
        scene.polyline(&[(x, y - 6.0), (x, y + 6.0)], line(width), color);
    }
}

/// What the colours beside the scale mean, as far as they occur; where the next entry goes.
fn draw_legend(scene: &mut Scene, cells: &[MapCell], mut x: f32) -> f32 {
    let is_endless = |cell: &MapCell| matches!(cell, MapCell::Stable(StableRange { to: None, .. }));
    let y = HEIGHT - 30.0;
    for (is_there, color, text) in [
        (cells.iter().any(is_endless), ENDLESS, "stable range without end"),
        (cells.contains(&MapCell::Unstable), UNSTABLE, "no stable range"),
        (cells.contains(&MapCell::Error), ERROR, "no results: invalid parameters"),
    ] {
        if is_there {
            scene.rectangle([x, y - 12.0, x + 16.0, y + 4.0], Paint::Fill, color);
            scene.rectangle([x, y - 12.0, x + 16.0, y + 4.0], line(1.0), INK);
            scene.text((x + 24.0, y + 1.0), Anchor::Start, TEXT, INK, text);
            x += 24.0 + font::width(text, TEXT) + 32.0;
        }
    }
    x
}
