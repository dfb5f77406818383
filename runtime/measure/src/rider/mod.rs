//! A rider from a few measures: Moore, Hubbard, Kooijman & Schwab (2009), "A method for estimating physical properties of a
//! combined bicycle and rider", DETC2009-86947; Moore (2012), chapter "Physical Parameters".

mod measures;
mod segments;

use carvallo::Sources;
use carvallo_design::input::{Raw, load_raw, read_raw};
use carvallo_design::number::shortest;
use carvallo_design::{DisplayUnit, Failure};

use self::measures::Measures;

/// A file of a rider's measures to start from: those of a rider of 72 kg on a Batavus Browser.
pub const EXAMPLE: &str = include_str!("example.toml");

/// A rigid rider on a bicycle, in the axes of its parameters: each number with its standard deviation, 0 without one.
#[derive(Clone, Debug, PartialEq)]
pub struct Rider {
    /// What the rider is called.
    pub name: String,
    /// In kg.
    pub mass: [f64; 2],
    /// The centre of mass in m: forward of the rear contact, and down.
    pub at: [[f64; 2]; 2],
    /// Moments of inertia about the centre of mass in kg m^2: xx, yy, zz and xz.
    pub moments: [[f64; 2]; 4],
}

impl Rider {
    /// From the measures in a file, or with `-` in the standard input.
    ///
    /// # Errors
    /// Everything that is wrong with the file, or that it cannot be read.
    pub fn load(path: &str) -> Result<Self, Failure> {
        Self::of(load_raw(path)?)
    }

    /// From the measures in the contents of a file; the ending of its label tells the format, or else what is in it.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn read(label: &str, contents: Vec<u8>) -> Result<Self, Failure> {
        Self::of(read_raw(label, contents)?)
    }

    fn of(raw: Raw) -> Result<Self, Failure> {
        let sources = Sources::default();
        let measures = Measures::read(raw, &sources)?;
        let body = segments::body(&measures)?;
        let of = |number: carvallo::Uncertain| [number.value(), number.deviation()];
        Ok(Self {
            mass: of(measures.mass),
            name: measures.name,
            at: [body.x, body.z].map(of),
            moments: [body.xx, body.yy, body.zz, body.xz].map(of),
        })
    }

    /// As a body in TOML, which can be joined to a frame, with numbers in what their units are shown in.
    pub fn to_toml(&self, unit_of: &dyn Fn(&str) -> DisplayUnit) -> String {
        let number = |[value, deviation]: [f64; 2], unit: &DisplayUnit| {
            let written = |value: f64| match unit.is_declared() {
                true => format!("{value:?}"),
                false => format!("\"{} {}\"", shortest(unit.value(value)), unit.written),
            };
            match deviation {
                0.0 => written(value),
                deviation => format!("{{ value = {}, std = {} }}", written(value), written(deviation)),
            }
        };
        let name = self.name.replace(['"', '\\'], "'");
        let mut text = format!("name = \"{name}\"\nto = \"rear\"\n");
        let [x, z] = self.at;
        let [xx, yy, zz, xz] = self.moments;
        let lines = [
            ("mass", self.mass, "kg", ""),
            ("x", x, "m", "centre of mass, forward of the rear contact"),
            ("z", z, "m", "centre of mass, downward"),
            ("Ixx", xx, "kg*m^2", "about the centre of mass, in roll"),
            ("Iyy", yy, "kg*m^2", "in pitch"),
            ("Izz", zz, "kg*m^2", "in yaw"),
            ("Ixz", xz, "kg*m^2", ""),
        ];
        let lines = lines.map(|(name, value, unit, docs)| {
            let unit = unit_of(unit);
            (format!("{name} = {}", number(value, &unit)), unit.unit(), docs)
        });
        let width = lines.iter().map(|(entry, ..)| entry.len()).max().unwrap_or(0);
        let units = lines.iter().map(|(_, unit, _)| unit.chars().count()).max().unwrap_or(0);
        for (entry, unit, docs) in lines {
            text.push_str(format!("{entry:width$}  # {unit:units$}  {docs}").trim_end());
            text.push('\n');
        }
        text
    }
}
