//! The colours of a map: from values to shades, and the scale beside a panel that tells which are which.

use crate::picture::axes::{self, Axes, INK};
use crate::picture::scene::{Anchor, Color, Scene, line};

const TEXT: f32 = 13.0;
/// From the right of a panel to the labels of its scale.
const SCALE: [f32; 2] = [14.0, 32.0];
/// The least room right of a panel, for the scale and what stands above it.
const RIGHT: f32 = 80.0;

/// Dark for low values, light for high ones, of even steps in lightness and readable without colours (viridis, by van der
/// Walt & Smith).
const COLORS: [Color; 7] = [
    Color(0x44, 0x01, 0x54),
    Color(0x44, 0x39, 0x83),
    Color(0x31, 0x68, 0x8e),
    Color(0x21, 0x91, 0x8c),
    Color(0x35, 0xb7, 0x79),
    Color(0x90, 0xd7, 0x43),
    Color(0xfd, 0xe7, 0x25),
];
/// The steps of colour that are told apart.
const LEVELS: usize = 60;
pub const UNSTABLE: Color = Color(0xd9, 0xd9, 0xd9);
pub const ERROR: Color = Color(0xc0, 0x28, 0x3c);
pub const ENDLESS: Color = Color(0xf7, 0xc9, 0xe0);

/// How a cell is painted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shade {
    Level(usize),
    Endless,
    Unstable,
    Error,
}

impl Shade {
    pub fn color(self) -> Color {
        match self {
            Self::Level(level) => {
                let place = level as f32 / (LEVELS - 1) as f32 * (COLORS.len() - 1) as f32;
                let index = (place as usize).min(COLORS.len() - 2);
                let (Color(r, g, b), Color(red, green, blue)) = (COLORS[index], COLORS[index + 1]);
                let share = place - index as f32;
                let mix = |a: u8, b: u8| (f32::from(a) + share * (f32::from(b) - f32::from(a))).round() as u8;
                Color(mix(r, red), mix(g, green), mix(b, blue))
            }
            Self::Endless => ENDLESS,
            Self::Unstable => UNSTABLE,
            Self::Error => ERROR,
        }
    }
}

/// What differs by less, relatively, differs by rounding.
const ROUNDING: f64 = 1e-9;

/// From values to colours.
pub struct Scale {
    /// `None` where there are no values.
    range: Option<(f64, f64)>,
    /// Whether there are values above.
    is_cut: bool,
}

impl Scale {
    /// From the least value, none of which is below zero, to the largest one; but widths grow without bound next to ranges without end, and a few of them
    /// would leave no colours for the others.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let [Some(&low), Some(&most), Some(&last)] = [values.first(), values.get(values.len() * 9 / 10), values.last()]
        else {
            return Self { range: None, is_cut: false };
        };
        let is_cut = last > 2.0 * most && most > low;
        let high = if is_cut { most } else { last };
        if high - low > ROUNDING * high {
            return Self { range: Some((low, high)), is_cut };
        }
        // One value alone has a scale around it; speeds are not below zero.
        let range = if low > 0.0 { (0.5 * low, 1.5 * low) } else { (0.0, 1.0) };
        Self { range: Some(range), is_cut }
    }

    pub fn shade(&self, value: f64) -> Shade {
        let share = self.range.map_or(0.0, |(low, high)| (value - low) / (high - low));
        Shade::Level(((share * LEVELS as f64) as usize).min(LEVELS - 1))
    }

    /// What it takes right of a panel.
    pub fn room(&self) -> f32 {
        let labels = self.range.map_or(0.0, |range| axes::width(&axes::upward(range)));
        RIGHT.max(SCALE[1] + 9.0 + labels + 12.0)
    }

    /// The colours from bottom to top right of a panel, with their values.
    pub fn draw(&self, scene: &mut Scene, [_, top, right, bottom]: [f32; 4]) {
        let Some(range) = self.range else { return };
        let [left, right] = SCALE.map(|distance| right + distance);
        let step = (bottom - top) / LEVELS as f32;
        for level in 0..LEVELS {
            let bottom = bottom - step * level as f32;
            let rectangle = [left, (bottom - step - 0.4).max(top), right, bottom];
            scene.rectangles(&[rectangle], Shade::Level(level).color());
        }
        scene.rectangle([left, top, right, bottom], line(1.2), INK);
        if self.is_cut {
            scene.text((left, top - 7.0), Anchor::Start, TEXT, INK, "and more");
        }
        let axes = Axes::even((0.0, 1.0), range, [left, top, right, bottom]);
        for (value, text) in axes::upward(range) {
            let (_, y) = axes.place(0.0, value);
            scene.polyline(&[(right, y), (right + 5.0, y)], line(1.2), INK);
            scene.text((right + 9.0, y + 4.5), Anchor::Start, TEXT, INK, &text);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Scale;

    /// Of a value that is everywhere the same, but for rounding, the scale is around it and not below zero.
    #[test]
    fn one_value_is_within_its_scale() {
        for (values, expected) in [
            (vec![0.0; 4], (0.0, 1.0)),
            (vec![0.2; 4], (0.1, 0.3)),
            (vec![4.0, 4.0 + 4e-15, 4.0], (2.0, 6.0)),
            (vec![4.0, 4.5, 5.0], (4.0, 5.0)),
        ] {
            let found = Scale::of(values.into_iter()).range.unwrap();
            assert!((found.0 - expected.0).abs() < 1e-12 && (found.1 - expected.1).abs() < 1e-12, "{found:?}");
        }
    }
}
