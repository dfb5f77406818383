//! What a search has come to.

use std::rc::Rc;

use carvallo_design::Failure;
use carvallo_design::number::{fixed, shortest};

use super::point::Point;
use super::{CLOSE, Search};
use crate::measures::Measures;
use crate::optimum::{End, Optimum};

impl Search<'_> {
    /// The best design that keeps everything, or why there is none.
    pub(super) fn finish(&self, reached: &[Rc<Point>]) -> Result<Optimum, Failure> {
        self.at_ends();
        let problem = self.problem;
        let Some(best) = self.best.borrow().clone() else { return Err(self.nothing(reached)) };
        let value = best.value();
        let agrees = |point: &&Rc<Point>| (point.value() - value).abs() <= CLOSE * value.abs().max(CLOSE);
        let end = |share: &f64| match *share {
            0.0 => Some(End::Low),
            1.0 => Some(End::High),
            _ => None,
        };
        let given = Measures::new(problem.design.model, problem.design.values(), problem.settings.speeds);
        Ok(Optimum {
            values: best.values.clone().unwrap_or_default(),
            varied: best.varied.clone(),
            value,
            before: given.ok().and_then(|measures| measures.value(problem.goal.measure)),
            ends: best.shares.iter().map(end).collect(),
            is_tight: best.excess.iter().map(|excess| excess.is_some_and(|excess| excess > -CLOSE)).collect(),
            starts: reached.len() as u32,
            agreeing: reached.iter().filter(agrees).count() as u32,
            evaluations: self.evaluations.get(),
        })
    }

    /// Whether what is close to ends may be at them.
    fn at_ends(&self) {
        let Some(best) = self.best.borrow().clone() else { return };
        let snapped = |share: &f64| match *share {
            share if share < CLOSE => 0.0,
            share if share > 1.0 - CLOSE => 1.0,
            share => share,
        };
        let shares: Vec<f64> = best.shares.iter().map(snapped).collect();
        if shares == best.shares {
            return;
        }
        let point = self.at(&shares);
        let loss = self.sign * (point.value() - best.value());
        if point.keeps_all() && loss <= CLOSE * CLOSE * best.value().abs() {
            *self.best.borrow_mut() = Some(point);
        }
    }

    /// Why there is nothing, from where searches ended.
    fn nothing(&self, reached: &[Rc<Point>]) -> Failure {
        let problem = self.problem;
        let title = problem.design.title();
        if reached.iter().all(|point| point.measures.is_none()) {
            return Failure::Run(format!(
                "{title}: none of the designs within these ranges that were tried can be built, or computed: `carvallo sweep` \
                 with the same ranges tells why"
            ));
        }
        if reached.iter().all(|point| point.measured.is_none()) {
            let nearest = reached.iter().map(|point| point.instability()).fold(f64::INFINITY, f64::min);
            let [low, high] = problem.settings.speeds.map(shortest);
            return Failure::Run(format!(
                "{title}: no design within these ranges was found that has {}; the largest real part of the eigenvalues, at \
                 the speed from {low} to {high} m/s at which it is least, comes down to {} 1/s",
                problem.goal.measure.had(),
                fixed(nearest, 4)
            ));
        }
        let never: Vec<String> = problem
            .constraints
            .iter()
            .zip(self.kept.borrow().iter())
            .filter(|(_, kept)| !**kept)
            .map(|(constraint, _)| format!("`{}`", constraint.written))
            .collect();
        let which = match never[..] {
            [] => "each is kept by some, but none keeps all".to_owned(),
            _ => format!("none of those that were tried keeps {}", never.join(" or ")),
        };
        Failure::Run(format!("{title}: no design within these ranges was found that keeps what must be kept: {which}"))
    }
}
