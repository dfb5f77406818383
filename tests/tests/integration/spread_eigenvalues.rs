//! Eigenvalues whose sizes spread over up to 240 orders of magnitude, against 260 digits: right, or refused.

use carvallo::{Complex, Matrix, System};
use carvallo_tests::facts::{SpreadEigenvalues, spread_eigenvalues};

/// The largest relative error; `None` if the system is refused.
fn worst<const N: usize>(known: &SpreadEigenvalues) -> Option<f64> {
    let matrix = |which: usize| Matrix::<f64, N>::from_row_slice(&known.entries[which * N * N..][..N * N]);
    let mut found = System::new(matrix(0), matrix(1), matrix(2)).eigenvalues().ok()?;
    // Each of the known ones once, the largest first.
    found.sort_by(|x, y| y.norm().total_cmp(&x.norm()));
    let mut left = known.values.clone();
    let error = |found: Complex<f64>, known: &Complex<f64>| (found - known).norm() / found.norm().max(known.norm());
    Some(found.into_iter().fold(0.0, |worst: f64, value| {
        let errors = left.iter().map(|known| error(value, known)).enumerate();
        let (place, least) = errors.min_by(|x, y| x.1.total_cmp(&y.1)).expect("as many as there are");
        left.swap_remove(place);
        worst.max(least)
    }))
}

#[test]
fn are_right_or_refused() {
    let mut refused = 0;
    let all = spread_eigenvalues();
    for known in &all {
        let worst = if known.coordinates == 3 { worst::<3>(known) } else { worst::<4>(known) };
        match worst {
            // Those that are small beside others have half of their digits.
            Some(worst) => assert!(worst < 1e-8, "{worst:e} of {known:?}"),
            None => {
                assert!(known.reach >= 20, "refused: {known:?}");
                refused += 1;
            }
        }
    }
    assert!(refused < all.len() * 2 / 3, "{refused} of {}", all.len());
}
