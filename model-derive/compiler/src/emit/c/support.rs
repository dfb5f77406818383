//! The files that all models share, which are written by hand.

use super::File;

const TRIG_H: &str = include_str!("support/carvallo_trig.h");
const TRIG_C: &str = include_str!("support/carvallo_trig.c");
const SYSTEM_H: &str = include_str!("support/carvallo_system.h");
const SYSTEM_C: &str = include_str!("support/carvallo_system.c");
const MOTION_H: &str = include_str!("support/carvallo_motion.h");
const MOTION_C: &str = include_str!("support/carvallo_motion.c");
/// The rest of `carvallo_system.c`, in double precision.
const SOLVE_C: &str = include_str!("support/carvallo_solve.c");

/// The words of `SOLVE_C` that differ in single precision.
const SINGLE: [(&str, &str); 6] =
    [("double", "float"), ("f64", "f32"), ("DBL_", "FLT_"), ("fabs(", "fabsf("), ("8.0", "8.0F"), ("0.0", "0.0F")];

/// The files, each with its name.
pub fn files() -> Vec<File> {
    let single = SINGLE.iter().fold(SOLVE_C.to_string(), |text, (double, single)| text.replace(double, single));
    let system = format!("{SYSTEM_C}\n{SOLVE_C}\n{single}");
    let file = |name: &str, text: &str| File { name: name.to_string(), text: text.to_string() };
    vec![
        file("carvallo_motion.c", MOTION_C),
        file("carvallo_motion.h", MOTION_H),
        file("carvallo_system.c", &system),
        file("carvallo_system.h", SYSTEM_H),
        file("carvallo_trig.c", TRIG_C),
        file("carvallo_trig.h", TRIG_H),
    ]
}
