//! How far a simulation is, for who waits.

use std::cell::{Cell, OnceCell};
use std::io::IsTerminal as _;
use std::time::{Duration, Instant};

use anstyle::Style;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::terminal::note;

/// What is done sooner needs no bar.
const SHORT: Duration = Duration::from_millis(500);
/// Of the bar, which counts in whole numbers.
const PARTS: f64 = 1000.0;
/// When the first line is printed where there is no terminal; the next one always after twice the time.
const FIRST_LINE: Duration = Duration::from_secs(10);

/// A bar on the standard error if that is a terminal, else a line now and then.
pub struct Progress {
    duration: f64,
    started: Instant,
    bar: OnceCell<ProgressBar>,
    next_line: Cell<Duration>,
}

impl Progress {
    /// Of a motion that takes so many seconds.
    pub fn new(duration: f64) -> Self {
        Self { duration, started: Instant::now(), bar: OnceCell::new(), next_line: Cell::new(FIRST_LINE) }
    }

    /// Tells that a time of the motion is reached.
    pub fn reach(&self, time: f64) {
        let elapsed = self.started.elapsed();
        if elapsed < SHORT {
            return;
        }
        if !std::io::stderr().is_terminal() {
            if elapsed >= self.next_line.get() {
                self.next_line.set(2 * elapsed);
                self.print_line(time, elapsed);
            }
            return;
        }
        let bar = self.bar.get_or_init(|| {
            let bar = ProgressBar::with_draw_target(Some(PARTS as u64), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{wide_bar} {msg}, {eta} left");
            style.map_or(bar.clone(), |style| bar.with_style(style))
        });
        bar.set_message(format!("{time:.3} s of {:.3} s", self.duration));
        bar.set_position((PARTS * time / self.duration) as u64);
    }

    fn print_line(&self, time: f64, elapsed: Duration) {
        let left = elapsed.as_secs_f64() * (self.duration - time) / time;
        // What is beyond a century is no time to wait for.
        let left = Duration::try_from_secs_f64(left).ok().filter(|left| left.as_secs() < 100 * 365 * 86_400);
        let left = left.map_or("more than a century".to_owned(), |left| format!("about {}", HumanDuration(left)));
        let elapsed = HumanDuration(elapsed);
        let text = format!(
            "{time:.3} s of {:.3} s after {elapsed}, {left} left; nothing is kept if it is stopped",
            self.duration
        );
        note(Style::new(), "progress", &text);
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}
