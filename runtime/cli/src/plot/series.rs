//! What is drawn of the eigenvalues, and how: curves that belong together, with their name.

use carvallo::Mode;

use super::colors::color;
use super::curves::{Curve, Pair, alone, pairs};
use super::ordered;
use super::scene::{Color, Paint, dashed, line};
use crate::analysis::{ModeRow, Rows};

/// Curves of one colour and name.
pub struct Series {
    pub name: String,
    pub color: Color,
    pub paint: Paint,
    /// The colour of the border of a line that stands for two modes.
    pub border: Option<Color>,
    /// Whether the name stands beside the curve; else it does beside another one of the same modes.
    pub has_label: bool,
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

/// Everything that there is to draw, in painting order.
pub fn series(rows: &Rows) -> Vec<Series> {
    match rows {
        Rows::Modes(rows) => modes(rows),
        // All of them in one colour.
        Rows::Sorted(rows) => vec![
            Series::imaginary("imaginary parts".to_owned(), color(Mode::Castering), ordered::imaginary(rows)),
            Series::real("real parts".to_owned(), color(Mode::Castering), ordered::real(rows)),
        ],
    }
}

fn modes(rows: &[ModeRow]) -> Vec<Series> {
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
