//! Several designs beside each other, in tables.

use carvallo::{CriticalSpeed, ParameterInfo};
use carvallo_design::DisplayUnit;
use carvallo_design::number::{fixed, shortest};
use carvallo_design::units::Units;
use carvallo_plot::analysis::compare::{Compared, Comparison, Difference, End, Event, Parameter, Way, Whole};
use carvallo_plot::analysis::name;

use crate::output::list::ranges;
use crate::output::typeset::{Cell, Column, Document, Table};

/// Critical speeds and parameters, of these those that differ or all, and which parameters make the differences.
pub fn of_comparison(comparison: &Comparison, all: bool, units: &Units) -> Document {
    let labels: Vec<&str> = comparison.designs.iter().map(|compared| compared.label.as_str()).collect();
    let mut tables = vec![critical_speeds(comparison, units), parameters(comparison, all, units)];
    let (first, others) = (&comparison.designs[0], &comparison.designs[1..]);
    let differences = others.iter().zip(&comparison.differences);
    tables.extend(differences.map(|(other, difference)| explained(first, other, difference, units)));
    Document { title: labels.join(", "), about: Vec::new(), tables }
}

/// What speeds are declared in.
const SPEED: &str = "m/s";

/// More names than this are counted.
const MOST_NAMES: usize = 30;

fn columns(comparison: &Comparison) -> impl Iterator<Item = Column> + '_ {
    comparison.designs.iter().map(|compared| Column::right(compared.label.clone()))
}

/// The critical speeds of each kind, and the stable ranges, of all designs.
pub fn critical_speeds(comparison: &Comparison, units: &Units) -> Table {
    let unit = units.of(SPEED);
    let of = |compared: &Compared| -> Vec<(&'static str, f64)> {
        let Compared { analysis, .. } = compared;
        let named = |critical: &CriticalSpeed| (name(critical, analysis.design.info()), critical.speed);
        analysis.critical_speeds().iter().map(named).collect()
    };
    let speeds: Vec<Vec<(&str, f64)>> = comparison.designs.iter().map(of).collect();
    let mut kinds: Vec<&str> = Vec::new();
    for (kind, _) in speeds.iter().flatten() {
        if !kinds.contains(kind) {
            kinds.push(kind);
        }
    }
    let rank = |kind: &str| match kind {
        "double_root" => 2,
        "capsize" | "divergence" => 1,
        _ => 0,
    };
    kinds.sort_by_key(|kind| rank(kind));
    let row = |kind: &&str| {
        let of_kind = |speeds: &Vec<(&str, f64)>| -> Vec<String> {
            speeds.iter().filter(|(other, _)| other == kind).map(|(_, speed)| fixed(unit.value(*speed), 4)).collect()
        };
        let cells = speeds.iter().map(of_kind);
        let cell =
            |speeds: Vec<String>| Cell::number(if speeds.is_empty() { "-".to_owned() } else { speeds.join(", ") });
        [Cell::words(kind.replace('_', " "))].into_iter().chain(cells.map(cell)).collect()
    };
    let stable = |Compared { analysis, .. }: &Compared| {
        let is_same = !analysis.design.model.depends_on_speed() && !analysis.stable_ranges().is_empty();
        Cell::words(if is_same { "at every speed".to_owned() } else { ranges(analysis.stable_ranges(), &unit) })
    };
    let stable = comparison.designs.iter().map(stable);
    let stable = [Cell::words("self-stable")].into_iter().chain(stable).collect();
    Table {
        title: format!("Critical speeds ({})", unit.unit()),
        columns: [Column::left("")].into_iter().chain(columns(comparison)).collect(),
        rows: kinds.iter().map(row).chain([stable]).collect(),
        notes: Vec::new(),
    }
}

fn parameters(comparison: &Comparison, all: bool, units: &Units) -> Table {
    let shown = comparison.parameters(all);
    let row = |Parameter { info, values, .. }: &Parameter| {
        let unit = units.of(info.unit);
        let shown = |value: f64| shortest(unit.value(value) + 0.0);
        let value = |value: &Option<f64>| Cell::number(value.map_or("-".to_owned(), shown));
        let head = [Cell::parameter(info), Cell::words(unit.unit())];
        head.into_iter().chain(values.iter().map(value)).collect()
    };
    let every = comparison.parameters(true);
    let (common, own): (Vec<&Parameter>, Vec<&Parameter>) = every.iter().partition(|parameter| parameter.is_common());
    let same: Vec<&str> = common.iter().filter(|known| !known.differs()).map(|known| known.info.name).collect();
    let mut notes = Vec::new();
    if shown.is_empty() {
        notes.push(
            if common.is_empty() { "they have none in common" } else { "those that all have are the same" }.to_owned(),
        );
    } else if !same.is_empty() && !all {
        notes.push(format!("the same in all: {}", same.join(", ")));
    }
    if !own.is_empty() && !all {
        let names: Vec<&str> = own.iter().map(|parameter| parameter.info.name).collect();
        let names = if names.len() <= MOST_NAMES { names.join(", ") } else { format!("{} parameters", names.len()) };
        notes.push(format!("not in all: {names}"));
    }
    let title = if all { "Parameters" } else { "Parameters that differ" };
    Table {
        title: title.to_owned(),
        columns: [Column::left("parameter"), Column::left("unit")].into_iter().chain(columns(comparison)).collect(),
        rows: shown.iter().map(row).collect(),
        notes,
    }
}

/// What each parameter contributes to the differences of the critical speeds, the largest contribution first.
pub fn explained(first: &Compared, other: &Compared, difference: &Difference, units: &Units) -> Table {
    let speed = units.of(SPEED);
    let title = format!("What makes the difference of {} from {} ({})", other.label, first.label, speed.unit());
    let (parameters, ways) = match difference {
        Difference::Explained { parameters, ways } => (parameters, ways),
        Difference::Unexplained(reason) => {
            return Table { title, columns: Vec::new(), rows: Vec::new(), notes: vec![reason.clone()] };
        }
    };
    let info = other.analysis.design.info();
    let whole = difference.whole();
    let heading = |Whole { from, to, .. }: &&Whole| {
        let kind = name(from, info).replace('_', " ");
        Column::right(format!("{kind} {} → {}", fixed(speed.value(from.speed), 4), fixed(speed.value(to.speed), 4)))
    };
    let order = difference.order();
    let row = |&place: &usize| {
        let parameter: &ParameterInfo = &info.parameters[parameters[place]];
        let [from, to] = [first, other].map(|compared| &compared.analysis.design.parameters[parameters[place]]);
        let unit = units.of(parameter.unit);
        let change = format!("{} → {}", rounded(unit.value(from.value)), rounded(unit.value(to.value)));
        let head = [Cell::parameter(parameter), Cell::words(format!("{change} {}", unit.unit()).trim_end())];
        let contribution = |whole: &&Whole| Cell::number(signed(speed.value(whole.contributions[place])));
        head.into_iter().chain(whole.iter().map(contribution)).collect()
    };
    let sum = |Whole { from, to, .. }: &&Whole| Cell::number(signed(speed.value(to.speed - from.speed)));
    let sum = [Cell::words("in sum"), Cell::words("")].into_iter().chain(whole.iter().map(sum)).collect();
    let rows: Vec<Vec<Cell>> = if whole.is_empty() { Vec::new() } else { order.iter().map(row).chain([sum]).collect() };
    let mut notes: Vec<String> = ways.iter().filter_map(|way| part(way, first, other, &speed)).collect();
    let without = (0..parameters.len()).filter(|place| !order.contains(place));
    let without: Vec<&str> = without.map(|place| info.parameters[parameters[place]].name).collect();
    if !without.is_empty() && !whole.is_empty() {
        notes.push(format!("without effect: {}", without.join(", ")));
    }
    if ways.is_empty() {
        notes.push("there is no difference to explain".to_owned());
    }
    Table {
        title,
        columns: [Column::left("parameter"), Column::left("from → to")]
            .into_iter()
            .chain(whole.iter().map(heading))
            .collect(),
        rows,
        notes,
    }
}

/// What becomes of a critical speed that one of the designs has alone.
fn part(way: &Way, first: &Compared, other: &Compared, unit: &DisplayUnit) -> Option<String> {
    let (critical, label, happens, Event { place, speed, end }) = match way {
        Way::Whole(_) => return None,
        Way::Lost { from, event } => (from, &first.label, "vanishes", event),
        Way::Found { to, event } => (to, &other.label, "appears", event),
    };
    let kind = name(critical, other.analysis.design.info()).replace('_', " ");
    let near = match end {
        End::Endless | End::AtRest => String::new(),
        _ => format!(" near {} {}", fixed(unit.value(*speed), 4), unit.unit()),
    };
    let speed = fixed(unit.value(critical.speed), 4);
    Some(format!("the {kind} speed {speed} of {label} {happens} at {:.4} % of the way{near}: {end}", 100.0 * place))
}

/// Six digits, which are enough beside a contribution.
pub fn rounded(value: f64) -> String {
    shortest(format!("{value:.5e}").parse().unwrap_or(value))
}

fn signed(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    format!("{}{}", if value > 0.0 { "+" } else { "" }, fixed(value, 6))
}
