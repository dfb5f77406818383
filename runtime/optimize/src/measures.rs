//! The measures of a design at some parameters, with their exact derivatives.

use carvallo::{Change, CriticalDerivative, CriticalKind, CriticalSpeed, Stability};
use carvallo_design::conventions::Quantity;
use carvallo_design::{Dual, Equations, Shipped};

use crate::goal::Measure;

/// A measure with its derivatives by all parameters of the model.
#[derive(Clone, Debug)]
pub struct Measured {
    pub value: f64,
    pub gradient: Vec<f64>,
}

impl Measured {
    /// Its derivative by what the parameters of the model have these derivatives by.
    pub fn along(&self, slopes: &[f64]) -> f64 {
        self.gradient.iter().zip(slopes).map(|(of, by)| of * by).sum()
    }
}

/// A design of which measures are taken.
pub struct Measures {
    model: &'static Shipped,
    values: Vec<f64>,
    equations: Box<dyn Equations>,
    stability: Stability,
    /// The speeds that count, in m/s.
    window: [f64; 2],
}

impl Measures {
    /// # Errors
    /// If the parameters are not possible, or there is no answer.
    pub fn new(model: &'static Shipped, values: Vec<f64>, window: [f64; 2]) -> Result<Self, String> {
        let equations = model.equations(&values)?;
        let stability = equations.stability(gravity(model, &values)).map_err(|error| error.to_string())?;
        Ok(Self { model, values, equations, stability, window })
    }

    /// One of them; `None` where the design has no such speed.
    ///
    /// # Errors
    /// If a derivative has no answer.
    pub fn take(&self, measure: Measure) -> Result<Option<Measured>, String> {
        let first = |is_wanted: &dyn Fn(&&CriticalSpeed) -> bool| self.stability.critical_speeds.iter().find(is_wanted);
        let of = |kind: CriticalKind, change: Change| {
            move |critical: &&CriticalSpeed| critical.kind == kind && critical.change == change
        };
        let critical = match measure {
            Measure::StableRange => return self.stable_range(),
            Measure::Parameter(quantity) => return Ok(self.of_quantity(&quantity)),
            Measure::WeaveSpeed => {
                let is_wanted = of(CriticalKind::Weave, Change::Stabilizes);
                self.stability.critical_speeds.iter().rev().find(is_wanted)
            }
            Measure::CapsizeSpeed => first(&of(CriticalKind::Capsize, Change::Destabilizes)),
            Measure::FlutterSpeed => first(&of(CriticalKind::Weave, Change::Destabilizes)),
        };
        critical.map(|critical| self.of_critical(critical)).transpose()
    }

    fn of_quantity(&self, quantity: &Quantity) -> Option<Measured> {
        let info = self.model.info;
        let value = quantity.value(info, &|at| Dual::constant(self.values[at]))?.value;
        Some(Measured { value, gradient: quantity.gradient(info, &self.values)? })
    }

    /// The same without derivatives.
    pub fn value(&self, measure: Measure) -> Option<f64> {
        self.take(measure).ok().flatten().map(|measured| measured.value)
    }

    /// The width of the widest stable range within the speeds that count.
    fn stable_range(&self) -> Result<Option<Measured>, String> {
        let Some([from, to]) = self.stable_ends()? else { return Ok(None) };
        let [low, high] = self.window;
        // What the speeds that count cut off does not move.
        let moves = [low < from.value, to.value < high].map(|moves| if moves { 1.0 } else { 0.0 });
        let slopes = to.gradient.iter().zip(&from.gradient).map(|(to, from)| moves[1] * to - moves[0] * from);
        Ok(Some(Measured { value: to.value.min(high) - from.value.max(low), gradient: slopes.collect() }))
    }

    /// The ends of that range, wherever they are: the upper one may be infinite.
    ///
    /// # Errors
    /// If a derivative has no answer.
    pub fn stable_ends(&self) -> Result<Option<[Measured; 2]>, String> {
        let [low, high] = self.window;
        let clipped = self.stability.stable_ranges.iter().map(|range| {
            let to = range.to.unwrap_or(f64::INFINITY);
            (range.from, to, to.min(high) - range.from.max(low))
        });
        let widest = clipped.filter(|(.., width)| *width > 0.0).max_by(|a, b| a.2.total_cmp(&b.2));
        let Some((from, to, _)) = widest else { return Ok(None) };
        let end = |speed: f64| match self.stability.critical_speeds.iter().find(|critical| critical.speed == speed) {
            Some(critical) => self.of_critical(critical),
            // At rest, or without end.
            None => Ok(Measured { value: speed, gradient: vec![0.0; self.values.len()] }),
        };
        Ok(Some([end(from)?, end(to)?]))
    }

    fn of_critical(&self, critical: &CriticalSpeed) -> Result<Measured, String> {
        let sensitivity = self.model.sensitivity(&self.values)?;
        let gradient = match sensitivity.critical_speed(critical).map_err(|error| error.to_string())? {
            CriticalDerivative::Smooth { speed, .. } => speed,
            // Where two meet; no direction is known to be better.
            CriticalDerivative::None(_) => vec![0.0; self.values.len()],
        };
        Ok(Measured { value: critical.speed, gradient })
    }

    /// How far the design is from being stable at any of the speeds that count: the largest real part of its eigenvalues at the
    /// speed where that is least, in 1/s.
    pub fn instability(&self) -> f64 {
        const SPEEDS: u32 = 60;
        let [low, high] = self.window;
        let gravity = gravity(self.model, &self.values);
        let at = |index: u32| {
            let speed = low + (high - low) * f64::from(index) / f64::from(SPEEDS);
            let values = self.equations.eigenvalues(speed, gravity).ok()?;
            Some(values.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max))
        };
        (1..=SPEEDS).filter_map(at).fold(f64::INFINITY, f64::min)
    }
}

fn gravity(model: &Shipped, values: &[f64]) -> f64 {
    model.info.gravity.map_or(0.0, |position| values[position])
}
