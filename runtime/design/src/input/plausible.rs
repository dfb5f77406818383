//! Whether the parameters can be those of a real bicycle.

use std::f64::consts::FRAC_PI_4;

use carvallo::{ModelInfo, sort_by};

use crate::bodies::body;
use crate::number::{fixed, shortest};

/// Measured inertias may miss a bound by the rounding of their last digit without meaning anything.
const TOLERANCE: f64 = 1e-9;

/// What deserves a warning: a steer axis that is tilted by 45 degrees or more, as by a head angle in the place of the tilt;
/// a centre of mass below the ground; wheels that overlap; and in any body a moment of inertia that exceeds the sum
/// of the other two, or is negative. Bodies with a product of inertia are judged by their principal moments.
pub fn warnings(info: &ModelInfo, values: &[f64]) -> Vec<String> {
    let value = |name: &str| info.position(name).and_then(|position| values.get(position)).copied();
    let frame = |body: &str| {
        let [xx, yy, zz, xz] = ["xx", "yy", "zz", "xz"].map(|axes| value(&format!("I{body}{axes}")));
        let (xx, yy, zz) = (xx?, yy?, zz?);
        let radius = ((xx - zz) / 2.0).hypot(xz?);
        let mean = (xx + zz) / 2.0;
        let is_left_out = yy == 0.0 && info.position(&format!("I{body}yy")).is_some_and(|at| !info.parameters[at].used);
        // Where nothing depends on it, nobody measures it: it is then taken for what it must be at least.
        Some([mean - radius, mean + radius, if is_left_out { 2.0 * radius } else { yy }])
    };
    let wheel = |body: &str| {
        let radial = value(&format!("I{body}xx"))?;
        Some([radial, radial, value(&format!("I{body}yy"))?])
    };
    let bodies = [("R", wheel("R")), ("B", frame("B")), ("H", frame("H")), ("F", wheel("F"))];
    let inertias = bodies.into_iter().filter_map(|(letter, moments)| check_moments(&body(info, letter), moments?));
    let tilt = value("lam").filter(|tilt| tilt.abs() >= FRAC_PI_4).map(|tilt| {
        let [tilt, head] = [tilt.to_degrees(), 90.0 - tilt.to_degrees()].map(|angle| fixed(angle, 1));
        format!("`lam` is {tilt} deg: it is the tilt of the steer axis, 90 deg minus the head angle, which would be {head} deg")
    });
    let below = ["zB", "zH"].into_iter().filter_map(|name| match value(name) {
        Some(depth) if depth > 0.0 => {
            Some(format!("`{name}` is {} m, below the ground: z points down", shortest(depth)))
        }
        _ => None,
    });
    let wheels = ["w", "rR", "rF"].map(value);
    inertias.chain(below).chain(tilt).chain(overlap(wheels)).collect()
}

/// That the wheels, which stand on one level, reach into each other.
fn overlap(wheels: [Option<f64>; 3]) -> Option<String> {
    let [Some(w), Some(rear), Some(front)] = wheels else { return None };
    let apart = w.hypot(rear - front);
    (apart < rear + front).then(|| {
        let [apart, both] = [apart, rear + front].map(|length| fixed(length, 4));
        format!(
            "the wheels overlap: with `w` their centres are {apart} m apart, and `rR` and `rF` are {both} m together"
        )
    })
}

fn check_moments(body: &str, mut moments: [f64; 3]) -> Option<String> {
    sort_by(&mut moments, f64::total_cmp);
    let [small, middle, large] = moments;
    let sum = small + middle;
    if small < -TOLERANCE * large.abs() {
        Some(format!("no rigid body has the inertias of the {body}: a principal moment is {} kg m²", fixed(small, 4)))
    } else if large - sum > TOLERANCE * large {
        let percent = 100.0 * (large / sum - 1.0);
        let excess = if percent < 1e7 { format!("{percent:.1} %") } else { "far".to_owned() };
        Some(format!(
            "no rigid body has the inertias of the {body}: its principal moment {} kg m² exceeds the sum of \
             the others, {} kg m², by {excess}",
            fixed(large, 4),
            fixed(sum, 4)
        ))
    } else {
        None
    }
}
