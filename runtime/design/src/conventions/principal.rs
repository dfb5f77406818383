//! Principal radii of gyration and the angles of principal axes, as Moore and Hubbard (2019) have them, and the sets
//! `principal` (`Moore2019`) of BicycleParameters.
//!
//! Five bodies: the rear frame D, a rigid person P, the front frame H, and the wheels R and F. Axes as in the paper; an angle
//! alpha is that from the x-axis to the principal axis a, from z to x, so that it tips a forward end upward.

use std::f64::consts::FRAC_PI_2;

use super::Convention;
use super::dual::Dual;
use super::name::{AXISYMMETRIC, Name, Need, SYMMETRIC, Values};
use super::tensor::{Body, Tensor};

pub const PRINCIPAL: Convention = Convention {
    name: "principal",
    others: &["Moore2019", "moore2019"],
    title: "principal radii of gyration, as Moore and Hubbard (2019)",
    names: NAMES,
    alternatives: &[],
    prepare: |_, _| {},
    to_paper,
    from_paper,
    complete: super::nothing,
};

const DRAWN: Need = Need::Ignored("only pictures of the person have it");

const NAMES: &[Name] = &[
    Name::new("w", "m", "Wheel base"),
    Name::new("c", "m", "Trail"),
    Name::new("lam", "rad", "Steer axis tilt").or(&["lambda", "lamda"]),
    Name::new("g", "N/kg", "Gravitational field strength").or(&["gravity"]).optional(),
    Name::new("rR", "m", "Radius of the rear wheel").positive(),
    Name::new("mR", "kg", "Mass of the rear wheel").not_negative(),
    Name::new("kRaa", "m", "Radius of gyration of the rear wheel, radial"),
    Name::new("kRyy", "m", "Radius of gyration of the rear wheel, axial"),
    Name::new("xD", "m", "Centre of mass of the rear frame, forward of the rear contact"),
    Name::new("zD", "m", "Centre of mass of the rear frame, downward"),
    Name::new("mD", "kg", "Mass of the rear frame").not_negative(),
    Name::new("kDaa", "m", "Radius of gyration of the rear frame about its principal axis a"),
    Name::new("kDbb", "m", "Radius of gyration of the rear frame about its principal axis b"),
    Name::new("kDyy", "m", "Radius of gyration of the rear frame in pitch"),
    Name::new("alphaD", "rad", "Angle of the principal axis a of the rear frame"),
    Name::new("xP", "m", "Centre of mass of the person, forward of the rear contact"),
    Name::new("zP", "m", "Centre of mass of the person, downward"),
    Name::new("mP", "kg", "Mass of the person").not_negative(),
    Name::new("kPaa", "m", "Radius of gyration of the person about its principal axis a"),
    Name::new("kPbb", "m", "Radius of gyration of the person about its principal axis b"),
    Name::new("kPyy", "m", "Radius of gyration of the person in pitch"),
    Name::new("alphaP", "rad", "Angle of the principal axis a of the person"),
    Name::new("xH", "m", "Centre of mass of the front frame, forward of the rear contact"),
    Name::new("zH", "m", "Centre of mass of the front frame, downward"),
    Name::new("mH", "kg", "Mass of the front frame").not_negative(),
    Name::new("kHaa", "m", "Radius of gyration of the front frame about its principal axis a"),
    Name::new("kHbb", "m", "Radius of gyration of the front frame about its principal axis b"),
    Name::new("kHyy", "m", "Radius of gyration of the front frame in pitch"),
    Name::new("alphaH", "rad", "Angle of the principal axis a of the front frame"),
    Name::new("rF", "m", "Radius of the front wheel").positive(),
    Name::new("mF", "kg", "Mass of the front wheel").not_negative(),
    Name::new("kFaa", "m", "Radius of gyration of the front wheel, radial"),
    Name::new("kFyy", "m", "Radius of gyration of the front wheel, axial"),
    Name::extra("kRbb", "m", Need::Equal("kRaa", AXISYMMETRIC)),
    Name::extra("kFbb", "m", Need::Equal("kFaa", AXISYMMETRIC)),
    Name::extra("xF", "m", Need::Equal("w", "the front wheel stands at the wheel base")),
    Name::extra("xR", "m", Need::Zero("places are measured from the rear contact")),
    Name::extra("yD", "m", SYMMETRIC),
    Name::extra("yP", "m", SYMMETRIC),
    Name::extra("yH", "m", SYMMETRIC),
    Name::extra("yR", "m", SYMMETRIC),
    Name::extra("yF", "m", SYMMETRIC),
    Name::extra("zR", "m", Need::Ignored("a wheel is as high as its radius")),
    Name::extra("zF", "m", Need::Ignored("a wheel is as high as its radius")),
    Name::extra("alphaR", "rad", Need::Ignored("a wheel has no principal axis a of its own")),
    Name::extra("alphaF", "rad", Need::Ignored("a wheel has no principal axis a of its own")),
    Name::extra("lP", "m", DRAWN),
    Name::extra("wP", "m", DRAWN),
    Name::extra("v", "m/s", Need::Ignored("the speeds come from --speeds")),
];

/// What both conventions have.
const SHARED: [&str; 11] = ["w", "c", "lam", "g", "rR", "mR", "rF", "mF", "xH", "zH", "mH"];

fn to_paper(given: &Values) -> Result<Values, String> {
    let mut result = Values::default();
    result.keep(given, &SHARED);
    for (mass, names, moments) in
        [("mR", ["kRaa", "kRyy"], ["IRxx", "IRyy"]), ("mF", ["kFaa", "kFyy"], ["IFxx", "IFyy"])]
    {
        let [mass] = given.all([mass]);
        result.extend(moments, given.all(names).map(|radius| mass * radius.square()));
    }
    let body = |[x, z, mass]: [&str; 3], [aa, yy, bb, angle]: [&str; 4]| {
        let [x, z, mass, angle] = given.all([x, z, mass, angle]);
        let [xx, yy, zz] = given.all([aa, yy, bb]).map(|radius| mass * radius.square());
        Body { mass, centre: [x, z], inertia: Tensor { xx, yy, zz, xz: Dual::default() }.turned(-angle) }
    };
    let frame = body(["xD", "zD", "mD"], ["kDaa", "kDyy", "kDbb", "alphaD"]);
    let person = body(["xP", "zP", "mP"], ["kPaa", "kPyy", "kPbb", "alphaP"]);
    let Body { mass, centre: [x, z], inertia } = Body::joined(&[frame, person]);
    result.extend(["xB", "zB", "mB"], [x, z, mass]);
    result.extend(["IBxx", "IByy", "IBzz", "IBxz"], inertia.entries());
    let front = body(["xH", "zH", "mH"], ["kHaa", "kHyy", "kHbb", "alphaH"]);
    result.extend(["IHxx", "IHyy", "IHzz", "IHxz"], front.inertia.entries());
    Ok(result)
}

fn from_paper(given: &Values) -> Result<Values, String> {
    let mut result = Values::default();
    let radius = |moment: Dual, mass: &str, what: &str| {
        let [mass] = given.all([mass]);
        let moment = if moment.value == 0.0 { Dual::default() } else { moment };
        match (moment.value, mass.value) {
            (0.0, _) => Ok(moment),
            (_, 0.0) => Err(format!("{what} has inertia and no mass, and so no radius of gyration")),
            (moment, _) if moment < 0.0 => {
                let moment = crate::number::with_unit(moment, "kg*m^2");
                Err(format!("{what} has a principal moment of inertia of {moment}, and so no radius of gyration"))
            }
            _ => Ok((moment / mass).sqrt()),
        }
    };
    let mut wheel = |names: [&'static str; 2], mass: &str, moments, what| {
        let [radial, axial] = given.all(moments);
        result.extend(names, [radius(radial, mass, what)?, radius(axial, mass, what)?]);
        Ok::<_, String>(())
    };
    wheel(["kRaa", "kRyy"], "mR", ["IRxx", "IRyy"], "the rear wheel")?;
    wheel(["kFaa", "kFyy"], "mF", ["IFxx", "IFyy"], "the front wheel")?;
    let mut frame = |names: [&'static str; 4], mass: &str, moments, what| {
        let tensor = Tensor::new(given.all(moments));
        let ([a, b], angle) = tensor.principal();
        // As in the published sets, a is the axis of the larger moment.
        let quarter = Dual::constant(FRAC_PI_2);
        let (a, b, angle) = if a.value < b.value { (b, a, angle + quarter) } else { (a, b, angle) };
        let [aa, bb, yy] = [radius(a, mass, what)?, radius(b, mass, what)?, radius(tensor.yy, mass, what)?];
        result.extend(names, [aa, bb, yy, angle]);
        Ok::<_, String>(())
    };
    frame(["kDaa", "kDbb", "kDyy", "alphaD"], "mB", ["IBxx", "IByy", "IBzz", "IBxz"], "the rear frame")?;
    frame(["kHaa", "kHbb", "kHyy", "alphaH"], "mH", ["IHxx", "IHyy", "IHzz", "IHxz"], "the front frame")?;
    result.keep(given, &SHARED);
    // The frame and the person are one body in the paper: all of it is here the frame.
    let [x, z, mass] = given.all(["xB", "zB", "mB"]);
    result.extend(["xD", "zD", "mD"], [x, z, mass]);
    result.extend(["xP", "zP"], [x, z]);
    let none = [Dual::default(); 5];
    result.extend(["mP", "kPaa", "kPbb", "kPyy", "alphaP"], none);
    Ok(result)
}
