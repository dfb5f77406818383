//! What a model calls its bodies.

use carvallo::ModelInfo;

/// The body that parameters such as `mR` and `IRxx` belong to, by the documentation of its mass and their letter: `rear
/// wheel R`; in a model that runs backwards, `front wheel R`.
pub fn body(info: &ModelInfo, letter: &str) -> String {
    let mass = info.position(&format!("m{letter}")).map_or("", |position| info.parameters[position].docs);
    let name = mass.trim().strip_prefix("Mass of the ").unwrap_or("body");
    // A rigid rider is part of a frame.
    let name = name.split(['.', ',', ';', ':']).next().unwrap_or(name).split(" and ").next().unwrap_or(name);
    format!("{name} {letter}")
}
