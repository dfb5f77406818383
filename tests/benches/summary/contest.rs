//! Contenders for a task, timed in turn.

use std::time::{Duration, Instant};

/// Rounds of a task at most: an odd number, so that there is one in the middle.
const MOST_ROUNDS: usize = 1001;
const LEAST_ROUNDS: usize = 5;

/// Something to compute, in several ways.
pub struct Task<'a> {
    pub name: String,
    /// How often a contender computes it in one run.
    repetitions: u64,
    contenders: Vec<Contender<'a>>,
}

struct Contender<'a> {
    name: &'static str,
    /// Does not compute it, but what it cannot do without.
    limit: bool,
    run: Box<dyn FnMut() + 'a>,
}

/// What a contender took.
pub struct Time {
    pub name: &'static str,
    pub limit: bool,
    /// Median for one computation, in ns.
    pub nanoseconds: f64,
    /// Median ratio to the first contender in the same round.
    pub to_first: f64,
    /// Median ratio to the next limit below in the same round, if there is one.
    pub to_limit: Option<f64>,
}

impl<'a> Task<'a> {
    /// A task of which every contender does so many in one run: in much less than a millisecond if that can be, since
    /// longer runs are more often interrupted by other processes, and then the slow ones seem slower than they are.
    pub fn new(name: impl Into<String>, repetitions: usize) -> Self {
        Self { name: name.into(), repetitions: repetitions as u64, contenders: Vec::new() }
    }

    /// Adds a contender. The first one is what the others are compared with.
    pub fn contender(mut self, name: &'static str, run: impl FnMut() + 'a) -> Self {
        self.contenders.push(Contender { name, limit: false, run: Box::new(run) });
        self
    }

    /// Adds a limit to the contenders since the last one.
    pub fn limit(mut self, name: &'static str, run: impl FnMut() + 'a) -> Self {
        self.contenders.push(Contender { name, limit: true, run: Box::new(run) });
        self
    }

    /// Times all contenders in turn, round by round, until so much time is over.
    pub fn race(mut self, time: Duration) -> Vec<Time> {
        // One round that does not count, for memory that is not there yet and code that is not in the cache.
        self.round();
        let end = Instant::now() + time;
        let mut rounds = Vec::new();
        while rounds.len() < LEAST_ROUNDS || (rounds.len() < MOST_ROUNDS && Instant::now() < end) {
            rounds.push(self.round());
        }
        let over = |value: &dyn Fn(&[f64]) -> f64| median(rounds.iter().map(|round| value(round)).collect());
        let time = |(index, contender): (usize, &Contender<'_>)| {
            let limit = self.contenders[index..].iter().position(|below| below.limit).map(|below| index + below);
            Time {
                name: contender.name,
                limit: contender.limit,
                nanoseconds: over(&|round| round[index]) / self.repetitions as f64,
                to_first: over(&|round| round[index] / round[0]),
                to_limit: limit.map(|limit| over(&|round| round[index] / round[limit])),
            }
        };
        self.contenders.iter().enumerate().map(time).collect()
    }

    /// What each run took, in ns.
    fn round(&mut self) -> Vec<f64> {
        let time = |contender: &mut Contender<'_>| {
            let start = Instant::now();
            (contender.run)();
            start.elapsed().as_secs_f64() * 1e9
        };
        self.contenders.iter_mut().map(time).collect()
    }
}

/// The value in the middle; of an even number of values the upper one of the two.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
