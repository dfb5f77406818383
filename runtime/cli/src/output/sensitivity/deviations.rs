//! Standard deviations of critical speeds and matrices for people, and where they come from.

use std::fmt::Write as _;

use carvallo_design::number::shortest;
use carvallo_plot::analysis::name;
use carvallo_plot::analysis::sensitivity::{Changes, Derivatives};
use carvallo_plot::data::matrices;

use crate::output::columns::width;
use crate::output::{FAINT, HEADING};

/// So many of the parameters that contribute most are named.
const NAMED: usize = 4;

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn write_deviations(changes: &Changes, text: &mut String) {
    let Some(deviations) = &changes.deviations else { return };
    let (given, all) = (deviations.iter().filter(|&&deviation| deviation > 0.0).count(), deviations.len());
    let together = match changes.design.covariance {
        Some(_) => "with their correlations",
        None => "taken to be independent",
    };
    let _ = writeln!(
        text,
        "\n{HEADING}Standard deviations{HEADING:#}  to first order, from those of {given} of {all} parameters, {together}"
    );
    let (ranked, unit) = (changes.ranked(), changes.of_speeds());
    let speeds: Vec<String> = ranked
        .iter()
        .map(|(critical, derivatives)| {
            with_deviation(unit.value(critical.speed), unit.value(derivatives.deviation.unwrap_or(0.0)))
        })
        .collect();
    let column = width(&speeds, 20);
    for ((critical, derivatives), speed) in ranked.iter().zip(&speeds) {
        let kind = name(critical, changes.design.info()).replace('_', " ");
        let parts = contributions(changes, derivatives);
        let _ = writeln!(text, "  {kind:<10}{speed:<column$}{:<6}{FAINT}{parts}{FAINT:#}", unit.unit());
    }
    write_matrices(changes, text);
}

/// The parameters that contribute most to the variance, with their shares.
pub fn contributions(changes: &Changes, derivatives: &Derivatives) -> String {
    let shares = derivatives.variance_shares.as_deref().unwrap_or_default();
    let mut order: Vec<usize> = (0..shares.len()).filter(|&i| shares[i] >= 0.005).collect();
    order.sort_by(|&a, &b| shares[b].total_cmp(&shares[a]));
    let name = |&i: &usize| format!("{} {:.0} %", changes.design.info().parameters[i].name, 100.0 * shares[i]);
    let parts: Vec<String> = order.iter().take(NAMED).map(name).collect();
    if parts.is_empty() { String::new() } else { format!("of the variance {}", parts.join(", ")) }
}

/// The entries of each matrix, with their deviations.
pub fn matrices_with_deviations(changes: &Changes) -> Vec<Vec<Vec<String>>> {
    let found = changes.matrix_deviations.iter().flat_map(|deviations| deviations.matrices());
    let matrices = matrices(&changes.design);
    matrices
        .iter()
        .map(|matrix| {
            let deviations = found.clone().find(|(name, _)| name.name() == matrix.name).map(|(_, rows)| rows);
            let entry = |i: usize, j: usize| {
                with_deviation(matrix.rows[i][j], deviations.as_ref().map_or(0.0, |rows| rows[i][j]))
            };
            (0..matrix.rows.len()).map(|i| (0..matrix.rows.len()).map(|j| entry(i, j)).collect()).collect()
        })
        .collect()
}

fn write_matrices(changes: &Changes, text: &mut String) {
    let (matrices, rows) = (matrices(&changes.design), matrices_with_deviations(changes));
    let column = width(rows.iter().flatten().flatten(), 20);
    for (matrix, rows) in matrices.iter().zip(&rows) {
        for (index, row) in rows.iter().enumerate() {
            let (name, unit) = if index == 0 { (matrix.name, matrix.unit) } else { ("", "") };
            let row: String = row.iter().map(|entry| format!("{entry:<column$}")).collect();
            let _ = writeln!(text, "  {name:<3}{unit:<7}{}", row.trim_end());
        }
    }
}

/// `4.195 ± 0.034`: the deviation to two digits, and the value to as many decimals.
pub fn with_deviation(value: f64, deviation: f64) -> String {
    // Adding zero turns -0 into 0.
    let value = value + 0.0;
    if deviation == 0.0 {
        return shortest(value);
    }
    let decimals = 1.0 - deviation.log10().floor();
    if (0.0..=12.0).contains(&decimals) && value.abs() < 1e9 {
        let decimals = decimals as usize;
        format!("{value:.decimals$} ± {deviation:.decimals$}")
    } else {
        format!("{value:e} ± {deviation:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::with_deviation;

    #[test]
    fn deviations_have_two_digits() {
        assert_eq!(with_deviation(4.195_375_6, 0.034_2), "4.195 ± 0.034");
        assert_eq!(with_deviation(-80.951, 1.26), "-81.0 ± 1.3");
        assert_eq!(with_deviation(80.0, 0.0), "80");
        assert_eq!(with_deviation(1234.0, 123.0), "1.234e3 ± 1.2e2");
        assert_eq!(with_deviation(0.0, 2e-20), "0e0 ± 2.0e-20");
    }
}
