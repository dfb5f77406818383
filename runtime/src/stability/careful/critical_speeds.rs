//! All critical speeds, as roots of polynomials in the speed.

use core::cmp::Ordering;

use nalgebra::Complex;

use super::double_roots::{self, DoubleRoot};
use super::found::{FoundSpeed, is_same};
use super::imaginary::{Pair, find_imaginary_pairs};
use crate::number::real::Real;
use crate::numeric::{DoubleDouble, Root, Tracked, positive_roots, sort_by};
use crate::stability::along_speed::Characteristic;
use crate::stability::critical::{Change, CriticalKind, CriticalSpeed};
use crate::stability::stretches::count_pairs;
use crate::stability::verdict::Verdict;
use crate::system::SystemError;

/// All critical speeds, ascending.
pub(super) fn find_critical_speeds(characteristic: &Characteristic) -> Result<Vec<FoundSpeed>, SystemError> {
    let mut found = Vec::new();
    let p = characteristic.coefficients();
    for root in positive_roots(&p[0]) {
        found.push(find_capsize(characteristic, root)?);
    }
    for root in positive_roots(&characteristic.hurwitz()) {
        find_weave(characteristic, root, &mut found)?;
    }
    for (root, double_root) in double_roots::find_double_roots(characteristic) {
        found.push(find_meeting(characteristic, root, double_root)?);
    }
    sort_by(&mut found, |x, y| x.at.partial_cmp(&y.at).unwrap_or(Ordering::Equal));
    for i in 0..found.len() {
        if found[i].undecided {
            found[i].critical.change = change_around(characteristic, &found, &found[i]);
        }
    }
    Ok(found)
}

/// The change at a critical speed from what is half-way to its neighbours: the number of pairs, where two eigenvalues
/// meet, or else the verdict.
fn change_around(
    characteristic: &Characteristic,
    found: &[FoundSpeed],
    &FoundSpeed { at, critical, .. }: &FoundSpeed,
) -> Change {
    let half = DoubleDouble::from(0.5);
    let others = found.iter().map(|found| found.at).filter(|&other| !is_same(other, at));
    let below = others.clone().rfind(|&other| other < at).unwrap_or(DoubleDouble::ZERO);
    let above = others.clone().find(|&other| other > at).unwrap_or(at + at);
    let around = [(below + at) * half, (at + above) * half];
    let [pairs_below, pairs_above] = around.map(|speed| count_pairs(characteristic.roots(speed)));
    let [unstable_below, unstable_above] =
        around.map(|speed| Verdict::of_polynomial(&characteristic.at(speed)) == Verdict::Unstable);
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
    let eigenvalue = characteristic.eigenvalue(eigenvalue);
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
fn find_capsize(characteristic: &Characteristic, root: Root) -> Result<FoundSpeed, SystemError> {
    let p: Vec<Tracked> = characteristic.coefficients().iter().map(|p| p.at(root.at)).collect();
    let slope = p.get(1).map_or(0, |p| p.sign());
    let change = change(-root.before * slope, -root.after * slope);
    let critical = critical_speed(characteristic, CriticalKind::Capsize, root, Complex::new(0.0, 0.0), change)?;
    let there = Some(Verdict::of_polynomial(&p[1..]).max(Verdict::Marginal));
    Ok(FoundSpeed { critical, at: root.at, there, undecided: slope == 0 })
}

/// Where the Hurwitz determinant is zero, if two eigenvalues that sum to zero are imaginary.
fn find_weave(characteristic: &Characteristic, root: Root, found: &mut Vec<FoundSpeed>) -> Result<(), SystemError> {
    for Pair { square, rest, side } in find_imaginary_pairs(characteristic, root) {
        let eigenvalue = Complex::new(0.0, square.sqrt().to_f64());
        let change = change(side.0, side.1);
        let critical = critical_speed(characteristic, CriticalKind::Weave, root, eigenvalue, change)?;
        let there = Some(Verdict::of_polynomial(&rest).max(Verdict::Marginal));
        found.push(FoundSpeed { critical, at: root.at, there, undecided: false });
    }
    Ok(())
}

/// Where the discriminant is zero.
fn find_meeting(characteristic: &Characteristic, root: Root, at: DoubleRoot) -> Result<FoundSpeed, SystemError> {
    let change = match at.unfolding {
        1 => Change::Merges,
        -1 => Change::Splits,
        _ => Change::Touches,
    };
    let critical = critical_speed(characteristic, CriticalKind::DoubleRoot, root, at.eigenvalue, change)?;
    Ok(FoundSpeed { critical, at: root.at, there: None, undecided: at.unfolding == 0 })
}
