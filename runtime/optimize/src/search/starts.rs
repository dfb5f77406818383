//! Where searches begin.

use std::rc::Rc;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng as _, SeedableRng as _};

use super::descent::Aim;
use super::point::Point;
use super::{Search, WORSE};
use crate::range::Range;

/// So many designs are tried for each start; searches begin at the best of them.
const TRIED: u32 = 16;

impl Search<'_> {
    /// The given design, and the best of those that are tried, and some that are not.
    pub(super) fn starts(&self) -> Vec<Vec<f64>> {
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
}
