//! Many designs of one machine, by columns of parameters, on several threads.

use std::mem::{self, MaybeUninit};
use std::num::NonZero;
use std::sync::{Mutex, PoisonError};
use std::thread;

use carvallo_design::Equations;

use crate::failure::Failure;
use crate::machine::Machine;
use crate::pointers::fill;
use crate::types::{CarvalloStatus, Complex, CriticalSpeed, Range, Summary};

/// Designs that differ in some parameters.
pub struct Designs<'a> {
    pub machine: &'a Machine,
    /// Each with the place of its parameter, all of one length.
    pub columns: Vec<(usize, &'a [f64])>,
    pub count: usize,
    /// 0 for as many as there are cores.
    pub threads: usize,
}

impl Designs<'_> {
    /// The eigenvalues of each at a speed, so many a row, zero where there are none.
    pub fn eigenvalues(
        &self,
        speed: f64,
        values: &mut [MaybeUninit<Complex>],
        statuses: &mut [MaybeUninit<CarvalloStatus>],
    ) {
        self.each(
            statuses,
            values,
            self.machine.model.eigenvalues(),
            |equations, gravity, row| {
                let found = equations.eigenvalues(speed, gravity)?;
                fill(row, found.into_iter().map(Complex::from));
                Ok(CarvalloStatus::Ok)
            },
            |status| status,
        );
    }

    /// The stability of each, and its first critical speeds, `most` a row.
    pub fn stability(
        &self,
        summaries: &mut [MaybeUninit<Summary>],
        critical_speeds: &mut [MaybeUninit<CriticalSpeed>],
        most: usize,
    ) {
        let failed = |status| Summary {
            status,
            critical_speeds: 0,
            stable_ranges: 0,
            undecided: 0,
            stable: Range { from: 0.0, to: 0.0 },
        };
        self.each(
            summaries,
            critical_speeds,
            most,
            |equations, gravity, row| {
                let found = equations.stability(gravity)?;
                fill(row, found.critical_speeds.iter().map(CriticalSpeed::from));
                Ok(Summary {
                    critical_speeds: found.critical_speeds.len(),
                    stable_ranges: found.stable_ranges.len(),
                    undecided: found.undecided.len(),
                    stable: found.stable_ranges.first().copied().map_or(Range { from: 0.0, to: 0.0 }, Range::from),
                    ..failed(CarvalloStatus::Ok)
                })
            },
            failed,
        );
    }

    /// What is computed of each design, and beside it a row of so many places.
    fn each<A: Send, B: Send + Empty>(
        &self,
        answers: &mut [MaybeUninit<A>],
        rows: &mut [MaybeUninit<B>],
        width: usize,
        compute: impl Fn(&dyn Equations, f64, &mut [MaybeUninit<B>]) -> Result<A, Failure> + Sync,
        failed: impl Fn(CarvalloStatus) -> A + Sync,
    ) {
        let cores = || thread::available_parallelism().map_or(1, NonZero::get);
        let threads = if self.threads == 0 { cores() } else { self.threads.min(MOST) };
        let share = self.count.div_ceil(threads).max(LEAST);
        let mut rows = rows;
        let parts = answers.chunks_mut(share).enumerate().map(|(part, answers)| {
            let (mine, others) = mem::take(&mut rows).split_at_mut(answers.len() * width);
            rows = others;
            (part * share, answers, mine)
        });
        let parts: Vec<_> = parts.collect();
        let workers = parts.len();
        let parts = Mutex::new(parts.into_iter());
        let next = || parts.lock().unwrap_or_else(PoisonError::into_inner).next();
        let work = || {
            let mut values = self.machine.values.clone();
            while let Some((first, answers, rows)) = next() {
                for (index, answer) in answers.iter_mut().enumerate() {
                    for (place, column) in &self.columns {
                        values[*place] = column[first + index];
                    }
                    let row = &mut rows[index * width..(index + 1) * width];
                    row.iter_mut().for_each(|place| {
                        place.write(B::EMPTY);
                    });
                    let found =
                        self.machine.with_values(&values, |equations, gravity| compute(equations, gravity, row));
                    answer.write(found.unwrap_or_else(|failure| failed(failure.status)));
                }
            }
        };
        thread::scope(|scope| {
            for _ in 1..workers {
                // Where the system gives no more threads, those that there are do all of it.
                if thread::Builder::new().spawn_scoped(scope, work).is_err() {
                    break;
                }
            }
            work();
        });
    }
}

/// More threads than this are a slip.
const MOST: usize = 1024;

/// Fewer designs are not worth a thread.
const LEAST: usize = 64;

/// What stands in a row where there is nothing.
trait Empty {
    const EMPTY: Self;
}

impl Empty for Complex {
    const EMPTY: Self = Self { re: 0.0, im: 0.0 };
}

impl Empty for CriticalSpeed {
    const EMPTY: Self = Self {
        kind: crate::types::CarvalloKind::Weave,
        change: crate::types::CarvalloChange::Touches,
        speed: 0.0,
        error: 0.0,
        eigenvalue: Complex::EMPTY,
    };
}
