//! Where the wheels of a bicycle touch the ground.

use carvallo::nalgebra::{Rotation3, Unit, Vector3};

use super::motion::{Motion, Row};

/// The paths of the wheels over the ground, x forward and y to the right, as far as they are known: of the rear wheel, or
/// that whose place is told, and of the front wheel of a bicycle.
pub fn paths(motion: &Motion) -> Vec<(&'static str, Vec<(f64, f64)>)> {
    let (Some(x), Some(y)) = (motion.position("x"), motion.position("y")) else { return Vec::new() };
    let rear = motion.rows.iter().map(|row| (row.positions[x], row.positions[y])).collect();
    let front: Option<Vec<(f64, f64)>> = motion.rows.iter().map(|row| front(motion, row)).collect();
    let mut paths = vec![("rear wheel", rear)];
    paths.extend(front.map(|front| ("front wheel", front)));
    paths
}

/// Where the front wheel touches the ground. Of linear motions that is to first order.
fn front(motion: &Motion, row: &Row) -> Option<(f64, f64)> {
    let value = |name: &str| motion.design.value(name);
    let position = |name: &str| Some(row.positions[motion.position(name)?]);
    let (w, c, lam) = (value("w")?, value("c")?, value("lam")?);
    let (rear_radius, front_radius) = (value("rR")?, value("rF")?);
    let (x, y, yaw) = (position("x")?, position("y")?, position("psi")?);
    let (lean, steer) = (position("phi")?, position("delta")?);
    if motion.is_linear {
        return Some((x + w, y + w * yaw - c * lam.cos() * steer));
    }
    let heading = Rotation3::from_axis_angle(&Vector3::z_axis(), yaw);
    let frame = heading
        * Rotation3::from_axis_angle(&Vector3::x_axis(), lean)
        * Rotation3::from_axis_angle(&Vector3::y_axis(), position("pitch")?);
    let steered =
        frame * Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::new(lam.sin(), 0.0, lam.cos())), steer);
    let rear_centre = Vector3::new(x, y, 0.0) - rear_radius * downward(&frame);
    // A point on the steer axis, and the centre of the front wheel from there, in the reference position.
    let axis = Vector3::new(w + c, 0.0, rear_radius);
    let front_centre = rear_centre + frame * axis + steered * Vector3::new(-c, 0.0, -front_radius);
    let contact = front_centre + front_radius * downward(&steered);
    Some((contact.x, contact.y))
}

/// The direction from the centre of a wheel to its lowest point; its axle is along y.
fn downward(wheel: &Rotation3<f64>) -> Vector3<f64> {
    let axle = wheel * Vector3::y();
    (Vector3::z() - axle * axle.z).normalize()
}
