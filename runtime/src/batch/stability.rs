//! The critical speeds and stable ranges of many designs with two coordinates.

use fearless_simd::{Simd, dispatch};

use super::transpose::MOST;
use super::{Batch, BatchError, Lanes};
use crate::characteristic::determinant::Rows;
use crate::characteristic::powers::Matrices;
use crate::stability::Stability;
use crate::stability::fast::conditions::{Conditions, are_moderate, entries, in_speed, in_square};
use crate::system::{Coefficients, States, SystemError};

impl Batch {
    /// The critical speeds and stable ranges of each design, at a gravitational field strength in N/kg for each, into a slice of
    /// equal length.
    ///
    /// They are those of [`Stability::new`], to the last bit, with all that it promises; a design that has none gets its
    /// error, and the others are not affected. What is computed in lanes are the polynomials along the speed, in twice the
    /// precision of `f64`; their roots are found for one design after the other.
    ///
    /// # Errors
    /// If the slices differ in length. Nothing is written then.
    pub fn stability(
        &self,
        coefficients: &[Coefficients<f64, 2>],
        gravity: &[f64],
        stability: &mut [Result<Stability, SystemError>],
    ) -> Result<(), BatchError> {
        BatchError::require_room("gravity", coefficients.len(), gravity.len())?;
        BatchError::require_room("result", coefficients.len(), stability.len())?;
        dispatch!(self.level, simd => of_designs(simd, coefficients, gravity, stability));
        Ok(())
    }

    /// As [`Batch::stability`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::stability`].
    #[cfg(feature = "rayon")]
    pub fn parallel_stability(
        &self,
        coefficients: &[Coefficients<f64, 2>],
        gravity: &[f64],
        stability: &mut [Result<Stability, SystemError>],
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        /// Some ten microseconds of work and more.
        const DESIGNS: usize = 32;
        BatchError::require_room("gravity", coefficients.len(), gravity.len())?;
        BatchError::require_room("result", coefficients.len(), stability.len())?;
        let designs = coefficients.par_chunks(DESIGNS).zip(gravity.par_chunks(DESIGNS));
        let parts = designs.zip(stability.par_chunks_mut(DESIGNS));
        parts.try_for_each(|((coefficients, gravity), stability)| self.stability(coefficients, gravity, stability))
    }
}

/// How a design is computed.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// In lanes, by polynomials in the square of the speed.
    Square,
    /// In lanes, by polynomials in the speed.
    Speed,
    Alone,
}

/// As many lanes as the widest registers have, in `f64`.
const LANES: usize = MOST / 2;

#[inline(always)]
fn of_designs<S: Simd>(
    simd: S,
    coefficients: &[Coefficients<f64, 2>],
    gravity: &[f64],
    stability: &mut [Result<Stability, SystemError>],
) {
    let lanes = Lanes::<S>::COUNT;
    let designs = coefficients.chunks(lanes).zip(gravity.chunks(lanes)).zip(stability.chunks_mut(lanes));
    for ((coefficients, gravity), stability) in designs {
        let last = coefficients.len() - 1;
        let mut rows = [[[[0.0; 2]; 2]; 6]; LANES];
        let mut ways = [Way::Alone; LANES];
        for (lane, (coefficients, gravity)) in coefficients.iter().zip(gravity).enumerate() {
            rows[lane] = entries(coefficients);
            let is_usual = !coefficients.has_odd_powers()
                && coefficients.states == [States::Both; 2]
                && are_moderate(&rows[lane], *gravity);
            ways[lane] = match is_usual {
                true if rows[lane][1] == [[0.0; 2]; 2] => Way::Square,
                true => Way::Speed,
                false => Way::Alone,
            };
        }
        // Lanes without a design repeat the last one.
        let of_lanes = |matrix: usize| -> Rows<Lanes<S>> {
            let entry = |i: usize, j: usize| Lanes::from_fn(simd, |lane| rows[lane.min(last)][matrix][i][j]);
            [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
        };
        let gravities = Lanes::from_fn(simd, |lane| gravity[lane.min(last)]);
        let matrices =
            Matrices::new([of_lanes(0), of_lanes(1), of_lanes(2), of_lanes(3), of_lanes(4), of_lanes(5)], gravities);
        let ways = &ways[..=last];
        // No closures: they would be functions of their own, for which the instructions of the processor are not known.
        let square = if ways.contains(&Way::Square) { Some(in_square(&matrices)) } else { None };
        let speed = if ways.contains(&Way::Speed) { Some(in_speed(&matrices)) } else { None };
        for (lane, (way, stability)) in ways.iter().zip(stability).enumerate() {
            let found = match way {
                Way::Square => square.as_ref().and_then(|conditions| of_lane(conditions, lane)),
                Way::Speed => speed.as_ref().and_then(|conditions| of_lane(conditions, lane)),
                Way::Alone => None,
            };
            *stability = match found {
                Some(found) => Ok(found),
                None => Stability::new(&coefficients[lane], gravity[lane]),
            };
        }
    }
}

fn of_lane<S: Simd, const P: usize, const H: usize, const D: usize>(
    conditions: &Conditions<P, H, D, Lanes<S>>,
    lane: usize,
) -> Option<Stability> {
    Stability::of_conditions(&conditions.lane(lane)?)
}
