//! What is joined, and to what, as it was written and judged.

use carvallo::{ModelInfo, Sources, Uncertain};

use super::inertia::Inertia;
use crate::failure::Place;
use crate::input::warnings_of_body;

/// A body that is to be joined to a frame. Each number comes with the standard deviation of its measurement, 0 without one.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// What it is called, if it is.
    pub name: Option<String>,
    /// Where it is told of.
    pub place: Place,
    /// What it is joined to.
    pub frame: Frame,
    /// In kg: of each, if there is one on both sides.
    pub mass: Number,
    /// The centre of mass in m: forward of the rear contact, to the right, and down.
    pub at: [Number; 3],
    /// How its mass is distributed.
    pub shape: Shape,
    /// By how much it is turned in pitch, in radians, with its front end up.
    pub tilt: Number,
    /// Whether there is another one on the other side.
    pub on_both_sides: bool,
}

/// A number and its standard deviation.
pub type Number = [f64; 2];

/// What a body can be joined to, by the letter in the names of its parameters: `mB`, `xB`, `IBxx` and so on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame(pub String);

/// How the mass of a body is distributed.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Moments of inertia about its centre of mass in kg m^2: xx, yy, zz and xz; all zero of a point.
    Given([Number; 4]),
    /// Extents in m.
    Box([Number; 3]),
    /// Radius and length in m, and its axis.
    Cylinder([Number; 2], usize),
    /// The radius in m.
    Sphere(Number),
}

impl Body {
    /// With sources of its own for its deviations.
    pub fn inertia<'a>(&self, sources: &'a Sources) -> Inertia<'a> {
        let number = |[value, deviation]: Number| sources.measured(value, deviation);
        let [x, y, z] = self.at.map(number);
        let point = Inertia::point(sources, number(self.mass), [x, z]);
        let body = match &self.shape {
            Shape::Given(moments) => {
                let [xx, yy, zz, xz] = moments.map(number);
                Inertia { xx, yy, zz, xz, ..point }
            }
            Shape::Box(extents) => point.of_box(extents.map(number)),
            Shape::Cylinder(size, axis) => point.of_cylinder(size.map(number), *axis),
            Shape::Sphere(radius) => point.of_sphere(number(*radius)),
        };
        let body = body.turned(number(self.tilt));
        if self.on_both_sides { body.on_both_sides(y) } else { body }
    }
}

impl Body {
    /// What of it seems to be in another unit, told where it is; what that makes of the machine is no news then.
    pub fn warnings(&self) -> Vec<String> {
        let mut lengths: Vec<_> = ["x", "y", "z"].into_iter().zip(self.at.map(|[value, _]| value)).collect();
        let longest = |sizes: &[Number]| sizes.iter().map(|[size, _]| *size).fold(0.0, f64::max);
        let mut moments = Vec::new();
        match &self.shape {
            Shape::Given(given) => {
                moments.extend(["Ixx", "Iyy", "Izz", "Ixz"].into_iter().zip(given.map(|[value, _]| value)));
            }
            Shape::Box(sizes) => lengths.push(("box", longest(sizes))),
            Shape::Cylinder(sizes, _) => lengths.push(("cylinder", longest(sizes))),
            Shape::Sphere(radius) => lengths.push(("sphere", radius[0])),
        }
        let told = warnings_of_body(&lengths, self.mass[0], &moments);
        told.into_iter().map(|text| format!("{}: {text}", self.place)).collect()
    }
}

impl Frame {
    /// The positions of its mass, x, z, Ixx, Iyy, Izz and Ixz among the parameters of a model; a model for which Iyy is of no
    /// account may be without it.
    pub fn positions(&self, info: &ModelInfo) -> Option<[Option<usize>; 7]> {
        let letter = &self.0;
        let names = ["m", "x", "z"].map(|quantity| format!("{quantity}{letter}"));
        let [mass, x, z] = names.map(|name| info.position(&name));
        let [xx, yy, zz, xz] = ["xx", "yy", "zz", "xz"].map(|axes| info.position(&format!("I{letter}{axes}")));
        let all = [mass, x, z, xx, yy, zz, xz];
        (all.iter().filter(|position| position.is_none()).count() <= usize::from(yy.is_none())).then_some(all)
    }

    /// The letters of all that a model has.
    pub fn all(info: &ModelInfo) -> Vec<String> {
        let letters = info.parameters.iter().filter_map(|parameter| parameter.name.strip_prefix('m'));
        let frames = letters.map(|letter| Self(letter.to_owned())).filter(|frame| frame.positions(info).is_some());
        frames.map(|frame| frame.0).collect()
    }
}

/// Numbers of a machine and of its bodies, in the order of [`Frame::positions`].
pub fn as_numbers(inertia: Inertia) -> [Uncertain; 7] {
    let Inertia { mass, x, z, xx, yy, zz, xz } = inertia;
    [mass, x, z, xx, yy, zz, xz]
}
