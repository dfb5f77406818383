//! What every bicycle keeps, without being asked: its wheels do not overlap, and its bodies are rigid bodies.

use carvallo::ModelInfo;
use carvallo_design::{Dual, body};

use crate::constraint::{Constraint, Excess};

/// The least gap between the wheels, in m.
const GAP: f64 = 0.02;

/// The constraints on parameters that change, of models that have them.
pub fn constraints(info: &ModelInfo, changing: &[&str]) -> Vec<Constraint> {
    let has = |names: &[&str]| names.iter().all(|name| info.position(name).is_some());
    let is_varied = |names: &[&str]| changing.iter().any(|name| names.contains(name));
    let mut constraints = Vec::new();
    let wheels = ["rR", "rF", "w"];
    if has(&wheels) && is_varied(&wheels) {
        let written = format!("the wheels are {} cm apart: rR + rF + {GAP} <= w", 100.0 * GAP);
        constraints.push(Constraint::built(written, overlap, ""));
    }
    for (letter, axes, excess) in [
        ("R", &["xx", "yy"][..], wheel as Excess),
        ("B", &["xx", "yy", "zz", "xz"][..], frame),
        ("H", &["xx", "yy", "zz", "xz"][..], frame),
        ("F", &["xx", "yy"][..], wheel),
    ] {
        let names: Vec<String> = axes.iter().map(|axes| format!("I{letter}{axes}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        if has(&names) && is_varied(&names) {
            let written = format!(
                "the {} is a rigid body: no principal moment exceeds the sum of the others",
                body(info, letter)
            );
            constraints.push(Constraint::built(written, excess, letter));
        }
    }
    constraints
}

fn overlap(value: &dyn Fn(&str) -> Dual, _: &str) -> Dual {
    value("rR") + value("rF") + GAP.into() - value("w")
}

/// Of a frame with a product of inertia, by its principal moments; relative to their sum.
fn frame(value: &dyn Fn(&str) -> Dual, letter: &str) -> Dual {
    let [xx, yy, zz, xz] = ["xx", "yy", "zz", "xz"].map(|axes| value(&format!("I{letter}{axes}")));
    let (mean, radius) = (0.5 * (xx + zz), (0.5 * (xx - zz)).hypot(xz));
    let excess = (yy - 2.0 * mean).max(2.0 * radius - yy).max(radius - mean);
    excess / (xx + yy + zz).abs().max(f64::MIN_POSITIVE.into())
}

fn wheel(value: &dyn Fn(&str) -> Dual, letter: &str) -> Dual {
    let [radial, axial] = ["xx", "yy"].map(|axes| value(&format!("I{letter}{axes}")));
    (axial - 2.0 * radial) / (2.0 * radial + axial).abs().max(f64::MIN_POSITIVE.into())
}
