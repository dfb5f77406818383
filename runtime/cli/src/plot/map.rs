//! Maps: where in the speeds two parameters put the stable range, each design as a cell of colour.

use std::ops::Range;

use carvallo::StableRange;

use super::axes::{self, Axes, INK};
use super::font;
use super::scene::{Anchor, Color, Paint, Scene, line};
use crate::number;

const HEIGHT: f32 = 560.0;
const SIDE: f32 = 400.0;
const TOP: f32 = 84.0;
const TEXT: f32 = 13.0;
/// From the right of a panel to the labels of its scale.
const SCALE: [f32; 2] = [14.0, 32.0];
/// The least room right of a panel, for the scale and what stands above it.
const RIGHT: f32 = 80.0;
/// From there to the next panel.
const BETWEEN: f32 = 24.0;

/// Dark for low values, light for high ones, of even steps in lightness and readable without colours (viridis, by van der
/// Walt & Smith).
const COLORS: [Color; 7] = [
    Color(0x44, 0x01, 0x54),
    Color(0x44, 0x39, 0x83),
    Color(0x31, 0x68, 0x8e),
    Color(0x21, 0x91, 0x8c),
    Color(0x35, 0xb7, 0x79),
    Color(0x90, 0xd7, 0x43),
    Color(0xfd, 0xe7, 0x25),
];
/// The steps of colour that are told apart.
const LEVELS: usize = 60;
const UNSTABLE: Color = Color(0xd9, 0xd9, 0xd9);
const ERROR: Color = Color(0xc0, 0x28, 0x3c);
const ENDLESS: Color = Color(0xf7, 0xc9, 0xe0);

/// One parameter of a map.
pub struct MapAxis {
    label: String,
    /// In the unit of the label.
    values: Vec<f64>,
    /// Where the design is that was varied.
    base: f64,
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
    /// Angles are shown in degrees.
    pub fn new(label: String, unit: &str, values: &[f64], base: f64) -> Self {
        let (factor, unit) = match unit {
            "rad" => (180.0 / std::f64::consts::PI, "°".to_owned()),
            unit => (1.0, number::unit(unit)),
        };
        let label = if unit.is_empty() { label } else { format!("{label} ({unit})") };
        Self { label, values: values.iter().map(|value| value * factor).collect(), base: base * factor }
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

/// What a panel shows of the stable ranges.
struct Panel {
    title: &'static str,
    value: fn(&StableRange) -> Option<f64>,
}

const PANELS: [Panel; 2] = [
    Panel { title: "stable from (m/s)", value: |range| Some(range.from) },
    Panel { title: "width of the stable range (m/s)", value: |range| range.to.map(|to| to - range.from) },
];

/// Two panels: where the stable range begins, and how wide it is. Of the axes the first is horizontal; the cells of each of
/// its values stand together.
pub fn map(name: &str, axes: &[MapAxis], cells: &[MapCell]) -> Scene {
    let [x_axis, y_axis] = axes else { return Scene::new(String::new(), 1.0, 1.0) };
    let edges = [x_axis.edges(), y_axis.edges()];
    let [x_range, y_range] = [MapAxis::extent(&edges[0]), MapAxis::extent(&edges[1])];
    let left = axes::margin(y_range);
    let scales = PANELS.each_ref().map(|panel| Scale::of(values(panel, cells)));
    let [first_right, second_right] = scales.each_ref().map(Scale::room);
    let second_left = left + SIDE + first_right + BETWEEN + left;
    let width = second_left + SIDE + second_right;
    let title = format!("Stability of {name} over two parameters");
    let mut scene = Scene::new(title.clone(), width, HEIGHT);
    scene.text((width / 2.0, 30.0), Anchor::Middle, 18.0, INK, &title);
    for ((panel, scale), left) in PANELS.iter().zip(scales).zip([left, second_left]) {
        let area = [left, TOP, left + SIDE, TOP + SIDE - 40.0];
        let axes = Axes { x: x_range, y: y_range, area };
        scene.text((left + SIDE / 2.0, TOP - 14.0), Anchor::Middle, 15.0, INK, panel.title);
        fill(&mut scene, &axes, &edges, cells, |cell| match cell {
            MapCell::Stable(range) => (panel.value)(range).map_or(Shade::Endless, |value| scale.shade(value)),
            MapCell::Unstable => Shade::Unstable,
            MapCell::Error => Shade::Error,
        });
        mark(&mut scene, &axes, (x_axis.base, y_axis.base));
        axes.frame(&mut scene, &x_axis.label, &y_axis.label);
        scale.draw(&mut scene, area);
    }
    let x = legend(&mut scene, cells, left);
    let is_marked = |axis: &MapAxis, (low, high): (f64, f64)| (low..=high).contains(&axis.base);
    if is_marked(x_axis, x_range) && is_marked(y_axis, y_range) {
        let y = HEIGHT - 34.0;
        cross(&mut scene, (x + 8.0, y));
        scene.text((x + 24.0, y + 5.0), Anchor::Start, TEXT, INK, name);
    }
    scene
}

/// What a panel shows in colours.
fn values(panel: &Panel, cells: &[MapCell]) -> impl Iterator<Item = f64> {
    cells.iter().filter_map(|cell| match cell {
        MapCell::Stable(range) => (panel.value)(range),
        _ => None,
    })
}

/// How a cell is painted.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shade {
    Level(usize),
    Endless,
    Unstable,
    Error,
}

impl Shade {
    fn color(self) -> Color {
        match self {
            Self::Level(level) => {
                let place = level as f32 / (LEVELS - 1) as f32 * (COLORS.len() - 1) as f32;
                let index = (place as usize).min(COLORS.len() - 2);
                let (Color(r, g, b), Color(red, green, blue)) = (COLORS[index], COLORS[index + 1]);
                let share = place - index as f32;
                let mix = |a: u8, b: u8| (f32::from(a) + share * (f32::from(b) - f32::from(a))).round() as u8;
                Color(mix(r, red), mix(g, green), mix(b, blue))
            }
            Self::Endless => ENDLESS,
            Self::Unstable => UNSTABLE,
            Self::Error => ERROR,
        }
    }
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
fn mark(scene: &mut Scene, axes: &Axes, (x, y): (f64, f64)) {
    if (axes.x.0..=axes.x.1).contains(&x) && (axes.y.0..=axes.y.1).contains(&y) {
        cross(scene, axes.place(x, y));
    }
}

fn cross(scene: &mut Scene, (x, y): (f32, f32)) {
    for (width, color) in [(5.0, Color(0xff, 0xff, 0xff)), (2.0, INK)] {
        scene.polyline(&[(x - 6.0, y), (x + 6.0, y)], line(width), color);
        scene.polyline(&[(x, y - 6.0), (x, y + 6.0)], line(width), color);
    }
}

/// From values to colours.
struct Scale {
    /// `None` where there are no values.
    range: Option<(f64, f64)>,
    /// Whether there are values above.
    is_cut: bool,
}

impl Scale {
    /// From the least value to the largest one; but widths grow without bound next to ranges without end, and a few of them
    /// would leave no colours for the others.
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let [Some(&low), Some(&most), Some(&last)] = [values.first(), values.get(values.len() * 9 / 10), values.last()]
        else {
            return Self { range: None, is_cut: false };
        };
        let is_cut = last > 2.0 * most && most > low;
        let high = if is_cut { most } else { last };
        if low < high {
            return Self { range: Some((low, high)), is_cut };
        }
        // One value alone has a scale around it.
        let half = (low.abs() / 2.0).max(0.5);
        Self { range: Some((low - half, low + half)), is_cut }
    }

    fn shade(&self, value: f64) -> Shade {
        let share = self.range.map_or(0.0, |(low, high)| (value - low) / (high - low));
        Shade::Level(((share * LEVELS as f64) as usize).min(LEVELS - 1))
    }

    /// What it takes right of a panel.
    fn room(&self) -> f32 {
        let labels = self.range.map_or(0.0, |range| axes::width(&axes::upward(range)));
        RIGHT.max(SCALE[1] + 9.0 + labels + 12.0)
    }

    /// The colours from bottom to top right of a panel, with their values.
    fn draw(&self, scene: &mut Scene, [_, top, right, bottom]: [f32; 4]) {
        let Some(range) = self.range else { return };
        let [left, right] = SCALE.map(|distance| right + distance);
        let step = (bottom - top) / LEVELS as f32;
        for level in 0..LEVELS {
            let bottom = bottom - step * level as f32;
            let rectangle = [left, (bottom - step - 0.4).max(top), right, bottom];
            scene.rectangles(&[rectangle], Shade::Level(level).color());
        }
        scene.rectangle([left, top, right, bottom], line(1.2), INK);
        if self.is_cut {
            scene.text((left, top - 7.0), Anchor::Start, TEXT, INK, "and more");
        }
        let axes = Axes { x: (0.0, 1.0), y: range, area: [left, top, right, bottom] };
        for (value, text) in axes::upward(range) {
            let (_, y) = axes.place(0.0, value);
            scene.polyline(&[(right, y), (right + 5.0, y)], line(1.2), INK);
            scene.text((right + 9.0, y + 4.5), Anchor::Start, TEXT, INK, &text);
        }
    }
}

/// What the colours beside the scale mean, as far as they occur; where the next entry goes.
fn legend(scene: &mut Scene, cells: &[MapCell], mut x: f32) -> f32 {
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
