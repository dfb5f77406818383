//! Marks of technical drawings.

use super::axes::INK;
use super::scene::{Color, Paint, Scene, line};

pub const DIMENSION: Color = Color(0x60, 0x60, 0x60);

/// A line with a head at each end, where it is long enough for heads.
pub fn draw_arrow(scene: &mut Scene, from: (f32, f32), to: (f32, f32)) {
    scene.polyline(&[from, to], line(1.2), DIMENSION);
    let direction = (to.0 - from.0).signum();
    if (to.0 - from.0).abs() > 16.0 {
        for ((x, y), inward) in [(from, direction), (to, -direction)] {
            let head = [(x, y), (x + 7.0 * inward, y - 3.0), (x + 7.0 * inward, y + 3.0)];
            scene.polyline(&head, Paint::Fill, DIMENSION);
        }
    }
}

/// The usual mark: a disc of which two opposite quarters are filled.
pub fn draw_center_of_mass((x, y): (f32, f32), scene: &mut Scene) {
    let radius = 7.0;
    scene.circle((x, y), radius, Paint::Fill, Color(0xff, 0xff, 0xff));
    for start in [0.0, std::f32::consts::PI] {
        let mut quarter = arc((x, y), radius, start, std::f32::consts::FRAC_PI_2);
        quarter.push((x, y));
        scene.polyline(&quarter, Paint::Fill, INK);
    }
    scene.circle((x, y), radius, line(1.5), INK);
}

/// Points along an arc; angles turn clockwise on the page, from the right.
pub fn arc((x, y): (f32, f32), radius: f32, start: f32, turn: f32) -> Vec<(f32, f32)> {
    const STEPS: u8 = 72;
    let angle = |index: u8| start + turn * f32::from(index) / f32::from(STEPS);
    (0..=STEPS).map(|index| (x + radius * angle(index).cos(), y + radius * angle(index).sin())).collect()
}
