//! The effects of parameters on the weave and capsize speeds as bars from zero to both sides, the largest first.

use carvallo::{CriticalKind, CriticalSpeed, Mode, ModelInfo};
use carvallo_design::number::{fixed, shortest};

use super::axes::INK;
use super::bars::{self, Bars, Row};
use super::colors::color;
use super::scene::{Color, Scene};
use crate::analysis::name;
use crate::analysis::sensitivity::{Changes, Step};

/// Of the hue that it has against the speed, but lighter: bars side by side must differ also for who sees no hues.
const CAPSIZE: Color = Color(0xea, 0xa2, 0x21);

/// The bar chart; `None` if there is nothing to draw.
pub fn draw_tornado(changes: &Changes) -> Option<Scene> {
    let rows = rows(changes);
    let shown: Vec<&CriticalSpeed> = changes.within_reach().into_iter().map(|(critical, _)| critical).collect();
    let info = changes.design.info();
    let colors = colors(&shown, info);
    let title_of_all = format!("Sensitivity of {}: what 1 % of each parameter changes", changes.design.title());
    bars::draw(&Bars {
        short_title: title_of_all.clone(),
        title: title_of_all,
        series: shown.iter().map(|critical| title(critical, changes)).zip(colors).collect(),
        notes: notes(changes, &rows),
        rows,
        across: format!(
            "change of the critical speed ({}) as the parameter changes by what stands beside it",
            changes.of_speeds().unit()
        ),
    })
}

/// What the chart cannot show.
fn notes(changes: &Changes, rows: &[Row]) -> Vec<String> {
    let mut notes = Vec::new();
    if rows.iter().any(|row| row.beside.starts_with('*')) {
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
    let unit = changes.of_speeds();
    format!("{name} speed, {} {}", fixed(unit.value(critical.speed), 4), unit.unit())
}

fn rows(changes: &Changes) -> Vec<Row> {
    let (info, shown, speed) = (changes.design.info(), changes.within_reach(), changes.of_speeds());
    let row = |parameter: usize| {
        let values: Option<Vec<f64>> =
            shown.iter().map(|(_, derivatives)| Some(speed.value(changes.effect(derivatives, parameter)?))).collect();
        let (info, step) = (&info.parameters[parameter], changes.steps[parameter].size()?);
        // Angles are shown in degrees, as on maps, unless another unit is asked for.
        let in_unit = changes.of_parameter(parameter);
        let (step, unit) = match in_unit.written.as_str() {
            "rad" => (step.to_degrees(), "°".to_owned()),
            "deg" => (in_unit.value(step), "°".to_owned()),
            _ => (in_unit.value(step), format!(" {}", in_unit.unit())),
        };
        // Three digits are enough beside a bar.
        let rounded: f64 = format!("{step:.2e}").parse().unwrap_or(step);
        let sign = if step < 0.0 { "" } else { "+" };
        let mark = if matches!(changes.steps[parameter], Step::OfScale(_)) { "* " } else { "" };
        let step = format!("{mark}{sign}{}{unit}", shortest(rounded)).replace('-', "−");
        let values = values.filter(|values| values.iter().any(|value| *value != 0.0))?;
        Some(Row { symbol: info.symbol.to_owned(), beside: step.trim_end().to_owned(), values })
    };
    changes.order().into_iter().filter_map(row).collect()
}

/// The colours of critical speeds; of several of a kind the later are lighter.
pub fn colors(shown: &[&CriticalSpeed], info: &ModelInfo) -> Vec<Color> {
    let name = |critical: &CriticalSpeed| name(critical, info);
    let color = |(index, critical): (usize, &&CriticalSpeed)| {
        let color = match critical.kind {
            CriticalKind::Weave if name(critical) == "wobble" => color(Mode::Wobble),
            CriticalKind::Weave => color(Mode::Weave),
            CriticalKind::Capsize => CAPSIZE,
            CriticalKind::DoubleRoot => INK.lighter(0.3),
        };
        let before = shown[..index].iter().filter(|other| name(other) == name(critical)).count();
        color.lighter((0.4 * before as f32).min(0.8))
    };
    shown.iter().enumerate().map(color).collect()
}
