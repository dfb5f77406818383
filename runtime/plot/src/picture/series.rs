//! What is drawn of the eigenvalues, and how: curves that belong together, with their name.

use carvallo::{Complex, Mode};

use super::colors::{color, other};
use super::curves::{Curve, Pair, alone, extend, pairs};
use super::scene::{Color, Paint, dashed, line};
use crate::analysis::strands::Strand;
use crate::analysis::{Eigenvalues, ModeRow, Row};

/// Curves of one colour and name.
pub struct Series {
    /// The mode or modes, and which part of their eigenvalues.
    pub name: String,
    /// Of the line.
    pub color: Color,
    /// Dashed for imaginary parts beside real ones.
    pub paint: Paint,
    /// The colour of the border of a line that stands for two modes.
    pub border: Option<Color>,
    /// Whether the name stands beside the curve; else it does beside another one of the same modes.
    pub has_label: bool,
    /// Speeds in m/s with eigenvalues in 1/s.
    pub curves: Vec<Curve>,
}

/// Real parts are lines, imaginary parts dashed and lighter.
impl Series {
    fn real(name: String, color: Color, curves: Vec<Curve>) -> Self {
        Self { name, color, paint: line(2.4), border: None, has_label: true, curves }
    }

    fn imaginary(name: String, color: Color, curves: Vec<Curve>) -> Self {
        Self { paint: dashed(1.8, [7.0, 5.0]), ..Self::real(name, color.lighter(0.35), curves) }
    }
}

/// The real parts and the imaginary parts of branches, each for a graph of its own, in one colour for each strand.
pub fn strands(rows: &[Row<Eigenvalues>]) -> [Vec<Series>; 2] {
    let strands = crate::analysis::strands::strands(rows);
    let (mut real, mut imaginary) = (Vec::new(), Vec::new());
    let (mut named, mut nameless) = (Vec::new(), 0);
    for Strand { branches, modes, title } in strands {
        let color = match modes.first() {
            Some(mode) if !named.contains(mode) => color(*mode),
            _ => {
                nameless += 1;
                other(nameless - 1)
            }
        };
        named.extend(modes);
        let values = |branch: usize| rows.iter().map(move |row| (row.speed, row.values.values[branch].value));
        let parts = |branch: &usize| values(*branch).map(|(speed, value)| (speed, value.re)).collect();
        real.push(Series::real(title.clone(), color, branches.iter().map(parts).collect()));
        let oscillating =
            branches.iter().flat_map(|&branch| oscillating(&values(branch).collect::<Vec<_>>())).collect();
        imaginary.push(Series::real(title, color, oscillating));
    }
    [real, imaginary]
}

/// The imaginary parts above zero of a branch. Where a pair begins or ends its curve reaches the axis.
fn oscillating(values: &[(f64, Complex<f64>)]) -> Vec<Curve> {
    let mut curves = Vec::new();
    for (index, &(speed, value)) in values.iter().enumerate() {
        let near = [index.checked_sub(1), Some(index + 1)].into_iter().flatten();
        let begins = value.im == 0.0 && near.flat_map(|near| values.get(near)).any(|(_, value)| value.im > 0.0);
        extend(&mut curves, (value.im > 0.0 || begins).then_some((speed, value.im)));
    }
    curves.retain(|curve| curve.len() > 1);
    curves
}

/// The modes of a bicycle, in painting order.
pub fn modes(rows: &[ModeRow]) -> Vec<Series> {
    let mut series = Vec::new();
    let pairs = pairs(rows);
    let oscillates = |mode: Mode| pairs.iter().any(|pair| pair.modes == (mode, mode));
    let [mut alone, mut of_pairs] = [Vec::new(), Vec::new()];
    for mode in [Mode::Castering, Mode::Capsize, Mode::Weave, Mode::Real, Mode::Oscillatory] {
        let name = if oscillates(mode) { format!("{mode}, real part") } else { mode.to_string() };
        alone.push(Series::real(name, color(mode), self::alone(rows, mode)));
    }
    for Pair { modes: (first, second), real, imaginary } in pairs {
        let name = if first == second { first.to_string() } else { format!("{first}/{second}") };
        if first != second {
            // The first shows as a border of the second.
            let both = Series::real(format!("{name}, real part"), color(second), real);
            of_pairs.push(Series { border: Some(color(first)), has_label: false, ..both });
        }
        of_pairs.push(Series::imaginary(format!("{name}, imaginary part"), color(second), imaginary));
    }
    series.extend(of_pairs);
    series.extend(alone);
    series
}
