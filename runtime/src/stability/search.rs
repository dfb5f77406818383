//! All critical speeds, as roots of polynomials in the speed.

use core::cmp::Ordering;

use super::characteristic::Characteristic;
use super::double_root;
use super::ranges::is_same;
use super::verdict::{Verdict, verdict};
use super::{Change, CriticalKind, CriticalSpeed};
use crate::numeric::{DoubleDouble, Real, Root, Sum, positive_roots};
use crate::{Complex, SystemError};

/// A critical speed and what the search knows beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) critical: CriticalSpeed,
    /// The scaled speed.
    pub(super) at: DoubleDouble,
    /// The verdict at that very speed; `None` where no eigenvalue is on the imaginary axis by construction.
    pub(super) there: Option<Verdict>,
    /// Whether the change is still to be read from the verdicts on both sides.
    pub(super) undecided: bool,
}

/// All critical speeds, ascending.
pub(super) fn search(characteristic: &Characteristic) -> Result<Vec<Found>, SystemError> {
    let mut found = Vec::new();
    let p = characteristic.coefficients();
    for root in positive_roots(&p[0]) {
        found.push(capsize(characteristic, root)?);
    }
    for root in positive_roots(&characteristic.hurwitz()) {
        weave(characteristic, root, &mut found)?;
    }
    for root in positive_roots(&characteristic.discriminant()) {
        found.push(double_root(characteristic, root)?);
    }
    found.sort_by(|x, y| x.at.partial_cmp(&y.at).unwrap_or(Ordering::Equal));
    for i in 0..found.len() {
        if found[i].undecided {
            found[i].critical.change = change_of_verdict(characteristic, &found, found[i].at);
        }
    }
    Ok(found)
}

/// The change at a speed by the verdicts half-way to its neighbours.
fn change_of_verdict(characteristic: &Characteristic, found: &[Found], at: DoubleDouble) -> Change {
    let half = DoubleDouble::from(0.5);
    let others = found.iter().map(|found| found.at).filter(|&other| !is_same(other, at));
    let below = others.clone().rfind(|&other| other < at).unwrap_or(DoubleDouble::ZERO);
    let above = others.clone().find(|&other| other > at).unwrap_or(at + at);
    let is_unstable = |speed| i8::from(verdict(&characteristic.at(speed)) == Verdict::Unstable);
    match is_unstable((at + above) * half) - is_unstable((below + at) * half) {
        -1 => Change::Stabilizes,
        1 => Change::Destabilizes,
        _ => Change::Touches,
    }
}

fn critical_speed(
    characteristic: &Characteristic,
    kind: CriticalKind,
    root: Root,
    eigenvalue: Complex<f64>,
    change: Change,
) -> Result<CriticalSpeed, SystemError> {
    let speed = characteristic.speed(root.at.to_f64());
    let error = characteristic.speed(root.error) + 0.5 * f64::EPSILON * speed;
    let eigenvalue = Complex::new(characteristic.eigenvalue(eigenvalue.re), characteristic.eigenvalue(eigenvalue.im));
    let is_finite = [speed, error, eigenvalue.re, eigenvalue.im].iter().all(|number| number.is_finite());
    if is_finite && speed > 0.0 {
        Ok(CriticalSpeed { kind, speed, error, eigenvalue, change })
    } else {
        Err(SystemError::OutOfRange { quantity: "a critical speed" })
    }
}

/// The change of a quantity whose sign is that of a real part.
fn change(before: i8, after: i8) -> Change {
    match (before, after) {
        (1, -1) => Change::Stabilizes,
        (-1, 1) => Change::Destabilizes,
        _ => Change::Touches,
    }
}

/// Where the lowest coefficient is zero. Nearby the eigenvalue is about `-p_0 / p_1`.
fn capsize(characteristic: &Characteristic, root: Root) -> Result<Found, SystemError> {
    let p: Vec<Sum> = characteristic.coefficients().iter().map(|p| p.at(root.at)).collect();
    let slope = p.get(1).map_or(0, |p| p.sign());
    let change = change(-root.before * slope, -root.after * slope);
    let critical = critical_speed(characteristic, CriticalKind::Capsize, root, Complex::new(0.0, 0.0), change)?;
    let there = Some(verdict(&p[1..]).max(Verdict::Marginal));
    Ok(Found { critical, at: root.at, there, undecided: slope == 0 })
}

/// Where the Hurwitz determinant is zero, if two eigenvalues that sum to zero are imaginary.
fn weave(characteristic: &Characteristic, root: Root, found: &mut Vec<Found>) -> Result<(), SystemError> {
    let p: Vec<Sum> = characteristic.coefficients().iter().map(|p| p.at(root.at)).collect();
    for Pair { square, rest, sign } in imaginary_pairs(&p) {
        let eigenvalue = Complex::new(0.0, square.sqrt().to_f64());
        let change = change(sign * root.before, sign * root.after);
        let critical = critical_speed(characteristic, CriticalKind::Weave, root, eigenvalue, change)?;
        let there = Some(verdict(&rest).max(Verdict::Marginal));
        found.push(Found { critical, at: root.at, there, undecided: sign == 0 });
    }
    Ok(())
}

/// The eigenvalues +-i omega of a polynomial whose Hurwitz determinant is zero.
struct Pair {
    /// The square of omega.
    square: DoubleDouble,
    /// The polynomial of the other eigenvalues.
    rest: Vec<Sum>,
    /// The sign of the real part of the pair at speeds nearby where the determinant is positive; zero if it has none.
    ///
    /// The determinant is, up to a positive factor, a product of sums of two eigenvalues. The factors that have a sign
    /// are the real part of the pair and, for a quartic, the sum `-p_3 / p_4` of the other two eigenvalues.
    sign: i8,
}

fn imaginary_pairs(p: &[Sum]) -> Vec<Pair> {
    let one_pair = |numerator: Sum, denominator: Sum, rest: Vec<Sum>, sign| {
        let imaginary = numerator.sign() * denominator.sign() > 0;
        imaginary.then(|| Pair { square: numerator.value / denominator.value, rest, sign }).into_iter().collect()
    };
    match *p {
        [p0, p1, p2, p3, p4] if p1.sign() == 0 && p3.sign() == 0 => {
            // A quadratic in s^2: both pairs are symmetric, and the determinant does not tell them apart.
            let square = p2 * p2 * 0.25.into() - p0 * p4;
            let (half, root) = (p2.value * 0.5.into(), square.value.sqrt());
            let squares = [(half - root) / p4.value, (half + root) / p4.value];
            let pair = |square: DoubleDouble, other: DoubleDouble| {
                let rest = vec![other.into(), Sum::ZERO, Sum::from(1.0)];
                Pair { square, rest, sign: 0 }
            };
            let pairs = [pair(squares[0], squares[1]), pair(squares[1], squares[0])];
            pairs.into_iter().filter(|pair| square.sign() >= 0 && pair.square > DoubleDouble::ZERO).collect()
        }
        [p0, p1, _, p3, p4] => one_pair(p1, p3, vec![p0, p3, p4], -p3.sign()),
        [_, p1, p2, p3] => one_pair(p1, p3, vec![p2, p3], -1),
        [p0, _, p2] => one_pair(p0, p2, vec![p2], -1),
        _ => Vec::new(),
    }
}

/// Where the discriminant is zero. Near a real double eigenvalue `s^2 = -2 p_v v / p_ss`, both measured from there.
fn double_root(characteristic: &Characteristic, mut root: Root) -> Result<Found, SystemError> {
    let at = double_root::find(characteristic, &mut root);
    let change = match at.unfolding {
        1 => Change::Merges,
        -1 => Change::Splits,
        _ => Change::Touches,
    };
    let critical = critical_speed(characteristic, CriticalKind::DoubleRoot, root, at.eigenvalue, change)?;
    Ok(Found { critical, at: root.at, there: None, undecided: at.eigenvalue.im != 0.0 })
}
