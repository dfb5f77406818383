//! Eigenvalues of several designs against the speed, laid over each other: real parts above imaginary parts, each design in a
//! colour, and above both where each is stable.

use carvallo_design::units::Units;
use carvallo_design::{DisplayUnit, Failure};

use super::axes::{EVEN, INK, margin};
use super::colors::{design, design_line};
use super::curves::{Curve, extend, samples};
use super::font;
use super::graph::{Graph, Line};
use super::panels::panels;
use super::scene::{Anchor, Color, Paint, Scene, line};
use super::series::Series;
use crate::analysis::Rows;
use crate::analysis::compare::{Compared, Comparison};

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const HEIGHTS: [f32; 2] = [360.0, 230.0];
const TEXT_SIZE: f32 = 13.0;
/// The height of a line of the legend, with the bar of stable speeds.
const ROW: f32 = 21.0;
const TOP: f32 = 52.0;
const GRID: Color = Color(0xe4, 0xe4, 0xe4);

/// The curves of a design, each with what it shows, and how far their axes go.
struct Curves {
    real: Vec<Curve>,
    imaginary: Vec<Curve>,
    real_limits: (f64, f64),
    imaginary_limit: f64,
}

/// The eigenvalues between two speeds in m/s, or as far as there is something to see of each; and real parts between two limits
/// in 1/s, or most of what there is.
///
/// # Errors
/// If they cannot be computed at one of the speeds.
pub fn draw_overlay(
    comparison: &Comparison,
    x: Option<(f64, f64)>,
    y: Option<(f64, f64)>,
    units: &Units,
) -> Result<Scene, Failure> {
    let speed = units.of("m/s");
    let reach = || comparison.designs.iter().map(|compared| compared.analysis.reach).fold(0.0, f64::max);
    let x = x.unwrap_or_else(|| (0.0, reach()));
    let all = comparison.designs.iter().map(|compared| curves(compared, x, &speed)).collect::<Result<Vec<_>, _>>()?;
    let most = |limit: fn(&Curves) -> f64| all.iter().map(limit).fold(0.0, f64::max);
    let real_limits = y.unwrap_or_else(|| (-most(|curves| -curves.real_limits.0), most(|curves| curves.real_limits.1)));
    let imaginary_limits = (0.0, most(|curves| curves.imaginary_limit));
    let left = margin(real_limits).max(margin(imaginary_limits));

    let labels: Vec<&str> = comparison.designs.iter().map(|compared| compared.label.as_str()).collect();
    let title = format!("Eigenvalues of {}", labels.join(", "));
    let title = if font::width(&title, 18.0) < WIDTH - 20.0 {
        title
    } else {
        format!("Eigenvalues of {} designs", labels.len())
    };
    let mut scene = Scene::new(title.clone(), WIDTH, 1.0);
    scene.heading((WIDTH / 2.0, 32.0), INK, &title);
    let mut top = write_legend(comparison, x, &speed, left, &mut scene);
    let x = (speed.value(x.0), speed.value(x.1));
    let graph = |title: &'static str, height, y, part: fn(&Curves) -> &Vec<Curve>| {
        let curves = all.iter().enumerate().flat_map(|(index, curves)| {
            part(curves).iter().map(move |curve| Line {
                name: None,
                color: design(index),
                paint: design_line(index, 2.0),
                curve: curve.clone(),
            })
        });
        Graph { title: title.into(), height, x, y, scales: EVEN, lines: curves.collect(), note: None }
    };
    let has_pairs = all.iter().any(|curves| !curves.imaginary.is_empty());
    let label = format!("speed v{}", speed.behind_name());
    let real = graph("real parts (1/s)", HEIGHTS[0], real_limits, |curves| &curves.real);
    top = real.draw((!has_pairs).then_some(label.as_str()), [left, RIGHT], top, &mut scene);
    if has_pairs {
        let imaginary = graph("imaginary parts (rad/s)", HEIGHTS[1], imaginary_limits, |curves| &curves.imaginary);
        top = imaginary.draw(Some(&label), [left, RIGHT], top, &mut scene);
    }
    scene.height = top;
    Ok(scene)
}

/// What the colours mean, each with a bar over the speeds at which the design is stable; the height below.
fn write_legend(comparison: &Comparison, x: (f64, f64), unit: &DisplayUnit, left: f32, scene: &mut Scene) -> f32 {
    // What is behind the names has its room, too.
    let labels: Vec<&str> = comparison.designs.iter().map(|compared| compared.label.as_str()).collect();
    let short = font::apart(&labels, TEXT_SIZE, 0.5 * WIDTH);
    let widest = short.iter().map(|label| font::width(label, TEXT_SIZE)).fold(0.0, f32::max);
    let place = |speed: f64| left + ((speed - x.0) / (x.1 - x.0)) as f32 * (RIGHT - left);
    let behind = unit.behind_number();
    let mut top = TOP;
    for (index, (Compared { label, analysis }, short)) in comparison.designs.iter().zip(&short).enumerate() {
        let color = design(index);
        let base = top + 13.0;
        scene.polyline(&[(left - 8.0, top + 8.0), (left + 22.0, top + 8.0)], design_line(index, 3.0), color);
        let stable = analysis.stable_ranges().iter();
        let stable: Vec<String> = stable
            .map(|range| match range.to {
                Some(to) => format!("{:.2} to {:.2}{behind}", unit.value(range.from), unit.value(to)),
                None => format!("above {:.2}{behind}", unit.value(range.from)),
            })
            .collect();
        let stable =
            if stable.is_empty() { "stable at no speed".to_owned() } else { format!("stable {}", stable.join(", ")) };
        scene.short_text((left + 30.0, base), TEXT_SIZE, color, [short, label]);
        scene.text((left + 30.0 + widest + 24.0, base), Anchor::Start, TEXT_SIZE, INK.lighter(0.3), &stable);
        top += ROW;
    }
    top += 4.0;
    for (index, Compared { analysis, .. }) in comparison.designs.iter().enumerate() {
        for range in analysis.stable_ranges() {
            let (from, to) = (range.from.max(x.0), range.to.unwrap_or(f64::INFINITY).min(x.1));
            if from < to {
                scene.rectangle([place(from), top, place(to), top + 6.0], Paint::Fill, design(index));
            }
        }
        top += 8.0;
    }
    scene.rectangle([left, top - 8.0 * comparison.designs.len() as f32 - 1.0, RIGHT, top - 1.0], line(1.0), GRID);
    let middle = top - 4.0 * comparison.designs.len() as f32;
    scene.text((left - 9.0, middle + 4.0), Anchor::End, TEXT_SIZE, INK, "stable");
    // The names of a graph's lines would stand here.
    top - 14.0
}

/// Of a design between two speeds in m/s, against the speed in a unit.
fn curves(Compared { analysis, .. }: &Compared, x: (f64, f64), unit: &DisplayUnit) -> Result<Curves, Failure> {
    let turns = analysis.critical_speeds().iter().map(|critical| critical.speed).chain(analysis.meetings());
    let rows = analysis.rows(&samples(x, turns))?.shown_in(unit);
    let panels = panels(&rows, None);
    let is_one = matches!(rows, Rows::Modes(_));
    let is_imaginary = |panel: usize, series: &Series| {
        if is_one { matches!(series.paint, Paint::Stroke { dash: Some(_), .. }) } else { panel > 0 }
    };
    let of = |wanted: bool| -> Vec<Curve> {
        let all =
            panels.iter().enumerate().flat_map(|(index, panel)| panel.series.iter().map(move |series| (index, series)));
        let wanted = all.filter(|(index, series)| is_imaginary(*index, series) == wanted);
        wanted.flat_map(|(_, series)| series.curves.iter().cloned()).collect()
    };
    let real_limits = panels.first().map_or((-1.0, 1.0), |panel| panel.y);
    let imaginary_limit = panels.last().map_or(1.0, |panel| panel.y.1);
    // A model that does not depend on the speed has the same eigenvalues at each.
    let spread = |curves: Vec<Curve>| -> Vec<Curve> {
        if analysis.design.model.depends_on_speed() {
            return curves;
        }
        curves
            .into_iter()
            .filter_map(|curve| {
                curve.first().map(|(_, value)| vec![(unit.value(x.0), *value), (unit.value(x.1), *value)])
            })
            .collect()
    };
    let [real, imaginary] = [false, true].map(|wanted| once(spread(of(wanted))));
    Ok(Curves { real, imaginary, real_limits, imaginary_limit })
}

/// The curves without what others before them have as well, as the real parts of a pair: dashes would fill the gaps of others.
fn once(curves: Vec<Curve>) -> Vec<Curve> {
    let mut all: Vec<Curve> = Vec::new();
    for curve in curves {
        let mut own = Vec::new();
        for piece in curve.windows(2) {
            let is_drawn = all.iter().any(|other| other.windows(2).any(|drawn| drawn == piece));
            if is_drawn {
                extend(&mut own, None);
            } else {
                if own.last().is_none_or(Vec::is_empty) {
                    extend(&mut own, Some(piece[0]));
                }
                extend(&mut own, Some(piece[1]));
            }
        }
        all.extend(own.into_iter().filter(|curve| !curve.is_empty()));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::once;

    /// Two real parts meet, go on as those of a pair, and part.
    #[test]
    fn what_two_curves_share_is_drawn_once() {
        let one = vec![(0.0, 1.0), (1.0, 2.0), (2.0, 2.5), (3.0, 3.0), (4.0, 3.0)];
        let other = vec![(0.0, 4.0), (1.0, 2.0), (2.0, 2.5), (3.0, 3.0), (4.0, 5.0)];
        let ends = [vec![(0.0, 4.0), (1.0, 2.0)], vec![(3.0, 3.0), (4.0, 5.0)]];
        assert_eq!(once(vec![one.clone(), other]), [vec![one], ends.to_vec()].concat());
    }
}
