//! The names of Moore's thesis, "Human Control of a Bicycle" (2012), which HumanControl, DynamicistToolKit
//! (`benchmark_to_moore`) and BicycleParameters (`Moore2012`) have, too.
//!
//! The bodies are the rear frame C, the rear wheel D, the front frame E and the front wheel F. Their axes are parallel to the
//! steer axis (3) and across it (1), and centres of mass are measured from the centres of the wheels.

use super::Convention;
use super::name::{AXISYMMETRIC, Name, Need, SYMMETRIC, Values};
use super::steered::{Offsets, offsets, paper};
use super::tensor::{Tensor, turned};

pub const MOORE: Convention = Convention {
    name: "moore",
    others: &["Moore2012"],
    title: "the names of Moore (2012)",
    names: NAMES,
    alternatives: &[],
    prepare: |_, _| {},
    to_paper,
    from_paper,
    complete: super::nothing,
};

const NAMES: &[Name] = &[
    Name::new("rr", "m", "Radius of the rear wheel").positive(),
    Name::new("rf", "m", "Radius of the front wheel").positive(),
    Name::new("d1", "m", "Distance of the steer axis from the centre of the rear wheel"),
    Name::new("d2", "m", "Distance of the wheels' centres along the steer axis"),
    Name::new("d3", "m", "Distance of the centre of the front wheel from the steer axis: the fork offset"),
    Name::new("l1", "m", "Centre of mass of the rear frame from the centre of the rear wheel, across the steer axis"),
    Name::new(
        "l2",
        "m",
        "Centre of mass of the rear frame from the centre of the rear wheel, along the steer axis, downward",
    ),
    Name::new("l3", "m", "Centre of mass of the front frame from the centre of the front wheel, across the steer axis"),
    Name::new(
        "l4",
        "m",
        "Centre of mass of the front frame from the centre of the front wheel, along the steer axis, downward",
    ),
    Name::new("mc", "kg", "Mass of the rear frame and rider").not_negative(),
    Name::new("md", "kg", "Mass of the rear wheel").not_negative(),
    Name::new("me", "kg", "Mass of the front frame").not_negative(),
    Name::new("mf", "kg", "Mass of the front wheel").not_negative(),
    Name::new("ic11", "kg*m^2", "Moment of inertia of the rear frame and rider, across the steer axis"),
    Name::new("ic22", "kg*m^2", "Moment of inertia of the rear frame and rider, in pitch").optional(),
    Name::new("ic33", "kg*m^2", "Moment of inertia of the rear frame and rider, along the steer axis"),
    Name::new("ic31", "kg*m^2", "Product of inertia of the rear frame and rider"),
    Name::new("id11", "kg*m^2", "Radial moment of inertia of the rear wheel"),
    Name::new("id22", "kg*m^2", "Axial moment of inertia of the rear wheel"),
    Name::new("ie11", "kg*m^2", "Moment of inertia of the front frame, across the steer axis"),
    Name::new("ie22", "kg*m^2", "Moment of inertia of the front frame, in pitch").optional(),
    Name::new("ie33", "kg*m^2", "Moment of inertia of the front frame, along the steer axis"),
    Name::new("ie31", "kg*m^2", "Product of inertia of the front frame"),
    Name::new("if11", "kg*m^2", "Radial moment of inertia of the front wheel"),
    Name::new("if22", "kg*m^2", "Axial moment of inertia of the front wheel"),
    Name::new("g", "N/kg", "Gravitational field strength").or(&["gravity"]).optional(),
    Name::extra("ic12", "kg*m^2", SYMMETRIC),
    Name::extra("ic23", "kg*m^2", SYMMETRIC),
    Name::extra("ie12", "kg*m^2", SYMMETRIC),
    Name::extra("ie23", "kg*m^2", SYMMETRIC),
    Name::extra("id33", "kg*m^2", Need::Equal("id11", AXISYMMETRIC)),
    Name::extra("if33", "kg*m^2", Need::Equal("if11", AXISYMMETRIC)),
    Name::extra("mg", "kg", Need::Zero("the rider is rigid, and part of C")),
    Name::extra("v", "m/s", Need::Ignored("the speeds come from --speeds")),
];

fn to_paper(given: &Values) -> Result<Values, String> {
    let [rr, rf, d1, d2, d3] = given.all(["rr", "rf", "d1", "d2", "d3"]);
    let (lam, mut result) = paper(&Offsets { radii: [rr, rf], rear: d1, along: d2, front: d3 }, "d1, d2 and d3")?;
    let [w] = result.all(["w"]);
    let [l1, l2, l3, l4] = given.all(["l1", "l2", "l3", "l4"]);
    let ([xb, zb], [xh, zh]) = (turned([l1, l2], -lam), turned([l3, l4], -lam));
    result.extend(["xB", "zB", "xH", "zH"], [xb, zb - rr, w + xh, zh - rf]);
    for (name, from) in [("mB", "mc"), ("mR", "md"), ("mH", "me"), ("mF", "mf"), ("g", "g")] {
        result.copy(name, given, from);
    }
    for (name, from) in [("IRxx", "id11"), ("IRyy", "id22"), ("IFxx", "if11"), ("IFyy", "if22")] {
        result.copy(name, given, from);
    }
    let frame = |names| Tensor::new(given.all(names)).turned(-lam).entries();
    let [xx, _, zz, xz] = frame(["ic11", "ic22", "ic33", "ic31"]);
    result.extend(["IBxx", "IBzz", "IBxz"], [xx, zz, xz]);
    let [xx, _, zz, xz] = frame(["ie11", "ie22", "ie33", "ie31"]);
    result.extend(["IHxx", "IHzz", "IHxz"], [xx, zz, xz]);
    result.copy("IByy", given, "ic22");
    result.copy("IHyy", given, "ie22");
    Ok(result)
}

fn from_paper(given: &Values) -> Result<Values, String> {
    let [w, lam, rr, rf] = given.all(["w", "lam", "rR", "rF"]);
    let mut result = Values::default();
    let Offsets { rear, along, front, .. } = offsets(given);
    result.extend(["rr", "rf", "d1", "d2", "d3"], [rr, rf, rear, along, front]);
    let [xb, zb, xh, zh] = given.all(["xB", "zB", "xH", "zH"]);
    result.extend(["l1", "l2"], turned([xb, zb + rr], lam));
    result.extend(["l3", "l4"], turned([xh - w, zh + rf], lam));
    result.extend(["mc", "md", "me", "mf"], given.all(["mB", "mR", "mH", "mF"]));
    let frame = |names| Tensor::new(given.all(names)).turned(lam).entries();
    result.extend(["ic11", "ic22", "ic33", "ic31"], frame(["IBxx", "IByy", "IBzz", "IBxz"]));
    result.extend(["id11", "id22"], given.all(["IRxx", "IRyy"]));
    result.extend(["ie11", "ie22", "ie33", "ie31"], frame(["IHxx", "IHyy", "IHzz", "IHxz"]));
    result.extend(["if11", "if22"], given.all(["IFxx", "IFyy"]));
    result.keep(given, &["g"]);
    Ok(result)
}
