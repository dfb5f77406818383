//! A report as an assertion.

use super::Report;

/// What a comparison must keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The largest error of an entry in units of the last place of the size of its terms, of every side and in both number
    /// types. Each operation of a formula adds half of one at most.
    pub ulps: f64,
    /// How many times as long the generated code may take as any function by hand, in every task but those of other
    /// sizes: 1.1 is a tenth more. It needs times, of a program with optimization.
    pub times_by_hand: Option<f64>,
    /// How many times as many operations the generated code may do as any function by hand that is counted.
    pub operations_by_hand: Option<f64>,
}

/// 16 units in the last place, and nothing of time and operations.
impl Default for Limits {
    fn default() -> Self {
        Self { ulps: 16.0, times_by_hand: None, operations_by_hand: None }
    }
}

impl Report {
    /// Asserts that nothing differs, and that the limits are kept to.
    ///
    /// # Panics
    /// If it is not so: with what, where, its value and the limit, and then the report.
    #[track_caller]
    pub fn assert(&self, limits: Limits) {
        let broken = self.broken(limits);
        assert!(broken.is_empty(), "{}: {}\n\n{self}", self.model.name, broken.join("; "));
    }

    /// What does not keep to the limits, each in a sentence; nothing if all does.
    #[must_use]
    pub fn broken(&self, Limits { ulps, times_by_hand, operations_by_hand }: Limits) -> Vec<String> {
        let mut broken = self.inexact(ulps);
        broken.extend(times_by_hand.map(|most| self.slow(most)).unwrap_or_default());
        broken.extend(operations_by_hand.map(|most| self.laborious(most)).unwrap_or_default());
        broken
    }

    fn inexact(&self, most: f64) -> Vec<String> {
        let mut broken = Vec::new();
        for side in &self.sides {
            let name = &side.name;
            if !side.double.differences.is_empty() {
                let entries: Vec<&str> = side.double.differences.iter().map(|worst| worst.entry.as_str()).collect();
                broken.push(format!("`{name}` differs in {}", entries.join(", ")));
                continue;
            }
            if let Some(single) = side.single.as_ref().filter(|single| !single.differences.is_empty()) {
                let entries: Vec<&str> = single.differences.iter().map(|worst| worst.entry.as_str()).collect();
                broken.push(format!("`{name}` differs in f32 in {}", entries.join(", ")));
                continue;
            }
            for (scalar, accuracy) in [("f64", Some(&side.double)), ("f32", side.single.as_ref())] {
                if let Some(worst) = accuracy.and_then(|accuracy| accuracy.worst.as_ref()).filter(|it| it.ulps > most) {
                    broken.push(format!(
                        "{} of `{name}` in {scalar} is off by {:.1} units in the last place of its terms at {}, of which {most} are allowed",
                        worst.entry, worst.ulps, worst.design.name
                    ));
                }
            }
        }
        broken
    }

    fn slow(&self, most: f64) -> Vec<String> {
        if self.times.is_empty() {
            return vec!["no time was taken, which a limit needs: `timed`".into()];
        }
        if !self.optimized {
            return vec!["times of a program without optimization cannot be limited: `--release`".into()];
        }
        let mut broken = Vec::new();
        for task in &self.times {
            let Some((generated, others)) = task.times.split_first() else { continue };
            for hand in others.iter().filter(|other| self.sides[1..].iter().any(|side| side.name == other.name)) {
                // Of each round the ratio, which other work on the machine moves least.
                let ratio = 1.0 / hand.to_first;
                if ratio > most {
                    broken.push(format!(
                        "{}: `{}` takes {ratio:.2} times as long as `{}`, of which {most} are allowed",
                        task.task, generated.name, hand.name
                    ));
                }
            }
        }
        broken
    }

    fn laborious(&self, most: f64) -> Vec<String> {
        let Some((generated, others)) = self.sides.split_first() else { return Vec::new() };
        let Some(own) = generated.operations else { return vec!["the generated code was not counted".into()] };
        let broken = others.iter().filter_map(|hand| {
            let total = hand.operations?.total();
            (own.total() as f64 > most * total as f64).then(|| {
                format!(
                    "`{}` does {} operations, `{}` {total}, of which {most} times as many are allowed",
                    generated.name,
                    own.total(),
                    hand.name
                )
            })
        });
        broken.collect()
    }
}
