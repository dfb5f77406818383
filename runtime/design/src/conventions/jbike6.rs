//! The files of JBike6 (Schwab, Papadopoulos, Ruina & Dressel): scripts of MATLAB with seven bodies, y pointing up.
//!
//! The origin is the rear contact point, x points forward, y up and z to the right. Each body has its moments of inertia about
//! its principal axes 1 and 2 and about z, `I… = [I11 I22 Izz]`, and `alpha…`, the angle from the x-axis to axis 1, positive
//! from x to y. The centres of fork and basket are in axes u and v, which are x and y turned by the tilt of the steer axis,
//! from where that meets the ground.

use super::Convention;
use super::dual::Dual;
use super::name::{AXISYMMETRIC, Name, Values};
use super::tensor::{Body, Tensor, turned};

pub const JBIKE6: Convention = Convention {
    name: "jbike6",
    others: &["JBike6"],
    title: "the names of JBike6",
    names: NAMES,
    alternatives: &[&[&["head_angle"], &["lambda"]]],
    prepare: super::arrays::spread,
    to_paper,
    from_paper,
    complete: super::nothing,
};

/// What a moment of inertia and a list of three are called in a script: `Irider = [I11rider I22rider Izzrider]`.
pub const BODIES: [&str; 7] = ["rearwheel", "frontwheel", "rider", "frame", "fork", "basket", "rack"];

macro_rules! body {
    ($what:literal, $mass:literal, $first:literal, $second:literal, $third:literal, $angle:literal) => {
        [
            Name::new($mass, "kg", concat!("Mass of the ", $what)).not_negative(),
            Name::new($first, "kg*m^2", concat!("Moment of inertia of the ", $what, " about its principal axis 1")),
            Name::new($second, "kg*m^2", concat!("Moment of inertia of the ", $what, " about its principal axis 2")),
            Name::new($third, "kg*m^2", concat!("Moment of inertia of the ", $what, " about z")),
            Name::new($angle, "rad", concat!("Angle from the x-axis to the principal axis 1 of the ", $what))
                .optional(),
        ]
    };
}

const REAR_WHEEL: [Name; 5] =
    body!("rear wheel", "mrearwheel", "I11rearwheel", "I22rearwheel", "Izzrearwheel", "alphaIrearwheel");
const FRONT_WHEEL: [Name; 5] =
    body!("front wheel", "mfrontwheel", "I11frontwheel", "I22frontwheel", "Izzfrontwheel", "alphaIfrontwheel");
const RIDER: [Name; 5] = body!("rider", "mrider", "I11rider", "I22rider", "Izzrider", "alphaIrider");
const FRAME: [Name; 5] = body!("frame", "mframe", "I11frame", "I22frame", "Izzframe", "alphaIframe");
const FORK: [Name; 5] = body!("fork", "mfork", "I11fork", "I22fork", "Izzfork", "alphaIfork");
const BASKET: [Name; 5] = body!("basket", "mbasket", "I11basket", "I22basket", "Izzbasket", "alphaIbasket");
const RACK: [Name; 5] = body!("rack", "mrack", "I11rack", "I22rack", "Izzrack", "alphaIrack");

const NAMES: &[Name] = &{
    let [a, b, c, d, e] = REAR_WHEEL;
    let [f, g, h, i, j] = FRONT_WHEEL;
    let [k, l, m, n, o] = RIDER;
    let [p, q, r, s, t] = FRAME;
    let [u, v, w, x, y] = FORK;
    let [z, aa, ab, ac, ad] = BASKET;
    let [ae, af, ag, ah, ai] = RACK;
    [
        Name::new("wheelbase", "m", "Wheel base"),
        Name::new("head_angle", "rad", "Angle of the steer axis from the ground").rising().optional(),
        Name::new("lambda", "rad", "Tilt of the steer axis from the vertical").or(&["lamda", "lam"]).optional(),
        Name::new("trail", "m", "Trail"),
        Name::new("gravity", "N/kg", "Gravitational field strength").or(&["g"]).optional(),
        Name::new("Drearwheel", "m", "Diameter of the rear wheel").positive(),
        a,
        b,
        c,
        d,
        e,
        Name::new("Dfrontwheel", "m", "Diameter of the front wheel").positive(),
        f,
        g,
        h,
        i,
        j,
        k,
        Name::new("xcmrider", "m", "Centre of mass of the rider, forward of the rear contact"),
        Name::new("ycmrider", "m", "Centre of mass of the rider, upward"),
        l,
        m,
        n,
        o,
        p,
        Name::new("xcmframe", "m", "Centre of mass of the frame, forward of the rear contact"),
        Name::new("ycmframe", "m", "Centre of mass of the frame, upward"),
        q,
        r,
        s,
        t,
        u,
        Name::new("ucmfork", "m", "Centre of mass of the fork, forward of the steer axis"),
        Name::new("vcmfork", "m", "Centre of mass of the fork, up along the steer axis from the ground"),
        v,
        w,
        x,
        y,
        z,
        Name::new("ucmbasket", "m", "Centre of mass of the basket, forward of the steer axis"),
        Name::new("vcmbasket", "m", "Centre of mass of the basket, up along the steer axis from the ground"),
        aa,
        ab,
        ac,
        ad,
        ae,
        Name::new("xcmrack", "m", "Centre of mass of the rack, forward of the rear contact"),
        Name::new("ycmrack", "m", "Centre of mass of the rack, upward"),
        af,
        ag,
        ah,
        ai,
    ]
};

/// The mass, the principal moments and their angle of a body.
fn body(given: &Values, names: &[Name; 5], centre: [Dual; 2]) -> Body {
    let [mass, xx, zz, yy, angle] = given.all([0, 1, 2, 3, 4].map(|at: usize| names[at].name));
    let inertia = Tensor { xx, yy, zz, xz: Dual::default() };
    // Turning from x to the upward y is turning from z to x where z points down.
    Body { mass, centre, inertia: inertia.turned(-angle) }
}

fn wheel(given: &Values, names: &[Name; 5]) -> Result<[Dual; 3], String> {
    let [mass, first, second, axial] = given.all([0, 1, 2, 3].map(|at: usize| names[at].name));
    if (first.value - second.value).abs() > 1e-9 * first.value.abs().max(second.value.abs()) {
        let names = format!("`{}` and `{}`", names[1].name, names[2].name);
        let [first, second] = [first, second].map(|moment| crate::number::with_unit(moment.value, "kg*m^2"));
        return Err(format!("{names} are {first} and {second}; they must be equal, as {AXISYMMETRIC}"));
    }
    Ok([mass, first, axial])
}

fn to_paper(given: &Values) -> Result<Values, String> {
    let [w, c, rear, front] = given.all(["wheelbase", "trail", "Drearwheel", "Dfrontwheel"]);
    let quarter = Dual::constant(std::f64::consts::FRAC_PI_2);
    let lam = match (given.get("lambda"), given.get("head_angle")) {
        (Some(lam), Some(head)) if (quarter - head - lam).value.abs() > 1e-4 => {
            return Err("`head_angle` and `lambda` are not 90 deg together".to_owned());
        }
        (Some(lam), _) => lam,
        (None, head) => quarter - head.unwrap_or_default(),
    };
    let mut result = Values::default();
    result.extend(["w", "c", "lam", "rR", "rF"], [w, c, lam, 0.5 * rear, 0.5 * front]);
    result.extend(["mR", "IRxx", "IRyy"], wheel(given, &REAR_WHEEL)?);
    result.extend(["mF", "IFxx", "IFyy"], wheel(given, &FRONT_WHEEL)?);
    let up = |x: &str, y: &str| {
        let [x, y] = given.all([x, y]);
        [x, -y]
    };
    let rear = Body::joined(&[
        body(given, &RIDER, up("xcmrider", "ycmrider")),
        body(given, &FRAME, up("xcmframe", "ycmframe")),
        body(given, &RACK, up("xcmrack", "ycmrack")),
    ]);
    let steered = |u: &str, v: &str| {
        let [x, z] = turned(up(u, v), -lam);
        [w + c + x, z]
    };
    let front = Body::joined(&[
        body(given, &FORK, steered("ucmfork", "vcmfork")),
        body(given, &BASKET, steered("ucmbasket", "vcmbasket")),
    ]);
    result.extend(["mB", "xB", "zB"], [rear.mass, rear.centre[0], rear.centre[1]]);
    result.extend(["IBxx", "IByy", "IBzz", "IBxz"], rear.inertia.entries());
    result.extend(["mH", "xH", "zH"], [front.mass, front.centre[0], front.centre[1]]);
    result.extend(["IHxx", "IHyy", "IHzz", "IHxz"], front.inertia.entries());
    result.copy("g", given, "gravity");
    Ok(result)
}

fn from_paper(given: &Values) -> Result<Values, String> {
    let [w, c, lam, rear, front] = given.all(["w", "c", "lam", "rR", "rF"]);
    let head = Dual::constant(std::f64::consts::FRAC_PI_2) - lam;
    let mut result = Values::default();
    result.extend(["wheelbase", "head_angle", "trail"], [w, head, c]);
    result.copy("gravity", given, "g");
    result.extend(["Drearwheel", "Dfrontwheel"], [2.0 * rear, 2.0 * front]);
    let mut wheel = |names: &[Name; 5], [mass, radial, axial]: [Dual; 3]| {
        let values = [mass, radial, radial, axial, Dual::default()];
        names.iter().zip(values).for_each(|(name, value)| result.push(name.name, value));
    };
    wheel(&REAR_WHEEL, given.all(["mR", "IRxx", "IRyy"]));
    wheel(&FRONT_WHEEL, given.all(["mF", "IFxx", "IFyy"]));
    let mut body = |names: &[Name; 5], mass: Dual, inertia: Tensor| {
        let ([first, second], angle) = inertia.principal();
        let values = [mass, first, second, inertia.yy, angle];
        names.iter().zip(values).for_each(|(name, value)| result.push(name.name, value));
    };
    let [xb, zb, mb, xh, zh, mh] = given.all(["xB", "zB", "mB", "xH", "zH", "mH"]);
    body(&FRAME, mb, Tensor::new(given.all(["IBxx", "IByy", "IBzz", "IBxz"])));
    body(&FORK, mh, Tensor::new(given.all(["IHxx", "IHyy", "IHzz", "IHxz"])));
    // Frame and rider are one body in the paper: all of it is here the frame.
    [RIDER, BASKET, RACK].iter().for_each(|names| body(names, Dual::default(), Tensor::default()));
    let [u, down] = turned([xh - w - c, zh], lam);
    result.extend(["xcmframe", "ycmframe", "ucmfork", "vcmfork"], [xb, -zb, u, -down]);
    let nowhere = [Dual::default(); 6];
    result.extend(["xcmrider", "ycmrider", "xcmrack", "ycmrack", "ucmbasket", "vcmbasket"], nowhere);
    Ok(result)
}
