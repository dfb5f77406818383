//! Units in which results are shown, other than those of the SI.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::display::DisplayUnit;
use crate::failure::{Failure, Place};
use crate::number::by_time;
use crate::quantity::units::in_si;
use crate::quantity::{Scale, scale};

/// The units that `imperial` stands for.
const IMPERIAL: [&str; 7] = ["in", "lb", "deg", "mph", "lb*in", "lb*in^2", "ft/s^2"];

/// What quantities are shown in; those that have no unit among them are in that of the SI.
#[derive(Clone, Debug, Default)]
pub struct Units(Vec<Asked>);

/// A unit that is asked for.
#[derive(Clone, Debug)]
struct Asked {
    unit: String,
    /// What it was asked for by, and whether a quantity has been shown in anything of that.
    by: Arc<(String, AtomicBool)>,
}

impl Asked {
    /// Whether it was asked for by its own name, and not by `imperial`.
    fn is_named(&self) -> bool {
        self.by.0 == self.unit
    }
}

impl Units {
    /// From units that stand behind commas, such as `mm,deg,km/h`; `imperial` is `in,lb,deg,mph,lb*in,lb*in^2,ft/s^2`, of which
    /// units beside it replace some, as in `imperial,km/h`; and `si` is none.
    ///
    /// # Errors
    /// What is no unit; and two of one quantity.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        let fail = |message: String| Failure::at(Place::Option(format!("--units {text}")), message);
        let mut units: Vec<Asked> = Vec::new();
        for part in text.split(',').map(str::trim) {
            let own = match part.to_lowercase().as_str() {
                "imperial" => &IMPERIAL[..],
                "si" => &[],
                "" => return Err(fail("expected units such as mm,deg,km/h, or imperial".to_owned())),
                _ if scale(part, part).is_none() => {
                    return Err(fail(format!(
                        "`{part}` is no unit; expected such as mm, in, deg, kg, lb, km/h, mph or kg*cm^2"
                    )));
                }
                _ => &[part],
            };
            let by = Arc::new((part.to_owned(), AtomicBool::new(false)));
            units.extend(own.iter().map(|unit| Asked { unit: (*unit).to_owned(), by: by.clone() }));
        }
        // What is asked for by its name goes before what `imperial` has of the quantity.
        let named: Vec<String> =
            units.iter().filter(|asked| asked.is_named()).map(|asked| asked.unit.clone()).collect();
        units.retain(|asked| asked.is_named() || !named.iter().any(|own| is_same(own, &asked.unit)));
        for (at, Asked { unit, .. }) in units.iter().enumerate() {
            if let Some(first) = units[..at].iter().find(|first| is_same(&first.unit, unit)) {
                return Err(fail(format!("`{}` and `{unit}` are units of the same quantity", first.unit)));
            }
        }
        Ok(Self(units))
    }

    /// What was asked for while nothing has been shown in it, by this and by its clones.
    pub fn unused(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self
            .0
            .iter()
            .filter(|asked| !asked.by.1.load(Ordering::Relaxed))
            .map(|asked| asked.by.0.as_str())
            .collect();
        names.dedup();
        names
    }

    /// Whether everything is in units of the SI.
    pub fn is_si(&self) -> bool {
        self.0.is_empty()
    }

    /// What a quantity is shown in whose unit is declared as `kg*m^2`.
    pub fn of(&self, declared: &str) -> DisplayUnit {
        self.or(declared, None)
    }

    /// The same, in another unit where none is asked for.
    pub fn or(&self, declared: &str, usual: Option<&str>) -> DisplayUnit {
        match self.asked(declared).or_else(|| usual.and_then(|unit| Some((unit, scale(declared, unit)?)))) {
            Some((unit, scale)) if !scale.is_one() => DisplayUnit::new(unit, scale),
            None => self.of_time(declared, usual).unwrap_or_else(|| DisplayUnit::declared(declared)),
            Some(_) => DisplayUnit::declared(declared),
        }
    }

    /// The same for people: of angles in degrees where no unit is asked for.
    pub fn for_people(&self, declared: &str) -> DisplayUnit {
        self.or(declared, usual(declared))
    }

    /// What the rate is shown in of what is declared in a unit, or with `power` 2 the acceleration: if nothing is asked for, in the
    /// unit of the position by time.
    pub fn by_time(&self, declared: &str, power: u32, usual: Option<&str>) -> DisplayUnit {
        let rate = by_time(declared, power);
        if self.asked(&rate).is_some() {
            return self.of(&rate);
        }
        let position = self.or(declared, usual);
        let unit = by_time(&position.written, power);
        let scale = scale(&rate, &unit).filter(|_| !position.is_declared());
        scale.map_or_else(|| DisplayUnit::declared(&rate), |scale| DisplayUnit::new(&unit, scale))
    }

    /// The same for people.
    pub fn by_time_for_people(&self, declared: &str, power: u32) -> DisplayUnit {
        self.by_time(declared, power, usual(declared))
    }

    /// The unit that is asked for of a quantity, which is shown in it then.
    fn asked(&self, declared: &str) -> Option<(&str, Scale)> {
        let exact = self.0.iter().find(|asked| is_same(declared, &asked.unit));
        let asked = exact.or_else(|| self.0.iter().find(|asked| scale(declared, &asked.unit).is_some()))?;
        let scale = scale(declared, &asked.unit)?;
        asked.by.1.store(true, Ordering::Relaxed);
        Some((&asked.unit, scale))
    }

    /// Rates and accelerations of angles in the unit of angles, where they have none of their own.
    fn of_time(&self, declared: &str, usual: Option<&str>) -> Option<DisplayUnit> {
        let time = declared.strip_prefix("rad").filter(|time| matches!(*time, "/s" | "/s^2"))?;
        let angle = self.or("rad", usual);
        let unit = format!("{}{time}", angle.written);
        let scale = scale(declared, &unit)?;
        (!angle.is_declared()).then(|| DisplayUnit::new(&unit, scale))
    }
}

/// Whether units are of one quantity where pounds are of mass: not `lb` and `N`.
fn is_same(one: &str, other: &str) -> bool {
    let powers = |unit: &str| in_si(unit, false).map(|(powers, _)| powers);
    powers(one) == powers(other) && scale(one, other).is_some()
}

/// What people have angles in.
fn usual(declared: &str) -> Option<&'static str> {
    (declared == "rad").then_some("deg")
}
