//! The table at the end.

use std::fmt;

use carvallo_compare::Time;

/// Rows of all tasks.
#[derive(Default)]
pub struct Table {
    tasks: Vec<(String, Vec<Time>)>,
}

impl Table {
    pub fn push(&mut self, task: String, times: Vec<Time>) {
        self.tasks.push((task, times));
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.tasks.is_empty() {
            return Ok(());
        }
        let width = |texts: &mut dyn Iterator<Item = &str>| texts.map(|text| text.chars().count()).max().unwrap_or(0);
        let times = || self.tasks.iter().flat_map(|(_, times)| times);
        let name = width(&mut times().map(|time| time.name.as_str())) + 2;
        writeln!(f, "\n{:name$} {:>12} {:>10} {:>10}", "", "time", "to first", "to limit")?;
        for (task, times) in &self.tasks {
            writeln!(f, "\n{task}")?;
            for time in times {
                let to_limit = match time.to_limit {
                    Some(ratio) if !time.limit => format!("{ratio:.2}"),
                    _ => String::new(),
                };
                let (nanoseconds, to_first) = (duration(time.nanoseconds), format!("{:.3}", time.to_first));
                writeln!(f, "  {:name$} {nanoseconds:>10} {to_first:>10} {to_limit:>10}", time.name)?;
            }
        }
        Ok(())
    }
}

/// A time in the unit that leaves digits before the point.
fn duration(nanoseconds: f64) -> String {
    if nanoseconds < 1e3 { format!("{nanoseconds:.1} ns") } else { format!("{:.2} µs", nanoseconds / 1e3) }
}
