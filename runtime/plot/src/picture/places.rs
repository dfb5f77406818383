//! Points by where they are on the page, so that those near a label are found without a look at all of them.

/// The side of a cell in pixels, about the height of a label.
const SIDE: f32 = 20.0;

/// Points with what they weigh, in square cells. What lies outside of the area is in the cells at its edges.
#[derive(Debug)]
pub struct Places {
    left: f32,
    top: f32,
    columns: usize,
    rows: usize,
    cells: Vec<Vec<((f32, f32), f32)>>,
}

impl Places {
    /// None yet, in an area: left, top, right, bottom.
    pub fn new([left, top, right, bottom]: [f32; 4]) -> Self {
        let count = |length: f32| (length / SIDE) as usize + 1;
        let (columns, rows) = (count(right - left), count(bottom - top));
        Self { left, top, columns, rows, cells: vec![Vec::new(); columns * rows] }
    }

    pub fn add(&mut self, point: (f32, f32), weight: f32) {
        let (column, row) = self.cell(point);
        self.cells[row * self.columns + column].push((point, weight));
    }

    /// All points in a box, left, top, right, bottom, and some around it.
    pub fn near(&self, [left, top, right, bottom]: [f32; 4]) -> impl Iterator<Item = ((f32, f32), f32)> {
        let ((first, upper), (last, lower)) = (self.cell((left, top)), self.cell((right, bottom)));
        let rows = (upper..=lower).map(|row| row * self.columns);
        rows.flat_map(move |row| self.cells[row + first..=row + last].iter().flatten().copied())
    }

    fn cell(&self, (x, y): (f32, f32)) -> (usize, usize) {
        // Casting is to the nearest that there is, zero for what is less.
        let place = |distance: f32, count: usize| ((distance / SIDE) as usize).min(count - 1);
        (place(x - self.left, self.columns), place(y - self.top, self.rows))
    }
}

#[cfg(test)]
mod tests {
    use super::Places;

    /// Every point that is in a box is found by it, wherever both are.
    #[test]
    fn points_in_a_box_are_found() {
        let steps = || (-3..14).map(|step| 17.0 * step as f32);
        let mut places = Places::new([20.0, 10.0, 170.0, 105.0]);
        for (x, y) in steps().flat_map(|x| steps().map(move |y| (x, y))) {
            places.add((x, y), x);
        }
        for (left, top) in steps().flat_map(|x| steps().map(move |y| (x, y))) {
            let bounds = [left - 1.0, top - 1.0, left + 40.0, top + 25.0];
            let is_inside =
                |(x, y): (f32, f32)| (bounds[0]..=bounds[2]).contains(&x) && (bounds[1]..=bounds[3]).contains(&y);
            let expected = steps().flat_map(|x| steps().map(move |y| (x, y))).filter(|point| is_inside(*point)).count();
            let found = places.near(bounds).filter(|(point, weight)| is_inside(*point) && *weight == point.0).count();
            assert_eq!(found, expected, "{bounds:?}");
        }
    }
}
