//! The way down from one design: what is minimized, and what constrains it, with their derivatives.

use std::rc::Rc;

use slsqp::{Func, StopTols, minimize};

use super::point::Point;
use super::{Search, WORSE};
use crate::goal::{Goal, Measure};

/// The most designs of one search.
const MOST: usize = 300;
/// The room that a search leaves to each constraint, relative, so that rounding does not violate it.
const ROOM: f64 = 1e-9;

/// What a search is for.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Aim {
    Goal,
    /// The goal, where that is the widest stable range: the ends of a range of speeds that count are two more unknowns, which
    /// must be within the stable range, so that nothing has a kink where an end of it passes one of them.
    Range,
    /// Any design that has what is measured.
    Stability,
}

impl Search<'_> {
    /// The end of a search from one design.
    pub(super) fn descend(&self, start: &[f64], aim: Aim) -> Rc<Point> {
        let count = start.len();
        let aim = match (aim, self.problem.goal) {
            (Aim::Goal, Goal { measure: Measure::StableRange, maximize: true }) => Aim::Range,
            (aim, _) => aim,
        };
        let mut start = start.to_vec();
        if aim == Aim::Range {
            start.extend(self.stable_shares(&start));
        }
        let objective = |shares: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| match aim {
            Aim::Range => {
                if let Some(gradient) = gradient {
                    gradient.fill(0.0);
                    gradient[count..].copy_from_slice(&[1.0, -1.0]);
                }
                shares[count] - shares[count + 1]
            }
            aim => self.objective(shares, gradient, aim),
        };
        let of_range = if aim == Aim::Range { 2 } else { 0 };
        let kept = self.problem.constraints.len();
        let constraints: Vec<_> = (0..kept + of_range)
            .map(|index| {
                move |shares: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| match index.checked_sub(kept) {
                    None => self.constraint(index, &shares[..count], gradient),
                    Some(end) => self.stable_end(end, shares, gradient),
                }
            })
            .collect();
        let constraints: Vec<&dyn Func<()>> =
            constraints.iter().map(|constraint| constraint as &dyn Func<()>).collect();
        let tolerances = StopTols { ftol_rel: 1e-13, xtol_abs: vec![1e-11; start.len()], ..StopTols::default() };
        let bounds = vec![(0.0, 1.0); start.len()];
        *self.best_of_search.borrow_mut() = None;
        let end = match minimize(objective, &start, &bounds, &constraints, (), MOST, Some(tolerances)) {
            Ok((_, end, _)) | Err((_, end, _)) => end,
        };
        let end = self.at(&end[..count].iter().map(|share| share.clamp(0.0, 1.0)).collect::<Vec<f64>>());
        self.best_of_search.borrow_mut().take().filter(|_| aim != Aim::Stability).unwrap_or(end)
    }

    /// Where the ends of the stable range are among the speeds that count; all of these where there is none.
    fn stable_shares(&self, shares: &[f64]) -> [f64; 2] {
        let [low, high] = self.problem.settings.speeds;
        let ends = self.at(shares).measures.as_ref().and_then(|measures| measures.stable_ends().ok().flatten());
        ends.map_or([0.0, 1.0], |ends| ends.map(|end| ((end.value - low) / (high - low)).clamp(0.0, 1.0)))
    }

    /// By how much an unknown end of a range of speeds is outside of the stable range.
    fn stable_end(&self, end: usize, shares: &[f64], gradient: Option<&mut [f64]>) -> f64 {
        let (own, unknowns) = shares.split_at(shares.len() - 2);
        let [low, high] = self.problem.settings.speeds;
        // The lower end must be above that of the stable range, and the upper one below.
        let sign = if end == 0 { 1.0 } else { -1.0 };
        let point = self.at(own);
        let ends = point.measures.as_ref().and_then(|measures| measures.stable_ends().ok().flatten());
        let mut slopes = gradient;
        if let Some(slopes) = &mut slopes {
            slopes.fill(0.0);
        }
        match ends {
            Some(ends) if ends[end].value.is_finite() => {
                if let Some(slopes) = slopes {
                    for (slope, by) in slopes.iter_mut().zip(self.problem.slopes(&point.varied)) {
                        *slope = sign * ends[end].along(&by) / (high - low);
                    }
                    slopes[own.len() + end] = -sign;
                }
                sign * ((ends[end].value - low) / (high - low) - unknowns[end])
            }
            // Stable without end.
            Some(_) => -1.0,
            None => {
                let instability = point.instability();
                if let Some(slopes) = slopes {
                    self.instability_slopes(&point, instability, &mut slopes[..own.len()]);
                }
                1.0 + instability
            }
        }
    }

    /// What is minimized, with its derivatives by the shares.
    fn objective(&self, shares: &[f64], gradient: Option<&mut [f64]>, aim: Aim) -> f64 {
        let point = self.at(shares);
        match (&point.measured, aim) {
            (Some(measured), Aim::Goal) => {
                if let Some(gradient) = gradient {
                    for (slope, by) in gradient.iter_mut().zip(self.problem.slopes(&point.varied)) {
                        *slope = self.sign * measured.along(&by);
                    }
                }
                self.sign * measured.value
            }
            _ => {
                let instability = point.instability();
                if let Some(gradient) = gradient {
                    self.instability_slopes(&point, instability, gradient);
                }
                if aim == Aim::Goal { WORSE + instability } else { instability }
            }
        }
    }

    /// By differences into the range.
    fn instability_slopes(&self, point: &Point, instability: f64, gradient: &mut [f64]) {
        const STEP: f64 = 1e-6;
        if self.has_ended.get() {
            gradient.fill(0.0);
            return;
        }
        for (index, slope) in gradient.iter_mut().enumerate() {
            let mut shares = point.shares.clone();
            let step = if shares[index] > 0.5 { -STEP } else { STEP };
            shares[index] += step;
            let values = self.problem.values(&self.problem.at(&shares)).ok();
            let measures = values.and_then(|values| self.measures(values));
            *slope = measures.map_or(0.0, |measures| (measures.instability() - instability) / step);
        }
    }

    fn constraint(&self, index: usize, shares: &[f64], gradient: Option<&mut [f64]>) -> f64 {
        let point = self.at(shares);
        let (constraint, scale) = (&self.problem.constraints[index], self.scales[index]);
        if let Some(gradient) = gradient {
            gradient.fill(0.0);
            if let Some(values) = &point.values {
                let by = self.problem.slopes(&point.varied);
                let slopes = constraint.gradient(self.problem.design.info(), values, point.measures.as_ref(), &by);
                gradient.iter_mut().zip(slopes).for_each(|(entry, slope)| *entry = slope / scale);
            }
        }
        point.excess[index].unwrap_or(1.0) + ROOM
    }
}
