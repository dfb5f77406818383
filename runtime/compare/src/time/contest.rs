//! Contenders for a task, timed in turn.

use std::time::{Duration, Instant};

use serde::Serialize;

/// Rounds of a task at most: an odd number, so that there is one in the middle.
const MOST_ROUNDS: usize = 1001;
const LEAST_ROUNDS: usize = 5;

/// Something to compute, in several ways.
///
/// ```
/// use std::hint::black_box;
/// use std::time::Duration;
///
/// use carvallo_compare::Task;
///
/// let root = Task::new("a square root", 100)
///     .contender("as a root", || (0..100).for_each(|_| drop(black_box(black_box(2_f64).sqrt()))))
///     .contender("as a power", || (0..100).for_each(|_| drop(black_box(black_box(2_f64).powf(0.5)))));
/// let times = root.race(Duration::from_millis(10));
/// assert_eq!(times.len(), 2);
/// assert_eq!(times[0].to_first, 1.0);
/// ```
pub struct Task<'a> {
    /// What it is.
    pub name: String,
    /// How often a contender computes it in one run.
    pub repetitions: u64,
    /// Who computes it, and the limits.
    pub contenders: Vec<Contender<'a>>,
}

/// One way to compute a task.
pub struct Contender<'a> {
    /// What it is called.
    pub name: String,
    /// Does not compute it, but what it cannot do without.
    pub limit: bool,
    /// Computes it as often as the task says.
    pub run: Box<dyn FnMut() + 'a>,
}

/// What a contender took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Time {
    /// What it is called.
    pub name: String,
    /// Whether it does not compute the task, but what that cannot do without.
    pub limit: bool,
    /// Median for one computation, in ns.
    pub nanoseconds: f64,
    /// The lower and the upper quartile, in ns: half of the rounds lie between them.
    pub quartiles: [f64; 2],
    /// Median ratio to the first contender in the same round.
    pub to_first: f64,
    /// The quartiles of that ratio. What else the machine does hits all contenders of a round alike, so it spreads less.
    pub quartiles_to_first: [f64; 2],
    /// Median ratio to the next limit below in the same round, if there is one.
    pub to_limit: Option<f64>,
}

impl<'a> Task<'a> {
    /// A task of which every contender does so many in one run: in much less than a millisecond if that can be, since
    /// longer runs are more often interrupted by other processes, and then the slow ones seem slower than they are.
    #[must_use]
    pub fn new(name: impl Into<String>, repetitions: usize) -> Self {
        Self { name: name.into(), repetitions: repetitions as u64, contenders: Vec::new() }
    }

    /// Adds a contender. The first one is what the others are compared with.
    #[must_use]
    pub fn contender(mut self, name: impl Into<String>, run: impl FnMut() + 'a) -> Self {
        self.contenders.push(Contender { name: name.into(), limit: false, run: Box::new(run) });
        self
    }

    /// Adds a limit to the contenders since the last one.
    #[must_use]
    pub fn limit(mut self, name: impl Into<String>, run: impl FnMut() + 'a) -> Self {
        self.contenders.push(Contender { name: name.into(), limit: true, run: Box::new(run) });
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
        let over = |value: &dyn Fn(&[f64]) -> f64| quartiles(rounds.iter().map(|round| value(round)).collect());
        let time = |(index, contender): (usize, &Contender<'_>)| {
            let limit = self.contenders[index..].iter().position(|below| below.limit).map(|below| index + below);
            let [lower, median, upper] = over(&|round| round[index] / self.repetitions as f64);
            let [least, to_first, most] = over(&|round| round[index] / round[0]);
            Time {
                name: contender.name.clone(),
                limit: contender.limit,
                nanoseconds: median,
                quartiles: [lower, upper],
                to_first,
                quartiles_to_first: [least, most],
                to_limit: limit.map(|limit| over(&|round| round[index] / round[limit])[1]),
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

/// The values in the middle, and in the middle of the lower and upper half; of an even number the upper one of two.
fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values[quarter * values.len() / 4])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_and_the_quartiles_of_rounds() {
        assert_eq!(quartiles(vec![5.0, 1.0, 4.0, 2.0, 3.0]), [2.0, 3.0, 4.0]);
        assert_eq!(quartiles(vec![1.0; 5]), [1.0; 3]);
    }

    #[test]
    fn contenders_take_turns() {
        let order = std::cell::RefCell::new(String::new());
        let note = |letter: char| {
            let order = &order;
            move || order.borrow_mut().push(letter)
        };
        let times = Task::new("letters", 1).contender("a", note('a')).limit("b", note('b')).race(Duration::ZERO);
        // One round before, and as many as there are at least.
        assert_eq!(*order.borrow(), "ab".repeat(1 + LEAST_ROUNDS));
        assert_eq!((times[0].to_first, times[1].limit), (1.0, true));
        assert!(times[0].quartiles[0] <= times[0].nanoseconds && times[0].nanoseconds <= times[0].quartiles[1]);
    }
}
