//! The frame of a graph: where data go on the page, ticks and their labels.

use super::font;
use super::scene::{Anchor, Color, Scene, line};

pub const INK: Color = Color(0x22, 0x22, 0x22);
const GRID: Color = Color(0xe4, 0xe4, 0xe4);
const TEXT_SIZE: f32 = 13.0;

/// A range of data on each axis, and the rectangle of the page that shows it.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    pub x: (f64, f64),
    pub y: (f64, f64),
    /// Left, top, right, bottom.
    pub area: [f32; 4],
}

impl Axes {
    /// Where a point of the data goes on the page.
    pub fn place(&self, x: f64, y: f64) -> (f32, f32) {
        let [left, top, right, bottom] = self.area;
        let share = |value: f64, (low, high): (f64, f64)| ((value - low) / (high - low)) as f32;
        (left + share(x, self.x) * (right - left), bottom + share(y, self.y) * (top - bottom))
    }

    /// The grid, to be drawn under the data.
    pub fn grid(&self, scene: &mut Scene) {
        let [left, top, right, bottom] = self.area;
        for x in ticks(self.x) {
            let (x, _) = self.place(x, self.y.0);
            scene.polyline(&[(x, top), (x, bottom)], line(1.0), GRID);
        }
        for y in ticks(self.y) {
            let (_, y) = self.place(self.x.0, y);
            scene.polyline(&[(left, y), (right, y)], line(1.0), GRID);
        }
    }

    /// The frame with its labels, to be drawn over the data.
    pub fn frame(&self, scene: &mut Scene, x_label: &str, y_label: &str) {
        let [left, top, right, bottom] = self.area;
        if self.y.0 < 0.0 && self.y.1 > 0.0 {
            let (_, zero) = self.place(self.x.0, 0.0);
            scene.polyline(&[(left, zero), (right, zero)], line(1.2), INK);
        }
        scene.rectangle(self.area, line(1.2), INK);
        for tick in ticks(self.x) {
            let (x, _) = self.place(tick, self.y.0);
            scene.polyline(&[(x, bottom), (x, bottom + 5.0)], line(1.2), INK);
            let text = label(tick, self.x);
            // The last label may be wider than the margin.
            let x = x.min(scene.width - 4.0 - font::width(&text, TEXT_SIZE) / 2.0);
            scene.text((x, bottom + 20.0), Anchor::Middle, TEXT_SIZE, INK, &text);
        }
        for tick in ticks(self.y) {
            let (_, y) = self.place(self.x.0, tick);
            scene.polyline(&[(left - 5.0, y), (left, y)], line(1.2), INK);
            scene.text((left - 9.0, y + 4.5), Anchor::End, TEXT_SIZE, INK, &label(tick, self.y));
        }
        scene.text(((left + right) / 2.0, bottom + 43.0), Anchor::Middle, 15.0, INK, x_label);
        scene.upward_text((left - title_distance(self.y), (top + bottom) / 2.0), 15.0, INK, y_label);
    }
}

/// How far left of the frame the title of a vertical axis stands, clear of the labels of its ticks.
fn title_distance(range: (f64, f64)) -> f32 {
    let widths = ticks(range).map(|tick| font::width(&label(tick, range), TEXT_SIZE));
    widths.fold(44.0, |distance, width| distance.max(width + 19.0))
}

/// The room that a vertical axis needs left of the frame.
pub fn margin(range: (f64, f64)) -> f32 {
    title_distance(range) + 32.0
}

/// The ticks of a range, each with what stands at it.
pub fn labels(range: (f64, f64)) -> impl Iterator<Item = (f64, String)> {
    ticks(range).map(move |tick| (tick, label(tick, range)))
}

/// What stands at a tick.
pub fn label(value: f64, range: (f64, f64)) -> String {
    tick_text(value, step(range)).replace('-', "−")
}

/// The step of about eight ticks: 1, 2 or 5 times a power of ten.
fn step((low, high): (f64, f64)) -> f64 {
    let rough = (high - low) / 8.0;
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
pub fn ticks(range: (f64, f64)) -> impl Iterator<Item = f64> {
    let step = step(range);
    let first = (range.0 / step - 1e-9).ceil();
    let last = (range.1 / step + 1e-9).floor();
    // Adding zero turns -0 into 0.
    (0..=(last - first) as u32).map(move |index| (first + f64::from(index)) * step + 0.0)
}

fn tick_text(value: f64, step: f64) -> String {
    if value != 0.0 && !(1e-5..1e6).contains(&step) {
        let digits = value.abs().log10().floor() - (step.log10() + 1e-9).floor();
        return format!("{value:.*e}", digits.clamp(1.0, 15.0) as usize);
    }
    // The tolerance guards against the logarithm of an exact power falling short.
    let decimals = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::{step, tick_text, ticks};

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(ticks((0.0, 10.0)).collect::<Vec<_>>(), (0..=10).map(f64::from).collect::<Vec<_>>());
        assert_eq!(ticks((-10.0, 10.0)).count(), 11);
        assert_eq!(tick_text(2.0, step((0.0, 10.0))), "2");
        assert_eq!(tick_text(0.3, step((0.0, 1.0))), "0.3");
        assert_eq!(tick_text(2e9, step((0.0, 1e10))), "2.0e9");
        assert_eq!(tick_text(9.12e9, step((9.1e9, 9.2e9))), "9.12e9");
        assert_eq!(ticks((0.3, 1.2)).count(), 10);
    }
}
