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

#[cfg(test)]
mod tests {
    use tiny_skia::Pixmap;

    use crate::picture::scene::{Color, Paint, Scene};

    #[test]
    fn two_pixels_are_as_long_as_one() {
        let mut scene = Scene::new(String::new(), 10.5, 8.0);
        scene.rectangle([2.0, 3.0, 4.0, 6.0], Paint::Fill, Color(10, 20, 30));
        let picture = Pixmap::decode_png(&scene.png().unwrap()).unwrap();
        assert_eq!((picture.width(), picture.height()), (21, 16));
        let color = |x, y| {
            let pixel = picture.pixel(x, y).unwrap();
            (pixel.red(), pixel.green(), pixel.blue(), pixel.alpha())
        };
        for (x, y) in [(4, 6), (7, 11)] {
            assert_eq!(color(x, y), (10, 20, 30, 255), "{x}, {y}");
        }
        for (x, y) in [(3, 6), (8, 11), (4, 5), (7, 12), (20, 15)] {
            assert_eq!(color(x, y), (255, 255, 255, 255), "{x}, {y}");
        }
    }

    #[test]
    fn what_has_no_room_in_memory_is_told() {
        let error = Scene::new(String::new(), 1e9, 1e9).png().unwrap_err();
        assert_eq!(error, "the picture is too large");
    }
}
