//! The graphs of a picture, one below the other: what each shows, and how far its axis goes.

use carvallo::Mode;

use super::curves::{Curve, extent, extent_of_all, quantile};
use super::series::{Series, modes, strands};
use crate::analysis::{Eigenvalues, ModeRow, Row, Rows};

/// One graph.
pub struct Panel {
    /// Its curves, in painting order.
    pub series: Vec<Series>,
    /// The limits of its axis.
    pub y: (f64, f64),
    /// What its axis shows, with the unit.
    pub label: &'static str,
    /// What it is, where there are several.
    pub name: Option<&'static str>,
    /// Its part of the height that there is.
    pub share: f32,
}

/// One graph for the modes of a bicycle, as figure 4 of Meijaard et al. (2007); for any other model, whose frequencies may be
/// far above what grows or dies away, real parts above imaginary parts.
pub fn panels(rows: &Rows, y: Option<(f64, f64)>) -> Vec<Panel> {
    match rows {
        Rows::Modes(rows) => vec![of_modes(rows, y)],
        Rows::Branches(rows) | Rows::Sorted(rows) => of_branches(rows, y),
    }
}

fn of_modes(rows: &[ModeRow], y: Option<(f64, f64)>) -> Panel {
    let series = modes(rows);
    let y = y.unwrap_or_else(|| {
        let most = extent(rows.iter().flat_map(|row| row.values.iter().map(|mode| mode.value)));
        // A mode is one, in however many pieces.
        let all: Vec<Curve> = series.iter().map(|series| series.curves.concat()).collect();
        let extent = extent_of_all(most, &all);
        (-extent, extent)
    });
    Panel { series, y, label: "eigenvalue λ (1/s)", name: None, share: 1.0 }
}

fn of_branches(rows: &[Row<Eigenvalues>], y: Option<(f64, f64)>) -> Vec<Panel> {
    let named: Vec<String> = crate::analysis::strands::strands(rows)
        .into_iter()
        // Castering dies away fast, and never decides.
        .filter(|strand| strand.modes.iter().any(|mode| *mode != Mode::Castering))
        .map(|strand| strand.title)
        .collect();
    let [real, imaginary] = strands(rows);
    let y = y.unwrap_or_else(|| real_limits(&real, &named));
    let has_pairs = imaginary.iter().any(|series| !series.curves.is_empty());
    let share = if has_pairs { 0.6 } else { 1.0 };
    let mut panels =
        vec![Panel { series: real, y, label: "real parts (1/s)", name: has_pairs.then_some("real parts"), share }];
    if has_pairs {
        let y = (0.0, imaginary_limit(&imaginary, &named));
        let (label, name) = ("imaginary parts (rad/s)", Some("imaginary parts"));
        panels.push(Panel { series: imaginary, y, label, name, share: 0.4 });
    }
    panels
}

/// How many times as far the axis goes as what becomes stable or unstable, for what is faster.
const FASTER: f64 = 3.0;

/// How many times as far it goes to show a curve to its end.
const NEARLY: f64 = 1.6;

/// Most of what becomes stable or unstable, and what is as slow as that; not the far ends of what is fast.
fn real_limits(series: &[Series], named: &[String]) -> (f64, f64) {
    let sizes = |series: &Series| -> Vec<f64> {
        series.curves.iter().flatten().map(|(_, value)| value.abs()).filter(|size| *size > 0.0).collect()
    };
    let critical = series.iter().filter(|series| named.contains(&series.name));
    let critical = critical.filter_map(|series| quantile(sizes(series), 7)).fold(0.0, f64::max);
    let slow = series.iter().filter_map(|series| quantile(sizes(series), 9));
    let slow = quantile(slow.collect(), 4).unwrap_or(0.0);
    let size = if critical > 0.0 { slow.clamp(critical, FASTER * critical) } else { slow };
    let size = if size > 0.0 { size } else { 1.0 };
    // What is above zero alone, or below, needs no more of the other side than a margin.
    let side = |sign: f64| {
        let farthest = |series: &Series| {
            let values = series.curves.iter().flatten().map(|(_, value)| sign * value);
            values.fold(0.0, f64::max)
        };
        let ends: Vec<f64> = series.iter().map(farthest).collect();
        let shown = ends.iter().copied().filter(|end| *end <= NEARLY * size).fold(0.0, f64::max);
        let goes_on = ends.iter().any(|end| *end > NEARLY * size);
        finely(1.03 * shown.max(if goes_on { size } else { 0.2 * size }))
    };
    (-side(-1.0), side(1.0))
}

/// The frequencies of what becomes stable or unstable, and most others.
fn imaginary_limit(series: &[Series], named: &[String]) -> f64 {
    let sizes = |series: &Series| -> Vec<f64> { series.curves.iter().flatten().map(|(_, value)| *value).collect() };
    let highest = |series: &Series| quantile(sizes(series), 9);
    let critical = series.iter().filter(|series| named.contains(&series.name)).filter_map(highest).fold(0.0, f64::max);
    let all = quantile(series.iter().filter_map(highest).collect(), 6).unwrap_or(1.0);
    let limit = 1.1 * critical.max(all);
    // What is not much higher is shown as well.
    let highest = series.iter().flat_map(|series| series.curves.iter().flatten()).map(|(_, value)| *value);
    let highest = highest.fold(0.0, f64::max);
    finely(if highest <= 1.6 * limit { 1.05 * highest } else { limit })
}

/// The next number of one digit or a half.
pub fn finely(size: f64) -> f64 {
    if size <= 0.0 {
        return 1.0;
    }
    let power = 10_f64.powf(size.log10().floor());
    let halves = (2.0 * size / power).ceil() / 2.0;
    halves * power
}
