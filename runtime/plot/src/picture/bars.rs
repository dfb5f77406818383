//! Bars from zero to both sides, several for each row: a chart of what contributes how much to what.

use super::axes::{INK, across};
use super::font;
use super::scene::{Anchor, Color, Paint, Scene, line};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 36.0;
/// Where names and notes begin.
const MARGIN: f32 = 24.0;
const TEXT_SIZE: f32 = 13.0;
/// A bar, what is between the bars of two rows, and the room of their label.
const BAR: f32 = 9.0;
const GAP: f32 = 9.0;
const LEAST_ROW: f32 = 18.0;
/// The height of a line of the legend, and where the first one stands.
const LEGEND: f32 = 21.0;
const LEGEND_TOP: f32 = 62.0;
const BELOW: f32 = 82.0;
/// The height of a line below everything.
const NOTE: f32 = 19.0;
const GRID: Color = Color(0xe4, 0xe4, 0xe4);

/// What a chart shows.
pub struct Bars {
    pub title: String,
    /// As much of it as there is room for.
    pub short_title: String,
    /// What the bars of a row stand for, and their colours.
    pub series: Vec<(String, Color)>,
    pub rows: Vec<Row>,
    /// What the horizontal axis shows.
    pub across: String,
    /// What the chart cannot show.
    pub notes: Vec<String>,
}

/// The bars of one row.
pub struct Row {
    pub symbol: String,
    /// What stands beside the symbol.
    pub beside: String,
    /// One for each of the series.
    pub values: Vec<f64>,
}

/// The chart; `None` if there is nothing to draw.
pub fn draw(Bars { title, short_title, series, rows, across: below, notes }: &Bars) -> Option<Scene> {
    let values = || rows.iter().flat_map(|row| row.values.iter().copied());
    let (low, high) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    if rows.is_empty() || low == high {
        return None;
    }
    let extent = (low - 0.04 * (high - low), high + 0.04 * (high - low));

    let notes: Vec<&str> = notes.iter().flat_map(|note| font::lines(note, TEXT_SIZE, WIDTH - 2.0 * MARGIN)).collect();
    let row_height = (BAR * series.len() as f32 + GAP).max(LEAST_ROW);
    let top = LEGEND_TOP + LEGEND * series.len() as f32;
    let bottom = top + row_height * rows.len() as f32 + GAP;
    let mut scene = Scene::new(title.clone(), WIDTH, bottom + BELOW + NOTE * notes.len().saturating_sub(1) as f32);
    scene.short_heading((WIDTH / 2.0, 32.0), INK, [short_title, title]);

    let besides = rows.iter().map(|row| font::width(&row.beside, TEXT_SIZE)).fold(0.0, f32::max);
    let symbols = rows.iter().map(|row| font::width(&row.symbol, TEXT_SIZE)).fold(0.0, f32::max);
    let left = MARGIN + symbols + 14.0 + besides + 12.0;
    let x = |value: f64| left + ((value - extent.0) / (extent.1 - extent.0)) as f32 * (RIGHT - left);
    legend(series, left, &mut scene);
    for (tick, _) in across(extent, RIGHT - left) {
        scene.polyline(&[(x(tick), top), (x(tick), bottom)], line(1.0), GRID);
    }
    for (index, row) in rows.iter().enumerate() {
        let row_top = top + GAP / 2.0 + row_height * index as f32;
        let base = row_top + row_height / 2.0 + 0.5;
        scene.text((MARGIN, base), Anchor::Start, TEXT_SIZE, INK, &row.symbol);
        scene.text((left - 12.0, base), Anchor::End, TEXT_SIZE, INK.lighter(0.4), &row.beside);
        let bars = BAR * row.values.len() as f32;
        let first = row_top + (row_height - GAP - bars).max(0.0) / 2.0;
        for (place, (value, (_, color))) in row.values.iter().zip(series).enumerate() {
            let (from, to) = (x(value.min(0.0)), x(value.max(0.0)));
            let bar_top = first + BAR * place as f32;
            scene.rectangle([from, bar_top, to, bar_top + BAR - 1.0], Paint::Fill, *color);
        }
    }
    frame(extent, [left, top, RIGHT, bottom], &x, below, &mut scene);
    for (index, note) in notes.iter().enumerate() {
        scene.text((MARGIN, bottom + 70.0 + NOTE * index as f32), Anchor::Start, TEXT_SIZE, INK.lighter(0.4), note);
    }
    Some(scene)
}

fn legend(series: &[(String, Color)], left: f32, scene: &mut Scene) {
    for (index, (text, color)) in series.iter().enumerate() {
        let base = LEGEND_TOP + LEGEND * index as f32;
        scene.rectangle([left, base - 10.0, left + 22.0, base], Paint::Fill, *color);
        scene.text((left + 30.0, base), Anchor::Start, TEXT_SIZE, INK, text);
    }
}

fn frame(extent: (f64, f64), area: [f32; 4], x: &dyn Fn(f64) -> f32, below: &str, scene: &mut Scene) {
    let [left, top, right, bottom] = area;
    scene.polyline(&[(x(0.0), top), (x(0.0), bottom)], line(1.2), INK);
    scene.rectangle(area, line(1.2), INK);
    for (tick, text) in across(extent, right - left) {
        scene.polyline(&[(x(tick), bottom), (x(tick), bottom + 5.0)], line(1.2), INK);
        scene.text((x(tick), bottom + 20.0), Anchor::Middle, TEXT_SIZE, INK, &text);
    }
    scene.text(((left + right) / 2.0, bottom + 45.0), Anchor::Middle, 15.0, INK, below);
}
