//! How far a sweep is, for who waits; and how fast it was.

use std::fmt;
use std::io::IsTerminal as _;
use std::time::Instant;

use indicatif::{HumanCount, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

/// A bar on the standard error, if that is a terminal and shows nothing else; and the time since the start.
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
}

impl Progress {
    /// The number of designs is not always known; results may be printed beside it.
    pub fn new(total: Option<u64>, prints: bool) -> Self {
        let is_shared = prints && std::io::stdout().is_terminal();
        let (target, template) = match (is_shared, total) {
            (true, _) => (ProgressDrawTarget::hidden(), ""),
            (false, Some(_)) => {
                (ProgressDrawTarget::stderr(), "{wide_bar} {human_pos} of {human_len} designs, {rate}, {eta} left")
            }
            (false, None) => (ProgressDrawTarget::stderr(), "{spinner} {human_pos} designs, {rate}"),
        };
        let bar = ProgressBar::with_draw_target(total, target);
        // Without decimals, unlike the `per_sec` of the library.
        let rate = |state: &ProgressState, text: &mut dyn fmt::Write| {
            // The text is memory.
            let _ = write!(text, "{}/s", HumanCount(state.per_sec() as u64));
        };
        let style = ProgressStyle::with_template(template).map(|style| style.with_key("rate", rate));
        let bar = style.map_or(bar.clone(), |style| bar.with_style(style));
        Self { bar, started: Instant::now() }
    }

    /// Moves the bar by so many designs.
    pub fn add(&self, designs: usize) {
        self.bar.inc(designs as u64);
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
    /// How many designs were computed, the time and the rate.
    pub fn summary(&self, designs: usize) -> String {
        let seconds = self.started.elapsed().as_secs_f64();
        let noun = if designs == 1 { "design" } else { "designs" };
        let rate = if seconds > 0.0 && designs > 0 {
            format!(", {:.0} designs/s", designs as f64 / seconds)
        } else {
            String::new()
        };
        format!("{designs} {noun} in {seconds:.3} s{rate}, with reading and writing")
    }
}
