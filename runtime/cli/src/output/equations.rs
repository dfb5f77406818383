//! The equations of motion: the terms that a model has, and its matrices with their units.

use std::fmt::Write as _;

use carvallo::{CoordinateInfo, MatrixName, ModelInfo, States};
use carvallo_design::Design;
use carvallo_design::number::{fixed, shortest};
use carvallo_plot::data::{Matrix, matrices};

use super::HEADING;
use super::columns::{LINE, width};

/// The equations with their matrices, for people. Writing to a string cannot fail, so that the results of `write!` are
/// dropped.
pub fn write_equations(design: &Design, text: &mut String) {
    let info = design.info();
    let coordinates: Vec<String> = info.coordinates.iter().map(coordinate).collect();
    let gravity = design.gravity().filter(|_| info.matrices.contains(&MatrixName::K0));
    let gravity = gravity.map(|gravity| format!(" and g = {} N/kg", shortest(gravity))).unwrap_or_default();
    let _ = writeln!(text, "\n{HEADING}Equations of motion{HEADING:#}  {}", equation(info));
    let _ = writeln!(text, "  with q = ({}){gravity}", coordinates.join(", "));
    for (states, what) in [(States::Rate, "rate"), (States::Position, "position")] {
        let only = info.coordinates.iter().filter(|coordinate| coordinate.states == states);
        let names: Vec<&str> = only.map(|coordinate| coordinate.label).collect();
        if !names.is_empty() {
            let _ = writeln!(text, "  of {} only the {what} is a state", names.join(", "));
        }
    }
    for line in matrix_lines(&matrices(design), &entries(design)) {
        let _ = writeln!(text, "{line}");
    }
}

/// The rows of each matrix as they are printed: all digits, unless that would make the lines long.
pub fn entries(design: &Design) -> Vec<Vec<Vec<String>>> {
    let matrices = matrices(design);
    let entries = |number: &dyn Fn(f64) -> String| -> Vec<Vec<Vec<String>>> {
        let row = |row: &Vec<f64>| row.iter().map(|value| number(*value)).collect();
        matrices.iter().map(|matrix| matrix.rows.iter().map(row).collect()).collect()
    };
    // Adding zero turns -0 into 0.
    let exact = |value: f64| shortest(value + 0.0);
    let rounded = |value: f64| if value == 0.0 { exact(value) } else { fixed(value, 6) };
    let all = entries(&exact);
    let is_long = matrix_lines(&matrices, &all).iter().any(|line| line.chars().count() > LINE);
    if is_long { entries(&rounded) } else { all }
}

fn matrix_lines(matrices: &[Matrix], rows: &[Vec<Vec<String>>]) -> Vec<String> {
    // The fewer columns there are, the wider they may be.
    let least = matrices.first().map_or(0, |matrix| 44 / matrix.rows.len().max(2));
    let width = width(rows.iter().flatten().flatten(), least);
    let names = matrices.iter().map(|matrix| matrix.name.len() + 1).fold(3, usize::max);
    let mut lines = Vec::new();
    for (Matrix { name, unit, .. }, rows) in matrices.iter().zip(rows) {
        for (index, row) in rows.iter().enumerate() {
            let (name, unit) = if index == 0 { (*name, *unit) } else { ("", "") };
            let row: String = row.iter().map(|value| format!("{value:>width$}")).collect();
            lines.push(format!("  {name:<names$}{unit:<7}{row}"));
        }
    }
    lines
}

/// `M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v² K2) q = f` with the terms that the model has.
pub fn equation(info: &ModelInfo) -> String {
    let sum = |terms: &[(MatrixName, &'static str)], factor: &str| {
        let terms = terms.iter().filter(|(matrix, _)| info.matrices.contains(matrix));
        match terms.map(|(_, term)| *term).collect::<Vec<_>>()[..] {
            [] => String::new(),
            [term] => format!(" + {term} {factor}"),
            ref terms => format!(" + ({}) {factor}", terms.join(" + ")),
        }
    };
    let damping = sum(&[(MatrixName::Cm1, "C-1/v"), (MatrixName::C0, "C0"), (MatrixName::C1, "v C1")], "q'");
    let stiffness =
        [(MatrixName::Kc, "Kc"), (MatrixName::K0, "g K0"), (MatrixName::K1, "v K1"), (MatrixName::K2, "v² K2")];
    let stiffness = sum(&stiffness, "q");
    format!("M q''{damping}{stiffness} = f")
}

/// What a coordinate is, and its symbol: `lean phi`.
pub fn coordinate(CoordinateInfo { label, name, .. }: &CoordinateInfo) -> String {
    if label == name { (*name).to_owned() } else { format!("{label} {name}") }
}

#[cfg(test)]
mod tests {
    use super::equation;
    use carvallo_design::{MODELS, WHIPPLE};

    #[test]
    fn equations_have_the_terms_of_their_model() {
        let of = |name: &str| MODELS.iter().find(|model| model.is_called(name)).map(|model| equation(model.info));
        assert_eq!(equation(WHIPPLE.info), "M q'' + v C1 q' + (g K0 + v² K2) q = f");
        assert_eq!(of("Pendulum").as_deref(), Some("M q'' + C0 q' + g K0 q = f"));
        assert_eq!(of("ThreePipes").as_deref(), Some("M q'' + (C0 + v C1) q' + (Kc + g K0 + v² K2) q = f"));
    }
}
