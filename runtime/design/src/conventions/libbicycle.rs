//! Two gyrostats as Peterson's library `libbicycle` has them: a `WheelAssemblyGyrostat` for the rear and one for the front, each a
//! wheel with its frame as one body, `Ixx Iyy Izz Ixz J m R r a b c`; and `ls`.
//!
//! They are [two gyrostats](super::gyrostats) by other names, but for two of them: `c` is counted forward to the steer axis from the
//! centre of either wheel, so that the front one is the negative of the fork offset, and `Iyy` has the wheel in it.

use super::Convention;
use super::dual::Dual;
use super::gyrostats::{EDGED, GYROSTATS};
use super::name::{Name, Values};
use crate::failure::Problem;
use crate::input::{Entry, is_part, without_owner};

pub const LIBBICYCLE: Convention = Convention {
    name: "libbicycle",
    others: &[],
    title: "the wheel assemblies of libbicycle",
    names: NAMES,
    alternatives: &[],
    prepare: of_assemblies,
    to_paper,
    from_paper,
    complete: super::nothing,
};

macro_rules! assembly {
    ($which:literal) => {
        [
            Name::new(concat!($which, "_R"), "m", concat!("Radius of the ", $which, " wheel")).positive(),
            Name::new(
                concat!($which, "_c"),
                "m",
                concat!("From the centre of the ", $which, " wheel to the steer axis, forward across it"),
            ),
            Name::new(concat!($which, "_m"), "kg", concat!("Mass of the ", $which, " wheel and frame")).not_negative(),
            Name::new(
                concat!($which, "_a"),
                "m",
                concat!("Centre of mass of the ", $which, " wheel and frame, forward across the steer axis"),
            ),
            Name::new(
                concat!($which, "_b"),
                "m",
                concat!("Centre of mass of the ", $which, " wheel and frame, down along the steer axis"),
            ),
            Name::new(
                concat!($which, "_Ixx"),
                "kg*m^2",
                concat!("Moment of inertia of the ", $which, " wheel and frame, across the steer axis"),
            ),
            Name::new(
                concat!($which, "_Iyy"),
                "kg*m^2",
                concat!("Moment of inertia of the ", $which, " wheel and frame, in pitch"),
            )
            .optional(),
            Name::new(
                concat!($which, "_Izz"),
                "kg*m^2",
                concat!("Moment of inertia of the ", $which, " wheel and frame, along the steer axis"),
            ),
            Name::new(
                concat!($which, "_Ixz"),
                "kg*m^2",
                concat!("Product of inertia of the ", $which, " wheel and frame"),
            ),
            Name::new(concat!($which, "_J"), "kg*m^2", concat!("Axial moment of inertia of the ", $which, " wheel")),
            Name::extra(concat!($which, "_r"), "m", EDGED),
        ]
    };
}

const NAMES: &[Name] = &{
    let [a, b, c, d, e, f, g, h, i, j, k] = assembly!("rear");
    let [l, m, n, o, p, q, r, s, t, u, v] = assembly!("front");
    let ls = Name::new("ls", "m", "Distance of the wheels' centres along the steer axis");
    let gravity = Name::new("g", "N/kg", "Gravitational field strength").or(&["gravity"]).optional();
    let [mr, irxx, mf, ifxx] = super::gyrostats::WHEELS;
    [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, ls, gravity, mr, irxx, mf, ifxx]
};

/// Names here, and those of the gyrostats that are the same.
const SAME: [(&str, &str); 18] = [
    ("rear_R", "rr"),
    ("rear_c", "lr"),
    ("rear_m", "mr"),
    ("rear_a", "lrx"),
    ("rear_b", "lrz"),
    ("rear_Ixx", "IDxx"),
    ("rear_Izz", "IDzz"),
    ("rear_Ixz", "IDxz"),
    ("rear_J", "ICyy"),
    ("front_R", "rf"),
    ("front_m", "mf"),
    ("front_a", "lfx"),
    ("front_b", "lfz"),
    ("front_Ixx", "IExx"),
    ("front_Izz", "IEzz"),
    ("front_Ixz", "IExz"),
    ("front_J", "IFyy"),
    ("ls", "ls"),
];

/// What is called the same in both.
const KEPT: [&str; 5] = ["g", "mR", "IRxx", "mF", "IFxx"];

/// `rear_Ixx` of `rear.Ixx`, `rear_.Ixx` and `bicycle.rear.Ixx`.
fn of_assemblies(entries: &mut Vec<Entry>, _: &mut Vec<Problem>) {
    for entry in entries {
        let Some((owner, own)) = entry.name.rsplit_once('.') else { continue };
        let owner = without_owner(owner);
        if is_part(owner) {
            entry.name = format!("{}_{own}", owner.trim_end_matches('_'));
        }
    }
}

fn to_paper(given: &Values) -> Result<Values, String> {
    let mut gyrostats = Values::default();
    SAME.iter().for_each(|(own, name)| gyrostats.copy(name, given, own));
    let [offset] = given.all(["front_c"]);
    gyrostats.push("lf", -offset);
    for (frame, own, wheel) in [("IDyy", "rear_Iyy", "rear_J"), ("IEyy", "front_Iyy", "front_J")] {
        if let Some(both) = given.get(own) {
            gyrostats.push(frame, both - given.get(wheel).unwrap_or_default());
        }
    }
    gyrostats.keep(given, &KEPT);
    (GYROSTATS.to_paper)(&gyrostats)
}

fn from_paper(paper: &Values) -> Result<Values, String> {
    let gyrostats = (GYROSTATS.from_paper)(paper)?;
    let mut result = Values::default();
    SAME.iter().for_each(|(own, name)| result.copy(own, &gyrostats, name));
    let [offset, rear, front, rear_wheel, front_wheel]: [Dual; 5] =
        gyrostats.all(["lf", "IDyy", "IEyy", "ICyy", "IFyy"]);
    result.extend(["front_c", "rear_Iyy", "front_Iyy"], [-offset, rear + rear_wheel, front + front_wheel]);
    result.keep(&gyrostats, &KEPT);
    Ok(result)
}
