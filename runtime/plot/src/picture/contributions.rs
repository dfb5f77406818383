//! What parameters contribute to the difference of the critical speeds of two designs, as bars, the largest first.

use carvallo::CriticalSpeed;
use carvallo_design::DisplayUnit;
use carvallo_design::number::{fixed, shortest};
use carvallo_design::units::Units;

use super::bars::{self, Bars, Row};
use super::font;
use super::scene::{Color, Scene};
use super::tornado::colors;
use crate::analysis::compare::{Compared, Difference, Way, Whole};
use crate::analysis::name;

/// Contributions smaller than this part of the largest one are too short for bars.
const SHORTEST: f64 = 0.002;

/// The longest name of a design in a title, in pixels.
const LONGEST: f32 = 720.0;

/// The bar chart of a design against the first one, with angles in degrees where no unit is asked for; `None` if there is nothing to
/// draw.
pub fn draw_contributions(first: &Compared, other: &Compared, difference: &Difference, units: &Units) -> Option<Scene> {
    let Difference::Explained { parameters, ways } = difference else { return None };
    let (info, whole) = (other.analysis.design.info(), difference.whole());
    let speed = units.of("m/s");
    let told = |critical: &CriticalSpeed| fixed(speed.value(critical.speed), 4);
    let label = |critical: &CriticalSpeed| name(critical, info).replace('_', " ");
    let shown: Vec<&CriticalSpeed> = whole.iter().map(|Whole { from, .. }| from).collect();
    let titles = whole.iter().map(|Whole { from, to, .. }| {
        let change = fixed(speed.value(to.speed - from.speed), 4);
        let sign = if to.speed >= from.speed { "+" } else { "" };
        format!("{} speed, from {} to {}{}: {sign}{change}", label(from), told(from), told(to), speed.behind_number())
            .replace('-', "−")
    });
    let series: Vec<(String, Color)> = titles.zip(colors(&shown, info)).collect();
    let sums = whole.iter().map(|Whole { from, to, .. }| speed.value(to.speed - from.speed));
    let sum = Row { symbol: "in sum".to_owned(), beside: String::new(), values: sums.collect() };
    let row = |place: usize| {
        let parameter = &info.parameters[parameters[place]];
        let value = |compared: &Compared| compared.analysis.design.parameters[parameters[place]].value;
        let beside = change(value(first), value(other), &units.for_people(parameter.unit));
        let values = whole.iter().map(|whole| speed.value(whole.contributions[place])).collect();
        Row { symbol: parameter.symbol.to_owned(), beside, values }
    };
    let all: Vec<Row> = difference.order().into_iter().map(row).collect();
    let size = |row: &Row| row.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let largest = all.iter().map(size).fold(0.0, f64::max);
    let (long, short): (Vec<Row>, Vec<Row>) = all.into_iter().partition(|row| size(row) >= SHORTEST * largest);
    let mut notes = Vec::new();
    if !short.is_empty() {
        let names: Vec<&str> = short.iter().map(|row| row.symbol.as_str()).collect();
        notes.push(format!("Too small for bars: {}", names.join(", ")));
    }
    let parts = ways.iter().filter(|way| !matches!(way, Way::Whole(_)));
    notes.extend(parts.map(|way| {
        let critical = way.critical();
        let whose = if matches!(way, Way::Lost { .. }) { &first.label } else { &other.label };
        format!("Only {whose} has the {} speed {}{}", label(critical), told(critical), speed.behind_number())
    }));
    let title = |other: &str, first: &str| format!("What makes the difference of {other} from {first}");
    // Both have room in the two lines of a title.
    let labels = font::apart(&[other.label.as_str(), first.label.as_str()], 13.0, LONGEST);
    bars::draw(&Bars {
        title: title(&other.label, &first.label),
        short_title: title(&labels[0], &labels[1]),
        series,
        rows: std::iter::once(sum).chain(long).collect(),
        across: format!("contribution to the difference of the critical speed{}", speed.behind_name()),
        notes,
    })
}

/// `85 to 4.49 kg`, with three digits.
fn change(from: f64, to: f64, unit: &DisplayUnit) -> String {
    let rounded = |value: f64| shortest(format!("{:.2e}", unit.value(value)).parse().unwrap_or(value));
    format!("{} to {}{}", rounded(from), rounded(to), unit.behind_number()).replace('-', "−")
}
