//! Two gyrostats, as in the programs of Peterson: the rear wheel with the rear frame, and the front wheel with the front
//! frame, each with its mass, its centre and its inertia as one body, and the axial moment of inertia of its wheel. That is
//! all that motions depend on.
//!
//! Axes are parallel to the steer axis (z) and across it (x); centres of mass are measured from the centres of the wheels.

use super::Convention;
use super::dual::Dual;
use super::name::{Name, Need, Values};
use super::steered::{Offsets, offsets, paper};
use super::tensor::{Body, Tensor, turned};

pub const GYROSTATS: Convention = Convention {
    name: "gyrostats",
    others: &["gyrostat"],
    title: "two gyrostats",
    names: NAMES,
    alternatives: &[],
    prepare: |_, _| {},
    to_paper,
    from_paper,
    complete: super::nothing,
};

/// What a file of gyrostats need not have, and what four bodies cannot be told from them without.
pub const SPLIT: [&str; 4] = ["mR", "IRxx", "mF", "IFxx"];

pub const EDGED: Need = Need::Zero("wheels are edged here, and a crown is not part of the model");

/// The wheels by themselves.
pub const WHEELS: [Name; 4] = [
    Name::new(SPLIT[0], "kg", "Mass of the rear wheel alone").not_negative().optional(),
    Name::new(SPLIT[1], "kg*m^2", "Radial moment of inertia of the rear wheel alone").optional(),
    Name::new(SPLIT[2], "kg", "Mass of the front wheel alone").not_negative().optional(),
    Name::new(SPLIT[3], "kg*m^2", "Radial moment of inertia of the front wheel alone").optional(),
];

const NAMES: &[Name] = &[
    Name::new("rr", "m", "Radius of the rear wheel").positive(),
    Name::new("rf", "m", "Radius of the front wheel").positive(),
    Name::new("lr", "m", "Distance of the steer axis from the centre of the rear wheel"),
    Name::new("ls", "m", "Distance of the wheels' centres along the steer axis"),
    Name::new("lf", "m", "Distance of the centre of the front wheel from the steer axis: the fork offset"),
    Name::new("mr", "kg", "Mass of the rear wheel and frame").not_negative(),
    Name::new("lrx", "m", "Centre of mass of the rear wheel and frame, across the steer axis"),
    Name::new("lrz", "m", "Centre of mass of the rear wheel and frame, along the steer axis, downward"),
    Name::new("IDxx", "kg*m^2", "Moment of inertia of the rear wheel and frame, across the steer axis"),
    Name::new("IDyy", "kg*m^2", "Moment of inertia of the rear frame in pitch, with the mass of its wheel").optional(),
    Name::new("IDzz", "kg*m^2", "Moment of inertia of the rear wheel and frame, along the steer axis"),
    Name::new("IDxz", "kg*m^2", "Product of inertia of the rear wheel and frame"),
    Name::new("ICyy", "kg*m^2", "Axial moment of inertia of the rear wheel"),
    Name::new("mf", "kg", "Mass of the front wheel and frame").not_negative(),
    Name::new("lfx", "m", "Centre of mass of the front wheel and frame, across the steer axis"),
    Name::new("lfz", "m", "Centre of mass of the front wheel and frame, along the steer axis, downward"),
    Name::new("IExx", "kg*m^2", "Moment of inertia of the front wheel and frame, across the steer axis"),
    Name::new("IEyy", "kg*m^2", "Moment of inertia of the front frame in pitch, with the mass of its wheel").optional(),
    Name::new("IEzz", "kg*m^2", "Moment of inertia of the front wheel and frame, along the steer axis"),
    Name::new("IExz", "kg*m^2", "Product of inertia of the front wheel and frame"),
    Name::new("IFyy", "kg*m^2", "Axial moment of inertia of the front wheel"),
    Name::new("g", "N/kg", "Gravitational field strength").or(&["gravity"]).optional(),
    WHEELS[0],
    WHEELS[1],
    WHEELS[2],
    WHEELS[3],
    Name::extra("rrt", "m", EDGED),
    Name::extra("rft", "m", EDGED),
];

/// A wheel by itself, at the origin of its gyrostat: as it is given, or else without mass and as flat as wheels are, which
/// changes no motion.
fn wheel(given: &Values, [mass, radial]: [&str; 2], axial: Dual) -> Body {
    let [mass] = given.all([mass]);
    let radial = given.get(radial).unwrap_or(0.5 * axial);
    let inertia = Tensor { xx: radial, zz: radial, ..Tensor::default() };
    Body { mass, inertia, ..Body::default() }
}

fn to_paper(given: &Values) -> Result<Values, String> {
    let [rr, rf, lr, ls, lf] = given.all(["rr", "rf", "lr", "ls", "lf"]);
    let (lam, mut result) = paper(&Offsets { radii: [rr, rf], rear: lr, along: ls, front: lf }, "lr, ls and lf")?;
    let [w] = result.all(["w"]);
    let gyrostat = |[mass, x, z]: [&str; 3], moments| {
        let [mass, x, z] = given.all([mass, x, z]);
        Body { mass, centre: turned([x, z], -lam), inertia: Tensor::new(given.all(moments)).turned(-lam) }
    };
    let [axial_rear, axial_front] = given.all(["ICyy", "IFyy"]);
    let [rear_wheel, front_wheel] =
        [wheel(given, ["mR", "IRxx"], axial_rear), wheel(given, ["mF", "IFxx"], axial_front)];
    let rear = gyrostat(["mr", "lrx", "lrz"], ["IDxx", "IDyy", "IDzz", "IDxz"]).without(rear_wheel);
    let front = gyrostat(["mf", "lfx", "lfz"], ["IExx", "IEyy", "IEzz", "IExz"]).without(front_wheel);
    for (body, wheel, what) in [(&rear, "mR", "mr"), (&front, "mF", "mf")] {
        if body.mass.value < 0.0 {
            return Err(format!("the wheel has more mass, `{wheel}`, than it has with its frame, `{what}`"));
        }
    }
    let [xb, zb] = rear.centre;
    let [xh, zh] = front.centre;
    result.extend(["xB", "zB", "mB"], [xb, zb - rr, rear.mass]);
    result.extend(["xH", "zH", "mH"], [w + xh, zh - rf, front.mass]);
    result.extend(["mR", "IRxx", "IRyy"], [rear_wheel.mass, rear_wheel.inertia.xx, axial_rear]);
    result.extend(["mF", "IFxx", "IFyy"], [front_wheel.mass, front_wheel.inertia.xx, axial_front]);
    result.extend(["IBxx", "IBzz", "IBxz"], [rear.inertia.xx, rear.inertia.zz, rear.inertia.xz]);
    result.extend(["IHxx", "IHzz", "IHxz"], [front.inertia.xx, front.inertia.zz, front.inertia.xz]);
    for (name, from, body) in [("IByy", "IDyy", rear), ("IHyy", "IEyy", front)] {
        if given.get(from).is_some() {
            result.push(name, body.inertia.yy);
        }
    }
    result.keep(given, &["g"]);
    Ok(result)
}

fn from_paper(given: &Values) -> Result<Values, String> {
    let [w, lam, rr, rf] = given.all(["w", "lam", "rR", "rF"]);
    let Offsets { rear, along, front, .. } = offsets(given);
    let mut result = Values::default();
    result.extend(["rr", "rf", "lr", "ls", "lf"], [rr, rf, rear, along, front]);
    let [axial_rear, axial_front] = given.all(["IRyy", "IFyy"]);
    let [rear_wheel, front_wheel] =
        [wheel(given, ["mR", "IRxx"], axial_rear), wheel(given, ["mF", "IFxx"], axial_front)];
    let frame = |mass, centre, moments| Body { mass, centre, inertia: Tensor::new(given.all(moments)) };
    let [xb, zb, xh, zh, mb, mh] = given.all(["xB", "zB", "xH", "zH", "mB", "mH"]);
    let gyrostat = |body: Body, wheel: Body| {
        let Body { mass, centre, inertia } = Body::joined(&[body, wheel]);
        (mass, turned(centre, lam), inertia.turned(lam).entries())
    };
    let (mass, centre, moments) = gyrostat(frame(mb, [xb, zb + rr], ["IBxx", "IByy", "IBzz", "IBxz"]), rear_wheel);
    result.push("mr", mass);
    result.extend(["lrx", "lrz"], centre);
    result.extend(["IDxx", "IDyy", "IDzz", "IDxz"], moments);
    result.push("ICyy", axial_rear);
    let (mass, centre, moments) = gyrostat(frame(mh, [xh - w, zh + rf], ["IHxx", "IHyy", "IHzz", "IHxz"]), front_wheel);
    result.push("mf", mass);
    result.extend(["lfx", "lfz"], centre);
    result.extend(["IExx", "IEyy", "IEzz", "IExz"], moments);
    result.push("IFyy", axial_front);
    result.keep(given, &["g"]);
    result.keep(given, &SPLIT);
    Ok(result)
}
