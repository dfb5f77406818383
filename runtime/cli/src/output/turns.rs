//! Steady turns for people, at a terminal.

use std::fmt::Write as _;

use anstyle::Style;
use carvallo::turns::Turn;
use carvallo_design::number::{fixed, shortest};
use carvallo_design::units::Units;
use carvallo_plot::analysis::turns::{Families, Family, end, growth, verdict};

use crate::output::columns::width;
use crate::output::table::write_heading;
use crate::output::{FAINT, GOOD, HEADING};

/// How many turns of a curve are shown, about.
const SHOWN: usize = 24;

/// All turns, or of a curve some, from its beginning to its end. Writing to a string cannot fail, so that the results of
/// `write!` are dropped.
pub fn render_table(families: &Families, all: bool, units: &Units) -> String {
    let mut text = String::new();
    write_heading(families.design, &mut text);
    for family in &families.families {
        let _ = writeln!(text, "\n{HEADING}Steady turns{HEADING:#} {}", begin(family, units));
        let turns = shown(family, all);
        if family.capsize.is_none() && !all {
            let _ = writeln!(text, "{FAINT}beginning of the curve: {}{FAINT:#}", end(family.begin));
        }
        write_turns(families, &turns, units, &mut text);
        let _ = match all {
            true if turns.is_empty() => writeln!(text, "  none at these steers"),
            true => Ok(()),
            false => writeln!(text, "{FAINT}end of the curve: {}{FAINT:#}", end(family.end)),
        };
    }
    text
}

/// Where the curve begins.
pub fn begin(family: &Family, units: &Units) -> String {
    let unit = units.of("m/s");
    match family.capsize {
        Some(speed) => format!("from the capsize speed of {} {}", shortest(unit.value(speed)), unit.unit()),
        None => "that begin at no capsize speed".to_owned(),
    }
}

/// All turns, or some of them.
pub fn shown(family: &Family, all: bool) -> Vec<&Turn> {
    let last = family.turns.len().saturating_sub(1);
    let each = if all { 1 } else { family.turns.len().div_ceil(SHOWN).max(1) };
    family
        .turns
        .iter()
        .enumerate()
        .filter(|(index, _)| index % each == 0 || *index == last)
        .map(|(_, turn)| turn)
        .collect()
}

/// The headings of the columns, and the cells of each turn, but for the verdict.
pub fn cells(families: &Families, turns: &[&Turn], units: &Units) -> (Vec<String>, Vec<Vec<String>>) {
    let (speed, length, rate) = (units.of("m/s"), units.of("m"), units.by_time_for_people("rad", 1));
    let mut headings = vec![format!("v{}", speed.behind_name()), format!("radius{}", length.behind_name())];
    for (_, told) in &families.positions {
        let label = if told.label == told.name { String::new() } else { format!("{} ", told.label) };
        headings.push(format!("{label}{}{}", told.name, units.for_people(told.unit).behind_name()));
    }
    headings.extend([format!("yaw rate{}", rate.behind_name()), "growth (1/s)".to_owned()]);
    let decimals = |value: f64| if value.abs() < 1e7 { format!("{:.4}", value + 0.0) } else { fixed(value, 4) };
    let rows: Vec<Vec<String>> = turns
        .iter()
        .map(|turn| {
            let radius =
                if turn.radius.is_finite() { decimals(length.value(turn.radius)) } else { "straight".to_owned() };
            let mut row = vec![decimals(speed.value(turn.speed)), radius];
            row.extend(
                families
                    .positions
                    .iter()
                    .map(|(place, told)| decimals(units.for_people(told.unit).value(turn.positions[*place]))),
            );
            row.extend([decimals(rate.value(turn.yaw_rate)), decimals(growth(turn))]);
            row.into_iter().map(|cell| if cell == "-0.0000" { "0.0000".to_owned() } else { cell }).collect()
        })
        .collect();
    (headings, rows)
}

fn write_turns(families: &Families, turns: &[&Turn], units: &Units, text: &mut String) {
    if turns.is_empty() {
        return;
    }
    let (headings, rows) = cells(families, turns, units);
    let widths: Vec<usize> = (0..headings.len())
        .map(|column| width(rows.iter().map(|row| &row[column]).chain([&headings[column]]), 0))
        .collect();
    let line = |cells: &[String]| -> String {
        cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}")).collect()
    };
    let _ = writeln!(text, "{FAINT}{}{FAINT:#}", line(&headings));
    for (row, turn) in rows.iter().zip(turns) {
        let verdict = verdict(turn);
        let style = if verdict == "stable" { GOOD } else { Style::new() };
        let _ = writeln!(text, "{style}{}  {verdict}{style:#}", line(row));
    }
}
