//! The critical speeds in the brackets of the conditions.

use core::cell::RefCell;

use nalgebra::Complex;

use super::condition::{Condition, Divergence, Drifting, Flutter, Regularity};
use super::equations::Equations;
use super::isolation::{Bracket, isolate};
use super::newton::Crossing;
use super::polynomial::Normalized;
use crate::eigenvalues::Spectrum;
use crate::numeric::sort_by;
use crate::stability::critical::{Change, CriticalKind};
use crate::system::SystemError;

/// A critical speed that was found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) kind: CriticalKind,
    pub(super) crossing: Crossing,
    /// What the eigenvalue does there, where its derivative tells.
    pub(super) change: Option<Change>,
}

/// All that a search has brought, in no order.
pub(super) struct Findings {
    pub(super) found: Vec<Found>,
    /// Speeds, and how many eigenvalues are unstable there.
    pub(super) samples: Vec<(f64, usize)>,
    /// The ends of brackets that were left as they were, when so much had been computed that the search ended.
    pub(super) unexamined: Vec<[f64; 2]>,
}

/// How far a bracket may be left for what is in it, relative to its width: two brackets may share an end that is a zero.
const MARGIN: f64 = 0.25;

/// The relative widths of brackets in which zeros are not told apart any further: by elimination, and by eigenvalues, which
/// take more time and are followed from there one by one.
const NARROW_DIVERGENCE: f64 = 1.0 / (1u64 << 40) as f64;
const NARROW_FLUTTER: f64 = 1.0 / (1u64 << 10) as f64;

/// How many pairs of pairs are tried for those that meet, the closest ones first.
const CANDIDATES: usize = 3;

/// What a frequency may move by, relative to it, from the eigenvalues at six digits of the speed to all of them.
const CLOSE: f64 = 1e-4;

/// The binary orders of magnitude, in steps, of scaled speeds at which eigenvalues are counted where rounding hides the
/// conditions. Farther away it hides the eigenvalues as well.
const ORDERS: core::ops::RangeInclusive<i32> = -10..=10;
const STEP: f64 = 0.6;

/// The scaled speed up to which conditions are sought.
const FARTHEST: f64 = (1u64 << 44) as f64;

impl Equations {
    /// All critical speeds, in no order.
    pub(super) fn find_crossings(&self) -> Result<Findings, SystemError> {
        match self.find_certain_crossings() {
            Some(findings) => Ok(findings),
            None => self.find_crossings_by_eigenvalues(),
        }
    }

    /// The same where it takes eigenvalues at many speeds.
    pub(super) fn find_crossings_by_eigenvalues(&self) -> Result<Findings, SystemError> {
        let (mut found, mut unexamined) = (Vec::new(), Vec::new());
        let condition = Divergence(self);
        let divergence = self.normalize(&condition)?;
        let drifts = if divergence.is_some() { 0 } else { self.least_at_samples(Self::count_zeros)? };
        let left_out =
            if self.states() < 2 { 0 } else { self.least_at_samples(|this, v| this.count_zero_sums(v, drifts))? };
        if let Some(divergence) = divergence {
            for bracket in isolate(&divergence, self.is_along_speed(), NARROW_DIVERGENCE)? {
                if self.is_exhausted() && bracket.zero.is_none() {
                    unexamined.push([bracket.low, bracket.high]);
                } else {
                    self.find_divergences(&bracket, left_out > 0, &mut found);
                }
            }
        } else {
            self.find_divergences_beside(drifts, &mut found)?;
        }
        if self.states() < 2 {
            return Ok(Findings { found, samples: Vec::new(), unexamined });
        }
        let sums = |is_refined| Flutter { equations: self, left_out, drifts, is_refined, samples: RefCell::default() };
        let coarse = sums(false);
        let fine = sums(true);
        // Where rounding has the better of the sums at all speeds, it has not of those of more digits.
        let (condition, flutter) = match self.normalize(&coarse)? {
            None if left_out == 0 => (&fine, self.normalize(&fine)?),
            flutter => (&coarse, flutter),
        };
        // Far beyond all critical speeds eigenvalues differ so much that rounding has the better of the small ones.
        condition.samples.borrow_mut().clear();
        if left_out == 0 && flutter.is_none() {
            // What changes between neighbours is found; what does so and back again is not.
            let speeds = ORDERS.map(|order| match self.variable.ends() {
                (low, Some(high)) => 0.5 * (low + high) + 0.049 * (high - low) * f64::from(order),
                _ => 2f64.powf(STEP * f64::from(order)),
            });
            let speeds: Vec<f64> = speeds.collect();
            for v in speeds.iter().copied() {
                condition.samples.borrow_mut().push((v, self.count(v)?.unstable));
            }
            let (low, high) = self.variable.ends();
            unexamined.push([low, high.unwrap_or(FARTHEST)]);
        }
        if let Some(flutter) = flutter {
            let mut brackets = isolate(&flutter, self.is_polynomial(), NARROW_FLUTTER)?;
            // What is certain comes first, and takes least.
            sort_by(&mut brackets, |x, y| x.zero.is_none().cmp(&y.zero.is_none()));
            for bracket in brackets {
                // Those that are certain are no more than the degree, and the search was for them.
                if self.is_exhausted() && bracket.zero.is_none() {
                    unexamined.push([bracket.low, bracket.high]);
                    continue;
                }
                self.find_flutters(&bracket, &mut found)?;
                if left_out > 0 && bracket.zero.is_some() {
                    self.find_meetings(&bracket, &mut found)?;
                }
            }
        }
        Ok(Findings { found, samples: condition.samples.take(), unexamined })
    }

    fn normalize<'a, F: Condition>(&self, condition: &'a F) -> Result<Option<Normalized<'a, F>>, SystemError> {
        match self.variable.ends() {
            (low, Some(high)) => Normalized::over_range(condition, [low, high]),
            _ => Normalized::new(condition),
        }
    }

    /// Where in a range what has to be regular is singular, if it is so anywhere.
    pub(super) fn find_singular(&self) -> Result<Option<f64>, SystemError> {
        let condition = Regularity(self);
        let Some(regularity) = self.normalize(&condition)? else { return Ok(Some(self.variable.ends().0)) };
        Ok(isolate(&regularity, self.is_along_speed(), NARROW_DIVERGENCE)?.first().map(Bracket::start))
    }

    /// The least number of something at speeds of which none is special.
    fn least_at_samples(&self, count: impl Fn(&Self, f64) -> Result<usize, SystemError>) -> Result<usize, SystemError> {
        let mut least = usize::MAX;
        for v in self.variable.samples() {
            least = least.min(count(self, v)?);
            if least == 0 {
                break;
            }
        }
        Ok(least)
    }

    /// Where another eigenvalue is zero beside those that are so at all speeds.
    fn find_divergences_beside(&self, drifts: usize, found: &mut Vec<Found>) -> Result<(), SystemError> {
        let condition = Drifting { equations: self, drifts };
        let Some(divergence) = self.normalize(&condition)? else { return Ok(()) };
        for bracket in isolate(&divergence, self.is_polynomial(), NARROW_FLUTTER)? {
            let crossing = self.find_divergence_beside(bracket.start(), drifts);
            if let Some(crossing) = crossing.filter(|crossing| bracket.contains(crossing)) {
                add(found, Found { kind: CriticalKind::Capsize, crossing, change: None });
            }
        }
        Ok(())
    }

    /// Where eigenvalues are symmetric about the axis an imaginary pair becomes a real one through zero: with a derivative
    /// that is not finite.
    fn find_divergences(&self, bracket: &Bracket, is_symmetric: bool, found: &mut Vec<Found>) {
        if let Some(crossing) = self.find_divergence(bracket.start()).filter(|crossing| bracket.contains(crossing)) {
            let change = bracket.zero.filter(|_| !is_symmetric).and_then(|_| change(crossing.growth));
            add(found, Found { kind: CriticalKind::Capsize, crossing, change });
        }
    }

    /// The pairs that cross the axis in a bracket. Where there may be more than one crossing, it is sought from both ends
    /// as well, and where a pair turns back.
    fn find_flutters(&self, bracket: &Bracket, found: &mut Vec<Found>) -> Result<(), SystemError> {
        let starts = match bracket.zero {
            Some(zero) => vec![zero],
            None => vec![bracket.start(), bracket.low, bracket.high],
        };
        for start in starts {
            for s in pairs_by_real_part(&self.spectrum(start)?) {
                if bracket.zero.is_none() && start == bracket.start() {
                    self.find_turn(s, bracket, found)?;
                }
                self.find_flutter_from(start, s, bracket, found);
            }
        }
        Ok(())
    }

    fn find_flutter_from(&self, start: f64, s: Complex<f64>, bracket: &Bracket, found: &mut Vec<Found>) {
        // Where the real part is zero, to first order.
        let rate = self.rate(s, start);
        let v = start - s.re / rate.re;
        if bracket.is_near(v) {
            let omega = s.im + rate.im * (v - start);
            let crossing = self.find_flutter(v, omega).filter(|crossing| bracket.contains(crossing));
            let found_flutter =
                |crossing: Crossing| Found { kind: CriticalKind::Weave, crossing, change: change(crossing.growth) };
            if let Some(crossing) = crossing {
                add(found, found_flutter(crossing));
            }
        }
    }

    /// Where the real part of a pair has an extremum in a bracket: it touches the axis there, or crosses it before and after.
    fn find_turn(&self, s: Complex<f64>, bracket: &Bracket, found: &mut Vec<Found>) -> Result<(), SystemError> {
        const STEPS: usize = 60;
        const TOUCHING: f64 = 4.0;
        let follow = |v: f64| -> Result<Option<(Complex<f64>, f64)>, SystemError> {
            let spectrum = self.spectrum(v)?;
            let distance = |value: &&Complex<f64>| (**value - s).norm();
            let nearest = spectrum.values.iter().min_by(|x, y| distance(x).total_cmp(&distance(y))).copied();
            Ok(nearest.map(|nearest| (nearest, self.rate(nearest, v).re)))
        };
        let [mut low, mut high] = [bracket.low, bracket.high];
        let (Some((_, below)), Some((_, above))) = (follow(low)?, follow(high)?) else { return Ok(()) };
        if below * above >= 0.0 {
            return Ok(());
        }
        let curvature = (above - below) / (high - low);
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            match follow(middle)? {
                Some((_, rate)) if (rate > 0.0) == (below > 0.0) => low = middle,
                _ => high = middle,
            }
        }
        let turn = 0.5 * (low + high);
        let Some((s, error)) = follow(turn)?.and_then(|(s, _)| self.refine(s, turn)) else { return Ok(()) };
        if s.re.abs() <= TOUCHING * error {
            let error = (2.0 * error / curvature.abs()).sqrt();
            let crossing = Crossing { v: turn.into(), omega: s.im, error, growth: 0.0 };
            add(found, Found { kind: CriticalKind::Weave, crossing, change: Some(Change::Touches) });
        } else if s.re * curvature < 0.0 {
            let distance = (-2.0 * s.re / curvature).sqrt();
            for start in [turn - distance, turn + distance] {
                if let Some((s, _)) = follow(start)? {
                    self.find_flutter_from(start, s, bracket, found);
                }
            }
        }
        Ok(())
    }

    /// Where eigenvalues are symmetric about the imaginary axis: two pairs that meet on it.
    fn find_meetings(&self, bracket: &Bracket, found: &mut Vec<Found>) -> Result<(), SystemError> {
        let start = bracket.start();
        let spectrum = self.spectrum(start)?;
        let halves: Vec<Complex<f64>> = spectrum.values.iter().copied().filter(|value| value.im > 0.0).collect();
        let gap = |[s, t]: &[Complex<f64>; 2]| (s - t).norm() / (s + t).norm();
        let pairs = halves.iter().enumerate().flat_map(|(i, s)| halves[..i].iter().map(move |t| [*s, *t]));
        let mut pairs: Vec<[Complex<f64>; 2]> = pairs.collect();
        sort_by(&mut pairs, |x, y| gap(x).total_cmp(&gap(y)));
        let crossing = pairs.into_iter().take(CANDIDATES).find_map(|[s, t]| {
            let omega = 0.5 * (s.im + t.im);
            // At a divergence, too, the determinant and its derivative are zero together: at the frequency zero.
            let reach = (s - t).norm().min(0.5 * omega) + CLOSE * omega;
            let is_near = |crossing: &Crossing| (crossing.omega - omega).abs() <= reach;
            self.find_meeting(start, omega).filter(|crossing| bracket.contains(crossing) && is_near(crossing))
        });
        if let Some(crossing) = crossing {
            add(found, Found { kind: CriticalKind::DoubleRoot, crossing, change: None });
        }
        Ok(())
    }

    /// The critical speed in an interval at whose ends different numbers of eigenvalues are unstable, by bisection.
    pub(super) fn bisect(
        &self,
        [mut low, mut high]: [f64; 2],
        unstable: usize,
        found: &mut Vec<Found>,
    ) -> Result<(), SystemError> {
        const STEPS: usize = 40;
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            if self.count(middle)?.unstable == unstable { low = middle } else { high = middle }
        }
        let bracket =
            Bracket { low: low * (1.0 - NARROW_FLUTTER), high: high * (1.0 + NARROW_FLUTTER), zero: Some(low) };
        self.find_divergences(&bracket, false, found);
        self.find_flutters(&bracket, found)
    }
}

/// The upper halves of the pairs, those nearest to the axis first.
fn pairs_by_real_part(spectrum: &Spectrum) -> Vec<Complex<f64>> {
    let mut pairs: Vec<_> = spectrum.values.iter().copied().filter(|value| value.im > 0.0).collect();
    sort_by(&mut pairs, |x, y| x.re.abs().total_cmp(&y.re.abs()));
    pairs
}

/// What an eigenvalue does whose real part changes at a rate; `None` where that is not finite.
pub(super) fn change(growth: f64) -> Option<Change> {
    growth.is_finite().then_some(if growth < 0.0 { Change::Stabilizes } else { Change::Destabilizes })
}

impl Bracket {
    pub(super) fn start(&self) -> f64 {
        self.zero.unwrap_or(0.5 * (self.low + self.high))
    }

    /// Whether a speed is in the bracket, and no rounding moves it to zero.
    pub(super) fn contains(&self, crossing: &Crossing) -> bool {
        let (v, margin) = (crossing.v.to_f64(), MARGIN * (self.high - self.low).min(self.low));
        v >= self.low - margin && v <= self.high + margin && crossing.error < v
    }

    /// Whether a first estimate of what is in the bracket is good enough to go on from.
    fn is_near(&self, v: f64) -> bool {
        let width = self.high - self.low;
        v.is_finite() && v > 0.0 && v >= self.low - 4.0 * width && v <= self.high + 4.0 * width
    }
}

/// Adds what has not been found in another bracket, or where a pair turns back as far as rounding tells.
pub(super) fn add(found: &mut Vec<Found>, new: Found) {
    const SAME: f64 = 1e-12;
    const SAME_FREQUENCY: f64 = 1e-6;
    let is_same = |old: &Found| {
        let [x, y] = [&old.crossing, &new.crossing];
        let distance = (x.v - y.v).to_f64().abs();
        let is_one_speed = distance <= SAME * y.v.to_f64() || distance <= x.error + y.error;
        let is_one_frequency = (x.omega - y.omega).abs() <= SAME_FREQUENCY * y.omega;
        old.kind == new.kind && is_one_speed && is_one_frequency
    };
    if !found.iter().any(is_same) {
        found.push(new);
    }
}
