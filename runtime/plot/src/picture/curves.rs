//! The lines of a graph of eigenvalues, in data.

use carvallo::{Complex, Mode, sort_by};

use crate::analysis::ModeRow;

/// Speeds of the curves, enough for lines that look smooth.
const SAMPLES: u32 = 250;

/// Speeds and values.
pub type Curve = Vec<(f64, f64)>;

/// Evenly spaced speeds, or values of a parameter, and close ones around those at which curves turn sharply: critical ones, and
/// where eigenvalues meet.
pub fn samples((low, high): (f64, f64), turns: impl Iterator<Item = f64>) -> Vec<f64> {
    let step = (high - low) / f64::from(SAMPLES);
    let mut speeds: Vec<f64> = (0..SAMPLES).map(|index| low + f64::from(index) * step).chain([high]).collect();
    for turn in turns {
        let around = (0..7).map(|power| step / 4_f64.powi(power)).flat_map(|shift| [-shift, shift]);
        speeds.extend(around.chain([0.0]).map(|shift| turn + shift));
    }
    speeds.retain(|speed| (low..=high).contains(speed));
    sort_by(&mut speeds, f64::total_cmp);
    speeds
}

/// How far the vertical axis goes: most of what there is to see, and not the far end of the castering mode.
pub fn extent(values: impl Iterator<Item = Complex<f64>>) -> f64 {
    let parts = values.flat_map(|value| [value.re.abs(), value.im.abs()]);
    round(quantile(parts.filter(|&part| part > 0.0).collect(), 7).unwrap_or(1.0))
}

/// The same, but so far that something shows of each of the curves that is not short beside the longest.
pub fn extent_of_all(extent: f64, curves: &[Curve]) -> f64 {
    let longest = curves.iter().map(Vec::len).max().unwrap_or(0);
    let sizes = |curve: &Curve| quantile(curve.iter().map(|&(_, value)| value.abs()).collect(), 1);
    curves.iter().filter(|curve| 20 * curve.len() >= longest).filter_map(sizes).map(round).fold(extent, f64::max)
}

/// The number that so many tenths of the numbers are below.
pub fn quantile(mut numbers: Vec<f64>, tenths: usize) -> Option<f64> {
    sort_by(&mut numbers, f64::total_cmp);
    numbers.get(numbers.len() * tenths / 10).copied()
}

/// The next of 1, 2 and 5 times a power of ten.
fn round(size: f64) -> f64 {
    if size <= 0.0 {
        return size;
    }
    let power = 10_f64.powf(size.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    power * steps.into_iter().find(|step| step * power >= size).unwrap_or(10.0)
}

/// Two modes, or one alone, that form a complex pair.
pub struct Pair {
    pub modes: (Mode, Mode),
    pub real: Vec<Curve>,
    /// The imaginary parts without their signs.
    pub imaginary: Vec<Curve>,
}

/// The complex pairs that there are; at each speed there may be two of them, even with the same modes.
pub fn pairs(rows: &[ModeRow]) -> Vec<Pair> {
    let (castering, capsize, weave) = (Mode::Castering, Mode::Capsize, Mode::Weave);
    let alone = [(weave, weave), (Mode::Oscillatory, Mode::Oscillatory)];
    let kinds = [(castering, capsize), (castering, weave), (capsize, weave)].into_iter().chain(alone);
    let upper: Vec<Vec<Oscillation>> = rows.iter().map(oscillations).collect();
    let pair = |modes| {
        let of = |row: usize| upper[row].iter().filter(move |one| one.modes == modes).map(|one| one.value);
        let parts = |part: fn(Complex<f64>) -> f64| ranked(rows, |row| of(row).map(part).collect());
        let mut imaginary = parts(|value| value.im);
        for curve in &mut imaginary {
            let ends_between = |inside: usize, outside: usize| {
                of(outside).next().is_none() && upper[outside].len() < upper[inside].len()
            };
            reach_axis(curve, rows, ends_between);
        }
        Pair { modes, real: parts(|value| value.re), imaginary }
    };
    kinds.map(pair).filter(|pair| !pair.real.is_empty()).collect()
}

/// An eigenvalue above the real axis, and the modes of its pair, the first in order first.
struct Oscillation {
    value: Complex<f64>,
    modes: (Mode, Mode),
}

fn oscillations(row: &ModeRow) -> Vec<Oscillation> {
    let upper = (0..4).filter(|&index| row.values[index].value.im > 0.0);
    let paired = upper.filter_map(|index| {
        let (mode, other) = (row.values[index].mode, partner(row, index)?);
        Some(Oscillation { value: row.values[index].value, modes: (mode.min(other), mode.max(other)) })
    });
    paired.collect()
}

/// Where a pair begins or ends between two rows, and the eigenvalues are real beyond, its curve reaches the axis.
fn reach_axis(curve: &mut Curve, rows: &[ModeRow], ends_between: impl Fn(usize, usize) -> bool) {
    let (Some(&(from, _)), Some(&(to, _))) = (curve.first(), curve.last()) else { return };
    let (first, behind) = (rows.partition_point(|row| row.speed < from), rows.partition_point(|row| row.speed <= to));
    if first > 0 && ends_between(first, first - 1) {
        curve.insert(0, (rows[first - 1].speed, 0.0));
    }
    if behind < rows.len() && ends_between(behind - 1, behind) {
        curve.push((rows[behind].speed, 0.0));
    }
}

/// The real parts of a mode where it is not in a pair with another mode.
pub fn alone(rows: &[ModeRow], mode: Mode) -> Vec<Curve> {
    ranked(rows, |row| {
        let row = &rows[row];
        let is_alone = |&index: &usize| {
            row.values[index].mode == mode && partner(row, index).is_none_or(|partner| partner == mode)
        };
        (0..4).filter(is_alone).map(|index| row.values[index].value.re).collect()
    })
}

/// Curves of any number of values at each speed. The k-th largest is continuous as long as the same eigenvalues are meant;
/// where names end and others begin, all curves begin anew.
fn ranked(rows: &[ModeRow], values: impl Fn(usize) -> Vec<f64>) -> Vec<Curve> {
    let mut ranks = vec![Vec::new(); 4];
    let mut before = None;
    for (place, row) in rows.iter().enumerate() {
        let mut values = values(place);
        sort_by(&mut values, f64::total_cmp);
        let names = (row.values.map(|value| value.mode), values.len());
        let goes_on = before.replace(names) == Some(names);
        for (rank, curves) in ranks.iter_mut().enumerate() {
            if !goes_on {
                extend(curves, None);
            }
            extend(curves, values.get(rank).map(|&value| (row.speed, value)));
        }
    }
    let mut curves = ranks.concat();
    curves.retain(|curve| !curve.is_empty());
    curves
}

/// The mode that the conjugate of an eigenvalue belongs to; `None` for a real one.
fn partner(row: &ModeRow, index: usize) -> Option<Mode> {
    let value = row.values[index].value;
    let is_conjugate = |&other: &usize| {
        let conjugate = row.values[other].value;
        other != index && value.im != 0.0 && conjugate.re == value.re && conjugate.im == -value.im
    };
    (0..4).find(is_conjugate).map(|other| row.values[other].mode)
}

/// Adds a point to the last curve; without a point the next one begins.
pub fn extend(curves: &mut Vec<Curve>, point: Option<(f64, f64)>) {
    match (curves.last_mut(), point) {
        (Some(curve), Some(point)) => curve.push(point),
        (None, Some(point)) => curves.push(vec![point]),
        (Some(curve), None) if !curve.is_empty() => curves.push(Curve::new()),
        _ => {}
    }
}

/// The pieces of a curve that lie between two heights, cut at them.
pub fn clip(curve: &[(f64, f64)], (low, high): (f64, f64)) -> Vec<Curve> {
    let mut pieces = Vec::new();
    let mut piece = Curve::new();
    for pair in curve.windows(2) {
        let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
        // The shares of the segment at which it enters and leaves; it enters after it leaves if it stays outside.
        let (enter, leave) = match y1 - y0 {
            0.0 if (low..=high).contains(&y0) => (0.0, 1.0),
            0.0 => (1.0, 0.0),
            rise => {
                let (a, b) = ((low - y0) / rise, (high - y0) / rise);
                (a.min(b).max(0.0), a.max(b).min(1.0))
            }
        };
        if enter < leave {
            let point = |share: f64| (x0 + share * (x1 - x0), y0 + share * (y1 - y0));
            if enter > 0.0 || piece.is_empty() {
                pieces.push(std::mem::take(&mut piece));
                piece.push(point(enter));
            }
            piece.push(point(leave));
        } else {
            pieces.push(std::mem::take(&mut piece));
        }
    }
    pieces.push(piece);
    pieces.retain(|piece| piece.len() > 1);
    pieces
}
