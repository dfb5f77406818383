//! The characteristic polynomial of two to four coordinates: its coefficients as polynomials.

use super::terms::{Product, Terms};
use crate::stability::general::equations::{Column, Equations};
use crate::stability::general::functions::{GRAVITY, ONE, OVER_SPEED, SPEED, SQUARE, Variable as Along};

/// What polynomials are in.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Variable {
    /// The scaled speed v.
    Speed,
    /// Its square: where v and the eigenvalue can change their signs together (C0 = K1 = 0), or v alone by transposing all
    /// matrices.
    Square,
}

/// An entry of the pencil, or a minor: by powers of the eigenvalue.
type ByPower<const R: usize, const S: usize> = [Terms<R>; S];

/// The most coordinates.
pub(super) const MOST: usize = 4;

/// The coefficients of the characteristic polynomial, of room for four coordinates.
pub(super) type Coefficients = [Terms<9>; 2 * MOST + 1];

/// The characteristic polynomial `det Q`.
pub(super) struct Characteristic {
    /// What the coefficients are polynomials in.
    pub(super) variable: Variable,
    /// Whether they are those of powers of the eigenvalue divided by v, which multiplies the conditions by powers of v.
    pub(super) is_divided: bool,
    /// Ascending, of as many powers of the eigenvalue as there are states, and one.
    pub(super) coefficients: Coefficients,
}

/// The most states of four coordinates with all powers of the speed: polynomials of higher degrees, up to 56, tell less than
/// interpolation in parts of the range.
const MOST_STATES: usize = 6;

/// That of two to four coordinates, without the powers of the eigenvalue that divide columns; `None` of other numbers of them.
pub(super) fn characteristic(equations: &Equations) -> Option<Characteristic> {
    let Along::Speed { gravity } = equations.variable else { return None };
    let Equations { mass, damping, stiffness, columns, .. } = equations;
    let is_even = damping.term(ONE).is_none() && stiffness.term(SPEED).is_none();
    let has_over_speed = damping.term(OVER_SPEED).is_some();
    if columns.len() == MOST && has_over_speed && !is_even && equations.states() > MOST_STATES {
        return None;
    }
    let variable = if is_even { Variable::Square } else { Variable::Speed };
    let entry = |i: usize, j: usize| -> ByPower<3, 3> {
        let [of_mass, of_damping, of_stiffness] = [mass, damping, stiffness]
            .map(|sum| move |function: usize| (sum.term(function).map_or(0.0, |matrix| matrix[i][j]), 0.0));
        let (standing, weight) = (of_stiffness(ONE), of_stiffness(GRAVITY));
        let weight = gravity * weight.0;
        let standing = (standing.0 + weight, f64::EPSILON * (standing.0.abs() + weight.abs()));
        let (m, over, c0, c1) = (of_mass(ONE), of_damping(OVER_SPEED), of_damping(ONE), of_damping(SPEED));
        let none = (0.0, 0.0);
        let [stiffness, damping, mass] = match variable {
            Variable::Square => [&[standing, of_stiffness(SQUARE)][..], &[over, c1], &[none, m]].map(Terms::new),
            Variable::Speed => {
                let stiffness = [standing, of_stiffness(SPEED), of_stiffness(SQUARE)];
                let (damping, mass): (&[_], &[_]) =
                    if has_over_speed { (&[over, c0, c1], &[none, none, m]) } else { (&[c0, c1], &[m]) };
                [&stiffness[..], damping, mass].map(Terms::new)
            }
        };
        match columns[j] {
            Column::Both => [stiffness, damping, mass],
            Column::Position => [stiffness, damping, Terms::ZERO],
            Column::Rate => [damping, mass, Terms::ZERO],
            Column::Neither => [mass, Terms::ZERO, Terms::ZERO],
        }
    };
    let row = |i: usize| move |j: usize| entry(i, j);
    let coefficients = match columns.len() {
        2 => {
            let rows: [[ByPower<3, 3>; 2]; 2] = [0, 1].map(|i| core::array::from_fn(row(i)));
            sum([(1.0, &rows[0][0], &rows[1][1]), (-1.0, &rows[0][1], &rows[1][0])].into_iter())
        }
        3 => {
            let below = minors::<3>([&row(1), &row(2)])?;
            let first: [ByPower<3, 3>; 3] = core::array::from_fn(row(0));
            // Without the column j the other two, of which the minor is.
            sum([(1.0, &first[0], &below[2]), (-1.0, &first[1], &below[1]), (1.0, &first[2], &below[0])].into_iter())
        }
        4 => {
            let [above, below] = [minors::<4>([&row(0), &row(1)])?, minors::<4>([&row(2), &row(3)])?];
            let sign = |pair: usize| if matches!(pair, 1 | 4) { -1.0 } else { 1.0 };
            sum((0..6).map(|pair| (sign(pair), &above[pair], &below[5 - pair])))
        }
        _ => None,
    };
    let coefficients: Coefficients = coefficients?;
    if variable == Variable::Speed && equations.is_reversible && !has_over_speed {
        let coefficients = coefficients.map(|p| p.in_square());
        return Some(Characteristic { variable: Variable::Square, is_divided: false, coefficients });
    }
    Some(Characteristic { variable, is_divided: is_even || has_over_speed, coefficients })
}

/// The minors of two rows in the columns 01, 02, 03, 12, 13 and 23, or 01, 02 and 12.
fn minors<const N: usize>(rows: [&dyn Fn(usize) -> ByPower<3, 3>; 2]) -> Option<[ByPower<5, 5>; 6]> {
    let rows = rows.map(|row| -> [ByPower<3, 3>; N] { core::array::from_fn(row) });
    let mut minors = [[Terms::ZERO; 5]; 6];
    let pairs = (0..N).flat_map(|i| (i + 1..N).map(move |j| (i, j)));
    for (minor, (i, j)) in minors.iter_mut().zip(pairs) {
        *minor = sum([(1.0, &rows[0][i], &rows[1][j]), (-1.0, &rows[0][j], &rows[1][i])].into_iter())?;
    }
    Some(minors)
}

/// A sum of products of polynomials in both.
fn sum<'a, const A: usize, const I: usize, const B: usize, const J: usize, const R: usize, const S: usize>(
    products: impl Iterator<Item = (f64, &'a ByPower<A, I>, &'a ByPower<B, J>)> + Clone,
) -> Option<ByPower<R, S>> {
    let mut sum = [Terms::ZERO; S];
    for (power, sum) in sum.iter_mut().enumerate() {
        let of_power = products.clone().flat_map(|(sign, a, b)| {
            let powers = power.saturating_sub(J - 1)..=power.min(I - 1);
            powers.map(move |i| -> Product<'a, A, B> { (sign, &a[i], &b[power - i]) })
        });
        *sum = Terms::sum(of_power)?;
    }
    Some(sum)
}
