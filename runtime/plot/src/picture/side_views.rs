//! Several bicycles from their right sides, to one scale and laid over each other.

use carvallo_design::units::Units;

use super::axes::INK;
use super::colors::{design, design_line};
use super::font;
use super::labels::{LINE, Labels};
use super::marks::arc;
use super::scene::{Anchor, Color, Paint, Scene, dashed, line};
use super::side_view::{Geometry, Scale, WIDTH, angle_in, scale};
use crate::analysis::compare::{Compared, Comparison};

const TEXT_SIZE: f32 = 15.0;
/// The height of a line of the legend.
const ROW: f32 = 22.0;
/// Where its texts begin.
const LEGEND_LEFT: f32 = 60.0;

/// The side views; `None` if one of the models has not the parameters of a bicycle.
pub fn draw_side_views(comparison: &Comparison, units: &Units) -> Option<Scene> {
    let of = |compared: &Compared| Geometry::of(&compared.analysis.design);
    let geometries = comparison.designs.iter().map(of).collect::<Option<Vec<_>>>()?;
    let (scale, height) = scale(&geometries);
    let labels: Vec<&str> = comparison.designs.iter().map(|compared| compared.label.as_str()).collect();
    let title = format!("{}: side views to one scale", labels.join(", "));
    let title = if font::width(&title, 18.0) < WIDTH - 20.0 {
        title
    } else {
        format!("{} side views to one scale", labels.len())
    };
    let legend = ROW * labels.len() as f32;
    // Dimensions, for which there is room below, are in the legend.
    let ground = scale.place((0.0, 0.0)).1;
    let below = height.min(ground + 34.0);
    let mut scene = Scene::new(title.clone(), WIDTH, below + legend + 8.0);
    scene.heading((WIDTH / 2.0, 32.0), INK, &title);
    scene.polyline(&[(24.0, ground), (WIDTH - 24.0, ground)], line(1.5), INK);
    let mut labels_taken = Labels::new([4.0, 40.0, WIDTH - 4.0, ground]);
    let masses = geometries.iter().flat_map(|geometry| geometry.bodies.iter().map(|(_, mass, _)| *mass));
    let most = masses.fold(0.0, f64::max);
    for (index, geometry) in geometries.iter().enumerate() {
        draw(geometry, &scale.of(geometry), index, &mut scene, &mut labels_taken);
    }
    // Over the lines of all.
    for (index, geometry) in geometries.iter().enumerate() {
        draw_masses(geometry, &scale.of(geometry), most, design(index), &mut scene, &mut labels_taken);
    }
    let (of_length, of_angle) = (units.of("m"), units.for_people("rad"));
    // About a millimetre.
    let decimals = (3.0 - of_length.value(1.0).log10().floor()).max(0.0) as usize;
    let dimensions = geometries.iter().map(|Geometry { wheel_base, trail, tilt, .. }| {
        let [wheel_base, trail] = [wheel_base, trail].map(|&length| {
            format!("{:.decimals$}{}", of_length.value(length), of_length.behind_number()).replace('-', "−")
        });
        format!(": wheel base {wheel_base}, trail {trail}, tilt {}", angle_in(&of_angle, *tilt))
    });
    let dimensions: Vec<String> = dimensions.collect();
    let longest = dimensions.iter().map(|text| font::width(text, TEXT_SIZE)).fold(0.0, f32::max);
    let short = font::apart(&labels, TEXT_SIZE, WIDTH - LEGEND_LEFT - 12.0 - longest);
    for (index, (names, dimensions)) in short.iter().zip(&labels).zip(&dimensions).enumerate() {
        let [short, text] = [names.0.as_str(), names.1].map(|name| format!("{name}{dimensions}"));
        let (color, base) = (design(index), below + ROW * index as f32);
        scene.polyline(&[(24.0, base - 5.0), (52.0, base - 5.0)], design_line(index, 3.0), color);
        scene.short_text((LEGEND_LEFT, base), TEXT_SIZE, color, [&short, &text]);
    }
    Some(scene)
}

/// Wheels, a hint of the frame, and the steer axis.
fn draw(geometry: &Geometry, scale: &Scale, index: usize, scene: &mut Scene, labels: &mut Labels) {
    let color = design(index);
    let [rear, front] = geometry.radii;
    let hubs = [(0.0, rear), (geometry.wheel_base, front)];
    let end = geometry.fork_end();
    let [rear_hub, front_hub] = hubs.map(|hub| scale.place(hub));
    let [end, head] = [end, end + 1.3 * front].map(|distance| scale.place(geometry.steer_axis(distance)));
    scene.polyline(&[rear_hub, head, end, front_hub], line(5.0), color.lighter(0.75));
    for (radius, hub) in geometry.radii.into_iter().zip(hubs) {
        let (center, pixels) = (scale.place(hub), (radius * scale.factor) as f32);
        scene.circle(center, pixels, design_line(index, 2.5), color);
        labels.avoid_line(&arc(center, pixels, 0.0, std::f32::consts::TAU), LINE);
    }
    let axis = [0.0, geometry.axis_length()].map(|distance| scale.place(geometry.steer_axis(distance)));
    scene.polyline(&axis, dashed(1.6, [12.0, 4.0]), color);
    labels.avoid_line(&axis, LINE);
}

/// Centres of mass, with areas as the masses, of which the largest of all is given; those of the wheels are their hubs.
fn draw_masses(geometry: &Geometry, scale: &Scale, most: f64, color: Color, scene: &mut Scene, labels: &mut Labels) {
    for (index, (name, mass, position)) in geometry.bodies.iter().enumerate() {
        let share = if most > 0.0 { (mass / most).sqrt() as f32 } else { 0.0 };
        let ((x, y), radius) = (scale.place(*position), 3.0 + 8.0 * share);
        scene.circle((x, y), radius, Paint::Fill, color);
        labels.avoid_box([x - radius, y - radius, x + radius, y + radius]);
        let place = labels.beside(&[(x, y), (x + 1.0, y)], name, TEXT_SIZE).filter(|_| index > 1);
        if let Some(place) = place {
            scene.text(place, Anchor::Start, TEXT_SIZE, color, name);
        }
    }
}
