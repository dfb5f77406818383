//! The search: from several starts, each by sequential quadratic programming (Kraft 1988, 1994).

use std::cell::{Cell, RefCell};
use std::ops::ControlFlow;
use std::rc::Rc;

use carvallo_design::Failure;
use carvallo_design::number::{fixed, shortest};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore as _, SeedableRng as _};
use slsqp::{Func, StopTols, minimize};

use crate::goal::{Goal, Measure};
use crate::measures::{Measured, Measures};
use crate::optimum::{End, Optimum, Progress};
use crate::problem::Problem;
use crate::range::Range;

/// So many designs are tried for each start; searches begin at the best of them.
const TRIED: u32 = 16;
/// The most designs of one search.
const MOST: usize = 300;
/// The room that a search leaves to each constraint, relative, so that rounding does not violate it.
const ROOM: f64 = 1e-9;
/// What is as close as this to an end or a constraint is at it.
const CLOSE: f64 = 1e-6;
/// Worse than every design that has what is measured, and by how much each miss counts.
const WORSE: f64 = 1e4;

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

/// What a search is for.
#[derive(Clone, Copy, PartialEq)]
enum Aim {
    Goal,
    /// The goal, where that is the widest stable range: the ends of a range of speeds that count are two more unknowns, which
    /// must be within the stable range, so that nothing has a kink where an end of it passes one of them.
    Range,
    /// Any design that has what is measured.
    Stability,
}

/// What is known of one design.
struct Point {
    shares: Vec<f64>,
    /// Of the parameters with ranges.
    varied: Vec<f64>,
    /// Of the model; none where there is no such design.
    values: Option<Vec<f64>>,
    measures: Option<Measures>,
    measured: Option<Measured>,
    /// Of each constraint, relative to its size.
    excess: Vec<Option<f64>>,
}

impl Point {
    fn keeps_all(&self) -> bool {
        self.excess.iter().all(|excess| excess.is_some_and(|excess| excess <= 0.0))
    }

    fn value(&self) -> f64 {
        self.measured.as_ref().map_or(f64::NAN, |measured| measured.value)
    }

    /// How far it is from being stable.
    fn instability(&self) -> f64 {
        self.measures.as_ref().map_or(WORSE, Measures::instability)
    }
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
        if self.is_better(&point) {
            *self.best.borrow_mut() = Some(point.clone());
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

    fn is_better(&self, point: &Point) -> bool {
        let value = |point: &Point| self.sign * point.value();
        let best = self.best.borrow();
        point.measured.is_some() && point.keeps_all() && best.as_ref().is_none_or(|best| value(point) < value(best))
    }

    /// Where searches begin: the given design, and the best of those that are tried, and some that are not.
    fn starts(&self) -> Vec<Vec<f64>> {
        let settings = self.problem.settings;
        let ranges = &self.problem.ranges;
        let share = |(at, range): (usize, &Range)| self.problem.before(at).map_or(0.5, |value| range.share(value));
        let given: Vec<f64> = ranges.iter().enumerate().map(share).collect();
        let mut generator = ChaCha8Rng::seed_from_u64(settings.seed);
        // 53 bits are a double from 0 to 1.
        let mut share = || (generator.next_u64() >> 11) as f64 * 2.0_f64.powi(-53);
        let mut random = || ranges.iter().map(|_| share()).collect::<Vec<f64>>();
        let mut tried: Vec<Rc<Point>> = vec![self.at(&given)];
        let others = settings.starts - 1;
        tried.extend((0..TRIED * settings.starts.max(4)).map(|_| self.at(&random())));
        let rank = |point: &Rc<Point>| {
            let missed: f64 = point.excess.iter().map(|excess| excess.map_or(1.0, |excess| excess.max(0.0))).sum();
            let value = if point.measured.is_some() { self.sign * point.value() } else { WORSE + point.instability() };
            value + WORSE * missed
        };
        let mut ranked: Vec<(f64, Rc<Point>)> = tried.iter().map(|point| (rank(point), point.clone())).collect();
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
        if tried.iter().all(|point| point.measured.is_none()) {
            let nearest: Vec<Vec<f64>> = ranked.iter().take(4).map(|(_, point)| point.shares.clone()).collect();
            return nearest.iter().map(|start| self.descend(start, Aim::Stability).shares.clone()).collect();
        }
        let best = ranked.iter().map(|(_, point)| point.shares.clone()).filter(|shares| *shares != given);
        std::iter::once(given.clone()).chain(best.take(others as usize)).collect()
    }

    /// The end of a search from one design.
    fn descend(&self, start: &[f64], aim: Aim) -> Rc<Point> {
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
        let end = match minimize(objective, &start, &bounds, &constraints, (), MOST, Some(tolerances)) {
            Ok((_, end, _)) | Err((_, end, _)) => end,
        };
        self.at(&end[..count].iter().map(|share| share.clamp(0.0, 1.0)).collect::<Vec<f64>>())
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

    fn finish(&self, reached: &[Rc<Point>]) -> Result<Optimum, Failure> {
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
