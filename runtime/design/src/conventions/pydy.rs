//! The names of the bicycle among the examples of PyDy and the tests of SymPy (`WRrad`, `htangle`, `framecg1`, …).
//!
//! Places are measured from the wheels' centres, 3 across the steer axis forward and 1 along it upward; those of the fork begin
//! where a line from the centre of the rear wheel meets the steer axis at a right angle. Inertias are in the axes of the paper,
//! with z pointing up, so that products have the other sign.

use super::Convention;
use super::dual::Dual;
use super::name::{Name, Values};
use super::steered::{Offsets, offsets, paper};
use super::tensor::turned;

pub const PYDY: Convention = Convention {
    name: "pydy",
    others: &["sympy"],
    title: "the names of PyDy's bicycle",
    names: NAMES,
    alternatives: &[],
    prepare: |_, _| {},
    to_paper,
    from_paper,
    complete: super::nothing,
};

const NAMES: &[Name] = &[
    Name::new("WRrad", "m", "Radius of the rear wheel").positive(),
    Name::new("WFrad", "m", "Radius of the front wheel").positive(),
    Name::new("htangle", "rad", "Angle of the steer axis from the ground").rising(),
    Name::new("framelength", "m", "Distance of the steer axis from the centre of the rear wheel"),
    Name::new("forklength", "m", "Distance of the wheels' centres along the steer axis"),
    Name::new("forkoffset", "m", "Distance of the centre of the front wheel from the steer axis"),
    Name::new("framecg1", "m", "Centre of mass of the frame, along the steer axis, upward"),
    Name::new("framecg3", "m", "Centre of mass of the frame, across the steer axis"),
    Name::new("forkcg1", "m", "Centre of mass of the fork, along the steer axis, upward"),
    Name::new("forkcg3", "m", "Centre of mass of the fork, across the steer axis"),
    Name::new("mframe", "kg", "Mass of the rear frame and rider").not_negative(),
    Name::new("mwr", "kg", "Mass of the rear wheel").not_negative(),
    Name::new("mfork", "kg", "Mass of the front frame").not_negative(),
    Name::new("mwf", "kg", "Mass of the front wheel").not_negative(),
    Name::new("Iframe11", "kg*m^2", "Moment of inertia of the rear frame and rider, in roll"),
    Name::new("Iframe22", "kg*m^2", "Moment of inertia of the rear frame and rider, in pitch").optional(),
    Name::new("Iframe33", "kg*m^2", "Moment of inertia of the rear frame and rider, in yaw"),
    Name::new("Iframe31", "kg*m^2", "Product of inertia of the rear frame and rider, with z upward"),
    Name::new("Iwr11", "kg*m^2", "Radial moment of inertia of the rear wheel"),
    Name::new("Iwr22", "kg*m^2", "Axial moment of inertia of the rear wheel"),
    Name::new("Ifork11", "kg*m^2", "Moment of inertia of the front frame, in roll"),
    Name::new("Ifork22", "kg*m^2", "Moment of inertia of the front frame, in pitch").optional(),
    Name::new("Ifork33", "kg*m^2", "Moment of inertia of the front frame, in yaw"),
    Name::new("Ifork31", "kg*m^2", "Product of inertia of the front frame, with z upward"),
    Name::new("Iwf11", "kg*m^2", "Radial moment of inertia of the front wheel"),
    Name::new("Iwf22", "kg*m^2", "Axial moment of inertia of the front wheel"),
    Name::new("g", "N/kg", "Gravitational field strength").or(&["gravity"]).optional(),
];

/// Names here, and in the paper, of what is the same in both.
const SAME: [(&str, &str); 15] = [
    ("mframe", "mB"),
    ("mwr", "mR"),
    ("mfork", "mH"),
    ("mwf", "mF"),
    ("Iframe11", "IBxx"),
    ("Iframe22", "IByy"),
    ("Iframe33", "IBzz"),
    ("Iwr11", "IRxx"),
    ("Iwr22", "IRyy"),
    ("Ifork11", "IHxx"),
    ("Ifork22", "IHyy"),
    ("Ifork33", "IHzz"),
    ("Iwf11", "IFxx"),
    ("Iwf22", "IFyy"),
    ("g", "g"),
];

fn to_paper(given: &Values) -> Result<Values, String> {
    let [rear, along, front] = given.all(["framelength", "forklength", "forkoffset"]);
    let [rr, rf, head] = given.all(["WRrad", "WFrad", "htangle"]);
    let offsets = Offsets { radii: [rr, rf], rear, along, front };
    let (lam, mut result) = paper(&offsets, "framelength, forklength and forkoffset")?;
    let [stated, found] = [head.value, std::f64::consts::FRAC_PI_2 - lam.value];
    if (stated - found).abs() > 1e-6 {
        let [stated, found] = [stated, found].map(|angle| crate::number::fixed(angle.to_degrees(), 4));
        return Err(format!("`htangle` is {stated} deg, but {found} deg with framelength, forklength and forkoffset"));
    }
    let [w] = result.all(["w"]);
    let [b1, b3, h1, h3] = given.all(["framecg1", "framecg3", "forkcg1", "forkcg3"]);
    let ([xb, zb], [xh, zh]) = (turned([b3, -b1], -lam), turned([h3 - front, -h1 - along], -lam));
    result.extend(["xB", "zB", "xH", "zH"], [xb, zb - rr, w + xh, zh - rf]);
    SAME.iter().for_each(|(here, there)| result.copy(there, given, here));
    result.extend(["IBxz", "IHxz"], given.all(["Iframe31", "Ifork31"]).map(|product| -product));
    Ok(result)
}

fn from_paper(given: &Values) -> Result<Values, String> {
    let [w, lam, rr, rf] = given.all(["w", "lam", "rR", "rF"]);
    let Offsets { rear, along, front, .. } = offsets(given);
    let mut result = Values::default();
    result.extend(["WRrad", "WFrad", "htangle"], [rr, rf, Dual::constant(std::f64::consts::FRAC_PI_2) - lam]);
    result.extend(["framelength", "forklength", "forkoffset"], [rear, along, front]);
    let [xb, zb, xh, zh] = given.all(["xB", "zB", "xH", "zH"]);
    let ([b3, b1], [h3, h1]) = (turned([xb, zb + rr], lam), turned([xh - w, zh + rf], lam));
    result.extend(["framecg1", "framecg3", "forkcg1", "forkcg3"], [-b1, b3, -h1 - along, h3 + front]);
    SAME.iter().for_each(|(here, there)| result.copy(here, given, there));
    result.extend(["Iframe31", "Ifork31"], given.all(["IBxz", "IHxz"]).map(|product| -product));
    Ok(result)
}
