//! Simultaneous linear equations as straight-line code.

use super::quantity::Quantity;

/// By rows.
pub type Matrix<'a> = Vec<Vec<Quantity<'a>>>;

/// The unknowns for each of some right-hand sides.
///
/// Equations with one unknown are solved first, and unknowns that are in one equation last: what is left couples, and
/// is solved by its determinant up to three of them, which has a value wherever there is a solution. Beyond that it is
/// elimination along the diagonal.
pub fn solve<'a>(matrix: &Matrix<'a>, sides: &Matrix<'a>) -> Matrix<'a> {
    let size = matrix.len();
    let mut found: Vec<Option<Vec<Quantity<'a>>>> = vec![None; size];
    // What is left of an equation with all that is known.
    let rest = |row: usize, found: &[Option<Vec<Quantity<'a>>>], side: usize| {
        let known = found.iter().zip(&matrix[row]).filter_map(|(values, entry)| Some(*entry * values.as_ref()?[side]));
        known.fold(sides[side][row], |rest, term| rest - term)
    };
    let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..size).collect(), (0..size).collect());
    let mut last = Vec::new();
    let only = |places: Vec<usize>| if let [place] = places[..] { Some(place) } else { None };
    loop {
        let in_row = |row: usize| columns.iter().copied().filter(|column| !matrix[row][*column].is_zero()).collect();
        let alone = rows.iter().find_map(|row| Some((*row, only(in_row(*row))?, true)));
        let in_column = |column: usize| rows.iter().copied().filter(|row| !matrix[*row][column].is_zero()).collect();
        let late = || columns.iter().find_map(|column| Some((only(in_column(*column))?, *column, false)));
        let Some((row, column, first)) = alone.or_else(late) else { break };
        if first {
            let values = (0..sides.len()).map(|side| rest(row, &found, side) / matrix[row][column]).collect();
            found[column] = Some(values);
        } else {
            last.push((row, column));
        }
        rows.retain(|other| *other != row);
        columns.retain(|other| *other != column);
    }
    let core: Matrix<'a> =
        rows.iter().map(|row| columns.iter().map(|column| matrix[*row][*column]).collect()).collect();
    let core_side = |side: usize| rows.iter().map(|row| rest(*row, &found, side)).collect();
    let core_sides: Matrix<'a> = (0..sides.len()).map(core_side).collect();
    let solved = solve_dense(core, core_sides);
    for (place, column) in columns.iter().enumerate() {
        found[*column] = Some(solved.iter().map(|values| values[place]).collect());
    }
    for (row, column) in last.into_iter().rev() {
        let values = (0..sides.len()).map(|side| rest(row, &found, side) / matrix[row][column]).collect();
        found[column] = Some(values);
    }
    let values = |side: usize| found.iter().flatten().map(|values| values[side]).collect();
    (0..sides.len()).map(values).collect()
}

/// For each right-hand side.
fn solve_dense<'a>(mut matrix: Matrix<'a>, mut sides: Matrix<'a>) -> Matrix<'a> {
    match &matrix[..] {
        [] => sides,
        [a, b] if a.len() == 2 && b.len() == 2 => {
            let determinant = a[0] * b[1] - a[1] * b[0];
            let solve = |side: &Vec<Quantity<'a>>| {
                [b[1] * side[0] - a[1] * side[1], a[0] * side[1] - b[0] * side[0]]
                    .map(|value| value / determinant)
                    .to_vec()
            };
            sides.iter().map(solve).collect()
        }
        [a, b, c] => {
            // The cofactors of each row are the vector product of the others.
            let [first, second, third] = [cross(b, c), cross(c, a), cross(a, b)];
            let determinant = a[0] * first[0] + a[1] * first[1] + a[2] * first[2];
            let solve = |side: &Vec<Quantity<'a>>| {
                let value =
                    |column: usize| first[column] * side[0] + second[column] * side[1] + third[column] * side[2];
                (0..3).map(|column| value(column) / determinant).collect()
            };
            sides.iter().map(solve).collect()
        }
        _ => {
            let size = matrix.len();
            for pivot in 0..size {
                let (above, below) = matrix.split_at_mut(pivot + 1);
                let known = &above[pivot];
                for (row, entries) in (pivot + 1..).zip(below) {
                    let factor = entries[pivot] / known[pivot];
                    let rest = entries.iter_mut().zip(known).skip(pivot + 1);
                    rest.for_each(|(entry, known)| *entry = *entry - factor * *known);
                    sides.iter_mut().for_each(|side| side[row] = side[row] - factor * side[pivot]);
                }
            }
            for side in &mut sides {
                for row in (0..size).rev() {
                    let rest =
                        (row + 1..size).fold(side[row], |rest, column| rest - matrix[row][column] * side[column]);
                    side[row] = rest / matrix[row][row];
                }
            }
            sides
        }
    }
}

fn cross<'a>(a: &[Quantity<'a>], b: &[Quantity<'a>]) -> [Quantity<'a>; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[next, last]| a[next] * b[last] - a[last] * b[next])
}

/// The solution with a symmetric, positive definite matrix, as L D transposed L: no divisor vanishes where there is one.
pub fn solve_definite<'a>(matrix: &Matrix<'a>, side: &[Quantity<'a>]) -> Vec<Quantity<'a>> {
    let size = matrix.len();
    let mut lower = matrix.clone();
    let mut diagonal: Vec<Quantity<'a>> = Vec::new();
    for column in 0..size {
        let terms = (0..column).map(|inner| lower[column][inner].square() * diagonal[inner]);
        let pivot = terms.fold(matrix[column][column], |rest, term| rest - term);
        for row in column + 1..size {
            // Times the pivot: the factor of the row above is divided once.
            let terms = (0..column).map(|inner| lower[row][inner] * (lower[column][inner] * diagonal[inner]));
            let rest = terms.fold(matrix[row][column], |rest, term| rest - term);
            lower[row][column] = rest / pivot;
        }
        diagonal.push(pivot);
    }
    let mut values = side.to_vec();
    for row in 0..size {
        values[row] = (0..row).fold(values[row], |rest, inner| rest - lower[row][inner] * values[inner]);
    }
    for row in (0..size).rev() {
        let own = values[row] / diagonal[row];
        values[row] = (row + 1..size).fold(own, |rest, inner| rest - lower[inner][row] * values[inner]);
    }
    values
}
