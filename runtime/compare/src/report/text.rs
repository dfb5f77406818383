//! A report as people read it.

use std::fmt;

use carvallo::ModelInfo;

use super::{Report, SideReport, TaskReport};
use crate::accuracy::{Accuracy, Worst};
use crate::designs::Design;
use crate::explain::Explanation;
use crate::reference::ReferenceKind;

/// The width of names of rows.
const NAMES: usize = 36;
/// So many parameters of a design stand in a line.
const FEW: usize = 8;
/// Digits of values that are shown beside each other.
const DIGITS: usize = 9;

/// The errors of a side in a number type.
type Find = fn(&SideReport) -> Option<&Accuracy>;

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.sides.iter().map(|side| side.name.as_str()).collect();
        let designs = match self.seed {
            Some(seed) => {
                let sets = if self.model.sets.is_empty() { "" } else { "its sets and " };
                format!("{sets}random designs (seed {seed}), {} in all", self.designs)
            }
            None => format!("{} designs", self.designs),
        };
        let reference = match self.reference {
            ReferenceKind::Formulas => "its formulas",
            ReferenceKind::Program => "its program",
        };
        writeln!(f, "{}: {} beside {reference} in 320 bits, at {designs}\n", self.model.name, names.join(", "))?;
        self.table(f)?;
        for side in &self.sides {
            self.worst(f, side)?;
        }
        for side in &self.sides {
            let SideReport { explanations, unexplained, explanations_in_single, unexplained_in_single, .. } = side;
            if !side.double.differences.is_empty() {
                side.differences(f, self.model, (&side.double, ""))?;
                told(f, explanations, unexplained)?;
            }
            let Some(single) = side.single.as_ref().filter(|single| !single.differences.is_empty()) else { continue };
            // Once where it is the same function.
            if (explanations, unexplained) != (explanations_in_single, unexplained_in_single) {
                side.differences(f, self.model, (single, " in f32"))?;
                told(f, explanations_in_single, unexplained_in_single)?;
            }
        }
        if !self.times.is_empty() {
            let note = if self.optimized { "" } else { ", which mean nothing without optimization (--release)" };
            writeln!(f, "\ntimes for a design, in turns, with quartiles{note}")?;
            self.times.iter().try_for_each(|task| task.fmt(f))?;
        }
        Ok(())
    }
}

impl Report {
    /// Operations and largest errors, a column for each side.
    fn table(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut row = |name: &str, cell: &dyn Fn(&SideReport) -> String| {
            let cells = self.sides.iter().map(|side| format!(" {:>width$}", cell(side), width = width(&side.name)));
            let line = format!("{name:NAMES$}{}", cells.collect::<String>());
            writeln!(f, "{}", line.trim_end())
        };
        row("", &|side| side.name.clone())?;
        if self.sides.iter().any(|side| side.operations.is_some()) {
            row("operations", &|side| side.operations.map_or("not counted".into(), |all| all.total().to_string()))?;
            let kinds = ["additions", "multiplications", "divisions", "negations", "roots", "trigonometric"];
            for (index, kind) in kinds.into_iter().enumerate() {
                let counts = self.sides.iter().filter_map(|side| side.operations);
                if counts.into_iter().any(|all| all.kinds()[index] > 0) {
                    let cell =
                        |side: &SideReport| side.operations.map_or("".into(), |all| all.kinds()[index].to_string());
                    row(&format!("  {kind}"), &cell)?;
                }
            }
        }
        for (scalar, accuracy) in [("f64", SideReport::in_double as Find), ("f32", SideReport::in_single)] {
            if self.sides.iter().any(|side| accuracy(side).is_some()) {
                let name = format!("largest error in {scalar}, ulp of terms");
                row(&name, &|side| ulps(accuracy(side), |accuracy| accuracy.ulps))?;
                let name = "  of the largest entry of the matrix";
                row(name, &|side| ulps(accuracy(side), |accuracy| accuracy.ulps_of_matrix))?;
            }
        }
        Ok(())
    }

    /// Where a side that is right is farthest off.
    fn worst(&self, f: &mut fmt::Formatter<'_>, side: &SideReport) -> fmt::Result {
        match &side.double.worst {
            Some(Worst { entry, computed, exact, design, .. }) if side.double.differences.is_empty() => {
                let Design { name: at, .. } = design;
                writeln!(f, "`{}` is farthest off in {entry} at {at}: {computed:?}, exactly {exact:?}", side.name)
            }
            _ => Ok(()),
        }
    }
}

impl SideReport {
    fn in_double(&self) -> Option<&Accuracy> {
        Some(&self.double)
    }

    fn in_single(&self) -> Option<&Accuracy> {
        self.single.as_ref()
    }

    /// Where a side differs in a number type, with how that is said.
    fn differences(
        &self,
        f: &mut fmt::Formatter<'_>,
        model: &ModelInfo,
        (Accuracy { differences, .. }, scalar): (&Accuracy, &str),
    ) -> fmt::Result {
        let name = &self.name;
        let entries = if differences.len() == 1 { "one entry" } else { &*format!("{} entries", differences.len()) };
        writeln!(f, "\n`{name}` differs{scalar} in {entries}; where each is farthest off:")?;
        for Worst { entry, formula, computed, exact, design, .. } in differences {
            let (computed, exact) = (number(*computed), number(*exact));
            let equals = if formula.is_empty() { "" } else { " = " };
            writeln!(f, "  {entry}{equals}{formula}")?;
            writeln!(f, "    is {computed} and should be {exact}")?;
            writeln!(f, "    at {}{}", design.name, parameters(model, design))?;
        }
        Ok(())
    }
}

/// What was done.
fn told(f: &mut fmt::Formatter<'_>, explanations: &[Explanation], unexplained: &[String]) -> fmt::Result {
    writeln!(f, "what was done:")?;
    for Explanation { entries, causes } in explanations {
        let (first, others) = causes.split_first().expect("a cause");
        writeln!(f, "  {first} ({})", entries.join(", "))?;
        others.iter().try_for_each(|other| writeln!(f, "    or {other}"))?;
    }
    if !unexplained.is_empty() {
        writeln!(f, "  no slip explains {}", unexplained.join(", "))?;
    }
    Ok(())
}

/// The parameters of a design, if they are few: `: r = 0.5, m = 2`.
fn parameters(model: &ModelInfo, Design { parameters, .. }: &Design) -> String {
    if parameters.len() > FEW {
        return String::new();
    }
    let all = model.parameters.iter().zip(parameters).map(|(parameter, value)| format!("{} = {value}", parameter.name));
    format!(": {}", all.collect::<Vec<_>>().join(", "))
}

impl fmt::Display for TaskReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "  {}", self.task)?;
        let names = self.times.iter().map(|time| time.name.chars().count()).max().unwrap_or(0).max(NAMES - 4);
        for time in &self.times {
            let [low, high] = time.quartiles.map(|nanoseconds| format!("{nanoseconds:.1}"));
            let [least, most] = time.quartiles_to_first.map(|ratio| format!("{ratio:.2}"));
            writeln!(
                f,
                "    {:names$} {:>8.1} ns ({low} to {high}), {:>5.2} of the first ({least} to {most})",
                time.name, time.nanoseconds, time.to_first
            )?;
        }
        Ok(())
    }
}

fn width(name: &str) -> usize {
    name.chars().count().max(12)
}

fn ulps(accuracy: Option<&Accuracy>, ulps: fn(&Accuracy) -> f64) -> String {
    match accuracy {
        None => "no function".into(),
        Some(accuracy) if !accuracy.differences.is_empty() => "differs".into(),
        Some(accuracy) => format!("{:.2}", ulps(accuracy)),
    }
}

/// A value with as many digits as tell two formulas apart.
fn number(value: f64) -> String {
    let rounded = format!("{value:.DIGITS$e}");
    rounded.parse::<f64>().map_or(rounded, |value| value.to_string())
}
