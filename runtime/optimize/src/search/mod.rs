//! The search: from several starts, each by sequential quadratic programming (Kraft 1988, 1994).

mod descent;
mod ending;
mod point;
mod starts;

use std::cell::{Cell, RefCell};
use std::ops::ControlFlow;
use std::rc::Rc;

use carvallo_design::Failure;

use self::descent::Aim;
use self::point::Point;
use crate::measures::Measures;
use crate::optimum::{Optimum, Progress};
use crate::problem::Problem;

/// Worse than every design that has what is measured, and by how much each miss counts.
const WORSE: f64 = 1e4;
/// What is as close as this to an end or a constraint is at it.
const CLOSE: f64 = 1e-6;

/// The best design.
///
/// The search begins at the given design and at the best of many others within the ranges. Where none of these has what is
/// measured, such as a stable range, the largest real part of the eigenvalues is minimized first, at the speed that counts at
/// which it is least, until one is stable.
///
/// How far it has come is told at each design that is tried, and what is told may end the search.
///
/// # Errors
/// If no design was found that keeps all constraints and has what is measured; or if the search was ended.
pub fn optimize(problem: &Problem, progress: &dyn Fn(Progress) -> ControlFlow<()>) -> Result<Optimum, Failure> {
    let search = Search::new(problem, progress);
    let starts = search.starts();
    search.starts.set(starts.len() as u32);
    let mut reached = Vec::new();
    for start in starts {
        reached.push(search.descend(&start, Aim::Goal));
        search.done.set(search.done.get() + 1);
    }
    if search.has_ended.get() {
        return Err(Failure::Run(format!("{}: the search was ended", problem.design.title())));
    }
    search.finish(&reached)
}

struct Search<'a> {
    problem: &'a Problem<'a>,
    progress: &'a dyn Fn(Progress) -> ControlFlow<()>,
    /// How many starts there are, and how many of them are done.
    starts: Cell<u32>,
    done: Cell<u32>,
    /// Whether nothing is to be computed any more.
    has_ended: Cell<bool>,
    /// 1 or -1: searches minimize.
    sign: f64,
    scales: Vec<f64>,
    best: RefCell<Option<Rc<Point>>>,
    /// The best of the search that is running: the solver may end at a worse one, where it can go no further.
    best_of_search: RefCell<Option<Rc<Point>>>,
    last: RefCell<Option<Rc<Point>>>,
    evaluations: Cell<u64>,
    /// Of each constraint whether any design keeps it.
    kept: RefCell<Vec<bool>>,
}

impl<'a> Search<'a> {
    fn new(problem: &'a Problem<'a>, progress: &'a dyn Fn(Progress) -> ControlFlow<()>) -> Self {
        let (info, values) = (problem.design.info(), problem.design.values());
        let measures = Measures::new(problem.design.model, values.clone(), problem.settings.speeds).ok();
        let scales = problem.constraints.iter().map(|constraint| constraint.scale(info, &values, measures.as_ref()));
        Self {
            problem,
            progress,
            starts: Cell::new(problem.settings.starts),
            done: Cell::new(0),
            has_ended: Cell::new(false),
            sign: if problem.goal.maximize { -1.0 } else { 1.0 },
            scales: scales.collect(),
            best: RefCell::default(),
            best_of_search: RefCell::default(),
            last: RefCell::default(),
            evaluations: Cell::new(0),
            kept: RefCell::new(vec![false; problem.constraints.len()]),
        }
    }

    /// None where there is no answer.
    fn measures(&self, values: Vec<f64>) -> Option<Measures> {
        Measures::new(self.problem.design.model, values, self.problem.settings.speeds).ok()
    }

    /// What there is at shares of the ranges; of those that keep everything the best is remembered.
    fn at(&self, shares: &[f64]) -> Rc<Point> {
        if let Some(last) = self.last.borrow().as_ref().filter(|last| last.shares == shares) {
            return last.clone();
        }
        let problem = self.problem;
        let varied = problem.at(shares);
        // The solver, which knows no way to be ended, soon has enough of designs of which nothing is known.
        let values = if self.ends() { None } else { problem.values(&varied).ok() };
        self.evaluations.set(self.evaluations.get() + u64::from(!self.has_ended.get()));
        let measures = values.as_ref().and_then(|values| self.measures(values.clone()));
        let measured = measures.as_ref().and_then(|measures| measures.take(problem.goal.measure).ok().flatten());
        let excess = |(constraint, scale): (&crate::Constraint, &f64)| {
            let excess = constraint.excess(problem.design.info(), values.as_ref()?, measures.as_ref())?;
            Some(excess / scale)
        };
        let excess: Vec<Option<f64>> = problem.constraints.iter().zip(&self.scales).map(excess).collect();
        let holds = excess.iter().map(|excess| excess.is_some_and(|excess| excess <= 0.0));
        self.kept.borrow_mut().iter_mut().zip(holds).for_each(|(kept, holds)| *kept |= holds);
        let point = Rc::new(Point { shares: shares.to_vec(), varied, values, measures, measured, excess });
        for best in [&self.best, &self.best_of_search] {
            if self.is_better(&point, best.borrow().as_deref()) {
                *best.borrow_mut() = Some(point.clone());
            }
        }
        *self.last.borrow_mut() = Some(point.clone());
        point
    }

    /// Tells how far the search has come; whether it is to end.
    fn ends(&self) -> bool {
        let best = self.best.borrow().as_ref().map(|best| best.value());
        let progress = Progress { done: self.done.get(), starts: self.starts.get(), best };
        if !self.has_ended.get() && (self.progress)(progress).is_break() {
            self.has_ended.set(true);
        }
        self.has_ended.get()
    }

    fn is_better(&self, point: &Point, best: Option<&Point>) -> bool {
        let value = |point: &Point| self.sign * point.value();
        point.measured.is_some() && point.keeps_all() && best.is_none_or(|best| value(point) < value(best))
    }
}
