//! Eigenvectors as phasors: of each mode a dial, on which the coordinates are arrows with their sizes and phases.

use carvallo::{Complex, CoordinateInfo, ModeValue, States};
use carvallo_design::Shape;
use carvallo_design::number::{fixed, shortest};

use super::axes::INK;
use super::colors::{design, design_line};
use super::scene::{Anchor, Color, Paint, Scene, line};
use crate::analysis::{Analysis, Rows};

/// The most speeds that a picture has room for.
pub const MOST_SPEEDS: usize = 12;

const MARGIN: f32 = 36.0;
const CELL: f32 = 232.0;
const RADIUS: f32 = 84.0;
/// Dials side by side.
const ABREAST: usize = 4;
/// Room for the title, for a speed, and for what stands above a dial.
const TITLE: f32 = 52.0;
const SPEED: f32 = 34.0;
const NAMES: f32 = 62.0;
const LEGEND: f32 = 19.0;
const GRID: Color = Color(0xd8, 0xdc, 0xe0);
/// Half the angle of the head of an arrow, and its length.
const HEAD: (f32, f32) = (0.32, 13.0);
/// A component below this part of the largest has no direction that rounding leaves.
const NOTHING: f64 = 1e-12;

/// A dial for each mode at each speed, of pairs for the half with a positive imaginary part: each coordinate an arrow from the
/// middle, as long as its size relative to the largest, at the angle by which it leads that one, counterclockwise from the right.
pub fn draw_phasors(analysis: &Analysis, rows: &Rows, shapes: &[Vec<Shape>]) -> Scene {
    let coordinates = analysis.design.info().coordinates;
    let at_speeds: Vec<(f64, Vec<(&ModeValue, &Shape)>)> =
        rows.values().into_iter().zip(shapes).map(|((speed, values), shapes)| (speed, shown(values, shapes))).collect();
    let abreast = at_speeds.iter().map(|(_, modes)| modes.len()).max().unwrap_or(1).clamp(2, ABREAST);
    let width = 2.0 * MARGIN + CELL * abreast as f32;
    let moves = analysis.design.model.depends_on_speed();
    let speed_text = |speed: f64| format!("{} {}", shortest(analysis.unit.value(speed)), analysis.unit.written);
    let at = match &at_speeds[..] {
        [(speed, _)] if moves => format!(" at {}", speed_text(*speed)),
        _ => String::new(),
    };
    let mut scene = Scene::new(format!("Eigenvectors of {}{at}", analysis.design.title()), width, 0.0);
    scene.heading((width / 2.0, 32.0), INK, &scene.title.clone());
    let height = NAMES + 2.0 * RADIUS + 44.0 + LEGEND * coordinates.len() as f32;
    let mut top = TITLE;
    for (speed, modes) in &at_speeds {
        if at_speeds.len() > 1 {
            scene.polyline(&[(MARGIN, top), (width - MARGIN, top)], line(1.0), GRID);
            scene.text((MARGIN, top + 24.0), Anchor::Start, 16.0, INK, &speed_text(*speed));
            top += SPEED;
        }
        for line_of in modes.chunks(abreast) {
            let indent = (width - CELL * line_of.len() as f32) / 2.0;
            for (index, (value, shape)) in line_of.iter().enumerate() {
                let x = indent + CELL * (index as f32 + 0.5);
                draw_dial((x, top), value, shape, coordinates, &mut scene);
            }
            top += height;
        }
    }
    scene.height = top + 8.0;
    scene
}

/// The modes that dials are for.
fn shown<'a>(values: &'a [ModeValue], shapes: &'a [Shape]) -> Vec<(&'a ModeValue, &'a Shape)> {
    values.iter().zip(shapes).filter(|(value, _)| value.value.im >= 0.0).collect()
}

fn draw_dial(
    (x, top): (f32, f32),
    ModeValue { mode, value }: &ModeValue,
    shape: &Shape,
    coordinates: &[CoordinateInfo],
    scene: &mut Scene,
) {
    let minus = |text: String| text.replace('-', "\u{2212}");
    let real = fixed(value.re, 4);
    let value = if value.im == 0.0 { real } else { format!("({real} ± {} i)", fixed(value.im, 4)) };
    scene.text((x, top + 16.0), Anchor::Middle, 15.0, INK, &mode.to_string());
    scene.text((x, top + 35.0), Anchor::Middle, 13.0, INK, &minus(format!("{value} 1/s")));
    let center = (x, top + NAMES + RADIUS);
    draw_grid(center, scene);
    let mut arrows: Vec<(usize, Complex<f64>)> = shape.right.iter().copied().enumerate().collect();
    // Short ones lie on long ones, which may have the same direction.
    arrows.sort_by(|a, b| b.1.norm().total_cmp(&a.1.norm()));
    for (index, component) in arrows {
        draw_arrow(center, component, index, scene);
    }
    let base = center.1 + RADIUS + 40.0;
    for (index, (coordinate, component)) in coordinates.iter().zip(&shape.right).enumerate() {
        let y = base + LEGEND * index as f32;
        let left = x - RADIUS;
        scene.polyline(&[(left, y - 5.0), (left + 22.0, y - 5.0)], design_line(index, 3.0), design(index));
        let rate = if coordinate.states == States::Rate { "\u{2019}" } else { "" };
        let text = format!("{}{rate}  {}", coordinate.name, minus(phasor(*component)));
        scene.text((left + 30.0, y), Anchor::Start, 14.0, INK, &text);
    }
}

/// The circles of the sizes 1 and a half, and a ray every 30 degrees.
fn draw_grid((x, y): (f32, f32), scene: &mut Scene) {
    for part in [0.5, 1.0] {
        scene.circle((x, y), part * RADIUS, line(1.0), GRID);
    }
    for ray in 0..12 {
        let (sin, cos) = (30.0 * f32::from(ray as u8)).to_radians().sin_cos();
        scene.polyline(&[(x, y), (x + RADIUS * cos, y - RADIUS * sin)], line(0.7), GRID);
    }
    let faint = INK.lighter(0.4);
    for (text, anchor, (dx, dy)) in [
        ("0°", Anchor::Start, (6.0, 4.0)),
        ("90°", Anchor::Middle, (0.0, -6.0)),
        ("180°", Anchor::End, (-6.0, 4.0)),
        ("\u{2212}90°", Anchor::Middle, (0.0, 15.0)),
    ] {
        let (sx, sy) = (f32::signum(dx) * f32::from(u8::from(dx != 0.0)), f32::signum(dy));
        let place = if dx == 0.0 { (x, y + sy * RADIUS + dy) } else { (x + sx * RADIUS + dx, y + dy) };
        scene.text(place, anchor, 11.0, faint, text);
    }
}

/// An arrow on a dial, with a bright edge that parts it from what lies below.
fn draw_arrow((x, y): (f32, f32), component: Complex<f64>, index: usize, scene: &mut Scene) {
    let size = component.norm();
    if size <= NOTHING {
        return;
    }
    let (length, angle) = (RADIUS * size as f32, component.arg() as f32);
    let (sin, cos) = angle.sin_cos();
    let along = |distance: f32| (x + distance * cos, y - distance * sin);
    let head = HEAD.1.min(length);
    let shaft = [(x, y), along(length - 0.8 * head)];
    let corner = |side: f32| {
        let (sin, cos) = (angle + std::f32::consts::PI - side * HEAD.0).sin_cos();
        let (tip_x, tip_y) = along(length);
        (tip_x + head * cos, tip_y - head * sin)
    };
    let head = [along(length), corner(1.0), corner(-1.0), along(length)];
    let edge = Color(0xff, 0xff, 0xff);
    scene.polyline(&shaft, line(5.4), edge);
    scene.polyline(&head, line(2.4), edge);
    scene.polyline(&shaft, design_line(index, 3.0), design(index));
    scene.polyline(&head, Paint::Fill, design(index));
}

/// The size and the phase of a component, as in tables.
fn phasor(component: Complex<f64>) -> String {
    let size = component.norm();
    if size <= NOTHING {
        "0".to_owned()
    } else if component.im == 0.0 && component.re > 0.0 {
        fixed(size, 4)
    } else {
        format!("{} at {:.0}°", fixed(size, 4), component.arg().to_degrees() + 0.0)
    }
}
