//! Geometry as manufacturers print it: head angle, fork offset, wheel base and the sizes of wheels, with masses and inertias
//! as in the paper.

use super::Convention;
use super::dual::Dual;
use super::name::{Name, Need, Values};
use super::twice::PRINTED;

pub const GEOMETRY: Convention = Convention {
    name: "geometry",
    others: &[],
    title: "the geometry that manufacturers print",
    names: NAMES,
    alternatives: &[
        &[&["wheelbase"], &BOTTOM_BRACKET],
        &[&["head_angle"], &["lam"]],
        &[&["fork_offset"], &["trail"]],
        &[
            &["rear_wheel_diameter"],
            &["rR"],
            &["wheel_diameter"],
            &["rear_wheel_circumference"],
            &["wheel_circumference"],
        ],
        &[
            &["front_wheel_diameter"],
            &["rF"],
            &["wheel_diameter"],
            &["front_wheel_circumference"],
            &["wheel_circumference"],
        ],
    ],
    prepare: super::wheels::measure,
    to_paper,
    from_paper,
    complete,
};

/// What the wheel base follows from.
const BOTTOM_BRACKET: [&str; 3] = ["chainstay", "front_center", "bb_drop"];

const DRAWN: Need = Need::Ignored("the equations of motion do not depend on it");

const NAMES: &[Name] = &[
    Name::new("wheelbase", "m", "Wheel base").or(&["w"]).printed("mm").optional(),
    Name::new("head_angle", "rad", "Angle of the steer axis from the ground")
        .rising()
        .or(&["head_tube_angle", "steering_angle", "hta"])
        .printed("deg")
        .optional(),
    Name::new("fork_offset", "m", "Distance of the centre of the front wheel from the steer axis")
        .or(&["rake", "fork_rake", "offset"])
        .printed("mm")
        .optional(),
    Name::new("rear_wheel_diameter", "m", "Diameter of the rear wheel with its tyre")
        .positive()
        .printed("mm")
        .optional(),
    Name::new("front_wheel_diameter", "m", "Diameter of the front wheel with its tyre")
        .positive()
        .printed("mm")
        .optional(),
    Name::new("g", "N/kg", "Gravitational field strength").or(&["gravity"]).optional(),
    Name::new("mR", "kg", "Mass of the rear wheel").not_negative(),
    Name::new("IRxx", "kg*m^2", "Radial moment of inertia of the rear wheel"),
    Name::new("IRyy", "kg*m^2", "Axial moment of inertia of the rear wheel"),
    Name::new("xB", "m", "Centre of mass of the rear frame and rider, forward of the rear contact").printed("mm"),
    Name::new("zB", "m", "Centre of mass of the rear frame and rider, downward").printed("mm"),
    Name::new("mB", "kg", "Mass of the rear frame and rider").not_negative(),
    Name::new("IBxx", "kg*m^2", "Moment of inertia of the rear frame and rider, in roll"),
    Name::new("IByy", "kg*m^2", "Moment of inertia of the rear frame and rider, in pitch").optional(),
    Name::new("IBzz", "kg*m^2", "Moment of inertia of the rear frame and rider, in yaw"),
    Name::new("IBxz", "kg*m^2", "Product of inertia of the rear frame and rider"),
    Name::new("xH", "m", "Centre of mass of the front frame, forward of the rear contact").printed("mm"),
    Name::new("zH", "m", "Centre of mass of the front frame, downward").printed("mm"),
    Name::new("mH", "kg", "Mass of the front frame").not_negative(),
    Name::new("IHxx", "kg*m^2", "Moment of inertia of the front frame, in roll"),
    Name::new("IHyy", "kg*m^2", "Moment of inertia of the front frame, in pitch").optional(),
    Name::new("IHzz", "kg*m^2", "Moment of inertia of the front frame, in yaw"),
    Name::new("IHxz", "kg*m^2", "Product of inertia of the front frame"),
    Name::new("mF", "kg", "Mass of the front wheel").not_negative(),
    Name::new("IFxx", "kg*m^2", "Radial moment of inertia of the front wheel"),
    Name::new("IFyy", "kg*m^2", "Axial moment of inertia of the front wheel"),
    // What may stand in the place of one of the others.
    Name::new("lam", "rad", "Steer axis tilt").or(&["lambda", "lamda", "λ", "caster_angle"]).optional(),
    Name::new("trail", "m", "Trail").or(&["c"]).printed("mm").optional(),
    Name::new("rR", "m", "Radius of the rear wheel").positive().optional(),
    Name::new("rF", "m", "Radius of the front wheel").positive().optional(),
    Name::new("wheel_diameter", "m", "Diameter of both wheels with their tyres").positive().optional(),
    Name::new("rear_wheel_circumference", "m", "Circumference of the rear wheel").positive().optional(),
    Name::new("front_wheel_circumference", "m", "Circumference of the front wheel").positive().optional(),
    Name::new("wheel_circumference", "m", "Circumference of both wheels").positive().optional(),
    Name::new("chainstay", "m", "From the bottom bracket to the rear axle")
        .or(&["chainstay_length", "rear_center", "rear_centre"])
        .optional(),
    Name::new("front_center", "m", "From the bottom bracket to the front axle").or(&["front_centre"]).optional(),
    Name::new("bb_drop", "m", "Depth of the bottom bracket below the rear axle")
        .or(&["bottom_bracket_drop"])
        .optional(),
    Name::extra("stack", "m", DRAWN),
    Name::extra("reach", "m", DRAWN),
    Name::extra("seat_angle", "rad", DRAWN),
    Name::extra("seat_tube_angle", "rad", DRAWN),
    Name::extra("seat_tube", "m", DRAWN),
    Name::extra("top_tube", "m", DRAWN),
    Name::extra("head_tube", "m", DRAWN),
    Name::extra("standover", "m", DRAWN),
    Name::extra("v", "m/s", Need::Ignored("the speeds come from --speeds")),
];

/// What is the same in the paper.
const SAME: [&str; 21] = [
    "g", "mR", "IRxx", "IRyy", "xB", "zB", "mB", "IBxx", "IByy", "IBzz", "IBxz", "xH", "zH", "mH", "IHxx", "IHyy",
    "IHzz", "IHxz", "mF", "IFxx", "IFyy",
];

/// The radius of a wheel by whatever is given of it, or else of both.
fn radius(given: &Values, which: &str, own: &str) -> Result<Dual, String> {
    let names = [format!("{which}_wheel_diameter"), format!("{which}_wheel_circumference")];
    let turn = Dual::constant(std::f64::consts::TAU);
    let diameter = |name: &str| given.get(name).map(|diameter| 0.5 * diameter);
    let circumference = |name: &str| given.get(name).map(|length| length / turn);
    let own = [given.get(own), diameter(&names[0]), circumference(&names[1])];
    let both = [diameter("wheel_diameter"), circumference("wheel_circumference")];
    let found = if own.iter().any(Option::is_some) { &own[..] } else { &both };
    match found.iter().flatten().count() {
        0 | 1 => Ok(found.iter().flatten().next().copied().unwrap_or_default()),
        _ => Err(format!("the {which} wheel is given twice")),
    }
}

/// The horizontal distance of the axles by way of the bottom bracket.
fn by_bottom_bracket(given: &Values, [rear, front]: [Dual; 2]) -> Option<Dual> {
    let [chainstay, front_centre] = [given.get("chainstay")?, given.get("front_center")?];
    let drop = given.get("bb_drop")?;
    Some(leg(chainstay, drop) + leg(front_centre, front - rear + drop))
}

/// How far an axle is from the bottom bracket, horizontally.
fn leg(length: Dual, height: Dual) -> Dual {
    (length.square() - height.square()).sqrt()
}

/// That a size of both wheels is that of each which has one of its own.
fn check_both(given: &Values, radii: [Dual; 2]) -> Result<(), String> {
    for (name, turns) in [("wheel_diameter", 1.0), ("wheel_circumference", std::f64::consts::PI)] {
        let Some(both) = given.get(name).map(|both| both.value / turns) else { continue };
        let own = radii.map(|radius| 2.0 * radius.value);
        if own.iter().any(|own| (own - both).abs() > PRINTED) {
            let [both, rear, front] = [both, own[0], own[1]].map(|length| crate::number::fixed(1e3 * length, 1));
            return Err(format!(
                "the diameter of both wheels is {both} mm, but {rear} mm of the rear and {front} mm of the front one; leave one out"
            ));
        }
    }
    Ok(())
}

fn to_paper(given: &Values) -> Result<Values, String> {
    let [rear, front] = [radius(given, "rear", "rR")?, radius(given, "front", "rF")?];
    check_both(given, [rear, front])?;
    let w = match (given.get("wheelbase"), by_bottom_bracket(given, [rear, front])) {
        (_, Some(found)) if !found.value.is_finite() => {
            return Err("`chainstay` and `front_center` are too short to reach the axles".to_owned());
        }
        (Some(w), Some(found)) if (found.value - w.value).abs() > PRINTED => {
            let [found, w] = [found, w].map(|w| crate::number::fixed(1e3 * w.value, 1));
            return Err(format!(
                "`wheelbase` is {w} mm, but {found} mm with the bottom bracket; leave it or `chainstay` out"
            ));
        }
        (Some(w), _) | (None, Some(w)) => w,
        (None, None) => {
            let missing: Vec<&str> = BOTTOM_BRACKET.into_iter().filter(|name| given.get(name).is_none()).collect();
            return Err(format!(
                "`wheelbase` follows from the bottom bracket only with {}",
                super::read::list(&missing)
            ));
        }
    };
    let lam = match (given.get("head_angle"), given.get("lam")) {
        (Some(_), Some(_)) => {
            return Err("both `head_angle` and `lam` are given; one follows from the other".to_owned());
        }
        (Some(head), None) => Dual::constant(std::f64::consts::FRAC_PI_2) - head,
        (None, lam) => lam.unwrap_or_default(),
    };
    let (sin, cos) = lam.sin_cos();
    let by_offset = given.get("fork_offset").map(|offset| (front * sin - offset) / cos);
    let c = match (by_offset, given.get("trail")) {
        (Some(found), Some(trail)) if (found.value - trail.value).abs() > PRINTED => {
            let [found, trail] = [found, trail].map(|c| crate::number::fixed(1e3 * c.value, 1));
            return Err(format!("`trail` is {trail} mm, but {found} mm with the fork offset; leave one of them out"));
        }
        (Some(found), _) => found,
        (None, trail) => trail.unwrap_or_default(),
    };
    let mut result = Values::default();
    result.extend(["w", "c", "lam", "rR", "rF"], [w, c, lam, rear, front]);
    result.keep(given, &SAME);
    Ok(result)
}

fn from_paper(given: &Values) -> Result<Values, String> {
    let [w, c, lam, rear, front] = given.all(["w", "c", "lam", "rR", "rF"]);
    let (sin, cos) = lam.sin_cos();
    let mut result = Values::default();
    let head = Dual::constant(std::f64::consts::FRAC_PI_2) - lam;
    result.extend(["wheelbase", "head_angle", "fork_offset"], [w, head, front * sin - c * cos]);
    result.extend(["rear_wheel_diameter", "front_wheel_diameter"], [2.0 * rear, 2.0 * front]);
    result.keep(given, &SAME);
    Ok(result)
}

/// In other words, and of the bottom bracket by what is given, with the wheel base in the place of one of its lengths.
fn complete(paper: &Values, given: &Values) -> Values {
    let [w, c, lam, rear, front] = paper.all(["w", "c", "lam", "rR", "rF"]);
    let turn = Dual::constant(std::f64::consts::TAU);
    let mut result = Values::default();
    result.extend(["trail", "lam", "rR", "rF"], [c, lam, rear, front]);
    result.extend(["rear_wheel_diameter", "front_wheel_diameter"], [2.0 * rear, 2.0 * front]);
    result.extend(["rear_wheel_circumference", "front_wheel_circumference"], [turn * rear, turn * front]);
    if rear.value == front.value {
        result.extend(["wheel_diameter", "wheel_circumference"], [2.0 * rear, turn * rear]);
    }
    result.keep(given, &BOTTOM_BRACKET);
    if let Some(drop) = given.get("bb_drop") {
        let rise = front - rear + drop;
        match (given.get("chainstay"), given.get("front_center")) {
            (Some(chainstay), None) => result.push("front_center", (w - leg(chainstay, drop)).hypot(rise)),
            (None, Some(front_centre)) => result.push("chainstay", (w - leg(front_centre, rise)).hypot(drop)),
            _ => {}
        }
    }
    result
}
