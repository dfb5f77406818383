//! The lines of a graph of eigenvalues, in data.

use carvallo::Mode;

use crate::analysis::{Analysis, Row};

/// Speeds of the curves, enough for lines that look smooth.
const SAMPLES: u32 = 250;

/// Speeds and values.
pub type Curve = Vec<(f64, f64)>;

/// Evenly spaced speeds, and close ones around critical speeds, where curves turn sharply.
pub fn samples(analysis: &Analysis, low: f64, high: f64) -> Vec<f64> {
    let step = (high - low) / f64::from(SAMPLES);
    let mut speeds: Vec<f64> = (0..=SAMPLES).map(|index| low + f64::from(index) * step).collect();
    for critical in &analysis.stability.critical_speeds {
        let around = (0..7).map(|power| step / 4_f64.powi(power)).flat_map(|shift| [-shift, shift]);
        speeds.extend(around.chain([0.0]).map(|shift| critical.speed + shift));
    }
    speeds.retain(|speed| (low..=high).contains(speed));
    speeds.sort_by(f64::total_cmp);
    speeds
}

/// How far the vertical axis goes: most of what there is to see, and not the far end of the castering mode.
pub fn extent(rows: &[Row]) -> f64 {
    let parts =
        rows.iter().flat_map(|row| row.values.iter().flat_map(|mode| [mode.value.re.abs(), mode.value.im.abs()]));
    let mut sizes: Vec<f64> = parts.filter(|&part| part > 0.0).collect();
    sizes.sort_by(f64::total_cmp);
    let typical = sizes.get(sizes.len() * 7 / 10).copied().unwrap_or(1.0);
    let power = 10_f64.powf(typical.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    power * steps.into_iter().find(|step| step * power >= typical).unwrap_or(10.0)
}

/// The curves of a mode.
#[derive(Default)]
pub struct Curves {
    pub real: Vec<Curve>,
    /// The imaginary parts without their signs.
    pub imaginary: Vec<Curve>,
    /// Where the mode forms a pair with another one, the real part that both have.
    pub shared: Vec<Curve>,
}

pub fn curves(rows: &[Row], mode: Mode) -> Curves {
    let mut curves = Curves::default();
    for Row { speed, values } in rows {
        let mut values: Vec<_> = values.iter().filter(|value| value.mode == mode).map(|value| value.value).collect();
        values.sort_by(|a, b| a.re.total_cmp(&b.re));
        curves.real.resize_with(values.len(), Curve::new);
        for (curve, value) in curves.real.iter_mut().zip(&values) {
            curve.push((*speed, value.re));
        }
        let largest = values.iter().map(|value| value.im.abs()).fold(0.0, f64::max);
        extend(&mut curves.imaginary, (largest > 0.0).then_some((*speed, largest)));
        let shared = match values[..] {
            [value] if value.im != 0.0 => Some((*speed, value.re)),
            _ => None,
        };
        extend(&mut curves.shared, shared);
    }
    curves
}

/// Adds a point to the last curve; without a point the next one begins.
fn extend(curves: &mut Vec<Curve>, point: Option<(f64, f64)>) {
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
