//! A bicycle from its right side, to scale: wheels, steer axis, trail, and centres of mass.

use carvallo_design::number::shortest;
use carvallo_design::units::Units;
use carvallo_design::{Design, DisplayUnit, body};

use super::axes::INK;
use super::font;
use super::labels::{LINE, Labels};
use super::marks::{DIMENSION, arc, draw_arrow, draw_center_of_mass};
use super::scene::{Anchor, Color, Scene, dashed, line};

pub(super) const WIDTH: f32 = 960.0;
const MAX_HEIGHT: f32 = 700.0;
const MARGIN: f32 = 56.0;
/// Room for the title above, and for the dimensions below the ground.
const ABOVE: f32 = 64.0;
const BELOW: f32 = 104.0;
/// Room for what is not drawn.
const NOTE: f32 = 14.0;
const TEXT_SIZE: f32 = 15.0;
const FRAME: Color = Color(0xc8, 0xcd, 0xd2);
const STEER: Color = Color(0x1f, 0x6f, 0xb4);
const HIP: Color = Color(0x2e, 0x7d, 0x32);

/// What is drawn, in metres; heights are above the ground.
pub(super) struct Geometry {
    pub wheel_base: f64,
    pub trail: f64,
    pub tilt: f64,
    pub radii: [f64; 2],
    /// 1 where the parameters count lengths forward, -1 where they count them backward.
    pub forward: f64,
    /// Name, mass and position of each body; the steered frame is the fourth.
    pub bodies: Vec<(String, f64, (f64, f64))>,
    /// The height of an axis along which an upper body leans, and where that is.
    pub hip: Option<(f64, f64)>,
}

/// Parameters that have no place in the view, but of inertias and gravity.
pub type LeftOut = Vec<&'static str>;

/// What is drawn, beside the upper body.
const DRAWN: [&str; 13] = ["w", "c", "lam", "rR", "mR", "rF", "mF", "xB", "zB", "mB", "xH", "zH", "mH"];
/// The upper body: its position and mass, and its axis.
const UPPER_BODY: [&str; 4] = ["xU", "zU", "mU", "zP"];

impl Geometry {
    pub fn of(design: &Design) -> Option<Self> {
        let value = |name| design.value(name);
        let (wheel_base, rear, front) = (value("w")?, value("rR")?, value("rF")?);
        // The parameters of such a model are those of the bicycle that it is when it runs backwards.
        let is_reversed = body(design.info(), "R").starts_with("front");
        // There the letters of the wheels alone would mislead.
        let wheel = |letter: &str| if is_reversed { body(design.info(), letter) } else { letter.to_owned() };
        let mut bodies = vec![
            (wheel("R"), value("mR")?, (0.0, rear)),
            (wheel("F"), value("mF")?, (wheel_base, front)),
            ("B".to_owned(), value("mB")?, (value("xB")?, -value("zB")?)),
            ("H".to_owned(), value("mH")?, (value("xH")?, -value("zH")?)),
        ];
        let upper = UPPER_BODY.map(value);
        let mut hip = None;
        if let [Some(x), Some(z), Some(mass), Some(axis)] = upper {
            bodies.push(("U".to_owned(), mass, (x, -z)));
            hip = Some((-axis, x));
        }
        Some(Self {
            wheel_base,
            trail: value("c")?,
            tilt: value("lam")?,
            radii: [rear, front],
            forward: if is_reversed { -1.0 } else { 1.0 },
            bodies,
            hip,
        })
    }

    /// What the model has beside it, in the order of its parameters.
    fn left_out(&self, design: &Design) -> LeftOut {
        let names = design.info().parameters.iter().map(|parameter| parameter.name);
        let is_drawn = |name: &str| DRAWN.contains(&name) || self.hip.is_some() && UPPER_BODY.contains(&name);
        names.filter(|name| !is_drawn(name) && !name.starts_with('I') && *name != "g").collect()
    }

    /// The point of the steer axis at a distance upwards from where it meets the ground.
    pub fn steer_axis(&self, distance: f64) -> (f64, f64) {
        let (sin, cos) = self.tilt.sin_cos();
        (self.wheel_base + self.trail - distance * sin, distance * cos)
    }

    /// Points that the page must have room for, as they lie on it: forward to the right, or to the left.
    fn extremes(&self) -> Vec<(f64, f64)> {
        let [rear, front] = self.radii;
        let ends = [self.steer_axis(0.0), self.steer_axis(self.axis_length())];
        let hip = self.hip.into_iter();
        let hip = hip.flat_map(|(height, x)| [-0.2, 0.2].map(|share| (x + share * self.wheel_base, height)));
        let vertical = (self.steer_axis(0.0).0, self.vertical_length());
        let corners = [(-rear, 0.0), (self.wheel_base + front, 2.0 * front), (0.0, 2.0 * rear), vertical];
        let centers = self.bodies.iter().map(|(_, _, position)| *position);
        let all = ends.into_iter().chain(centers).chain(hip).chain(corners);
        all.map(|(x, height)| (self.forward * x, height)).collect()
    }

    /// How far the axis is drawn: past the front frame, unless it lies almost flat. Wheels that stand one within the other
    /// are longer than the wheel base.
    pub fn axis_length(&self) -> f64 {
        let (_, _, (_, height)) = self.bodies[3];
        let height = height.max(2.4 * self.radii[1]) + 0.15 * self.wheel_base;
        (height / self.tilt.cos()).min(2.0 * self.wheel_base.max(2.0 * self.radii[1]))
    }

    /// How far the vertical is drawn that the tilt is measured from: about as high as the axis, or the front wheel.
    fn vertical_length(&self) -> f64 {
        let length = self.axis_length();
        (length * self.tilt.cos()).max(2.4 * self.radii[1]).min(length)
    }

    /// The point of the steer axis nearest to the front hub, as a distance along the axis.
    pub fn fork_end(&self) -> f64 {
        let (sin, cos) = self.tilt.sin_cos();
        self.trail * sin + self.radii[1] * cos
    }
}

/// From metres to the page, the same for both axes.
#[derive(Clone, Copy)]
pub(super) struct Scale {
    forward: f64,
    left: f64,
    bottom: f64,
    pub factor: f64,
    ground: f32,
    indent: f32,
}

impl Scale {
    /// The same for another bicycle, which may count lengths in the other direction.
    pub fn of(self, geometry: &Geometry) -> Self {
        Self { forward: geometry.forward, ..self }
    }

    pub fn place(&self, (x, height): (f64, f64)) -> (f32, f32) {
        let pixels = |length: f64| (length * self.factor) as f32;
        (self.indent + pixels(self.forward * x - self.left), self.ground - pixels(height - self.bottom))
    }
}

/// The side view, with what it leaves out; `None` for a model that has not the parameters of a bicycle.
pub fn draw_side_view(design: &Design, units: &Units) -> Option<(Scene, LeftOut)> {
    let geometry = Geometry::of(design)?;
    let (scale, height) = scale(std::slice::from_ref(&geometry));
    let left_out = geometry.left_out(design);
    let direction = if geometry.forward < 0.0 { ", forward to the right" } else { "" };
    let mut scene = Scene::new(format!("{}: side view to scale{direction}", design.name), WIDTH, height + NOTE);
    scene.heading((WIDTH / 2.0, 32.0), INK, &scene.title.clone());
    let mut labels = Labels::new([4.0, 40.0, WIDTH - 4.0, height - 4.0]);

    let ground = scale.place((0.0, 0.0)).1;
    scene.polyline(&[(24.0, ground), (WIDTH - 24.0, ground)], line(1.5), INK);
    labels.avoid_line(&[(24.0, ground), (WIDTH - 24.0, ground)], LINE);
    draw_frame(&geometry, &scale, &mut scene, &mut labels);
    for (radius, hub) in geometry.radii.into_iter().zip([0.0, geometry.wheel_base]) {
        let (center, pixels) = (scale.place((hub, radius)), (radius * scale.factor) as f32);
        scene.circle(center, pixels, line(3.0), INK);
        labels.avoid_line(&arc(center, pixels, 0.0, std::f32::consts::TAU), LINE);
    }
    draw_dimensions(&geometry, &units.of("m"), &scale, &mut scene, &mut labels);
    for (_, _, position) in &geometry.bodies {
        let (x, y) = scale.place(*position);
        draw_center_of_mass((x, y), &mut scene);
        labels.avoid_box([x - 7.0, y - 7.0, x + 7.0, y + 7.0]);
    }
    draw_steer_axis(&geometry, &units.for_people("rad"), &scale, &mut scene, &mut labels);
    draw_hip(&geometry, &scale, &mut scene, &mut labels);
    let of_mass = units.of("kg");
    for (name, mass, position) in &geometry.bodies {
        let (x, y) = scale.place(*position);
        let text = format!("{name}  {}", written(*mass, &of_mass));
        if let Some(place) = labels.beside(&[(x, y), (x + 1.0, y)], &text, TEXT_SIZE) {
            scene.text(place, Anchor::Start, TEXT_SIZE, INK, &text);
        }
    }
    let others = left_out.iter().map(|name| format!(", {name}")).collect::<String>();
    let note = format!("Not drawn: moments and products of inertia{others}");
    scene.text((24.0, height + 2.0), Anchor::Start, 13.0, DIMENSION, &note);
    Some((scene, left_out))
}

/// The axis along which the upper body leans, below or above its centre of mass.
fn draw_hip(geometry: &Geometry, scale: &Scale, scene: &mut Scene, labels: &mut Labels) {
    let Some((height, x)) = geometry.hip else { return };
    let half = 0.2 * geometry.wheel_base;
    let ends = [scale.place((x - half, height)), scale.place((x + half, height))];
    scene.polyline(&ends, dashed(2.0, [12.0, 4.0]), HIP);
    labels.avoid_line(&ends, LINE);
    if let Some(place) = labels.beside(&ends, "hip axis", TEXT_SIZE) {
        scene.text(place, Anchor::Start, TEXT_SIZE, HIP, "hip axis");
    }
}

/// Everything that is drawn of one or several fits on the page; with the height that it needs.
pub(super) fn scale(geometries: &[Geometry]) -> (Scale, f32) {
    let points = || geometries.iter().flat_map(Geometry::extremes);
    let least = |by: fn((f64, f64)) -> f64| points().map(by).fold(0.0, f64::min);
    let most = |by: fn((f64, f64)) -> f64| points().map(by).fold(0.0, f64::max);
    let (left, right, bottom, top) = (least(|p| p.0), most(|p| p.0), least(|p| p.1), most(|p| p.1));
    let across = f64::from(WIDTH - 2.0 * MARGIN) / (right - left);
    let upright = f64::from(MAX_HEIGHT - ABOVE - BELOW) / (top - bottom);
    let factor = across.min(upright);
    let ground = ABOVE + ((top - bottom) * factor) as f32;
    let indent = (WIDTH - ((right - left) * factor) as f32) / 2.0;
    let forward = geometries.first().map_or(1.0, |geometry| geometry.forward);
    (Scale { forward, left, bottom, factor, ground, indent }, ground + BELOW)
}

/// A hint of the frame: the model knows only its mass and inertia. The offset of the fork is true.
fn draw_frame(geometry: &Geometry, scale: &Scale, scene: &mut Scene, labels: &mut Labels) {
    let [rear, front] = geometry.radii;
    let end = geometry.fork_end();
    let head = end + 1.3 * front;
    let [rear_hub, front_hub] = [(0.0, rear), (geometry.wheel_base, front)].map(|hub| scale.place(hub));
    let [end, head] = [end, head].map(|distance| scale.place(geometry.steer_axis(distance)));
    let bars = [rear_hub, head, end, front_hub];
    scene.polyline(&bars, line(7.0), FRAME);
    labels.avoid_line(&bars, LINE);
}

fn draw_steer_axis(geometry: &Geometry, unit: &DisplayUnit, scale: &Scale, scene: &mut Scene, labels: &mut Labels) {
    let length = geometry.axis_length();
    let foot = geometry.steer_axis(0.0);
    let ends = [scale.place(foot), scale.place(geometry.steer_axis(length))];
    let upright = geometry.vertical_length();
    let vertical = [scale.place(foot), scale.place((foot.0, foot.1 + upright))];
    scene.polyline(&vertical, dashed(1.2, [3.0, 4.0]), DIMENSION);
    scene.polyline(&ends, dashed(2.0, [12.0, 4.0]), STEER);
    labels.avoid_line(&ends, LINE);
    labels.avoid_line(&vertical, LINE);

    let upwards = -std::f32::consts::FRAC_PI_2;
    let angle =
        arc(ends[0], (0.93 * upright * scale.factor) as f32, upwards, (-geometry.forward * geometry.tilt) as f32);
    scene.polyline(&angle, line(1.2), DIMENSION);
    labels.avoid_line(&angle, LINE);
    let text = format!("λ = {}", angle_in(unit, geometry.tilt));
    if let Some(place) = labels.beside(&angle, &text, TEXT_SIZE) {
        scene.text(place, Anchor::Start, TEXT_SIZE, INK, &text);
    }
    // Its upper end is the freer one.
    let upper = [scale.place(geometry.steer_axis(0.8 * length)), ends[1]];
    if let Some(place) = labels.beside(&upper, "steer axis", TEXT_SIZE) {
        scene.text(place, Anchor::Start, TEXT_SIZE, STEER, "steer axis");
    }
}

/// Wheel base and trail, each on a line of its own below the ground.
fn draw_dimensions(geometry: &Geometry, unit: &DisplayUnit, scale: &Scale, scene: &mut Scene, labels: &mut Labels) {
    let ground = scale.place((0.0, 0.0)).1;
    let x = |metres: f64| scale.place((metres, 0.0)).0;
    let (rear, front, foot) = (x(0.0), x(geometry.wheel_base), x(geometry.wheel_base + geometry.trail));
    for (x, depth) in [(rear, 42.0), (front, 78.0), (foot, 78.0)] {
        scene.polyline(&[(x, ground + 3.0), (x, ground + depth)], line(1.0), DIMENSION);
    }
    let (row, middle) = (ground + 36.0, (rear + front) / 2.0);
    draw_arrow(scene, (rear, row), (front, row));
    let text = format!("wheel base w = {}", written(geometry.wheel_base, unit));
    if font::width(&text, TEXT_SIZE) < (front - rear).abs() {
        scene.text((middle, row - 6.0), Anchor::Middle, TEXT_SIZE, INK, &text);
    } else {
        scene.text((rear.min(front) - 10.0, row + 5.0), Anchor::End, TEXT_SIZE, INK, &text);
    }
    let row = ground + 72.0;
    draw_arrow(scene, (front, row), (foot, row));
    let text = format!("trail c = {}", written(geometry.trail, unit));
    scene.text((front.min(foot) - 10.0, row + 5.0), Anchor::End, TEXT_SIZE, INK, &text);
    labels.avoid_box([rear.min(front).min(foot), ground, rear.max(front).max(foot), ground + BELOW]);
}

/// In a unit, with at most three decimals, without zeros at the end.
fn written(value: f64, unit: &DisplayUnit) -> String {
    let value = unit.value(value);
    let number = match value.abs() {
        1e-3..1e7 => shortest((1000.0 * value).round() / 1000.0),
        _ => shortest(value),
    };
    format!("{number}{}", unit.behind_number()).replace('-', "−")
}

/// An angle with two decimals of a degree, or four of a radian.
pub(super) fn angle_in(unit: &DisplayUnit, angle: f64) -> String {
    let decimals = if unit.is_declared() { 4 } else { 2 };
    format!("{:.decimals$}{}", unit.value(angle), unit.behind_number()).replace('-', "−")
}
