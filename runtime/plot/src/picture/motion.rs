//! A motion against time: positions by their units, the speed, and below them the paths of wheels.

use carvallo_design::number::shortest;
use carvallo_design::units::Units;

use super::axes::{self, EVEN, INK};
use super::curves::{Curve, quantile};
use super::graph::{Graph, Line, range, roomy};
use super::path::Paths;
use super::scene::{Color, Paint, Scene, dashed, line};
use crate::analysis::simulation::Motion;

const WIDTH: f32 = 960.0;
const RIGHT: f32 = WIDTH - 28.0;
const TOP: f32 = 56.0;
const HEIGHT: f32 = 220.0;
const FLAT: f32 = 160.0;
/// Curves of a linear motion beside a nonlinear one are lighter, and dashed.
pub const BESIDE: Paint = dashed(1.8, [7.0, 5.0]);
pub const LIGHTER: f32 = 0.35;
pub const COLORS: [Color; 6] = [
    Color(0x1f, 0x6f, 0xb4),
    Color(0xc0, 0x28, 0x3c),
    Color(0x2e, 0x7d, 0x32),
    Color(0xb4, 0x6a, 0x00),
    Color(0x7a, 0x3f, 0x9d),
    Color(0x55, 0x5d, 0x66),
];

/// Forces that are somewhere so many times as large as most of the time are shown so many times as large at most.
const FAR: f64 = 300.0;
const BEYOND: f64 = 10.0;

/// What one graph shows: its title, and the curves with their names, each with that of the linear motion.
struct Shown {
    title: String,
    height: f32,
    curves: Vec<(String, Curve, Curve)>,
    /// Whether they are forces, and not what these do.
    has_forces: bool,
}

/// A motion, and the linear one of the same state where it is not that itself; angles in degrees where no unit is asked for.
pub fn draw_motion(motion: &Motion, linear: Option<&Motion>, units: &Units) -> Scene {
    let end = motion.rows.last().map_or(1.0, |row| row.t);
    let mut drawn: Vec<Graph> = graphs(motion, linear, units).into_iter().map(|shown| graph(shown, end)).collect();
    if let (Some(first), Some(_)) = (drawn.first_mut(), linear) {
        first.note = Some((BESIDE, INK.lighter(LIGHTER), "the same by the linear equations"));
    }
    let title = format!("Motion of {}", motion.design.title());
    let paths = Paths::new(motion, linear, units);
    let left = drawn.iter().map(|graph| axes::margin(graph.y)).fold(paths.margin(RIGHT), f32::max);
    let mut scene = Scene::new(title.clone(), WIDTH, 0.0);
    scene.heading(((left + RIGHT) / 2.0, 32.0), INK, &title);
    let mut top = TOP;
    for (index, graph) in drawn.iter().enumerate() {
        let is_last = index + 1 == drawn.len();
        top = graph.draw(is_last.then_some("time t (s)"), [left, RIGHT], top, &mut scene);
    }
    scene.height = paths.draw([left, RIGHT], top, &mut scene) + 12.0;
    scene
}

/// Of a bicycle lean and steer, the forces of feedback, and the speed; of anything else all positions, those of one unit in one
/// graph, and the forces.
fn graphs(motion: &Motion, linear: Option<&Motion>, units: &Units) -> Vec<Shown> {
    let is_bicycle = motion.position("thetaR").is_some();
    let mut graphs: Vec<Shown> = Vec::new();
    let shown = motion.quantities.iter().filter(|quantity| !is_bicycle || ["phi", "delta"].contains(&quantity.name));
    for quantity in shown {
        let unit = units.for_people(quantity.unit);
        let what = if quantity.unit == "rad" { "angles" } else { "positions" };
        let title = format!("{what}{}", unit.behind_name());
        let curve = |motion: &Motion| -> Curve {
            let Some(place) = motion.position(quantity.name) else { return Curve::new() };
            motion.rows.iter().map(|row| (row.t, unit.value(row.positions[place]))).collect()
        };
        let name = match quantity.label == quantity.name {
            true => quantity.name.to_owned(),
            false => format!("{} {}", quantity.label, quantity.name),
        };
        add(&mut graphs, (title, false), HEIGHT, (name, curve(motion), linear.map(curve).unwrap_or_default()));
    }
    for (place, (name, declared)) in motion.feedback().into_iter().enumerate() {
        let unit = units.of(declared);
        let what = if declared == "N*m" { "torques" } else { "forces" };
        let title = format!("{what}{}", unit.behind_name());
        let curve = |motion: &Motion| -> Curve {
            motion.rows.iter().map(|row| (row.t, unit.value(row.feedback[place]))).collect()
        };
        add(&mut graphs, (title, true), FLAT, (name, curve(motion), linear.map(curve).unwrap_or_default()));
    }
    if is_bicycle {
        let unit = units.of("m/s");
        let speed = |motion: &Motion| -> Curve {
            motion.rows.iter().filter_map(|row| Some((row.t, unit.value(motion.speed(row)?)))).collect()
        };
        let curves = ("forward speed".to_owned(), speed(motion), linear.map(speed).unwrap_or_default());
        let title = format!("v{}", unit.behind_name());
        graphs.push(Shown { title, height: FLAT, curves: vec![curves], has_forces: false });
    }
    graphs
}

/// Adds curves to the graph of their title.
fn add(graphs: &mut Vec<Shown>, (title, has_forces): (String, bool), height: f32, curves: (String, Curve, Curve)) {
    match graphs.iter_mut().find(|shown| shown.title == title) {
        Some(shown) => shown.curves.push(curves),
        None => graphs.push(Shown { title, height, curves: vec![curves], has_forces }),
    }
}

fn graph(Shown { title, height, mut curves, has_forces }: Shown, end: f64) -> Graph {
    let y = if has_forces { extent_of_forces(&curves) } else { extent(&curves) };
    for (name, curve, _) in &mut curves {
        if let Some((_, last)) = curve.last().filter(|(_, last)| *last < y.0 || *last > y.1) {
            *name += &format!(", which goes on to {}", shown(*last));
        }
    }
    let color = |index: usize| if curves.len() == 1 { INK } else { COLORS[index % COLORS.len()] };
    let lines = curves.iter().enumerate();
    let beside = lines.clone().map(|(index, (_, _, linear))| Line {
        name: None,
        color: color(index).lighter(LIGHTER),
        paint: BESIDE,
        curve: linear.clone(),
    });
    let own = lines.map(|(index, (name, curve, _))| Line {
        name: Some(name.clone()),
        color: color(index),
        paint: line(2.2),
        curve: curve.clone(),
    });
    Graph {
        title: title.into(),
        height,
        x: (0.0, end),
        y,
        scales: EVEN,
        lines: beside.chain(own).collect(),
        note: None,
    }
}

/// Three digits of a large number.
fn shown(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    shortest(rounded).replace('-', "−")
}

/// What the vertical axis shows: all of the motion itself, and of a linear one beside it no more than it takes to see how that
/// leaves.
fn extent(curves: &[(String, Curve, Curve)]) -> (f64, f64) {
    let (low, high) = range(curves.iter().flat_map(|(_, curve, _)| curve).map(|point| point.1));
    let (linear_low, linear_high) = range(curves.iter().flat_map(|(_, _, curve)| curve).map(|point| point.1));
    let room = (high - low).max(1e-6);
    roomy((low.min(linear_low.max(low - 0.5 * room)), high.max(linear_high.min(high + 0.5 * room))))
}

/// The same of forces, which a law may let grow beyond all bounds where the motion ends, so that nothing would be seen of what was before.
fn extent_of_forces(curves: &[(String, Curve, Curve)]) -> (f64, f64) {
    let all = extent(curves);
    let sizes = curves.iter().flat_map(|(_, curve, _)| curve).map(|point| point.1.abs()).collect();
    match quantile(sizes, 7) {
        Some(usual) if usual > 0.0 && all.1.max(-all.0) > FAR * usual => {
            (all.0.max(-BEYOND * usual), all.1.min(BEYOND * usual))
        }
        _ => all,
    }
}
