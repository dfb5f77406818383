//! A drawing as PNG.

use tiny_skia::{FillRule, Paint as Brush, Pixmap, Stroke, StrokeDash, Transform};

use super::scene::{Color, Item, Paint, Scene};

/// Pixels of the picture per pixel of the drawing, for sharp text on today's screens.
const SCALE: f32 = 2.0;

impl Scene {
    /// The drawing as PNG, with two pixels for each of its own.
    ///
    /// # Errors
    /// If the picture is too large for memory, or cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, String> {
        write(self)
    }
}

fn write(scene: &Scene) -> Result<Vec<u8>, String> {
    let size = |length: f32| (SCALE * length).ceil() as u32;
    let mut pixmap = Pixmap::new(size(scene.width), size(scene.height)).ok_or("the picture is too large")?;
    pixmap.fill(tiny_skia::Color::WHITE);
    let transform = Transform::from_scale(SCALE, SCALE);
    for Item { path, paint, color: Color(red, green, blue), .. } in &scene.items {
        let mut brush = Brush::default();
        brush.set_color_rgba8(*red, *green, *blue, 255);
        match *paint {
            Paint::Fill => pixmap.fill_path(path, &brush, FillRule::Winding, transform, None),
            Paint::Stroke { width, dash } => {
                let dash = dash.and_then(|dash| StrokeDash::new(dash.to_vec(), 0.0));
                let stroke = Stroke { width, dash, line_join: tiny_skia::LineJoin::Round, ..Stroke::default() };
                pixmap.stroke_path(path, &brush, &stroke, transform, None);
            }
        }
    }
    pixmap.encode_png().map_err(|error| error.to_string())
}
