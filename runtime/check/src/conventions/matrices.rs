//! Whole matrices in another form: signs and order of coordinates, transposed, halves, factors of units.

use carvallo::{MatrixName, ModelInfo};

use super::{Assignment, Convention, Effect};
use carvallo_slips::index;

/// All of them, for matrices with these entries.
pub fn matrices(info: &ModelInfo, entries: &[f64], gravity: f64) -> Vec<Convention> {
    let build = Build { info, count: info.coordinates.len(), entries };
    let mut found = build.signs();
    found.extend(build.orders());
    found.extend(build.halves());
    found.extend(build.factors(gravity));
    found.extend(build.masses());
    found
}

/// Those of all matrices that C or K at a speed is the sum of, where they are several: transposed, or of the other sign.
pub fn sums(info: &ModelInfo, entries: &[f64]) -> Vec<Convention> {
    let build = Build { info, count: info.coordinates.len(), entries };
    let damping = [MatrixName::Cm1, MatrixName::C0, MatrixName::C1];
    let stiffness = [MatrixName::Kc, MatrixName::K0, MatrixName::K1, MatrixName::K2];
    let mut found = Vec::new();
    for group in [&damping[..], &stiffness] {
        let own: Vec<MatrixName> = info.matrices.iter().copied().filter(|own| group.contains(own)).collect();
        if own.len() > 1 {
            let names: Vec<&str> = own.iter().map(|own| own.name()).collect();
            let names = names.join(" and ");
            let negative = build.all(&own, |place| (place, -1.0));
            found.push(Convention::of_entries(format!("{names} have the other sign"), negative));
            let transposed = build.all(&own, |(row, column)| ((column, row), 1.0));
            let what = format!("{names} were filled row by column: they are transposed");
            found.extend((!transposed.is_empty()).then(|| Convention::of_entries(what, transposed)));
        }
    }
    found
}

struct Build<'a> {
    info: &'a ModelInfo,
    count: usize,
    entries: &'a [f64],
}

impl Build<'_> {
    fn places(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let count = self.count;
        (0..count * count).map(move |at| (at / count, at % count))
    }

    fn at(&self, matrix: MatrixName, (row, column): (usize, usize)) -> usize {
        index(matrix, row, column, self.count)
    }

    /// Every entry of the model's matrices from another place of the same matrix, times a factor.
    fn all(&self, matrices: &[MatrixName], from: impl Fn((usize, usize)) -> ((usize, usize), f64)) -> Vec<Assignment> {
        let assign = |matrix: MatrixName, place: (usize, usize)| {
            let (other, factor) = from(place);
            Assignment::times(self.at(matrix, place), self.at(matrix, other), factor)
        };
        let of = |&matrix: &MatrixName| self.places().map(move |place| (matrix, place));
        let all = matrices.iter().flat_map(of).map(|(matrix, place)| assign(matrix, place));
        all.filter(|own| own.to != own.from || own.factor != 1.0).collect()
    }

    fn label(&self, coordinate: usize) -> &'static str {
        self.info.coordinates[coordinate].label
    }

    /// Coordinates and equations that are positive the other way.
    fn signs(&self) -> Vec<Convention> {
        let all = self.info.matrices;
        let sign = |is: bool| if is { -1.0 } else { 1.0 };
        let mut found = Vec::new();
        // With two coordinates both are the same: only the product of the signs counts.
        let flipped = if self.count == 2 { 1 } else { self.count };
        for own in 0..if self.count == 1 { 0 } else { flipped } {
            let label = match self.count {
                2 => format!("{} or {}", self.label(0), self.label(1)),
                _ => self.label(own).to_owned(),
            };
            let flip = self.all(all, |(row, column)| ((row, column), sign((row == own) != (column == own))));
            found.push(Convention::of_entries(format!("{label} is positive the other way"), flip));
        }
        for own in 0..self.count {
            let label = self.label(own);
            let column = self.all(all, |place| (place, sign(place.1 == own)));
            let what = format!("{label} is positive the other way, but not its equation");
            found.push(Convention::of_entries(what, column));
            let row = self.all(all, |place| (place, sign(place.0 == own)));
            found.push(Convention::of_entries(format!("the equation of {label} has the other sign"), row));
        }
        found
    }

    /// Coordinates and equations in another order, and transposed matrices.
    fn orders(&self) -> Vec<Convention> {
        let all = self.info.matrices;
        let mut found = Vec::new();
        let pairs = (0..self.count).flat_map(|first| (first + 1..self.count).map(move |second| (first, second)));
        for (first, second) in pairs {
            let other = |at: usize| match at {
                at if at == first => second,
                at if at == second => first,
                at => at,
            };
            let names = format!("{} and {}", self.label(second), self.label(first));
            let both = self.all(all, |(row, column)| ((other(row), other(column)), 1.0));
            found.push(Convention::of_entries(format!("the coordinates are in another order, {names}"), both));
            let rows = self.all(all, |(row, column)| ((other(row), column), 1.0));
            found.push(Convention::of_entries(format!("the equations are in another order, {names}"), rows));
            let columns = self.all(all, |(row, column)| ((row, other(column)), 1.0));
            found.push(Convention::of_entries(format!("the columns are in another order, {names}"), columns));
        }
        if self.count > 1 {
            let transposed = |(row, column): (usize, usize)| ((column, row), 1.0);
            for matrix in all {
                let what = format!("{matrix} was filled row by column: it is transposed");
                found.push(Convention::of_entries(what, self.all(&[*matrix], transposed)));
            }
            let what = "all matrices were filled row by column: they are transposed";
            found.push(Convention::of_entries(what, self.all(all, transposed)));
        }
        found
    }

    /// Matrices of which one half was copied to the other.
    fn halves(&self) -> Vec<Convention> {
        let mut found = Vec::new();
        for &matrix in if self.count > 1 { self.info.matrices } else { &[] } {
            for (is_lower, half) in [(true, "lower"), (false, "upper")] {
                for (sign, how) in [(1.0, "symmetric"), (-1.0, "skew")] {
                    let from = |(row, column): (usize, usize)| {
                        let is_other = if is_lower { row < column } else { row > column };
                        if is_other { ((column, row), sign) } else { ((row, column), 1.0) }
                    };
                    let (row, column) = if is_lower { (1, 2) } else { (2, 1) };
                    let what = match (self.count, sign > 0.0) {
                        (2, true) => format!(
                            "{matrix} was filled row by column: {matrix}_{row}{column} has the value of \
                             {matrix}_{column}{row}"
                        ),
                        (2, false) => format!("{matrix}_{row}{column} has the value of -{matrix}_{column}{row}"),
                        _ => format!("{matrix} was made {how} by its {half} half"),
                    };
                    found.push(Convention::of_entries(what, self.all(&[matrix], from)));
                }
            }
        }
        found
    }

    /// Matrices times a factor.
    fn factors(&self, gravity: f64) -> Vec<Convention> {
        let all = self.info.matrices;
        let scale = |matrix: MatrixName, factor: f64| self.all(&[matrix], |place| (place, factor));
        let mut found = Vec::new();
        let mut of = |what: String, factors: &dyn Fn(MatrixName) -> f64| {
            let scaled: Vec<_> = all.iter().flat_map(|&matrix| scale(matrix, factors(matrix))).collect();
            if !scaled.is_empty() {
                found.push(Convention::of_entries(what, scaled));
            }
        };
        for &matrix in all {
            let only = |factor: f64| move |other: MatrixName| if other == matrix { factor } else { 1.0 };
            of(format!("{matrix} has the other sign"), &only(-1.0));
            of(format!("{matrix} is twice what it is here"), &only(2.0));
            of(format!("{matrix} is half of what it is here"), &only(0.5));
            of(format!("{matrix} is left out"), &only(0.0));
        }
        if gravity != 0.0 && gravity != 1.0 && all.contains(&MatrixName::K0) {
            let only = |factor: f64| move |matrix: MatrixName| if matrix == MatrixName::K0 { factor } else { 1.0 };
            of("g is in K0: it is multiplied already".to_owned(), &only(gravity));
            of("K0 is not multiplied by g".to_owned(), &only(1.0 / gravity));
        }
        let degree = std::f64::consts::PI / 180.0;
        of("coordinates are in degrees".to_owned(), &|_| degree);
        of("coordinates in rad were taken for degrees and converted".to_owned(), &|_| 1.0 / degree);
        of("all matrices have the other sign".to_owned(), &|_| -1.0);
        of("masses are in g in the place of kg".to_owned(), &|_| 1e3);
        of("masses are in lb in the place of kg".to_owned(), &|_| 1.0 / 0.453_592_37);
        found
    }

    /// What may become of the mass matrix.
    fn masses(&self) -> Vec<Convention> {
        let place = |place: (usize, usize)| self.at(MatrixName::M, place);
        let divided = "all matrices are divided by M from the left".to_owned();
        let mut found = vec![Convention { what: divided, effect: Effect::DividedByMass, rank: 0 }];
        if self.count > 1 {
            let what = "all matrices are divided by M from the right".to_owned();
            found.push(Convention { what, effect: Effect::DividedByMassFromRight, rank: 0 });
        }
        let identity =
            self.places().map(|own| Assignment::constant(place(own), if own.0 == own.1 { 1.0 } else { 0.0 }));
        found.push(Convention::of_entries("accelerations are not divided by M", identity.collect()));
        let off: Vec<_> = self.places().filter(|(row, column)| row != column).map(place).collect();
        if off.iter().any(|&at| self.entries[at] != 0.0) {
            let lost = off.iter().map(|&at| Assignment::constant(at, 0.0)).collect();
            found.push(Convention::of_entries("M has its diagonal alone", lost));
        }
        found
    }
}
