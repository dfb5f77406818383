//! An analysis for people, at a terminal.

use std::fmt::Write as _;

use carvallo::{Change, Complex, CriticalKind, CriticalSpeed, Mode, ModeValue, Stability, Verdict};
use carvallo_design::feedback::Law;
use carvallo_design::number::{fixed, shortest};
use carvallo_design::{Design, Shape};
use carvallo_plot::analysis::{self, Analysis, ModeRow, ROUNDING, Rows};

use super::columns::{speeds, width};
use super::ranges::{write_ranges, write_undecided};
use super::shapes::write_shapes;
use super::{FAINT, GOOD, HEADING, branches, equations, sorted};

/// With eigenvectors at each speed, if there are any.
///
/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn render_table(analysis: &Analysis, rows: &Rows, shapes: Option<&[Vec<Shape>]>) -> String {
    let mut text = String::new();
    write_heading(&analysis.design, &mut text);
    equations::write_equations(&analysis.design, &mut text);
    if analysis.design.model.depends_on_speed() {
        write_critical_speeds(analysis, &mut text);
    }
    match rows {
        Rows::Modes(rows) => write_modes(analysis, rows, &mut text),
        Rows::Branches(rows) => branches::write_eigenvalues(rows, &analysis.unit, &mut text),
        Rows::Sorted(rows) => sorted::write_eigenvalues(rows, &mut text),
    }
    if let Some(shapes) = shapes {
        write_shapes(analysis, rows, shapes, &mut text);
    }
    text
}

/// What it is, and where its parameters come from.
pub fn write_heading(design: &Design, text: &mut String) {
    let kind = design.kind.as_ref().map(|kind| format!(": {kind}")).unwrap_or_default();
    let _ = writeln!(text, "{HEADING}{}{HEADING:#}{kind}", design.title());
    if let Some(source) = &design.source {
        let _ = writeln!(text, "{FAINT}{source}{FAINT:#}");
    }
    for Law { written, .. } in &design.feedback {
        let _ = writeln!(text, "feedback {written}");
    }
}

fn write_critical_speeds(analysis: &Analysis, text: &mut String) {
    let Analysis { stability, unit, .. } = analysis;
    let shown = |critical: &CriticalSpeed| shortest(unit.value(critical.speed));
    let _ = writeln!(text, "\n{HEADING}Critical speeds{HEADING:#} ({})", unit.written);
    let speeds: Vec<String> = stability.critical_speeds.iter().map(shown).collect();
    let width = width(&speeds, 20);
    for critical in &stability.critical_speeds {
        let name = analysis::name(critical, analysis.design.info()).replace('_', " ");
        let (at, change) = (critical_eigenvalue(critical), describe_effect(stability, critical));
        let speed = shown(critical);
        let _ = writeln!(text, "  {name:<13}{speed:<width$}{FAINT}{change}, at λ = {at}{FAINT:#}");
    }
    if stability.critical_speeds.is_empty() {
        let _ = writeln!(text, "  {}", if stability.undecided.is_empty() { "none" } else { "none found" });
    }
    write_undecided(stability, unit, text);
    write_ranges(stability, unit, text);
}

/// The eigenvalue, or the pair, at a critical speed.
pub fn critical_eigenvalue(CriticalSpeed { kind, eigenvalue, .. }: &CriticalSpeed) -> String {
    match kind {
        CriticalKind::Weave => format!("±{} i", fixed(eigenvalue.im.abs(), 4)),
        CriticalKind::Capsize => "0".to_owned(),
        CriticalKind::DoubleRoot => double_root(*eigenvalue),
    }
}

/// Where two eigenvalues meet; off the real axis their conjugates meet as well.
fn double_root(eigenvalue: Complex<f64>) -> String {
    let [re, im] = [eigenvalue.re, eigenvalue.im.abs()].map(|part| fixed(part, 4));
    if eigenvalue.im == 0.0 {
        re
    } else if eigenvalue.re.abs() <= ROUNDING * eigenvalue.norm() {
        format!("±{im} i")
    } else {
        format!("{re} ± {im} i")
    }
}

/// What changes at a critical speed: of the mode, and of the motion, which another mode may keep unstable.
pub fn describe_effect(stability: &Stability, critical: &CriticalSpeed) -> &'static str {
    effect(critical.change, stability.verdicts_around(critical))
}

/// The same from what the mode does and the verdicts below and above.
pub fn effect(change: Change, verdicts: [Verdict; 2]) -> &'static str {
    match (change, verdicts) {
        (Change::Stabilizes, [_, Verdict::Stable]) => "becomes stable",
        (Change::Stabilizes, [_, Verdict::Marginal]) => "is unstable no longer",
        (Change::Stabilizes, [_, Verdict::Unstable]) => "becomes stable, but another mode is unstable",
        (Change::Destabilizes, [Verdict::Unstable, _]) => "becomes unstable, as another mode is already",
        (Change::Destabilizes, _) => "becomes unstable",
        (Change::Merges, _) => "two real eigenvalues become an oscillation",
        (Change::Splits, _) => "an oscillation becomes two real eigenvalues",
        (Change::Touches, _) => "nothing changes for longer",
    }
}

/// The eigenvalues of named modes, and of those without a name, each column from top to bottom.
pub struct ModeCells {
    pub casterings: Vec<String>,
    pub capsizes: Vec<String>,
    /// With their parts below each other.
    pub weaves: Vec<String>,
    pub others: Vec<String>,
}

impl ModeCells {
    pub fn of(rows: &[ModeRow]) -> Self {
        let of = |mode: Mode| rows.iter().map(move |row| with_mode(row, |other| other == mode));
        let one = |values: Vec<ModeValue>| if values.is_empty() { ABSENT.to_owned() } else { joined(&values) };
        let is_nameless = |mode| matches!(mode, Mode::Real | Mode::Oscillatory);
        Self {
            casterings: of(Mode::Castering).map(one).collect(),
            capsizes: of(Mode::Capsize).map(one).collect(),
            weaves: aligned(&of(Mode::Weave).map(|values| pair(&values)).collect::<Vec<_>>()),
            others: rows.iter().map(|row| joined(&with_mode(row, is_nameless))).collect(),
        }
    }
}

fn write_modes(analysis: &Analysis, rows: &[ModeRow], text: &mut String) {
    let speeds = speeds(rows, &analysis.unit);
    let ModeCells { casterings, capsizes, weaves, others } = ModeCells::of(rows);
    let [v, first, second] = [width(&speeds, 9), width(&casterings, 18), width(&capsizes, 18)];
    let third = width(&weaves, 26);
    // A column of its own only where there is one.
    let has_others = others.iter().any(|other| !other.is_empty());
    let fourth = if has_others { width(&others, 16) } else { 0 };
    let others_title = if has_others { "without a name" } else { "" };
    let _ = writeln!(text, "\n{HEADING}Eigenvalues{HEADING:#} (1/s)");
    let title = format!(
        "{:>v$}{:>first$}{:>second$}     {:<width$}{others:>fourth$}",
        format!("v ({})", analysis.unit.written),
        "castering",
        "capsize",
        "weave",
        width = third - 5,
        others = others_title
    );
    let _ = writeln!(text, "{FAINT}{}{FAINT:#}", title.trim_end());
    for (index, row) in rows.iter().enumerate() {
        let (style, mark) = match analysis.is_stable(row.speed) {
            true => (GOOD, "  stable"),
            false => (anstyle::Style::new(), ""),
        };
        let (speed, castering, capsize, weave) = (&speeds[index], &casterings[index], &capsizes[index], &weaves[index]);
        let line =
            format!("{speed:>v$}{castering:>first$}{capsize:>second$}{weave:>third$}{:>fourth$}{mark}", others[index]);
        let _ = writeln!(text, "{style}{}{style:#}", line.trim_end());
    }
}

/// What stands where no eigenvalue has the name of the column.
const ABSENT: &str = "-";

/// The values of a row whose modes are wanted.
fn with_mode(row: &ModeRow, is_wanted: impl Fn(Mode) -> bool) -> Vec<ModeValue> {
    row.values.iter().copied().filter(|value| is_wanted(value.mode)).collect()
}

fn number(ModeValue { value, .. }: &ModeValue) -> String {
    if value.im == 0.0 {
        return fixed(value.re, 6);
    }
    let sign = if value.im < 0.0 { '-' } else { '+' };
    format!("{}{sign}{}i", fixed(value.re, 4), fixed(value.im.abs(), 4))
}

/// Any eigenvalues side by side.
fn joined(values: &[ModeValue]) -> String {
    values.iter().map(number).collect::<Vec<_>>().join(", ")
}

/// The eigenvalues of weave: a complex pair as one, others side by side; with what stands between and after them.
fn pair(values: &[ModeValue]) -> [String; 4] {
    match values {
        [ModeValue { value: a, .. }, ModeValue { value: b, .. }] if a.im != 0.0 && a.re == b.re && a.im == -b.im => {
            [fixed(a.re, 6), " ± ".to_owned(), fixed(a.im.abs(), 6), " i".to_owned()]
        }
        [others @ .., last] => {
            let between = if others.is_empty() { "  " } else { ", " };
            // Real, or each in a pair with another mode.
            [joined(others), between.to_owned(), number(last), String::new()]
        }
        [] => [String::new(), "  ".to_owned(), ABSENT.to_owned(), String::new()],
    }
}

/// The pairs with their parts below each other.
fn aligned(pairs: &[[String; 4]]) -> Vec<String> {
    let longest = |part: usize| pairs.iter().map(|pair| pair[part].chars().count()).max().unwrap_or(0);
    let (first, second) = (longest(0).max(10), longest(2).max(9));
    let text = |[a, between, b, after]: &[String; 4]| {
        // Without what stands after it, the second ends where it would.
        let second = if after.is_empty() { second + 1 } else { second };
        format!("{a:>first$}{between}{b:>second$}{after}")
    };
    pairs.iter().map(text).collect()
}
