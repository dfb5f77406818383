//! Gains by one state that make numbers which are linear in them, with as few powers of the speed as do, and as few digits.

use carvallo::{Complex, MatrixName};

use crate::predict::Predictor;
use crate::zero::{ROUNDING, Square, determinant, size};

/// One power, or else two or three where numbers are given at as many speeds.
const POWERS: [&[usize]; 7] = [&[0], &[1], &[2], &[0, 1], &[0, 2], &[1, 2], &[0, 1, 2]];

/// The gains before some powers of the speed, of which `powers` tells what a gain of one makes of each number; those numbers alone are
/// looked at on which these have an effect. `None` where no gains make them.
pub fn solve(
    predictor: &Predictor,
    here: &[f64],
    powers: &[(MatrixName, Vec<f64>); 3],
    speeds: usize,
) -> Option<Vec<(MatrixName, f64)>> {
    let meant = POWERS.into_iter().filter(|meant| meant.len() <= speeds.max(1));
    meant.into_iter().find_map(|meant| {
        let effects: Vec<&[f64]> = meant.iter().map(|at| &powers[*at].1[..]).collect();
        let values = of_powers(predictor, here, &effects)?;
        Some(meant.iter().map(|at| powers[*at].0).zip(values).collect())
    })
}

/// The gains that make all numbers on which they have an effect, with the fewest digits.
fn of_powers(predictor: &Predictor, here: &[f64], effects: &[&[f64]]) -> Option<Vec<f64>> {
    // What rounding leaves of an effect is none.
    let is_known = |at: &usize| effects.iter().any(|own| own[*at].abs() > predictor.tolerances()[*at]);
    let known: Vec<usize> = (0..here.len()).filter(is_known).collect();
    let off = |at: usize| predictor.numbers()[at].1.value - here[at];
    let weighted = |of: &dyn Fn(usize) -> f64| -> f64 {
        known.iter().map(|&at| of(at) / (predictor.tolerances()[at] * predictor.tolerances()[at])).sum()
    };
    let products = |own: &[f64]| -> Vec<f64> { effects.iter().map(|e| weighted(&|at| own[at] * e[at])).collect() };
    let rows: Vec<Vec<f64>> = effects.iter().map(|own| products(own)).collect();
    let right: Vec<f64> = effects.iter().map(|own| weighted(&|at| own[at] * off(at))).collect();
    let values = solution(&rows, &right)?;
    let fits = |values: &Vec<f64>| {
        let made = |at: usize| -> f64 { effects.iter().zip(values).map(|(own, value)| own[at] * value).sum() };
        known.iter().all(|&at| (off(at) - made(at)).abs() <= predictor.tolerances()[at])
    };
    let rounded = (0..17).filter_map(|digits| {
        values.iter().map(|value| format!("{value:.digits$e}").parse().ok()).collect::<Option<Vec<f64>>>()
    });
    [vec![0.0; effects.len()]].into_iter().chain(rounded).find(fits)
}

/// The solution of linear equations, by Cramer's rule; `None` where there is not one.
pub fn solution(rows: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let with = |replaced: Option<usize>| -> Square {
        let entry = |row: usize, column: usize| {
            let own = if replaced == Some(column) { right[row] } else { rows[row][column] };
            Complex::new(own, 0.0)
        };
        (0..rows.len()).flat_map(|row| (0..rows.len()).map(move |column| entry(row, column))).collect()
    };
    let (all, largest) = (determinant(&with(None), rows.len()).re, size(&with(None), rows.len()));
    let values = (0..rows.len()).map(|column| determinant(&with(Some(column)), rows.len()).re / all);
    (all.abs() > ROUNDING * largest).then(|| values.collect())
}

#[cfg(test)]
mod tests {
    use super::solution;

    /// 2 x + y = 5 and x + 3 y = 5 have x = 2 and y = 1.
    #[test]
    fn equations_are_solved_or_have_no_solution() {
        assert_eq!(solution(&[vec![2.0, 1.0], vec![1.0, 3.0]], &[5.0, 5.0]), Some(vec![2.0, 1.0]));
        assert_eq!(solution(&[vec![4.0]], &[2.0]), Some(vec![0.5]));
        assert_eq!(solution(&[vec![1.0, 2.0], vec![2.0, 4.0]], &[1.0, 1.0]), None);
    }
}
