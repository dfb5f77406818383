//! Stability of a design along one of its parameters, at a fixed speed.

use std::str::FromStr;

use carvallo::{Complex, CriticalSpeed, CriticalValue, ParameterInfo, ParameterStability, Verdict};
use carvallo_design::matrices::{NAME, NO_PARAMETERS};
use carvallo_design::number::{shortest, with_unit};
use carvallo_design::parameter::ends;
use carvallo_design::{Design, DisplayUnit, Failure, Path, Place, Problem};

use crate::analysis::{self, extremes};

/// `NAME=LOW:HIGH`; what they mean depends on the model.
#[derive(Clone, Debug)]
pub struct Along {
    written: String,
    name: String,
    ends: [String; 2],
}

impl FromStr for Along {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        let parts = text.split_once('=').and_then(|(name, range)| Some((name.trim(), range.split_once(':')?)));
        match parts {
            Some((name, (low, high))) if !name.is_empty() && !high.contains(':') => Ok(Self {
                written: text.to_owned(),
                name: name.to_owned(),
                ends: [low, high].map(|end| end.trim().to_owned()),
            }),
            _ => {
                let message = "expected NAME=LOW:HIGH, such as mB=60:120".to_owned();
                Err(Problem { place: Place::Nowhere, message })
            }
        }
    }
}

/// What there is along a parameter.
pub struct AlongAnalysis {
    /// What is analyzed.
    pub design: Design,
    /// The parameter that changes: one of the model, or of any convention of bicycles.
    pub parameter: ParameterInfo,
    /// The designs that it passes through.
    pub path: Path,
    /// In m/s; none where nothing depends on it.
    pub speed: Option<f64>,
    /// The values of the parameter, in its unit, from end to end.
    pub range: [f64; 2],
    /// Its critical values and stable ranges.
    pub stability: ParameterStability,
    /// What values of the parameter are shown in.
    pub unit: DisplayUnit,
    /// What the speed is shown in.
    pub speed_unit: DisplayUnit,
}

/// The eigenvalues at a value, sorted by real part, then by imaginary part.
pub struct AtValue {
    /// Of the parameter, in its unit.
    pub value: f64,
    /// Whether the motion is stable.
    pub verdict: Verdict,
    /// In 1/s.
    pub eigenvalues: Vec<Complex<f64>>,
}

impl AlongAnalysis {
    /// A design along one of its parameters, at a speed in m/s.
    ///
    /// # Errors
    /// If there is no such parameter, no such range of it, or no answer.
    pub fn new(design: Design, along: &Along, speed: Option<f64>) -> Result<Self, Failure> {
        let info = design.info();
        let wrong = |message: String| Failure::at(Place::Option(format!("--along {}", along.written)), message);
        if info.name == NAME {
            return Err(wrong(NO_PARAMETERS.to_owned()));
        }
        if along.name == "v" {
            return Err(wrong("`v` is the speed: without --along everything is along it".to_owned()));
        }
        let path = Path::new(&design, &along.name).map_err(wrong)?;
        let parameter = path.parameter;
        let [low, high] = ends(along.ends.each_ref().map(String::as_str), &parameter).map_err(wrong)?;
        let speed = match speed {
            None if design.model.depends_on_speed() => {
                return Err(wrong("--speed is missing, the speed in m/s at which the parameter changes".to_owned()));
            }
            speed => speed.filter(|_| design.model.depends_on_speed()),
        };
        let stability = design.model.along(&path, [low, high], speed.unwrap_or(0.0));
        let stability = stability.map_err(|error| {
            Failure::Run(format!("{} along {}: {error}{}", design.title(), parameter.name, extremes(&design)))
        })?;
        let [unit, speed_unit] = [parameter.unit, "m/s"].map(DisplayUnit::declared);
        Ok(Self { design, parameter, path, speed, range: [low, high], stability, unit, speed_unit })
    }

    /// A value of the parameter as it is shown, without its unit: 30 deg and not 29.999999999999996, which are the same angle but
    /// for the rounding of conversions.
    pub fn shown(&self, value: f64) -> f64 {
        let shown = self.unit.value(value);
        let short = format!("{shown:.13e}").parse().unwrap_or(shown);
        let is_same = (self.unit.back(short) - value).abs() <= 2.0 * f64::EPSILON * value.abs();
        if !self.unit.is_declared() && is_same { short } else { shown }
    }

    /// A value of the parameter as it is shown, with its unit.
    pub fn with_unit(&self, value: f64) -> String {
        with_unit(self.shown(value), &self.unit.written)
    }

    /// The parameter with the unit that its values are shown in, if they have one.
    pub fn heading(&self) -> String {
        let unit = self.unit.unit();
        if unit.is_empty() { self.parameter.name.to_owned() } else { format!("{} ({unit})", self.parameter.name) }
    }

    /// The speed with its unit, after `before`; nothing where none counts.
    pub fn at_speed(&self, before: &str) -> String {
        let shown = |speed| format!("{before}{} {}", shortest(self.speed_unit.value(speed)), self.speed_unit.unit());
        self.speed.map(shown).unwrap_or_default()
    }

    /// What happens at a critical value, in the words of the field.
    pub fn name(&self, critical: &CriticalValue) -> &'static str {
        let CriticalValue { kind, value, error, eigenvalue, change } = *critical;
        let critical = CriticalSpeed { kind, speed: value, error, eigenvalue, change };
        analysis::name(&critical, self.design.info())
    }

    /// The eigenvalues at so many values from end to end.
    ///
    /// # Errors
    /// If they cannot be computed at one of them.
    pub fn rows(&self, count: u32) -> Result<Vec<AtValue>, Failure> {
        let [low, high] = self.range;
        // Values between are round in the unit that they are shown in.
        let [first, last] = self.range.map(|end| self.shown(end));
        let value = |k: u32| match k {
            0 => low,
            _ if k + 1 == count => high,
            _ => {
                let share = f64::from(k) / f64::from(count - 1);
                self.unit.back(rounded(first + (last - first) * share, last - first)).clamp(low, high)
            }
        };
        (0..count).map(|k| self.row(value(k))).collect()
    }

    fn row(&self, value: f64) -> Result<AtValue, Failure> {
        let parameters = self.path.at(value).map_err(|error| self.failed(value, &error))?;
        let gravity = self.design.info().gravity.map_or(0.0, |position| parameters[position]);
        let equations = self.design.model.equations(&parameters);
        let found = equations.and_then(|equations| {
            equations.eigenvalues(self.speed.unwrap_or(0.0), gravity).map_err(|error| error.to_string())
        });
        let eigenvalues = found.map_err(|error| self.failed(value, &error))?;
        let verdict = self.stability.verdict(value).unwrap_or(Verdict::Marginal);
        Ok(AtValue { value, verdict, eigenvalues })
    }

    /// That there is nothing at a value.
    pub(super) fn failed(&self, value: f64, error: &str) -> Failure {
        let (title, name) = (self.design.title(), self.parameter.name);
        Failure::Run(format!("{title} at {name} = {}: {error}", shortest(value)))
    }
}

/// A value without digits that the division of a range has made.
fn rounded(value: f64, width: f64) -> f64 {
    let unit = 10f64.powi((width.log10() - 9.0).floor() as i32);
    let digits = (-unit.log10()).round().clamp(0.0, 17.0) as usize;
    format!("{value:.digits$}").parse().unwrap_or(value)
}
