//! Curves of eigenvalues without names of modes.
//!
//! Each eigenvalue goes its way continuously, but which is which after two have met is nothing that their values tell. In
//! order of size it does not matter: the k-th largest of the real parts at each speed is continuous as well, and all of
//! these curves together are all of the real parts. The same holds for the imaginary parts.

use super::curves::{Curve, extend};
use crate::analysis::{Eigenvalues, Row};

/// The real parts in order.
pub fn real(rows: &[Row<Eigenvalues>]) -> Vec<Curve> {
    curves(rows, |values| values.values.iter().map(|value| value.re).collect())
}

/// The imaginary parts without their signs in order, where they are not zero.
pub fn imaginary(rows: &[Row<Eigenvalues>]) -> Vec<Curve> {
    // Those of a pair are equal, and so are the zeros of real ones, of which there is an even number: one of two will do.
    let sizes = |values: &Eigenvalues| {
        let mut sizes: Vec<f64> = values.values.iter().map(|value| value.im.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        sizes.into_iter().step_by(2).collect()
    };
    let curves = curves(rows, sizes);
    let mut oscillating = Vec::new();
    for curve in curves {
        let mut pieces = Vec::new();
        for (index, &(speed, size)) in curve.iter().enumerate() {
            // Where a pair begins or ends, its curve reaches the axis.
            let near = [index.saturating_sub(1), index + 1];
            let oscillates =
                size > 0.0 || near.iter().any(|&near| curve.get(near).is_some_and(|&(_, size)| size > 0.0));
            extend(&mut pieces, oscillates.then_some((speed, size)));
        }
        oscillating.extend(pieces);
    }
    oscillating.retain(|curve| curve.len() > 1);
    oscillating
}

fn curves(rows: &[Row<Eigenvalues>], parts: impl Fn(&Eigenvalues) -> Vec<f64>) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for Row { speed, values } in rows {
        let mut parts = parts(values);
        parts.sort_by(f64::total_cmp);
        curves.resize(parts.len(), Curve::new());
        for (curve, part) in curves.iter_mut().zip(parts) {
            curve.push((*speed, part));
        }
    }
    curves
}
