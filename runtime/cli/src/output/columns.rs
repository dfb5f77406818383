//! Columns of tables for people.

use carvallo_design::DisplayUnit;
use carvallo_design::number::shortest;
use carvallo_plot::analysis::Row;

/// How wide a line may become where that can be helped.
pub const LINE: usize = 124;

/// The width of a column that keeps two spaces before or after its texts.
pub fn width<'a>(texts: impl IntoIterator<Item = &'a String>, least: usize) -> usize {
    texts.into_iter().map(|text| text.chars().count() + 2).fold(least, usize::max)
}

/// Speeds with as many decimals as one of them has, unless that would make them long.
pub fn speeds<V>(rows: &[Row<V>], unit: &DisplayUnit) -> Vec<String> {
    // What another unit leaves of rounding is none.
    let shown = |speed: f64| match unit.is_declared() {
        true => speed,
        false => format!("{:.9}", unit.value(speed)).parse().unwrap_or(speed),
    };
    let speeds: Vec<f64> = rows.iter().map(|row| shown(row.speed)).collect();
    let decimals = speeds.iter().map(|speed| speed.to_string().split_once('.').map_or(0, |(_, tail)| tail.len()));
    let decimals = decimals.max().unwrap_or(0);
    let is_long = decimals > 6 || speeds.iter().any(|speed| *speed >= 1e9);
    let speeds = speeds.into_iter();
    speeds.map(|speed| if is_long { shortest(speed) } else { format!("{speed:.decimals$}") }).collect()
}
