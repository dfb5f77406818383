//! All critical speeds, as roots of polynomials in the speed.

use core::cmp::Ordering;

use nalgebra::Complex;

use super::branches::count_pairs;
use super::characteristic::Characteristic;
use super::double_root::{self, DoubleRoot};
use super::imaginary::{Pair, imaginary_pairs};
use super::ranges::is_same;
use super::verdict::{Verdict, verdict};
use super::{Change, CriticalKind, CriticalSpeed};
use crate::number::real::Real;
use crate::numeric::{DoubleDouble, Root, Tracked, positive_roots};
use crate::system::SystemError;

/// A critical speed and what the search knows beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) critical: CriticalSpeed,
    /// The scaled speed.
    pub(super) at: DoubleDouble,
    /// The verdict at that very speed; `None` where no eigenvalue is on the imaginary axis by construction.
    pub(super) there: Option<Verdict>,
    /// Whether the change is still to be read from both sides.
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
    for (root, double_root) in double_root::all(characteristic) {
        found.push(meeting(characteristic, root, double_root)?);
    }
    found.sort_by(|x, y| x.at.partial_cmp(&y.at).unwrap_or(Ordering::Equal));
    for i in 0..found.len() {
        if found[i].undecided {
            found[i].critical.change = change_around(characteristic, &found, &found[i]);
        }
    }
    Ok(found)
}

/// The change at a critical speed from what is half-way to its neighbours: the number of pairs, where two eigenvalues
/// meet, or else the verdict.
fn change_around(characteristic: &Characteristic, found: &[Found], &Found { at, critical, .. }: &Found) -> Change {
    let half = DoubleDouble::from(0.5);
    let others = found.iter().map(|found| found.at).filter(|&other| !is_same(other, at));
    let below = others.clone().rfind(|&other| other < at).unwrap_or(DoubleDouble::ZERO);
    let above = others.clone().find(|&other| other > at).unwrap_or(at + at);
    let around = [(below + at) * half, (at + above) * half];
    let [pairs_below, pairs_above] = around.map(|speed| count_pairs(characteristic.roots(speed)));
    let [unstable_below, unstable_above] = around.map(|speed| verdict(&characteristic.at(speed)) == Verdict::Unstable);
    let pairs = if critical.kind == CriticalKind::DoubleRoot { pairs_below.cmp(&pairs_above) } else { Ordering::Equal };
    match (pairs, unstable_below, unstable_above) {
        (Ordering::Less, ..) => Change::Merges,
        (Ordering::Greater, ..) => Change::Splits,
        (_, true, false) => Change::Stabilizes,
        (_, false, true) => Change::Destabilizes,
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
    let p: Vec<Tracked> = characteristic.coefficients().iter().map(|p| p.at(root.at)).collect();
    let slope = p.get(1).map_or(0, |p| p.sign());
    let change = change(-root.before * slope, -root.after * slope);
    let critical = critical_speed(characteristic, CriticalKind::Capsize, root, Complex::new(0.0, 0.0), change)?;
    let there = Some(verdict(&p[1..]).max(Verdict::Marginal));
    Ok(Found { critical, at: root.at, there, undecided: slope == 0 })
}

/// Where the Hurwitz determinant is zero, if two eigenvalues that sum to zero are imaginary.
fn weave(characteristic: &Characteristic, root: Root, found: &mut Vec<Found>) -> Result<(), SystemError> {
    for Pair { square, rest, side } in imaginary_pairs(characteristic, root) {
        let eigenvalue = Complex::new(0.0, square.sqrt().to_f64());
        let change = change(side.0, side.1);
        let critical = critical_speed(characteristic, CriticalKind::Weave, root, eigenvalue, change)?;
        let there = Some(verdict(&rest).max(Verdict::Marginal));
        found.push(Found { critical, at: root.at, there, undecided: false });
    }
    Ok(())
}

/// Where the discriminant is zero.
fn meeting(characteristic: &Characteristic, root: Root, at: DoubleRoot) -> Result<Found, SystemError> {
    let change = match at.unfolding {
        1 => Change::Merges,
        -1 => Change::Splits,
        _ => Change::Touches,
    };
    let critical = critical_speed(characteristic, CriticalKind::DoubleRoot, root, at.eigenvalue, change)?;
    Ok(Found { critical, at: root.at, there: None, undecided: at.unfolding == 0 })
}
