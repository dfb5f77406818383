//! Numbers that count what is done with them.

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use carvallo::Number;

use super::Operations;

thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

/// An `f64` whose operations are counted, for [`count`].
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Counted(pub f64);

/// What a function gives, and the operations that it does with [`Counted`] numbers on the way.
///
/// Comparisons and constants count nothing, and a sine with its cosine counts two. A function with branches does what it
/// does with the numbers that it is given.
///
/// ```
/// use carvallo_compare::{Counted, count};
///
/// let (area, operations) = count(|| Counted(3.0) * Counted(4.0));
/// assert_eq!((area.0, operations.multiplications, operations.total()), (12.0, 1, 1));
/// ```
pub fn count<R>(function: impl FnOnce() -> R) -> (R, Operations) {
    // What was counted so far belongs to whoever counts around this.
    let before = DONE.replace(Operations::NONE);
    let result = function();
    let counted = DONE.get();
    DONE.set(before + counted);
    (result, counted)
}

fn done(operations: Operations) {
    DONE.set(DONE.get() + operations);
}

macro_rules! operator {
    ($($operator:ident $method:ident $sign:tt $kind:ident)*) => {
        $(impl $operator for Counted {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                done(Operations { $kind: 1, ..Operations::NONE });
                Self(self.0 $sign other.0)
            }
        })*
    };
}

operator!(Add add + additions  Sub sub - additions  Mul mul * multiplications  Div div / divisions);

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        done(Operations { negations: 1, ..Operations::NONE });
        Self(-self.0)
    }
}

impl Number for Counted {
    fn like(self, value: f64) -> Self {
        Self(value)
    }
    fn sin_cos(self) -> (Self, Self) {
        (Number::sin(self), Number::cos(self))
    }
    fn sin(self) -> Self {
        done(Operations { trigonometric: 1, ..Operations::NONE });
        Self(self.0.sin())
    }
    fn cos(self) -> Self {
        done(Operations { trigonometric: 1, ..Operations::NONE });
        Self(self.0.cos())
    }
    fn tan(self) -> Self {
        done(Operations { trigonometric: 1, ..Operations::NONE });
        Self(self.0.tan())
    }
    fn sqrt(self) -> Self {
        done(Operations { roots: 1, ..Operations::NONE });
        Self(self.0.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_is_counted() {
        let (a, b) = (Counted(2.0), Counted(3.0));
        let (_, counted) = count(|| {
            let c = (a + b) * a - a.like(2.0) / -b;
            Number::sin(c) + Number::sin_cos(c).0 * Number::tan(c) + Number::sqrt(a)
        });
        let expected =
            Operations { additions: 4, multiplications: 2, divisions: 1, negations: 1, roots: 1, trigonometric: 4 };
        assert_eq!(counted, expected);
        assert_eq!(counted.total(), 13);
    }

    #[test]
    fn counts_inside_of_counts_are_part_of_them() {
        let product = || Counted(1.0) * Counted(2.0);
        let ((_, inner), outer) = count(|| {
            product();
            count(product)
        });
        assert_eq!((inner.multiplications, outer.multiplications), (1, 2));
    }
}
