//! A declaration and the nonlinear model of one mechanism, made together part by part.

use carvallo::Coefficients;
use carvallo_compiler::{Compiled, compile};
use carvallo_tests::multibody::{Body, Joint, Mechanism, Slip, Strut, Wheel};
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

use super::super::interpreted;
use super::links::Link;

/// A declaration in the making, beside the same mechanism for the nonlinear dynamics.
#[derive(Default)]
pub struct Pair {
    parameters: String,
    values: Vec<f64>,
    pub parts: String,
    pub coordinates: String,
    pub numeric: Mechanism,
}

/// A body as it is declared, and the joint that carries it in the nonlinear model.
#[derive(Clone)]
pub struct Carrier {
    pub name: String,
    pub joint: Option<usize>,
}

impl Pair {
    /// A parameter of this value.
    pub fn value(&mut self, unit: &str, value: f64) -> String {
        let name = format!("p{}", self.values.len());
        self.parameters.push_str(&format!("{name}: {unit};"));
        self.values.push(value);
        name
    }

    pub fn vector(&mut self, unit: &str, vector: Vector3<f64>) -> String {
        let components: Vec<String> = vector
            .iter()
            .map(|component| if *component == 0.0 { "0".into() } else { self.value(unit, *component) })
            .collect();
        format!("({})", components.join(", "))
    }

    pub fn body(&mut self, name: &str, joint: usize, mass: f64, centre: Vector3<f64>, inertia: Matrix3<f64>) {
        let [m, at] = [self.value("kg", mass), self.vector("m", centre)];
        let rows: Vec<String> = (0..3)
            .map(|row| {
                let entries: Vec<String> = (0..3)
                    .map(|column| match inertia[(row, column)] {
                        0.0 => "0".into(),
                        // The same name on both sides of the diagonal.
                        entry => match self.values.iter().rposition(|known| row > column && *known == entry) {
                            Some(known) => format!("p{known}"),
                            None => self.value("kg*m^2", entry),
                        },
                    })
                    .collect();
                format!("[{}]", entries.join(", "))
            })
            .collect();
        self.parts.push_str(&format!("body {name}: mass {m}, at {at}, inertia [{}];\n", rows.join(", ")));
        self.numeric.body(Body { joint, mass, centre, inertia });
    }

    /// A joint from a carrier to a new body, and that body.
    pub fn joint(&mut self, from: &Carrier, link: &Link) -> Carrier {
        let index = self.numeric.joints.len();
        let (name, coordinate) = (format!("b{index}"), format!("q{index}"));
        let along = self.vector("1", link.axis);
        let (kind, through, unit, per) = match link.slides {
            true => ("prismatic", String::new(), "m", "m^2"),
            false => ("revolute", format!("through {}, ", self.vector("m", link.point)), "rad", "1"),
        };
        let spring = self.value(&format!("N*m/({per})"), link.stiffness);
        let damper = self.value(&format!("N*m*s/({per})"), link.damping);
        self.parts.push_str(&format!(
            "{kind} {coordinate}: {} to {name}, {through}along {along}, spring {spring}, damper {damper};\n",
            from.name
        ));
        self.coordinates.push_str(&format!("{coordinate}: {unit};"));
        let joint = match link.slides {
            true => Joint::prismatic(from.joint, link.axis),
            false => Joint::revolute(from.joint, link.point, link.axis),
        };
        let joint = self.numeric.joint(joint.sprung(link.stiffness, link.damping));
        self.body(&name, joint, link.mass, link.centre, link.inertia());
        Carrier { name, joint: Some(joint) }
    }

    /// A joint with three freedoms from a carrier to a new body, and that body: a ball joint, or one in the plane of the axis of
    /// the first link and that of the second. In the nonlinear model a ball turns about z, then about the x axis that this has
    /// turned, then about the y axis that both have, which is how yaw, lean and pitch are defined.
    pub fn three(&mut self, from: &Carrier, links: &[Link; 3], is_ball: bool) -> Carrier {
        let first = self.numeric.joints.len();
        let name = format!("b{first}");
        let [a, b, c] = [0, 1, 2].map(|index| format!("q{}", first + index));
        let point = links[2].point;
        let through = self.vector("m", point);
        let held = links.each_ref().map(|link| [link.stiffness, link.damping]);
        let (words, axes): (_, [Vector3<f64>; 3]) = if is_ball {
            (
                [format!("yaw {a}"), format!("lean {b}"), format!("pitch {c}")],
                [Vector3::z(), Vector3::x(), Vector3::y()],
            )
        } else {
            let [first, second] = [links[0].axis, links[1].axis];
            let [along, across] = [first, second].map(|axis| self.vector("1", axis));
            let words =
                [format!("slides {a} along {along}"), format!("slides {b} along {across}"), format!("turns {c}")];
            (words, [first, second, first.cross(&second)])
        };
        let mut text =
            format!("{} N{first}: {} to {name}, through {through}", if is_ball { "ball" } else { "planar" }, from.name);
        let mut parent = from.joint;
        for (index, (word, axis)) in words.iter().zip(axes).enumerate() {
            let slides = !is_ball && index < 2;
            let (unit, per) = if slides { ("m", "m^2") } else { ("rad", "1") };
            let [stiffness, damping] = held[index];
            let spring = self.value(&format!("N*m/({per})"), stiffness);
            let damper = self.value(&format!("N*m*s/({per})"), damping);
            text.push_str(&format!(", {word}, spring {spring}, damper {damper}"));
            self.coordinates.push_str(&format!("q{}: {unit};", first + index));
            let joint = if slides { Joint::prismatic(parent, axis) } else { Joint::revolute(parent, point, axis) };
            parent = Some(self.numeric.joint(joint.sprung(stiffness, damping)));
        }
        self.parts.push_str(&format!("{text};\n"));
        let joint = parent.expect("three joints");
        let [.., Link { mass, centre, .. }] = links;
        self.body(&name, joint, *mass, *centre, links[2].inertia());
        Carrier { name, joint: Some(joint) }
    }

    /// A spring and a damper between points of two bodies.
    pub fn strut(&mut self, name: &str, [from, to]: [&Carrier; 2], points: [Vector3<f64>; 2], held: [f64; 2]) {
        let [at, end] = points.map(|point| self.vector("m", point));
        let [spring, damper] = [self.value("N/m", held[0]), self.value("N*s/m", held[1])];
        self.parts.push_str(&format!(
            "link {name}: {} to {}, from {at}, to {end}, spring {spring}, damper {damper};\n",
            from.name, to.name
        ));
        let ends = [(from.joint, points[0]), (to.joint, points[1])];
        self.numeric.struts.push(Strut { ends, stiffness: held[0], damping: held[1] });
    }

    /// A massless body on another one, with a rotor in it.
    pub fn rotor(&mut self, name: &str, on: &Carrier, momentum: Vector3<f64>) {
        let along = self.vector("N*m*s", momentum);
        self.parts.push_str(&format!("body {name}: massless, momentum {along};\nfix {name} to {};\n", on.name));
        self.numeric.rotors.push((on.joint.expect("a joint"), momentum));
    }

    pub fn wheel(&mut self, name: &str, carrier: &Carrier, wheel: Wheel, slip: Option<Slip>) {
        let [x, y] = [wheel.x, wheel.y].map(|length| if length == 0.0 { "0".into() } else { self.value("m", length) });
        let [radius, tyre] = [wheel.radius, wheel.tyre].map(|length| self.value("m", length));
        let mass = self.value("kg", wheel.mass);
        let [axial, radial] = [wheel.axial, wheel.transverse].map(|moment| self.value("kg*m^2", moment));
        self.parts.push_str(&format!(
            "wheel {name} on {}: mass {mass}, at ({x}, {y}, -{radius}), radius {radius}, tyre {tyre}, axial {axial}, radial {radial}",
            carrier.name
        ));
        self.numeric.wheel(wheel);
        if let Some(slip) = slip {
            let [cornering, camber] = [slip.cornering, slip.camber].map(|force| self.value("N", force));
            let trail = self.value("m", slip.trail);
            self.parts.push_str(&format!(", cornering {cornering}, camber {camber}, trail {trail}"));
            if let Some((length, deflection)) = slip.relaxation {
                let length = self.value("m", length);
                self.parts.push_str(&format!(", relaxation {length}, deflection e{deflection}"));
                self.coordinates.push_str(&format!("e{deflection}: m;"));
            }
            self.numeric.slip(slip);
        }
        self.parts.push_str(";\n");
    }

    /// The matrices of the compiled declaration.
    pub fn compiled<const N: usize>(&self, gravity: Option<f64>) -> Result<Coefficients<f64, N>, TestCaseError> {
        let (compiled, values) = self.compile(gravity)?;
        Ok(interpreted(&compiled, &values))
    }

    /// The compiled declaration, and the values of its parameters.
    pub fn compile(&self, gravity: Option<f64>) -> Result<(Compiled, Vec<f64>), TestCaseError> {
        self.compile_with(gravity, "")
    }

    /// The same with further statements.
    pub fn compile_with(&self, gravity: Option<f64>, statements: &str) -> Result<(Compiled, Vec<f64>), TestCaseError> {
        let Self { parameters, parts, coordinates, values, .. } = self;
        let weight = if gravity.is_some() { "g: N/kg, gravity;" } else { "" };
        // Of moments about axes that nothing turns about there may be some.
        let mut text = format!(
            "model Random {{ parameters {{ {parameters} {weight} }} mechanism {{ {parts} }} {statements} coordinates {{ {coordinates} }} }}"
        );
        let compiled = loop {
            match compile(text.parse().expect("tokens")) {
                Ok(compiled) => break compiled,
                Err(error) => {
                    let unused: Vec<String> = error.into_iter().map(|error| error.to_string()).collect();
                    let name = |message: &'_ str| {
                        let (name, end) = message.strip_prefix("no matrix depends on `")?.split_once("`: ")?;
                        end.starts_with("expected the word `unused`").then(|| name.to_owned())
                    };
                    let names: Vec<String> = unused.iter().filter_map(|message| name(message)).collect();
                    prop_assert_eq!(names.len(), unused.len(), "{:?} in {}", unused, text);
                    for name in names {
                        let start =
                            text.find(&format!(" {name}:")).or(text.find(&format!(";{name}:"))).expect("declared");
                        let end = start + text[start + 1..].find(';').expect("an end") + 1;
                        text.insert_str(end, ", unused");
                    }
                }
            }
        };
        Ok((compiled, values.iter().copied().chain(gravity).collect()))
    }
}
