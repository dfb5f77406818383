//! Units in which results are shown, other than those of the SI.

use crate::display::DisplayUnit;
use crate::failure::{Failure, Place};
use crate::quantity::scale;

/// The units that `imperial` stands for.
const IMPERIAL: [&str; 7] = ["in", "lb", "deg", "mph", "lb*in", "lb*in^2", "ft/s^2"];

/// What quantities are shown in; those that have no unit among them are in that of the SI.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Units(Vec<String>);

impl Units {
    /// From units that stand behind commas, such as `mm,deg,km/h`; `imperial` is `in,lb,deg,mph,lb*in,lb*in^2,ft/s^2`, and `si` none.
    ///
    /// # Errors
    /// What is no unit; and two of one quantity.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        let fail = |message: String| Failure::at(Place::Option(format!("--units {text}")), message);
        let mut units: Vec<String> = Vec::new();
        for part in text.split(',').map(str::trim) {
            match part.to_lowercase().as_str() {
                "imperial" => units.extend(IMPERIAL.map(str::to_owned)),
                "si" => {}
                "" => return Err(fail("expected units such as mm,deg,km/h, or imperial".to_owned())),
                _ if scale(part, part).is_none() => {
                    return Err(fail(format!(
                        "`{part}` is no unit; expected such as mm, in, deg, kg, lb, km/h, mph or kg*cm^2"
                    )));
                }
                _ => units.push(part.to_owned()),
            }
        }
        for (at, unit) in units.iter().enumerate() {
            if let Some(first) = units[..at].iter().find(|first| scale(first, unit).is_some()) {
                return Err(fail(format!("`{first}` and `{unit}` are units of the same quantity")));
            }
        }
        Ok(Self(units))
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
        let mut units = self.0.iter().map(String::as_str).chain(usual);
        let found = units.find_map(|unit| Some((unit, scale(declared, unit)?)));
        match found {
            Some((unit, scale)) if !scale.is_one() => DisplayUnit::new(unit, scale),
            None => self.of_time(declared, usual).unwrap_or_else(|| DisplayUnit::declared(declared)),
            Some(_) => DisplayUnit::declared(declared),
        }
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
