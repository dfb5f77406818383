//! Where labels go: beside their lines, and clear of everything else.

use super::font;
use super::places::Places;

/// Weights of what a label should avoid; a pixel of distance from its line weighs 1.
const OFF_MIDDLE: f32 = 0.03;
const ON_LABEL: f32 = 5000.0;
const OUTSIDE: f32 = 1e6;
const GAP: f32 = 2.0;
/// What weighs more than this would not be read; the colour of the line has to do.
const UNREADABLE: f32 = 400.0;
/// What a point of a line weighs: lines of the data, and thin lines that a label may cross at need.
pub const LINE: f32 = 60.0;
pub const THIN: f32 = 16.0;

/// What is on the page already.
#[derive(Debug)]
pub struct Labels {
    /// Left, top, right, bottom.
    area: [f32; 4],
    boxes: Vec<[f32; 4]>,
    /// Points of lines, with what they weigh.
    points: Places,
}

impl Labels {
    pub fn new(area: [f32; 4]) -> Self {
        Self { area, boxes: Vec::new(), points: Places::new(area) }
    }

    /// Keeps labels off a line.
    pub fn avoid_line(&mut self, points: &[(f32, f32)], weight: f32) {
        dense(points).for_each(|point| self.points.add(point, weight));
    }

    /// Keeps labels off a text or another box: left, top, right, bottom.
    pub fn avoid_box(&mut self, bounds: [f32; 4]) {
        self.boxes.push(bounds);
    }

    /// The left end of the baseline of a label for the line, and takes the place, if there is room.
    pub fn beside(&mut self, line: &[(f32, f32)], text: &str, size: f32) -> Option<(f32, f32)> {
        let width = font::width(text, size);
        // The height of capitals and of ascenders and descenders, roughly, for any Latin font.
        let (ascent, descent) = (0.76 * size, 0.22 * size);
        let middle = line.get(line.len() / 2).map_or(0.0, |&(x, _)| x);
        let mut best: Option<(f32, [f32; 4])> = None;
        for (x, y) in dense(line).step_by(3) {
            for gap in [5.0, 9.0, 14.0, 20.0, 28.0] {
                for left in [x - width / 2.0, x + gap, x - gap - width] {
                    for base in [y - gap - descent, y + gap + ascent] {
                        let bounds = [left, base - ascent, left + width, base + descent];
                        let least = best.map_or(f32::INFINITY, |(least, _)| least);
                        let away = GAP * gap + OFF_MIDDLE * (x - middle).abs();
                        // Nothing weighs less than nothing.
                        if away < least {
                            let cost = away + self.cost(bounds);
                            if cost < least {
                                best = Some((cost, bounds));
                            }
                        }
                    }
                }
            }
        }
        let (_, bounds) = best.filter(|&(cost, _)| cost < UNREADABLE)?;
        self.boxes.push(bounds);
        Some((bounds[0], bounds[3] - descent))
    }

    /// The middle of a box of a width and height, and takes the place: inside an area, low in its middle if nothing is in
    /// the way there.
    pub fn inside(&mut self, [left, top, right, bottom]: [f32; 4], (width, height): (f32, f32)) -> (f32, f32) {
        const STEP: f32 = 4.0;
        let (middle, lowest) = ((left + right) / 2.0, bottom - height / 2.0);
        let bounds = |(x, y): (f32, f32)| [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0];
        let (across, up) = (((right - left - width) / (2.0 * STEP)) as i32, ((bottom - top - height) / STEP) as i32);
        let places = (0..=up).flat_map(|row| (-across..=across).map(move |column| (column, row)));
        let places = places.map(|(column, row)| (middle + column as f32 * STEP, lowest - row as f32 * STEP));
        let mut best = (f32::INFINITY, (middle, lowest));
        for (x, y) in places {
            let away = OFF_MIDDLE * ((x - middle).abs() + (lowest - y));
            if away < best.0 {
                let cost = self.cost(bounds((x, y))) + away;
                if cost < best.0 {
                    best = (cost, (x, y));
                }
            }
        }
        let (_, best) = best;
        self.boxes.push(bounds(best));
        best
    }

    /// Whether no line of the data is behind a box.
    pub fn is_clear(&self, [left, top, right, bottom]: [f32; 4]) -> bool {
        let is_behind =
            |(x, y): (f32, f32), weight| weight >= LINE && (left..right).contains(&x) && (top..bottom).contains(&y);
        !self.points.near([left, top, right, bottom]).any(|(point, weight)| is_behind(point, weight))
    }

    /// The top and bottom of every box that an upright line meets, from above.
    pub fn crossed_at(&self, x: f32) -> Vec<(f32, f32)> {
        let boxes = self.boxes.iter().filter(|[left, _, right, _]| (*left..=*right).contains(&x));
        let mut crossed: Vec<(f32, f32)> = boxes.map(|&[_, top, _, bottom]| (top, bottom)).collect();
        crossed.sort_by(|a, b| a.0.total_cmp(&b.0));
        crossed
    }

    fn cost(&self, bounds: [f32; 4]) -> f32 {
        let [left, top, right, bottom] = self.area;
        let inside =
            bounds[0] > left + 3.0 && bounds[1] > top + 2.0 && bounds[2] < right - 3.0 && bounds[3] < bottom - 2.0;
        let boxes = self.boxes.iter().filter(|taken| overlap(**taken, bounds)).count();
        let [from, above, to, below] = [bounds[0] - 3.0, bounds[1] - 3.0, bounds[2] + 3.0, bounds[3] + 3.0];
        let is_near = |(x, y): (f32, f32)| x > from && x < to && y > above && y < below;
        let points = self.points.near([from, above, to, below]);
        let lines: f32 = points.map(|(point, weight)| if is_near(point) { weight } else { 0.0 }).sum();
        let outside = if inside { 0.0 } else { OUTSIDE };
        outside + ON_LABEL * boxes as f32 + lines
    }
}

fn overlap(a: [f32; 4], b: [f32; 4]) -> bool {
    let margin = 4.0;
    a[0] < b[2] + margin && b[0] < a[2] + margin && a[1] < b[3] + margin && b[1] < a[3] + margin
}

/// Points along a line, at most four pixels apart.
fn dense(line: &[(f32, f32)]) -> impl Iterator<Item = (f32, f32)> {
    line.windows(2).flat_map(|pair| {
        let [(x, y), (to_x, to_y)] = [pair[0], pair[1]];
        let steps = ((to_x - x).hypot(to_y - y) / 4.0).ceil().max(1.0) as u16;
        (0..steps).map(move |index| {
            let share = f32::from(index) / f32::from(steps);
            (x + share * (to_x - x), y + share * (to_y - y))
        })
    })
}
