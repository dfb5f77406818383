//! What each parameter contributes to the difference of a critical speed: the integral of its term along the path.

use std::cell::Cell;

use super::path::{Critical, Path};
use super::tracks::Track;

/// The contributions are exact to this, relative to the speeds, or as nearly as rounding allows.
const TOLERANCE: f64 = 1e-12;
const EACH: f64 = 1e-10;
/// So often the rule is used at most: where it does not do, derivatives are infinite or rounding decides.
const MOST: u32 = 600;

/// The rule of Kronrod with 15 nodes on -1 to 1: nodes, weights, and the weights of the rule of Gauss with 7 nodes among them
/// (Kronrod 1965; QUADPACK, Piessens et al. 1983, routine qk15).
const NODES: [(f64, f64, f64); 8] = [
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_55, 0.129_484_966_168_869_7),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18, 0.0),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_92, 0.279_705_391_489_276_66),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_4, 0.381_830_050_505_118_9),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (0.0, 0.209_482_141_084_727_83, 0.417_959_183_673_469_4),
];

/// The contributions of the parameters that differ, for each of the tracks, which go all the way.
///
/// # Errors
/// If there is no answer somewhere on the path.
pub fn integrate(path: &Path, tracks: &[Track]) -> Result<Vec<Vec<f64>>, String> {
    if tracks.is_empty() {
        return Ok(Vec::new());
    }
    let ends = |track: &Track| (track.first().critical.speed, track.last().critical.speed);
    let ends: Vec<(f64, f64)> = tracks.iter().map(ends).collect();
    Integral { path, tracks, left: Cell::new(MOST) }.over(0.0, 1.0, &ends)
}

struct Integral<'a> {
    path: &'a Path,
    tracks: &'a [Track],
    /// How often the rule may still be used.
    left: Cell<u32>,
}

/// What the rule gives for each track and parameter, and whether that is good.
struct Estimate {
    sums: Vec<Vec<f64>>,
    is_good: bool,
}

impl Integral<'_> {
    /// Over an interval, at the ends of which each track has these speeds: in two halves, until the sum of the contributions is
    /// the difference of the speeds and both rules agree.
    fn over(&self, low: f64, high: f64, ends: &[(f64, f64)]) -> Result<Vec<Vec<f64>>, String> {
        let estimate = self.by_rule(low, high, ends)?;
        let is_last = self.left.get() == 0;
        match estimate {
            Some(Estimate { sums, is_good }) if is_good || is_last => return Ok(sums),
            None if is_last => return Ok(self.by_ends(low, high, ends)),
            _ => {}
        }
        let middle = 0.5 * (low + high);
        let found = self.critical(middle)?;
        let near = |track: usize| self.tracks[track].speed_near(middle);
        let speeds = found.iter().enumerate().map(|(track, found)| match found {
            Some(critical) => critical.critical.speed,
            None => near(track),
        });
        let halves = speeds.zip(ends).map(|(speed, &(from, to))| ((from, speed), (speed, to)));
        let (lower, upper): (Vec<_>, Vec<_>) = halves.unzip();
        let mut sums = self.over(low, middle, &lower)?;
        let rest = self.over(middle, high, &upper)?;
        sums.iter_mut().flatten().zip(rest.into_iter().flatten()).for_each(|(sum, more)| *sum += more);
        Ok(sums)
    }

    /// By both rules; `None` if a critical speed is not recognised.
    fn by_rule(&self, low: f64, high: f64, ends: &[(f64, f64)]) -> Result<Option<Estimate>, String> {
        self.left.set(self.left.get().saturating_sub(1));
        let (center, half) = (0.5 * (low + high), 0.5 * (high - low));
        let mut sums = vec![vec![0.0; self.path.parameters.len()]; self.tracks.len()];
        let mut coarse = sums.clone();
        for &(node, weight, gauss) in &NODES {
            let places = if node == 0.0 { vec![center] } else { vec![center - half * node, center + half * node] };
            for place in places {
                for (track, critical) in self.critical(place)?.into_iter().enumerate() {
                    let Some(slopes) = critical.and_then(|critical| critical.slopes) else { return Ok(None) };
                    for (index, term) in slopes.terms.iter().enumerate() {
                        sums[track][index] += half * weight * term;
                        coarse[track][index] += half * gauss * term;
                    }
                }
            }
        }
        let is_good = (0..self.tracks.len()).all(|track| {
            let (from, to) = ends[track];
            let speed = from.max(to);
            let terms = sums[track].iter().zip(&coarse[track]);
            let rules = terms.map(|(fine, coarse)| (fine - coarse).abs() / speed).fold(0.0, f64::max);
            let sum: f64 = sums[track].iter().sum();
            // What the finer rule leaves, as QUADPACK estimates it; and what rounding makes of the speeds.
            let [first, last] = [self.tracks[track].first(), self.tracks[track].last()];
            let rounding = first.critical.error.max(last.critical.error);
            (200.0 * rules).powf(1.5) <= EACH && (sum - (to - from)).abs() <= (TOLERANCE * speed).max(2.0 * rounding)
        });
        Ok(Some(Estimate { sums, is_good }))
    }

    /// Where nothing else does: the difference, shared out by the derivatives at its ends.
    fn by_ends(&self, low: f64, high: f64, ends: &[(f64, f64)]) -> Vec<Vec<f64>> {
        let share = |(track, &(from, to)): (usize, &(f64, f64))| {
            let near =
                |place: f64| self.path.at(place).ok().and_then(|point| self.nearest(track, place, &point.critical));
            let slopes: Vec<_> =
                [low, high].into_iter().filter_map(near).filter_map(|critical| critical.slopes).collect();
            let term = |index: usize| slopes.iter().map(|slopes| slopes.terms[index]).sum::<f64>();
            let terms: Vec<f64> = (0..self.path.parameters.len()).map(term).collect();
            let sum: f64 = terms.iter().sum();
            let factor = if sum == 0.0 { 0.0 } else { (to - from) / sum };
            terms.into_iter().map(|term| term * factor).collect()
        };
        ends.iter().enumerate().map(share).collect()
    }

    /// The critical speed of each track at a place, where it is recognised.
    fn critical(&self, place: f64) -> Result<Vec<Option<Critical>>, String> {
        let found = self.path.at(place)?.critical;
        Ok((0..self.tracks.len()).map(|track| self.nearest(track, place, &found)).collect())
    }

    /// The one of its kind nearest to where the track must be.
    fn nearest(&self, track: usize, place: f64, found: &[Critical]) -> Option<Critical> {
        let (track, known) = (&self.tracks[track], &self.tracks[track].first().critical);
        let near = track.speed_near(place);
        let away = |critical: &&Critical| (critical.critical.speed - near).abs();
        let of_kind = |critical: &&Critical| critical.critical.kind == known.kind;
        found.iter().filter(of_kind).min_by(|a, b| away(a).total_cmp(&away(b))).cloned()
    }
}
