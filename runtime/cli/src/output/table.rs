//! An analysis for people, at a terminal.

use std::fmt::Write as _;

use carvallo::{Change, CriticalKind, CriticalSpeed, ModeValue, StableRange};

use super::{FAINT, GOOD, HEADING, is_stable, matrices};
use crate::analysis::{Analysis, Row};
use crate::number::{shortest, six_decimals};

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn table(analysis: &Analysis, rows: &[Row]) -> String {
    let mut text = String::new();
    heading(analysis, &mut text);
    write_matrices(analysis, &mut text);
    critical_speeds(analysis, &mut text);
    eigenvalues(analysis, rows, &mut text);
    text
}

fn heading(analysis: &Analysis, text: &mut String) {
    let bicycle = &analysis.bicycle;
    let kind = bicycle.kind.as_ref().map(|kind| format!(": {kind}")).unwrap_or_default();
    let _ = writeln!(text, "{HEADING}{}{HEADING:#}{kind}", bicycle.name);
    if let Some(source) = &bicycle.source {
        let _ = writeln!(text, "{FAINT}{source}{FAINT:#}");
    }
}

fn write_matrices(analysis: &Analysis, text: &mut String) {
    let coordinates: Vec<String> =
        analysis.bicycle.info().coordinates.iter().map(|q| format!("{} {}", q.label, q.name)).collect();
    let equations = "M q'' + v C1 q' + (g K0 + v² K2) q = f";
    let _ = writeln!(text, "\n{HEADING}Equations of motion{HEADING:#}  {equations}");
    let _ = writeln!(text, "  with q = ({}) and g = {} N/kg", coordinates.join(", "), shortest(analysis.gravity));
    for (name, unit, rows) in matrices(&analysis.coefficients) {
        // Adding zero turns -0 into 0.
        let [[a, b], [c, d]] = rows.map(|row| row.map(|value| shortest(value + 0.0)));
        let _ = writeln!(text, "  {name:<3}{unit:<7}{a:>22}{b:>22}");
        let _ = writeln!(text, "  {:<10}{c:>22}{d:>22}", "");
    }
}

fn critical_speeds(analysis: &Analysis, text: &mut String) {
    let _ = writeln!(text, "\n{HEADING}Critical speeds{HEADING:#} (m/s)");
    for CriticalSpeed { kind, speed, eigenvalue, change, .. } in &analysis.stability.critical_speeds {
        let (name, at) = match kind {
            CriticalKind::Weave => ("weave", format!("±{:.4} i", eigenvalue.im.abs())),
            CriticalKind::Capsize => ("capsize", "0".to_owned()),
            CriticalKind::DoubleRoot => ("double root", format!("{:.4}", eigenvalue.re)),
        };
        let change = match change {
            Change::Stabilizes => "becomes stable",
            Change::Destabilizes => "becomes unstable",
            Change::Merges => "two real eigenvalues become an oscillation",
            Change::Splits => "an oscillation becomes two real eigenvalues",
            Change::Touches => "nothing changes for longer",
        };
        let _ = writeln!(text, "  {name:<13}{:<20}{FAINT}{change}, at λ = {at}{FAINT:#}", shortest(*speed));
    }
    if analysis.stability.critical_speeds.is_empty() {
        let _ = writeln!(text, "  none");
    }
    let ranges = &analysis.stability.stable_ranges;
    for StableRange { from, to } in ranges {
        let _ = match to {
            Some(to) => writeln!(text, "  {GOOD}self-stable from {} to {} m/s{GOOD:#}", shortest(*from), shortest(*to)),
            None => writeln!(text, "  {GOOD}self-stable above {} m/s{GOOD:#}", shortest(*from)),
        };
    }
    if ranges.is_empty() {
        let _ = writeln!(text, "  stable by itself at no speed");
    }
}

fn eigenvalues(analysis: &Analysis, rows: &[Row], text: &mut String) {
    let decimals = rows.iter().map(|row| row.speed.to_string().split_once('.').map_or(0, |(_, tail)| tail.len()));
    let decimals = decimals.max().unwrap_or(0);
    let _ = writeln!(text, "\n{HEADING}Eigenvalues{HEADING:#} (1/s)");
    let _ = writeln!(text, "{FAINT}{:>9}{:>18}{:>18}     weave{FAINT:#}", "v (m/s)", "castering", "capsize");
    for Row { speed, values: [castering, capsize, weave @ ..] } in rows {
        let (style, mark) = match is_stable(&analysis.stability.stable_ranges, *speed) {
            true => (GOOD, "  stable"),
            false => (anstyle::Style::new(), ""),
        };
        let [castering, capsize] = [castering, capsize].map(|mode| number(mode.value.re, mode.value.im));
        let weave = pair(weave);
        let speed = if decimals > 6 { shortest(*speed) } else { format!("{speed:.decimals$}") };
        let _ = writeln!(text, "{style}{speed:>9}{castering:>18}{capsize:>18}{weave:>26}{mark}{style:#}");
    }
}

fn number(re: f64, im: f64) -> String {
    if im == 0.0 {
        six_decimals(re)
    } else if re.abs().max(im.abs()) < 1e5 {
        format!("{re:.4}{im:+.4}i")
    } else {
        format!("{re:.2e}{im:+.2e}i")
    }
}

/// Two eigenvalues: a complex pair as one, others side by side.
fn pair([first, second]: &[ModeValue; 2]) -> String {
    let (first, second) = (first.value, second.value);
    if first.im == 0.0 && second.im == 0.0 {
        format!("{:>10}, {:>10}", six_decimals(first.re), six_decimals(second.re))
    } else if first.re == second.re && first.im == -second.im {
        format!("{:>10} ± {:>9} i", six_decimals(first.re), six_decimals(first.im.abs()))
    } else {
        // Weave in a pair with another mode.
        format!("{}, {}", number(first.re, first.im), number(second.re, second.im))
    }
}
