//! The effects of parameters on the weave and capsize speeds as bars from zero to both sides, the largest first.

use carvallo::{CriticalKind, CriticalSpeed, Mode};
use carvallo_design::number::{fixed, shortest, unit};

use super::axes::{INK, across};
use super::colors::color;
use super::font;
use super::scene::{Anchor, Color, Paint, Scene, line};
use crate::analysis::name;
use crate::analysis::sensitivity::{Changes, Step};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 36.0;
const TEXT_SIZE: f32 = 13.0;
/// A bar, what is between the bars of two parameters, and the room of their label.
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
/// Of the hue that it has against the speed, but lighter: bars side by side must differ also for who sees no hues.
const CAPSIZE: Color = Color(0xea, 0xa2, 0x21);

/// The bars of one parameter.
struct Row {
    symbol: String,
    step: String,
    /// One for each critical speed, in m/s.
    effects: Vec<f64>,
}

/// The bar chart; `None` if there is nothing to draw.
pub fn draw_tornado(changes: &Changes) -> Option<Scene> {
    let rows = rows(changes);
    let series = series(changes);
    let effects = || rows.iter().flat_map(|row| row.effects.iter().copied());
    let (low, high) = (effects().fold(0.0, f64::min), effects().fold(0.0, f64::max));
    if rows.is_empty() || low == high {
        return None;
    }
    let extent = (low - 0.04 * (high - low), high + 0.04 * (high - low));

    let row_height = (BAR * series.len() as f32 + GAP).max(LEAST_ROW);
    let top = LEGEND_TOP + LEGEND * series.len() as f32;
    let bottom = top + row_height * rows.len() as f32 + GAP;
    let title = format!("Sensitivity of {}: what 1 % of each parameter changes", changes.design.title());
    let notes = notes(changes, &rows);
    let mut scene = Scene::new(title.clone(), WIDTH, bottom + BELOW + NOTE * notes.len().saturating_sub(1) as f32);
    scene.text((WIDTH / 2.0, 32.0), Anchor::Middle, 18.0, INK, &title);

    let steps = rows.iter().map(|row| font::width(&row.step, TEXT_SIZE)).fold(0.0, f32::max);
    let symbols = rows.iter().map(|row| font::width(&row.symbol, TEXT_SIZE)).fold(0.0, f32::max);
    let left = 24.0 + symbols + 14.0 + steps + 12.0;
    let x = |effect: f64| left + ((effect - extent.0) / (extent.1 - extent.0)) as f32 * (RIGHT - left);
    legend(&series, left, &mut scene);
    for (tick, _) in across(extent, RIGHT - left) {
        scene.polyline(&[(x(tick), top), (x(tick), bottom)], line(1.0), GRID);
    }
    for (index, row) in rows.iter().enumerate() {
        let row_top = top + GAP / 2.0 + row_height * index as f32;
        let base = row_top + row_height / 2.0 + 0.5;
        scene.text((24.0, base), Anchor::Start, TEXT_SIZE, INK, &row.symbol);
        scene.text((left - 12.0, base), Anchor::End, TEXT_SIZE, INK.lighter(0.4), &row.step);
        let bars = BAR * row.effects.len() as f32;
        let first = row_top + (row_height - GAP - bars).max(0.0) / 2.0;
        for (place, (effect, (_, color))) in row.effects.iter().zip(&series).enumerate() {
            let (from, to) = (x(effect.min(0.0)), x(effect.max(0.0)));
            let bar_top = first + BAR * place as f32;
            scene.rectangle([from, bar_top, to, bar_top + BAR - 1.0], Paint::Fill, *color);
        }
    }
    frame(extent, [left, top, RIGHT, bottom], &x, &mut scene);
    for (index, note) in notes.iter().enumerate() {
        scene.text((24.0, bottom + 70.0 + NOTE * index as f32), Anchor::Start, TEXT_SIZE, INK.lighter(0.4), note);
    }
    Some(scene)
}

/// What the chart cannot show.
fn notes(changes: &Changes, rows: &[Row]) -> Vec<String> {
    let mut notes = Vec::new();
    if rows.iter().any(|row| row.step.starts_with('*')) {
        notes.push(
            "* zero itself: 1 % of the median size of the others in the same unit, of an angle 1 % of a radian"
                .to_owned(),
        );
    }
    let drawn = changes.within_reach().len();
    let mut beyond: Vec<&CriticalSpeed> = changes.ranked().into_iter().map(|(critical, _)| critical).collect();
    if drawn < beyond.len() {
        beyond.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        let beyond: Vec<String> = beyond[drawn..].iter().map(|critical| title(critical, changes)).collect();
        notes.push(format!("Not drawn, beyond the speeds that matter: {}", beyond.join("; ")));
    }
    notes
}

/// `weave speed, 4.2924 m/s`.
fn title(critical: &CriticalSpeed, changes: &Changes) -> String {
    let name = name(critical, changes.design.info()).replace('_', "-");
    format!("{name} speed, {} m/s", fixed(critical.speed, 4))
}

fn rows(changes: &Changes) -> Vec<Row> {
    let (info, shown) = (changes.design.info(), changes.within_reach());
    let row = |parameter: usize| {
        let effects: Option<Vec<f64>> =
            shown.iter().map(|(_, derivatives)| changes.effect(derivatives, parameter)).collect();
        let (info, step) = (&info.parameters[parameter], changes.steps[parameter].size()?);
        // Angles are shown in degrees, as on maps.
        let (step, unit) = match info.unit {
            "rad" => (step.to_degrees(), "°".to_owned()),
            declared => (step, format!(" {}", unit(declared))),
        };
        // Three digits are enough beside a bar.
        let rounded: f64 = format!("{step:.2e}").parse().unwrap_or(step);
        let sign = if step < 0.0 { "" } else { "+" };
        let mark = if matches!(changes.steps[parameter], Step::OfScale(_)) { "* " } else { "" };
        let step = format!("{mark}{sign}{}{unit}", shortest(rounded)).replace('-', "−");
        let effects = effects.filter(|effects| effects.iter().any(|effect| *effect != 0.0))?;
        Some(Row { symbol: info.symbol.to_owned(), step: step.trim_end().to_owned(), effects })
    };
    changes.order().into_iter().filter_map(row).collect()
}

/// What the bars of a parameter stand for, and their colours; of several critical speeds of a kind the later are lighter.
fn series(changes: &Changes) -> Vec<(String, Color)> {
    let shown = changes.within_reach();
    let entry = |(index, (critical, _)): (usize, &(&CriticalSpeed, _))| {
        let name = |critical| name(critical, changes.design.info());
        let color = match critical.kind {
            CriticalKind::Weave if name(critical) == "wobble" => color(Mode::Wobble),
            CriticalKind::Weave => color(Mode::Weave),
            CriticalKind::Capsize => CAPSIZE,
            CriticalKind::DoubleRoot => INK.lighter(0.3),
        };
        let before = shown[..index].iter().filter(|(other, _)| name(other) == name(critical)).count();
        let color = color.lighter((0.4 * before as f32).min(0.8));
        (title(critical, changes), color)
    };
    shown.iter().enumerate().map(entry).collect()
}

fn legend(series: &[(String, Color)], left: f32, scene: &mut Scene) {
    for (index, (text, color)) in series.iter().enumerate() {
        let base = LEGEND_TOP + LEGEND * index as f32;
        scene.rectangle([left, base - 10.0, left + 22.0, base], Paint::Fill, *color);
        scene.text((left + 30.0, base), Anchor::Start, TEXT_SIZE, INK, text);
    }
}

fn frame(extent: (f64, f64), area: [f32; 4], x: &dyn Fn(f64) -> f32, scene: &mut Scene) {
    let [left, top, right, bottom] = area;
    scene.polyline(&[(x(0.0), top), (x(0.0), bottom)], line(1.2), INK);
    scene.rectangle(area, line(1.2), INK);
    for (tick, text) in across(extent, right - left) {
        scene.polyline(&[(x(tick), bottom), (x(tick), bottom + 5.0)], line(1.2), INK);
        scene.text((x(tick), bottom + 20.0), Anchor::Middle, TEXT_SIZE, INK, &text);
    }
    let title = "change of the critical speed (m/s) as the parameter changes by what stands beside it";
    scene.text(((left + right) / 2.0, bottom + 45.0), Anchor::Middle, 15.0, INK, title);
}
