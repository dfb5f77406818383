//! The lines of a graph of eigenvalues, in data.

use carvallo::{Complex, Mode};

use crate::analysis::{Analysis, ModeRow};

/// Speeds of the curves, enough for lines that look smooth; more where it is not known at which of them curves turn.
const SAMPLES: u32 = 250;
const SAMPLES_WITHOUT_CRITICAL: u32 = 1000;

/// Speeds and values.
pub type Curve = Vec<(f64, f64)>;

/// Evenly spaced speeds, and close ones around critical speeds, where curves turn sharply.
pub fn samples(analysis: &Analysis, low: f64, high: f64) -> Vec<f64> {
    let samples = if analysis.stability.is_some() { SAMPLES } else { SAMPLES_WITHOUT_CRITICAL };
    let step = (high - low) / f64::from(samples);
    let mut speeds: Vec<f64> = (0..=samples).map(|index| low + f64::from(index) * step).collect();
    for critical in analysis.critical_speeds() {
        let around = (0..7).map(|power| step / 4_f64.powi(power)).flat_map(|shift| [-shift, shift]);
        speeds.extend(around.chain([0.0]).map(|shift| critical.speed + shift));
    }
    speeds.retain(|speed| (low..=high).contains(speed));
    speeds.sort_by(f64::total_cmp);
    speeds
}

/// How far the vertical axis goes: most of what there is to see, and not the far end of the castering mode.
pub fn extent(values: impl Iterator<Item = Complex<f64>>) -> f64 {
    let parts = values.flat_map(|value| [value.re.abs(), value.im.abs()]);
    let mut sizes: Vec<f64> = parts.filter(|&part| part > 0.0).collect();
    sizes.sort_by(f64::total_cmp);
    let typical = sizes.get(sizes.len() * 7 / 10).copied().unwrap_or(1.0);
    let power = 10_f64.powf(typical.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    power * steps.into_iter().find(|step| step * power >= typical).unwrap_or(10.0)
}

/// Two modes, or weave alone, that form a complex pair.
pub struct Pair {
    pub modes: (Mode, Mode),
    pub real: Vec<Curve>,
    /// The imaginary parts without their signs.
    pub imaginary: Vec<Curve>,
}

/// The complex pairs that there are; at each speed there may be two of them.
pub fn pairs(rows: &[ModeRow]) -> Vec<Pair> {
    let (castering, capsize, weave) = (Mode::Castering, Mode::Capsize, Mode::Weave);
    let kinds = [(castering, capsize), (castering, weave), (capsize, weave), (weave, weave)];
    let mut pairs = Vec::from(kinds.map(|modes| Pair { modes, real: Vec::new(), imaginary: Vec::new() }));
    for row in rows {
        let found = |modes| {
            (0..4).find(|&index| partner(row, index).is_some_and(|mode| (row.values[index].mode, mode) == modes))
        };
        for Pair { modes, real, imaginary } in &mut pairs {
            let value = found(*modes).map(|index| row.values[index].value);
            extend(real, value.map(|value| (row.speed, value.re)));
            extend(imaginary, value.map(|value| (row.speed, value.im.abs())));
        }
    }
    pairs.retain(|pair| !pair.real.is_empty());
    pairs
}

/// The real parts of a mode where it is not in a pair with another mode: up to two at each speed.
pub fn alone(rows: &[ModeRow], mode: Mode) -> Vec<Curve> {
    let mut branches = [Vec::new(), Vec::new()];
    let mut before = [f64::NAN; 2];
    for row in rows {
        let is_alone = |&index: &usize| {
            row.values[index].mode == mode && partner(row, index).is_none_or(|partner| partner == mode)
        };
        let mut values: Vec<f64> = (0..4).filter(is_alone).map(|index| row.values[index].value.re).collect();
        values.sort_by(f64::total_cmp);
        let points = match values[..] {
            [] => [None, None],
            // One of two goes on with the branch that it is nearer to.
            [value] if (value - before[1]).abs() < (value - before[0]).abs() => [None, Some(value)],
            [value] => [Some(value), None],
            [first, second, ..] => [Some(first), Some(second)],
        };
        before = points.map(|value| value.unwrap_or(f64::INFINITY));
        for (branch, value) in branches.iter_mut().zip(points) {
            extend(branch, value.map(|value| (row.speed, value)));
        }
    }
    branches.concat()
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
