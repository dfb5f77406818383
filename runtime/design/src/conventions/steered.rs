//! The geometry of a bicycle by distances from its steer axis, as conventions have it whose axes are parallel to that.

use super::dual::Dual;
use super::name::Values;

/// Distances of the centres of the wheels from the steer axis and along it.
#[derive(Clone, Copy, Debug)]
pub struct Offsets {
    /// The radii of the rear and the front wheel.
    pub radii: [Dual; 2],
    /// From the centre of the rear wheel forward to the steer axis, at right angles to it.
    pub rear: Dual,
    /// How far the centre of the front wheel lies below that of the rear wheel, along the steer axis.
    pub along: Dual,
    /// From the steer axis forward to the centre of the front wheel, at right angles to it.
    pub front: Dual,
}

/// The distances of a bicycle in the paper's parameters.
pub fn offsets(paper: &Values) -> Offsets {
    let [w, c, lam, rear, front] = paper.all(["w", "c", "lam", "rR", "rF"]);
    let (sin, cos) = lam.sin_cos();
    Offsets {
        radii: [rear, front],
        rear: cos * (w + c) - rear * sin,
        along: w * sin - cos * (front - rear),
        front: front * sin - cos * c,
    }
}

/// The tilt of the steer axis; and w, c, lam, rR and rF. `names` are those of the distances, for messages.
///
/// # Errors
/// If the wheels cannot both touch the ground, or the steer axis would be level.
pub fn paper(offsets: &Offsets, names: &str) -> Result<(Dual, Values), String> {
    let Offsets { radii: [rear, front], along, .. } = *offsets;
    let across = offsets.rear + offsets.front;
    // The vector from one centre to the other, (w, rR - rF), turned into the axes of the steer axis.
    let (length, drop) = (across.hypot(along), front - rear);
    if length.value <= drop.value.abs() {
        return Err(format!("the wheels do not both touch the ground with {names}: their centres are too near"));
    }
    let lam = along.atan2(across) + (drop / length).asin();
    let (sin, cos) = lam.sin_cos();
    if cos.value <= 0.0 {
        let tilt = crate::number::fixed(lam.value.to_degrees(), 1);
        return Err(format!("the steer axis is tilted by {tilt} deg with {names}; it must be between -90 and 90 deg"));
    }
    let mut result = Values::default();
    let [w, c] = [across * cos + along * sin, (front * sin - offsets.front) / cos];
    result.extend(["w", "c", "lam", "rR", "rF"], [w, c, lam, rear, front]);
    Ok((lam, result))
}
