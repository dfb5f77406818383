//! Critical speeds that were given, as zeros of determinants at these speeds: whether matrices can have them is told so by a few products,
//! before their critical speeds are computed.

use carvallo::{Complex, CriticalKind, MatrixName, ModelInfo, States};

use crate::given::{Quantity, Reading};
use crate::predict::Predictor;
use crate::states::states;
use crate::zero::{Square, determinant, size};

/// A speed is tried no nearer than that, relative to it: more than rounding makes of the determinants.
const NEAR: f64 = 1e-6;

/// Farther away by so much the determinant of a machine that has a capsize speed is not zero.
const FAR: [f64; 2] = [1.1, 1.3];

/// More than rounding leaves of a determinant that is zero, relative to what is added up.
const NOTHING: f64 = 1e-15;

/// A coefficient is the same but for rounding, relative to it.
const SAME: f64 = 1e-9;

/// A critical speed that was given.
#[derive(Clone, Debug)]
pub struct Critical {
    /// Which number it is.
    pub number: usize,
    kinds: Vec<Kind>,
    /// The speed, and what is as far away on either side as may be.
    speeds: [f64; 3],
    /// Other matrices are zero.
    matrices: Vec<MatrixName>,
    /// Of each coordinate whether its position is no state.
    has_rate_alone: Vec<bool>,
    states: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// The eigenvalues have the product 0.
    Capsize,
    /// Two eigenvalues have the sum 0, by Orlando.
    Weave,
}

/// All of which the kind is known, or one of two; other matrices than these are zero.
pub fn criticals(predictor: &Predictor, info: &ModelInfo, matrices: &[MatrixName]) -> Vec<Critical> {
    let numbers = predictor.numbers().iter().zip(predictor.tolerances()).enumerate();
    let of = |(number, ((quantity, reading), tolerance)): (usize, (&(Quantity, &Reading), &f64))| {
        let Quantity::CriticalSpeed(at) = *quantity else { return None };
        let kinds = match predictor.given().critical_speeds[at].kind {
            Some(CriticalKind::Capsize) => vec![Kind::Capsize],
            Some(CriticalKind::Weave) => vec![Kind::Weave],
            Some(CriticalKind::DoubleRoot) => return None,
            None => vec![Kind::Capsize, Kind::Weave],
        };
        let away = tolerance.max(NEAR * reading.value);
        let speeds = [0.0, away, -away].map(|away| reading.value + away);
        // Nothing is divided by a speed that may be 0.
        let is_finite = speeds[2] > 0.0 || !matrices.contains(&MatrixName::Cm1);
        let has_rate_alone = info.coordinates.iter().map(|own| own.states == States::Rate).collect();
        let (matrices, states) = (matrices.to_vec(), states(info).len());
        is_finite.then_some(Critical { number, kinds, speeds, matrices, has_rate_alone, states })
    };
    numbers.filter_map(of).collect()
}

impl Critical {
    /// Whether these entries of the closed loop may have it: those that have do.
    pub fn holds(&self, entries: &[f64], gravity: f64) -> bool {
        self.kinds.iter().any(|kind| {
            if *kind == Kind::Capsize && self.is_singular(entries, gravity) {
                return false;
            }
            let [here, right, left] = self.speeds.map(|speed| self.value(*kind, speed, entries, gravity));
            // Beside another one twice as large as on the side that differs more.
            here.abs() <= 4.0 * (right - here).abs().max((left - here).abs())
        })
    }

    /// What is zero where these entries have it, if it is of one kind.
    pub fn off(&self, entries: &[f64], gravity: f64) -> Option<f64> {
        match self.kinds[..] {
            [kind] => Some(self.value(kind, self.speeds[0], entries, gravity)),
            _ => None,
        }
    }

    /// Whether a closed loop has the same characteristic polynomial at this speed, but for a factor.
    pub fn is_same(&self, [one, other]: [&[f64]; 2], [of_one, of_other]: [f64; 2]) -> bool {
        let [one, other] = [(one, of_one), (other, of_other)]
            .map(|(entries, gravity)| self.characteristic(self.speeds[0], entries, gravity));
        let largest = |all: &[f64]| all.iter().copied().fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        // Each is multiplied by what is the largest of the other one at the same power.
        let most = largest(&one);
        let at = one.iter().position(|own| *own == most).unwrap_or_default();
        let factor = other[at];
        one.iter().zip(&other).all(|(a, b)| (a * factor - b * most).abs() <= SAME * (a * factor).abs())
    }

    /// Whether it is costly to tell.
    pub fn is_weave(&self) -> bool {
        self.kinds.contains(&Kind::Weave)
    }

    /// Whether an eigenvalue is zero at all speeds: then none becomes it at this one.
    fn is_singular(&self, entries: &[f64], gravity: f64) -> bool {
        let count = self.has_rate_alone.len();
        FAR.iter().all(|factor| {
            let own = self.stiffness(factor * self.speeds[0], entries, gravity);
            determinant(&own, count).re.abs() <= NOTHING * size(&own, count)
        })
    }

    fn value(&self, kind: Kind, speed: f64, entries: &[f64], gravity: f64) -> f64 {
        match kind {
            Kind::Capsize => determinant(&self.stiffness(speed, entries, gravity), self.has_rate_alone.len()).re,
            Kind::Weave => hurwitz(&self.characteristic(speed, entries, gravity)),
        }
    }

    /// What is left of the equations where the eigenvalue is zero.
    fn stiffness(&self, speed: f64, entries: &[f64], gravity: f64) -> Square {
        self.polynomials(speed, entries, gravity).iter().map(|own| Complex::new(own[0], 0.0)).collect()
    }

    /// The coefficients of the characteristic polynomial at a speed, by powers from 0 on.
    fn characteristic(&self, speed: f64, entries: &[f64], gravity: f64) -> Vec<f64> {
        let mut characteristic = of_determinant(&self.polynomials(speed, entries, gravity), self.has_rate_alone.len());
        characteristic.truncate(self.states + 1);
        characteristic
    }

    /// Those of `s^2 M + s C + K` at a speed.
    fn polynomials(&self, speed: f64, entries: &[f64], gravity: f64) -> Vec<[f64; 3]> {
        let count = self.has_rate_alone.len();
        let mut polynomials = vec![[0.0; 3]; count * count];
        for &matrix in &self.matrices {
            let (power, factor) = match matrix {
                MatrixName::M => (2, 1.0),
                MatrixName::Cm1 => (1, 1.0 / speed),
                MatrixName::C0 => (1, 1.0),
                MatrixName::C1 => (1, speed),
                MatrixName::Kc => (0, 1.0),
                MatrixName::K0 => (0, gravity),
                MatrixName::K1 => (0, speed),
                MatrixName::K2 => (0, speed * speed),
            };
            let own = &entries[matrix as usize * count * count..][..count * count];
            polynomials.iter_mut().zip(own).for_each(|(sum, entry)| sum[power] += factor * entry);
        }
        for (_, own) in polynomials.iter_mut().enumerate().filter(|(at, _)| self.has_rate_alone[at % count]) {
            // Without its position the rate is what is solved for.
            *own = [own[1], own[2], 0.0];
        }
        polynomials
    }
}

/// The determinant of a square of polynomials of second degree: row by row, of each choice of columns the minor of the rows so far.
fn of_determinant(polynomials: &[[f64; 3]], count: usize) -> Vec<f64> {
    let length = 2 * count + 1;
    let mut minors = vec![0.0; length << count];
    minors[0] = 1.0;
    for columns in 1..1 << count {
        let row = columns_of(columns) - 1;
        // Each is made of those of fewer columns, which stand before it.
        let (before, own) = minors.split_at_mut(columns * length);
        for column in (0..count).filter(|column| columns >> column & 1 == 1) {
            let sign = if columns_of(columns >> column) % 2 == 1 { 1.0 } else { -1.0 };
            let others = &before[(columns & !(1 << column)) * length..][..2 * row + 1];
            for (power, factor) in polynomials[row * count + column].iter().enumerate().filter(|own| *own.1 != 0.0) {
                let factor = sign * factor;
                own[power..].iter_mut().zip(others).for_each(|(sum, other)| *sum += factor * other);
            }
        }
    }
    minors.split_off(minors.len() - length)
}

fn columns_of(columns: usize) -> usize {
    columns.count_ones() as usize
}

/// The Hurwitz determinant before the last, which is zero where two roots have the sum 0.
fn hurwitz(coefficients: &[f64]) -> f64 {
    if let [a, b, c, d, e] = *coefficients {
        return b * (c * d - b * e) - d * d * a;
    }
    let degree = coefficients.len() - 1;
    let count = degree.saturating_sub(1);
    let entry = |row: usize, column: usize| {
        let power = (degree + row + 1).checked_sub(2 * (column + 1));
        Complex::new(power.and_then(|power| coefficients.get(power)).copied().unwrap_or(0.0), 0.0)
    };
    let rows: Square = (0..count).flat_map(|row| (0..count).map(move |column| entry(row, column))).collect();
    determinant(&rows, count).re
}

#[cfg(test)]
mod tests {
    use super::{hurwitz, of_determinant};

    /// (s + 1)(s^2 + 4) and (s + 1)(s^2 + 4)(s^2 + s + 2), multiplied by hand.
    #[test]
    fn roots_on_the_imaginary_axis_make_it_zero() {
        assert_eq!(hurwitz(&[4.0, 4.0, 1.0, 1.0]), 0.0);
        assert!(hurwitz(&[8.0, 12.0, 10.0, 7.0, 2.0, 1.0]).abs() < 1e-12);
        // (s^2 + s + 2)(s^2 + 4), and with 4.1 s^2 + 0.1 s in its place.
        assert_eq!(hurwitz(&[8.0, 4.0, 6.0, 1.0, 1.0]), 0.0);
        assert!(hurwitz(&[8.0, 4.1, 6.0, 1.0, 1.0]) != 0.0);
    }

    /// The Hurwitz determinants of s^4 + 2 s^3 + 3 s^2 + 4 s + 5 and of s^3 + 2 s^2 + 3 s + 4: 2*3*4 - 4*4 - 2*2*5, and 2*3 - 4.
    #[test]
    fn it_is_that_of_hurwitz() {
        assert_eq!(hurwitz(&[5.0, 4.0, 3.0, 2.0, 1.0]), -12.0);
        assert_eq!(hurwitz(&[4.0, 3.0, 2.0, 1.0]).abs(), 2.0);
    }

    /// The determinant of [[s^2 + 1, s], [2 s, s^2 + 3 s]]: (s^2 + 1)(s^2 + 3 s) - 2 s^2; and one of a triangle, 1 (s + 2)(s^2).
    #[test]
    fn determinants_of_polynomials_are_polynomials() {
        let two = [[1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [0.0, 3.0, 1.0]];
        assert_eq!(of_determinant(&two, 2), [0.0, 3.0, -1.0, 3.0, 1.0]);
        let zero = [0.0; 3];
        let three = [
            zero,
            [2.0, 1.0, 0.0],
            [5.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [7.0, 0.0, 0.0],
            zero,
            zero,
            zero,
            [0.0, 0.0, 1.0],
        ];
        // The first two rows are exchanged.
        assert_eq!(of_determinant(&three, 3), [0.0, 0.0, -2.0, -1.0, 0.0, 0.0, 0.0]);
    }
}
