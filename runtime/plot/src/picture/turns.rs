//! Steady turns against their speed: what is in balance, and the radius.

use carvallo_design::units::Units;

use super::axes::{self, EVEN, INK};
use super::curves::Curve;
use super::graph::{Graph, Line, range, roomy};
use super::motion::COLORS;
use super::panels::finely;
use super::scene::{Color, Paint, Scene, dashed, line};
use crate::analysis::turns::{Families, Family, verdict};
use carvallo::turns::Turn;

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 56.0;
const HEIGHT: f32 = 320.0;
const FLAT: f32 = 220.0;
const UNSTABLE: Paint = dashed(2.0, [7.0, 5.0]);
/// The radius goes to infinity where a curve begins: it is shown up to so many times the median.
const LARGEST: f64 = 4.0;

/// The curves of a design; angles in degrees where no unit is asked for.
pub fn draw_turns(families: &Families, units: &Units) -> Scene {
    let (speed, angle, length) = (units.of("m/s"), units.for_people("rad"), units.of("m"));
    let drawn = drawn(families);
    let turns = || drawn.iter().flat_map(|family| &family.turns);
    let x = from_zero(range(turns().map(|turn| speed.value(turn.speed)).chain([0.0])));
    let angles = families.positions.iter().filter(|(_, told)| told.unit == "rad");
    let mut lines = Vec::new();
    for ((place, told), color) in angles.zip(COLORS) {
        let point = |turn: &Turn| (speed.value(turn.speed), angle.value(turn.positions[*place]));
        add(
            &mut lines,
            &drawn,
            &format!("{} {}", told.label, told.name).replace("pitch pitch", "pitch"),
            color,
            &point,
        );
    }
    let y = roomy(range(lines.iter().flat_map(|line: &Line| line.curve.iter().map(|point| point.1))));
    let note = Some((UNSTABLE, INK.lighter(0.35), "unstable"));
    let positions = Graph {
        title: format!("angles{}", angle.behind_name()).into(),
        height: HEIGHT,
        x,
        y,
        scales: EVEN,
        lines,
        note,
    };
    let mut lines = Vec::new();
    let mut radii: Vec<f64> =
        turns().map(|turn| length.value(turn.radius)).filter(|radius| radius.is_finite()).collect();
    radii.sort_by(f64::total_cmp);
    let most = radii.get(radii.len() / 2).map_or(1.0, |median| finely(LARGEST * median));
    let goes_on = radii.iter().any(|radius| *radius > most);
    let beyond = if goes_on {
        format!(", up to {most}{}: it goes on to straight running", length.behind_number())
    } else {
        String::new()
    };
    add(&mut lines, &drawn, &format!("radius{beyond}"), INK, &|turn| {
        (speed.value(turn.speed), length.value(turn.radius))
    });
    let radius = Graph {
        title: format!("radius{}", length.behind_name()).into(),
        height: FLAT,
        x,
        y: (0.0, most),
        scales: EVEN,
        lines,
        note: None,
    };

    let across = format!("speed v of the rear wheel{}", speed.behind_name());
    let title = format!("Steady turns of {}", families.design.title());
    let left = axes::margin(positions.y).max(axes::margin(radius.y));
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 32.0), INK, &title);
    let top = positions.draw(None, [left, RIGHT], TOP, &mut scene);
    scene.height = radius.draw(Some(&across), [left, RIGHT], top, &mut scene);
    scene
}

/// A range with room, of which none is below zero where no value is.
fn from_zero((low, high): (f64, f64)) -> (f64, f64) {
    let (below, above) = roomy((low, high));
    (if low < 0.0 { below } else { 0.0 }, above)
}

/// The curves that begin at capsize speeds; the others, which lean and steer much farther, where there is none of these.
fn drawn<'a>(families: &'a Families) -> Vec<&'a Family> {
    let from_capsize: Vec<&Family> = families.families.iter().filter(|family| family.capsize.is_some()).collect();
    if from_capsize.is_empty() { families.families.iter().collect() } else { from_capsize }
}

/// Points of all turns, of the speed with a value: one line for each stretch that is stable, or is not; before them the name, solid if one of them is.
fn add(lines: &mut Vec<Line>, families: &[&Family], name: &str, color: Color, point: &dyn Fn(&Turn) -> (f64, f64)) {
    let is_stable = |turn: &Turn| verdict(turn) == "stable";
    let has_stable = families.iter().any(|family| family.turns.iter().any(is_stable));
    let paint = if has_stable { line(2.4) } else { UNSTABLE };
    lines.push(Line { name: Some(name.to_owned()), color, paint, curve: Curve::new() });
    for family in families {
        for pair in family.turns.windows(2) {
            let points = pair.iter().map(point).filter(|point| point.1.is_finite());
            let paint = if pair.iter().all(is_stable) { line(2.4) } else { UNSTABLE };
            match lines.last_mut() {
                Some(last)
                    if last.paint == paint && last.name.is_none() && last.color == color && !last.curve.is_empty() =>
                {
                    last.curve.extend(points.skip(1));
                }
                _ => lines.push(Line { name: None, color, paint, curve: points.collect() }),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::from_zero;

    /// There are no speeds below zero, unless something runs backwards.
    #[test]
    fn speeds_begin_at_zero() {
        assert_eq!(from_zero((0.0, 6.0)).0, 0.0);
        assert_eq!(from_zero((0.0, 0.0)), (0.0, 1.0));
        assert!(from_zero((0.0, 6.0)).1 > 6.0 && from_zero((-1.0, 6.0)).0 < -1.0);
    }
}
