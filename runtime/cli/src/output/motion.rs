//! A motion for people, at a terminal.

use std::fmt::Write as _;

use carvallo_design::number::{fixed, shortest};
use carvallo_design::units::Units;
use carvallo_plot::analysis::simulation::{Motion, Quantity, Row};

use crate::output::columns::width;
use crate::output::table::write_heading;
use crate::output::{FAINT, HEADING};

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn render_table(motion: &Motion, units: &Units) -> String {
    let mut text = String::new();
    write_heading(motion.design, &mut text);
    let _ = writeln!(text, "\n{HEADING}Motion{HEADING:#} by {}", equations(motion));
    let columns = columns(motion, units);
    let widths: Vec<usize> =
        columns.iter().map(|column| width(std::iter::once(&column.heading).chain(&column.cells), 0)).collect();
    let line = |cells: Vec<&str>| -> String {
        cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}")).collect()
    };
    let _ = writeln!(text, "{FAINT}{}{FAINT:#}", line(columns.iter().map(|column| column.heading.as_str()).collect()));
    for row in 0..motion.rows.len() {
        let _ = writeln!(text, "{}", line(columns.iter().map(|column| column.cells[row].as_str()).collect()));
    }
    text
}

/// What it is computed by.
pub fn equations(motion: &Motion) -> &'static str {
    if motion.is_linear { "the linear equations, solved exactly" } else { "the nonlinear equations" }
}

/// The most letters that explain a symbol.
const LONGEST: usize = 16;

pub struct Column {
    pub heading: String,
    pub cells: Vec<String>,
}

/// Time, speed, and the positions; of a few coordinates their rates as well, and of a state alone the accelerations. Angles are in degrees, unless another unit is asked for.
pub fn columns(motion: &Motion, units: &Units) -> Vec<Column> {
    let column = |heading: String, cell: &dyn Fn(&Row) -> String| Column {
        heading,
        cells: motion.rows.iter().map(cell).collect(),
    };
    let mut columns = vec![column("t (s)".to_owned(), &|row| time(row.t))];
    // Of bicycles the speed tells what the angles of the wheels do.
    let has_speed = motion.rows.first().is_some_and(|row| motion.speed(row).is_some());
    if has_speed {
        let unit = units.of("m/s");
        columns.push(column(format!("v{}", unit.behind_name()), &|row| {
            four_decimals(unit.value(motion.speed(row).unwrap_or(0.0)))
        }));
    }
    let told = |quantity: &&Quantity| !(has_speed && matches!(quantity.name, "thetaR" | "thetaF"));
    for quantity in motion.quantities.iter().filter(told) {
        let place = place(motion, quantity);
        let shown = units.for_people(quantity.unit);
        let unit = shown.behind_name();
        // What is longer explains more than there is room for.
        let is_short = quantity.label != quantity.name && quantity.label.chars().count() <= LONGEST;
        let name = if is_short { format!("{} ", quantity.label) } else { String::new() };
        columns.push(column(format!("{name}{}{unit}", quantity.name), &|row| {
            four_decimals(shown.value(row.positions[place]))
        }));
    }
    for (place, (name, unit)) in motion.feedback().iter().enumerate() {
        let shown = units.of(unit);
        columns.push(column(format!("{name}{}", shown.behind_name()), &|row| {
            four_decimals(shown.value(row.feedback[place]))
        }));
    }
    if !has_speed {
        for quantity in &motion.quantities {
            let (place, shown) = (place(motion, quantity), units.by_time_for_people(quantity.unit, 1));
            columns.push(column(format!("{}'{}", quantity.name, shown.behind_name()), &|row| {
                four_decimals(shown.value(row.rates[place]))
            }));
        }
    }
    // Of a state alone, what it does next is all that there is to know.
    let is_state = matches!(motion.rows[..], [Row { t: 0.0, .. }]);
    if is_state {
        for quantity in motion.quantities.iter().filter(told) {
            let (place, shown) = (place(motion, quantity), units.by_time_for_people(quantity.unit, 2));
            columns.push(column(format!("{}''{}", quantity.name, shown.behind_name()), &|row| {
                four_decimals(shown.value(row.accelerations[place]))
            }));
        }
    }
    columns
}

fn place(motion: &Motion, quantity: &Quantity) -> usize {
    motion.position(quantity.name).unwrap_or(0)
}

/// What is close to zero is zero: how close is of no interest in a motion.
fn four_decimals(value: f64) -> String {
    if value.abs() < 1e7 { format!("{:.4}", (value * 1e4).round() / 1e4 + 0.0) } else { fixed(value, 4) }
}

/// No more digits than tell a time from its neighbours.
pub fn time(t: f64) -> String {
    if 0.0 < t && t < 1e-4 {
        return format!("{t:.3e}");
    }
    shortest(format!("{t:.6}").parse().unwrap_or(t))
}
