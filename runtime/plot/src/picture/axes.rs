//! The frame of a graph: where data go on the page, ticks and their labels.

use super::font;
use super::scene::{Anchor, Color, Scene, line};

pub const INK: Color = Color(0x22, 0x22, 0x22);
const GRID: Color = Color(0xe4, 0xe4, 0xe4);
const TEXT_SIZE: f32 = 13.0;
/// The ticks of an axis, about, if there is room.
const MOST: u32 = 8;
/// The least distance between labels.
const APART: f32 = 12.0;

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// At round numbers.
    Even,
    /// At powers of ten, and between them; the data are logarithms.
    #[cfg(feature = "control")]
    Decades,
    /// At parts of a full turn, in degrees.
    #[cfg(feature = "control")]
    Turns,
}

/// Round numbers on both axes.
pub const EVEN: [Scale; 2] = [Scale::Even; 2];

/// A range of data on each axis, from left to right and from below, and the rectangle of the page that shows it. What grows
/// downward has the larger end below.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    pub x: (f64, f64),
    pub y: (f64, f64),
    /// Left, top, right, bottom.
    pub area: [f32; 4],
    /// Of both axes.
    pub scales: [Scale; 2],
}

impl Axes {
    /// With round numbers on both axes.
    pub fn even(x: (f64, f64), y: (f64, f64), area: [f32; 4]) -> Self {
        Self { x, y, area, scales: EVEN }
    }

    /// The ticks of the horizontal axis, each with what stands at it.
    fn across(&self) -> Vec<(f64, String)> {
        match self.scales[0] {
            Scale::Even => across(self.x, self.area[2] - self.area[0]),
            #[cfg(feature = "control")]
            scale => super::scales::ticks(scale, self.x),
        }
    }

    /// The ticks of the vertical axis, likewise.
    fn upward(&self) -> Vec<(f64, String)> {
        match self.scales[1] {
            Scale::Even => upward(self.y),
            #[cfg(feature = "control")]
            // Upward there is less room.
            scale => super::scales::ticks(scale, self.y).into_iter().filter(|(_, text)| !text.is_empty()).collect(),
        }
    }

    /// Where a point of the data goes on the page.
    pub fn place(&self, x: f64, y: f64) -> (f32, f32) {
        let [left, top, right, bottom] = self.area;
        let share = |value: f64, (low, high): (f64, f64)| ((value - low) / (high - low)) as f32;
        (left + share(x, self.x) * (right - left), bottom + share(y, self.y) * (top - bottom))
    }

    /// The grid, to be drawn under the data.
    pub fn draw_grid(&self, scene: &mut Scene) {
        let [left, top, right, bottom] = self.area;
        for (x, _) in self.across() {
            let (x, _) = self.place(x, self.y.0);
            scene.polyline(&[(x, top), (x, bottom)], line(1.0), GRID);
        }
        for (y, _) in self.upward() {
            let (_, y) = self.place(self.x.0, y);
            scene.polyline(&[(left, y), (right, y)], line(1.0), GRID);
        }
    }

    /// The frame with its labels, to be drawn over the data. Without a label for the horizontal axis another graph goes on
    /// below, which has it.
    pub fn draw_frame(&self, scene: &mut Scene, x_label: Option<&str>, y_label: &str) {
        let [left, top, right, bottom] = self.area;
        if self.y.0 < 0.0 && self.y.1 > 0.0 {
            let (_, zero) = self.place(self.x.0, 0.0);
            scene.polyline(&[(left, zero), (right, zero)], line(1.2), INK);
        }
        scene.rectangle(self.area, line(1.2), INK);
        for (tick, text) in self.across() {
            let (x, _) = self.place(tick, self.y.0);
            scene.polyline(&[(x, bottom), (x, bottom + 5.0)], line(1.2), INK);
            if x_label.is_none() {
                continue;
            }
            // The last label may be wider than the margin.
            let x = x.min(scene.width - 4.0 - font::width(&text, TEXT_SIZE) / 2.0);
            scene.text((x, bottom + 20.0), Anchor::Middle, TEXT_SIZE, INK, &text);
        }
        for (tick, text) in self.upward() {
            let (_, y) = self.place(self.x.0, tick);
            scene.polyline(&[(left - 5.0, y), (left, y)], line(1.2), INK);
            scene.text((left - 9.0, y + 4.5), Anchor::End, TEXT_SIZE, INK, &text);
        }
        if let Some(x_label) = x_label {
            scene.text(((left + right) / 2.0, bottom + 43.0), Anchor::Middle, 15.0, INK, x_label);
        }
        scene.upward_text((left - title_distance(self.y), (top + bottom) / 2.0), 15.0, INK, y_label);
    }
}

/// How far left of the frame the title of a vertical axis stands, clear of the labels of its ticks.
fn title_distance(range: (f64, f64)) -> f32 {
    (width(&upward(range)) + 19.0).max(44.0)
}

/// The room that a vertical axis needs left of the frame.
pub fn margin(range: (f64, f64)) -> f32 {
    title_distance(range) + 32.0
}

/// The width of the widest label.
pub fn width(labels: &[(f64, String)]) -> f32 {
    labels.iter().map(|(_, text)| font::width(text, TEXT_SIZE)).fold(0.0, f32::max)
}

/// The ticks of a vertical axis, each with what stands at it.
pub fn upward(range: (f64, f64)) -> Vec<(f64, String)> {
    labels(range, MOST)
}

/// The ticks of a horizontal axis that is so long, each with what stands at it: fewer where the labels are wide.
pub fn across(range: (f64, f64), length: f32) -> Vec<(f64, String)> {
    let most = (2..=MOST).rev().find(|&most| {
        let room = (step(range, most) / (range.1 - range.0)) as f32 * length;
        width(&labels(range, most)) + APART <= room
    });
    labels(range, most.unwrap_or(2))
}

fn labels(range: (f64, f64), most: u32) -> Vec<(f64, String)> {
    let (step, ticks) = (step(range, most), ticks(range, most));
    let largest = ticks.clone().map(f64::abs).fold(0.0, f64::max);
    ticks.map(|tick| (tick, tick_text(tick, step, largest).replace('-', "−"))).collect()
}

/// The step of about so many ticks: 1, 2 or 5 times a power of ten.
fn step((low, high): (f64, f64), most: u32) -> f64 {
    // No finer than doubles are.
    let rough = ((high - low).abs() / f64::from(most)).max(2.0 * f64::EPSILON * low.abs().max(high.abs()));
    let power = 10_f64.powf(rough.log10().floor());
    let factor = rough / power;
    power
        * if factor < 1.5 {
            1.0
        } else if factor < 3.5 {
            2.0
        } else if factor < 7.5 {
            5.0
        } else {
            10.0
        }
}

/// Round numbers in a range.
fn ticks(range: (f64, f64), most: u32) -> impl Iterator<Item = f64> + Clone {
    let step = step(range, most);
    let first = (range.0.min(range.1) / step - 1e-9).ceil();
    let last = (range.0.max(range.1) / step + 1e-9).floor();
    // Adding zero turns -0 into 0.
    (0..(last - first + 1.0) as u32).map(move |index| (first + f64::from(index)) * step + 0.0)
}

/// What stands at a tick: as many digits as tell it from its neighbours, with an exponent where zeros would pile up.
fn tick_text(value: f64, step: f64, largest: f64) -> String {
    // The tolerance guards against the logarithm of an exact power falling short.
    let power = (step.log10() + 1e-9).floor();
    if value != 0.0 && !(1e-4..1e7).contains(&largest) {
        let digits = value.abs().log10().floor() - power;
        return format!("{value:.*e}", digits.clamp(1.0, 16.0) as usize);
    }
    let decimals = (-power).max(0.0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::{across, upward};

    fn texts(range: (f64, f64)) -> Vec<String> {
        upward(range).into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        let values: Vec<f64> = upward((0.0, 10.0)).into_iter().map(|(value, _)| value).collect();
        assert_eq!(values, (0..=10).map(f64::from).collect::<Vec<_>>());
        assert_eq!(texts((0.0, 10.0))[2], "2");
        assert_eq!(upward((-10.0, 10.0)).len(), 11);
        assert_eq!(texts((0.0, 1.0))[3], "0.3");
        assert_eq!(texts((0.0, 1e10))[2], "2.0e9");
        assert_eq!(texts((9.1e9, 9.2e9))[2], "9.12e9");
        assert_eq!(texts((1e-6, 2e-6))[..2], ["1.0e−6", "1.1e−6"]);
        assert_eq!(upward((0.3, 1.2)).len(), 10);
    }

    #[test]
    fn narrow_ranges_have_labels_that_differ() {
        for range in
            [(1.02, 1.020_000_1), (0.08, 0.080_001), (-1.0, -1.0 + 5e-15), (1e9, 1e9 + 1.0), (1e300, 1.001e300)]
        {
            let mut texts = texts(range);
            let count = texts.len();
            assert!(count > 1 && texts.iter().all(|text| !text.ends_with("e0")), "{range:?}: {texts:?}");
            texts.dedup();
            assert_eq!(texts.len(), count, "{range:?}: {texts:?}");
        }
    }

    #[test]
    fn wide_labels_have_fewer_ticks() {
        assert_eq!(across((0.0, 1.0), 400.0).len(), 11);
        let texts: Vec<String> = across((1.02, 1.020_000_1), 400.0).into_iter().map(|(_, text)| text).collect();
        assert_eq!(texts, ["1.02000000", "1.02000005", "1.02000010"]);
    }
}
