//! How far a simulation is, for who waits.

use std::cell::OnceCell;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What is done sooner needs no bar.
const SHORT: Duration = Duration::from_millis(500);
/// Of the bar, which counts in whole numbers.
const PARTS: f64 = 1000.0;

/// A bar on the standard error, if that is a terminal.
pub struct Progress {
    duration: f64,
    started: Instant,
    bar: OnceCell<ProgressBar>,
}

impl Progress {
    /// Of a motion that takes so many seconds.
    pub fn new(duration: f64) -> Self {
        Self { duration, started: Instant::now(), bar: OnceCell::new() }
    }

    /// Moves the bar to a time of the motion.
    pub fn reach(&self, time: f64) {
        if self.started.elapsed() < SHORT {
            return;
        }
        let bar = self.bar.get_or_init(|| {
            let bar = ProgressBar::with_draw_target(Some(PARTS as u64), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{wide_bar} {msg}, {eta} left");
            style.map_or(bar.clone(), |style| bar.with_style(style))
        });
        bar.set_message(format!("{time:.3} s of {} s", self.duration));
        bar.set_position((PARTS * time / self.duration) as u64);
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}
