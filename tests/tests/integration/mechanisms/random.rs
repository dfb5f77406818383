//! Random mechanisms, compiled and as nonlinear dynamics: the derivation knows no bicycle.

use carvallo::Coefficients;
use carvallo_compiler::compile;
use carvallo_tests::designs::config;
use carvallo_tests::multibody::{Body, Joint, Mechanism, Wheel};
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

use super::{assert_close, interpreted};

/// What the differences of the nonlinear dynamics may be off.
const DIFFERENCES: f64 = 1e-6;

/// A declaration in the making, beside the same mechanism for the nonlinear dynamics.
#[derive(Default)]
struct Pair {
    parameters: String,
    values: Vec<f64>,
    parts: String,
    coordinates: String,
    numeric: Mechanism,
}

/// A body as it is declared, and the joint that carries it in the nonlinear model.
#[derive(Clone)]
struct Carrier {
    name: String,
    joint: Option<usize>,
}

impl Pair {
    /// A parameter of this value.
    fn value(&mut self, unit: &str, value: f64) -> String {
        let name = format!("p{}", self.values.len());
        self.parameters.push_str(&format!("{name}: {unit};"));
        self.values.push(value);
        name
    }

    fn vector(&mut self, unit: &str, vector: Vector3<f64>) -> String {
        let components: Vec<String> = vector
            .iter()
            .map(|component| if *component == 0.0 { "0".into() } else { self.value(unit, *component) })
            .collect();
        format!("({})", components.join(", "))
    }

    fn body(&mut self, name: &str, joint: usize, mass: f64, centre: Vector3<f64>, inertia: Matrix3<f64>) {
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
    fn joint(&mut self, from: &Carrier, link: &Link) -> Carrier {
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

    fn wheel(&mut self, name: &str, carrier: &Carrier, wheel: Wheel) {
        let x = if wheel.x == 0.0 { "0".into() } else { self.value("m", wheel.x) };
        let [radius, tyre] = [wheel.radius, wheel.tyre].map(|length| self.value("m", length));
        let mass = self.value("kg", wheel.mass);
        let [axial, radial] = [wheel.axial, wheel.transverse].map(|moment| self.value("kg*m^2", moment));
        self.parts.push_str(&format!(
            "wheel {name} on {}: mass {mass}, at ({x}, 0, -{radius}), radius {radius}, tyre {tyre}, axial {axial}, radial {radial};\n",
            carrier.name
        ));
        self.numeric.wheel(wheel);
    }

    /// The matrices of the compiled declaration.
    fn compiled<const N: usize>(&self, gravity: Option<f64>) -> Result<Coefficients<f64, N>, TestCaseError> {
        let Self { parameters, parts, coordinates, values, .. } = self;
        let weight = if gravity.is_some() { "g: N/kg, gravity;" } else { "" };
        // Of moments about axes that nothing turns about there may be some.
        let mut text = format!(
            "model Random {{ parameters {{ {parameters} {weight} }} mechanism {{ {parts} }} coordinates {{ {coordinates} }} }}"
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
        let values: Vec<f64> = values.iter().copied().chain(gravity).collect();
        Ok(interpreted(&compiled, &values))
    }
}

/// A joint with its body.
#[derive(Clone, Debug)]
struct Link {
    /// Which of the bodies before it carries it.
    on: prop::sample::Index,
    slides: bool,
    point: Vector3<f64>,
    axis: Vector3<f64>,
    stiffness: f64,
    damping: f64,
    mass: f64,
    centre: Vector3<f64>,
    moments: [f64; 3],
    /// The rotation by which the body's own axes are turned.
    turned: Vector3<f64>,
}

impl Link {
    fn inertia(&self) -> Matrix3<f64> {
        let rotation = nalgebra::Rotation3::new(self.turned);
        let turned = rotation * Matrix3::from_diagonal(&Vector3::from(self.moments)) * rotation.inverse();
        // Exactly symmetric, so that both sides are one parameter.
        Matrix3::from_fn(|row, column| turned[(row.min(column), row.max(column))])
    }

    /// The same in a mechanism that is its own mirror image: in the plane y = 0 but for slides across it.
    fn in_plane(mut self) -> Self {
        let plane = |vector: Vector3<f64>| Vector3::new(vector.x, 0.0, vector.z);
        self.axis = if self.slides { Vector3::y() } else { plane(self.axis) };
        self.point = plane(self.point);
        self.centre = plane(self.centre);
        self.turned = Vector3::new(0.0, self.turned.y, 0.0);
        self
    }
}

fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    [-size..size, -size..size, -size..size].prop_map(Vector3::from)
}

fn link() -> impl Strategy<Value = Link> {
    let place = (any::<prop::sample::Index>(), prop::bool::weighted(0.3), vector(1.0), vector(1.0));
    let held = (0.0..50.0, 0.0..5.0, 0.5..20.0, vector(1.0));
    let moments = ([0.1..2.0, 0.1..2.0, 0.1..2.0], vector(1.0));
    (place, held, moments)
        .prop_map(|((on, slides, point, axis), (stiffness, damping, mass, centre), (moments, turned))| Link {
            on,
            slides,
            point,
            axis,
            stiffness,
            damping,
            mass,
            centre,
            moments,
            turned,
        })
        .prop_filter("a direction", |link| link.axis.x.abs() > 0.1 && link.axis.z.abs() > 0.1)
}

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn trees_of_any_joints_on_a_fixed_base(links in [link(), link(), link()]) {
        let mut pair = Pair::default();
        let mut carriers = vec![Carrier { name: "ground".into(), joint: None }];
        for link in &links {
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, link);
            carriers.push(next);
        }
        let found = pair.compiled::<3>(None)?;
        let mut expected = pair.numeric.linearized([0, 1, 2], None);
        // Nothing has weight without a gravity.
        expected.k0 *= 0.0;
        assert_close(&found, &expected, DIFFERENCES, "tree");
    }

    #[test]
    fn vehicles_on_two_wheels_with_any_joints(
        frame in link(),
        links in [link(), link()],
        front_on in any::<prop::sample::Index>(),
        (rear, front) in ([0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3], [0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3]),
        wheel_base in 0.7..2.0,
    ) {
        let mut pair = Pair::default();
        let root = pair.numeric.free_root();
        pair.parts.push_str("free b: lean phi;\n");
        pair.coordinates.push_str("phi: rad;");
        let frame = frame.in_plane();
        pair.body("b", root.pitch, frame.mass, frame.centre, frame.inertia());
        let mut carriers = vec![Carrier { name: "b".into(), joint: Some(root.pitch) }];
        for link in links {
            let link = link.in_plane();
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, &link);
            carriers.push(next);
        }
        let wheel = |[radius, tyre, mass, axial, transverse]: [f64; 5], x, carrier| Wheel {
            carrier, x, y: 0.0, radius, tyre, mass, axial, transverse,
        };
        let (first, last) = (carriers[0].clone(), front_on.get(&carriers).clone());
        pair.wheel("r", &first, wheel(rear, 0.0, root.pitch));
        pair.wheel("f", &last, wheel(front, wheel_base, last.joint.expect("a joint")));
        let found = pair.compiled::<3>(Some(9.81))?;
        let coordinates = [root.lean, root.pitch + 1, root.pitch + 2];
        assert_close(&found, &pair.numeric.linearized(coordinates, Some(root.x)), DIFFERENCES, "vehicle");
    }
}
