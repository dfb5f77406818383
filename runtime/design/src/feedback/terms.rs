//! Sums of numbers times powers of the speed times positions and rates: what a law is made of.

use super::parse::Symbol;

/// A number times a power of the speed, and at most one position or rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// In SI units.
    pub value: f64,
    /// Of kilogram, metre and second in the number; `None` if a part of it has no unit, and is taken to be in SI units.
    pub unit: Option<[i32; 3]>,
    /// Whether a part of the number has a unit.
    pub has_unit: bool,
    /// Of the speed.
    pub power: i32,
    /// The position or rate.
    pub motion: Option<Motion>,
}

/// A position, or a rate, of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    pub coordinate: usize,
    pub is_rate: bool,
}

/// A sum of terms of which no two have the same power and motion, unless there is none.
pub type Sum = Vec<Term>;

impl Term {
    pub fn number(value: f64) -> Self {
        Self { value, unit: None, has_unit: false, power: 0, motion: None }
    }

    pub fn quantity(value: f64, unit: [i32; 3]) -> Self {
        Self { unit: Some(unit), has_unit: true, ..Self::number(value) }
    }

    pub fn symbol(symbol: Symbol) -> Self {
        let one = Self { unit: Some([0; 3]), ..Self::number(1.0) };
        match symbol {
            Symbol::Speed => Self { power: 1, ..one },
            Symbol::Motion(motion) => Self { motion: Some(motion), ..one },
        }
    }

    pub fn is_number(&self) -> bool {
        self.power == 0 && self.motion.is_none()
    }

    fn times(self, other: Self) -> Option<Self> {
        Some(Self {
            value: self.value * other.value,
            unit: self.unit.zip(other.unit).map(|(one, other)| [0, 1, 2].map(|index| one[index] + other[index])),
            has_unit: self.has_unit || other.has_unit,
            power: self.power + other.power,
            motion: match (self.motion, other.motion) {
                (Some(_), Some(_)) => return None,
                (one, other) => one.or(other),
            },
        })
    }

    fn inverse(self) -> Option<Self> {
        let unit = self.unit.map(|unit| unit.map(|power| -power));
        self.motion.is_none().then_some(Self { value: 1.0 / self.value, unit, power: -self.power, ..self })
    }

    /// The number and the speed as powers of kilogram, metre and second, as far as it is known.
    fn factor_unit(&self) -> Option<[i32; 3]> {
        self.unit.map(|[kg, m, s]| [kg, m + self.power, s - self.power])
    }
}

/// Adds one to another.
///
/// # Errors
/// If what multiplies the same motion is of different quantities, by the units that are written.
pub fn add(sum: &mut Sum, term: Term) -> Result<(), ()> {
    let is_other = |own: &Term| {
        let known = own.factor_unit().zip(term.factor_unit());
        own.motion == term.motion && (own.has_unit || term.has_unit) && known.is_some_and(|(one, other)| one != other)
    };
    if sum.iter().any(is_other) {
        return Err(());
    }
    match sum.iter_mut().find(|own| own.power == term.power && own.motion == term.motion) {
        Some(own) => {
            own.value += term.value;
            own.unit = own.unit.or(term.unit);
            own.has_unit |= term.has_unit;
        }
        None => sum.push(term),
    }
    Ok(())
}

/// The product of two sums; `None` if motions are multiplied.
pub fn times(one: &Sum, other: &Sum) -> Option<Result<Sum, ()>> {
    let mut product = Sum::new();
    for first in one {
        for second in other {
            if add(&mut product, first.times(*second)?).is_err() {
                return Some(Err(()));
            }
        }
    }
    Some(Ok(product))
}

/// One divided by a sum: `None` unless it is a number times a power of the speed.
pub fn inverse(sum: &Sum) -> Option<Sum> {
    match sum[..] {
        [term] => term.inverse().map(|term| vec![term]),
        _ => None,
    }
}

/// A whole power of a sum, if it has one.
pub fn power(sum: &Sum, exponent: i32) -> Option<Sum> {
    let base = if exponent < 0 { inverse(sum)? } else { sum.clone() };
    let one = vec![Term { unit: Some([0; 3]), ..Term::number(1.0) }];
    (0..exponent.abs()).try_fold(one, |product, _| times(&product, &base)?.ok())
}
