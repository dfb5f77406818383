//! Units behind numbers: `m`, `[kg*m^2]`, `km/h`, `N m s/rad`.
//!
//! A unit is a product of powers of metre, kilogram, second, newton, gram, minute, hour, radian and degree, with the
//! usual prefixes of metre, and of inch, foot, mile, pound, ounce, slug, pound-force and kilogram-force; an angle is a pure
//! number. It fits if it is the same quantity as the declared unit. Where that takes a force, pounds and ounces are those of force, as
//! people write `lb*in` for torques.

use std::f64::consts::PI;

use super::arithmetic::Arithmetic;

/// What numbers in one unit are multiplied with, to be in another: one rounding each, as the quotient may have none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    numerator: f64,
    denominator: f64,
}

impl Scale {
    /// A number in the other unit.
    pub fn apply(self, value: f64) -> f64 {
        self.of(value)
    }

    /// The same of numbers of any kind.
    pub(crate) fn of<T: Arithmetic>(self, value: T) -> T {
        value * self.numerator.into() / self.denominator.into()
    }

    /// The way back.
    #[cfg(feature = "full")]
    pub fn inverse(self) -> Self {
        Self { numerator: self.denominator, denominator: self.numerator }
    }

    /// Whether both units are the same.
    pub fn is_one(self) -> bool {
        self.numerator == self.denominator
    }
}

/// How to convert from the unit that is written to another one, which is declared, if it is one and the quantities are the same.
pub fn scale(written: &str, other: &str) -> Option<Scale> {
    let written = written.trim();
    let inner = written.strip_prefix('[').map_or(Some(written), |rest| rest.strip_suffix(']'))?;
    let (written, declared) = (Unit::parse(inner, false)?, Unit::parse(other, false)?);
    // The page, which is small, takes no forces.
    let is_full = cfg!(feature = "full");
    written.fits(&declared).or_else(|| match (is_full && written.has_pounds, is_full && declared.has_pounds) {
        (true, false) => Unit::parse(inner, true)?.fits(&declared),
        (false, true) => written.fits(&Unit::parse(other, true)?),
        _ => None,
    })
}

/// A unit as powers of kilogram, metre and second, with what numbers in it are multiplied with to be in SI units. Pounds and ounces
/// are of mass, or of force.
pub fn in_si(written: &str, of_force: bool) -> Option<([i32; 3], Scale)> {
    Unit::parse(written, of_force).map(|unit| (unit.powers, unit.scale))
}

/// Names that stand for a mass, or for its weight.
const POUNDS: [&str; 4] = ["lb", "lbs", "pound", "pounds"];
const OUNCES: [&str; 3] = ["oz", "ounce", "ounces"];

/// A product of powers.
struct Unit {
    /// Of kilogram, metre and second.
    powers: [i32; 3],
    scale: Scale,
    has_angle: bool,
    has_degrees: bool,
    /// Or ounces, of mass or of force.
    has_pounds: bool,
}

impl Unit {
    /// How to convert to another one of the same quantity.
    fn fits(&self, other: &Self) -> Option<Scale> {
        let fits = self.powers == other.powers
            && match other.powers {
                // An angle has no other unit than its own, and other pure numbers have none.
                [0, 0, 0] => self.has_angle && other.has_angle,
                // Of stiffness and damping against an angle, people leave out or add the radian, which is 1.
                _ => self.has_angle == other.has_angle || !self.has_degrees && !other.has_degrees,
            };
        fits.then_some(Scale {
            numerator: self.scale.numerator * other.scale.denominator,
            denominator: self.scale.denominator * other.scale.numerator,
        })
    }

    /// Pounds and ounces of mass, or of force.
    fn parse(text: &str, of_force: bool) -> Option<Self> {
        let mut unit = Self {
            powers: [0; 3],
            scale: Scale { numerator: 1.0, denominator: 1.0 },
            has_angle: false,
            has_degrees: false,
            has_pounds: false,
        };
        let mut rest = text.trim();
        let mut divides = false;
        while !rest.is_empty() {
            let end = rest.find(|c: char| !c.is_alphabetic() && c != '°').unwrap_or(rest.len());
            let (name, behind) = rest.split_at(end);
            let (power, behind) = power(behind)?;
            match (name, power) {
                // `1/s`, and the unit of pure numbers.
                ("", 0) => {}
                (_, 0) => return None,
                _ => unit.multiply(name, if divides { -power } else { power }, of_force)?,
            }
            let behind = behind.trim_start();
            divides = behind.starts_with('/');
            rest = behind.strip_prefix(['/', '*', '·', '⋅']).unwrap_or(behind).trim_start();
            if rest.is_empty() && rest.len() != behind.len() {
                return None;
            }
        }
        Some(unit)
    }

    fn multiply(&mut self, name: &str, power: i32, of_force: bool) -> Option<()> {
        self.has_pounds |= ["lbf", "lbm"].contains(&name) || POUNDS.contains(&name) || OUNCES.contains(&name);
        // Kilogram, metre and second; and by what it is multiplied and divided.
        let ([kg, m, s], numerator, denominator) = match name {
            "kg" => ([1, 0, 0], 1.0, 1.0),
            "g" => ([1, 0, 0], 1.0, 1e3),
            "m" => ([0, 1, 0], 1.0, 1.0),
            "mm" => ([0, 1, 0], 1.0, 1e3),
            "cm" => ([0, 1, 0], 1.0, 1e2),
            "km" => ([0, 1, 0], 1e3, 1.0),
            // The international yard and pound of 1959 define these exactly.
            "in" | "inch" | "inches" => ([0, 1, 0], 254.0, 1e4),
            "ft" | "foot" | "feet" => ([0, 1, 0], 3048.0, 1e4),
            "mi" | "mile" | "miles" => ([0, 1, 0], 1_609_344.0, 1e3),
            "lbf" => ([1, 1, -2], 44_482_216_152_605.0, 1e13),
            _ if of_force && POUNDS.contains(&name) => ([1, 1, -2], 44_482_216_152_605.0, 1e13),
            _ if of_force && OUNCES.contains(&name) => ([1, 1, -2], 44_482_216_152_605.0, 16e13),
            "lbm" => ([1, 0, 0], 45_359_237.0, 1e8),
            _ if POUNDS.contains(&name) => ([1, 0, 0], 45_359_237.0, 1e8),
            _ if OUNCES.contains(&name) => ([1, 0, 0], 45_359_237.0, 16e8),
            "kgf" | "kp" => ([1, 1, -2], 980_665.0, 1e5),
            // What a pound-force accelerates by one foot per second squared.
            "slug" | "slugs" => ([1, 0, 0], 44_482_216_152_605.0, 3_048e9),
            "s" | "sec" | "second" | "seconds" => ([0, 0, 1], 1.0, 1.0),
            "ms" => ([0, 0, 1], 1.0, 1e3),
            "us" | "µs" | "μs" => ([0, 0, 1], 1.0, 1e6),
            "ns" => ([0, 0, 1], 1.0, 1e9),
            "min" => ([0, 0, 1], 60.0, 1.0),
            "h" | "hr" => ([0, 0, 1], 3600.0, 1.0),
            "N" => ([1, 1, -2], 1.0, 1.0),
            "Nm" => ([1, 2, -2], 1.0, 1.0),
            "Nms" => ([1, 2, -1], 1.0, 1.0),
            "kgm" => ([1, 1, 0], 1.0, 1.0),
            "kmh" | "kph" => ([0, 1, -1], 1e3, 3600.0),
            "mph" => ([0, 1, -1], 1397.0, 3125.0),
            "rad" => ([0; 3], 1.0, 1.0),
            "deg" | "degree" | "degrees" | "°" => ([0; 3], PI, 180.0),
            _ => return None,
        };
        if name == "kgm" {
            // `kgm^2` is a kilogram times a metre squared.
            self.multiply("kg", power.signum(), of_force)?;
            return self.multiply("m", power, of_force);
        }
        self.has_angle |= [kg, m, s] == [0; 3];
        self.has_degrees |= numerator == PI;
        for (sum, own) in self.powers.iter_mut().zip([kg, m, s]) {
            *sum += own * power;
        }
        let (up, down) = (f64::powi(numerator, power.abs()), f64::powi(denominator, power.abs()));
        let (up, down) = if power < 0 { (down, up) } else { (up, down) };
        self.scale.numerator *= up;
        self.scale.denominator *= down;
        Some(())
    }
}

/// The power behind a name, and what follows it: `^2`, `**2`, `²`, `2`, or nothing, which is 1. Zero for a `1` alone.
fn power(text: &str) -> Option<(i32, &str)> {
    for (sign, power) in [("²", 2), ("³", 3)] {
        if let Some(rest) = text.strip_prefix(sign) {
            return Some((power, rest));
        }
    }
    let explicit = text.strip_prefix("**").or_else(|| text.strip_prefix('^'));
    let digits = explicit.unwrap_or(text);
    let sign = usize::from(digits.starts_with('-'));
    let end = sign + digits[sign..].chars().take_while(char::is_ascii_digit).count();
    match (&digits[..end], explicit) {
        ("", None) => Some((1, text)),
        ("1", None) => Some((0, &digits[end..])),
        (power, _) => {
            power.parse().ok().filter(|power: &i32| (1..=4).contains(&power.abs())).map(|power| (power, &digits[end..]))
        }
    }
}
