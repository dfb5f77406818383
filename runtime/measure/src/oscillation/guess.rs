//! Where the search for an oscillation begins.

use std::f64::consts::TAU;

/// More samples than this tell the frequency no better.
const ENOUGH: usize = 2048;

/// How many frequencies are tried for each that the span tells apart.
const FINENESS: f64 = 4.0;

/// The decay and the angular frequency of a signal about zero, over the span for the unit of time: the frequency at which its
/// spectrum is largest, and the decay from its first half to its second.
pub fn guess(scaled: &[[f64; 2]]) -> Option<[f64; 2]> {
    let block = scaled.len().div_ceil(ENOUGH);
    let mean =
        |block: &[[f64; 2]], part: usize| block.iter().map(|sample| sample[part]).sum::<f64>() / block.len() as f64;
    let means: Vec<[f64; 2]> = scaled.chunks(block).map(|block| [mean(block, 0), mean(block, 1)]).collect();
    let step = TAU / FINENESS;
    let turns: Vec<[f64; 2]> = means.iter().map(|[time, _]| (step * time).sin_cos().into()).collect();
    let mut phasors: Vec<[f64; 2]> = vec![[0.0, 1.0]; means.len()];
    let most = (FINENESS * means.len() as f64 / 2.0) as usize;
    let mut best = (0.0, 0.0);
    for index in 1..=most {
        let mut sums = [0.0; 2];
        for ((phasor, [s, c]), [_, value]) in phasors.iter_mut().zip(&turns).zip(&means) {
            let [sine, cosine] = *phasor;
            *phasor = [sine * c + cosine * s, cosine * c - sine * s];
            sums[0] += value * phasor[0];
            sums[1] += value * phasor[1];
        }
        let power = sums[0].hypot(sums[1]);
        // Less than a period is a drift.
        if index as f64 >= 0.75 * FINENESS && power > best.0 {
            best = (power, index as f64 * step);
        }
    }
    let size =
        |half: &[[f64; 2]]| (half.iter().map(|[_, value]| value * value).sum::<f64>() / half.len() as f64).sqrt();
    let (first, second) = means.split_at(means.len() / 2);
    let decay = 2.0 * (size(first) / size(second)).ln();
    (best.0 > 0.0).then_some([if decay.is_finite() { decay.max(0.0) } else { 0.0 }, best.1])
}
