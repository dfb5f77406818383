//! Vehicles on three wheels, of which any slip on their tyres and any roll, with struts and rotors.

use carvallo::{Coefficients, States};
use carvallo_tests::designs::config;
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::multibody::{Root, Slip, Wheel};
use nalgebra::Vector3;
use proptest::prelude::*;

use super::super::{assert_close, interpreted};
use super::DIFFERENCES;
use super::links::{Link, link, vector};
use super::pair::{Carrier, Pair};

/// A wheel with its tyre.
#[derive(Clone, Copy, Debug)]
struct Tyred {
    /// Which body carries it, if not the frame.
    on: usize,
    /// Where it touches the ground, beside the place that it has in the vehicle.
    beside: [f64; 2],
    radius: f64,
    tyre: f64,
    mass: f64,
    axial: f64,
    transverse: f64,
    cornering: f64,
    camber: f64,
    trail: f64,
    /// The length over which its side force follows, if it does not follow at once.
    relaxation: Option<f64>,
}

fn tyred() -> impl Strategy<Value = Tyred> {
    let place = (0..3_usize, [-0.3..0.3, -0.3..0.3]);
    let wheel = [0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3];
    let force = (20.0..200.0, -30.0..30.0, -0.1..0.1, prop::option::weighted(0.4, 0.2..2.0));
    (place, wheel, force).prop_map(|((on, beside), wheel, (cornering, camber, trail, relaxation))| {
        let [radius, tyre, mass, axial, transverse] = wheel;
        Tyred { on, beside, radius, tyre, mass, axial, transverse, cornering, camber, trail, relaxation }
    })
}

/// How the vehicle moves over the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Course {
    /// All wheels slip.
    Free,
    /// One wheel rolls without slip: the yaw is a coordinate, and lateral motion follows.
    Yawing,
    /// The same with lateral motion as the coordinate.
    Drifting,
    /// Two wheels roll without slip.
    Led,
    /// One wheel rolls without slip, and turns the joint that carries it.
    Trailing,
}

/// What a vehicle is made of.
#[derive(Clone, Debug)]
struct Vehicle {
    frame: Link,
    links: [Link; 2],
    wheels: [Tyred; 3],
    course: Course,
    /// Whether forward motion is a coordinate; otherwise the speed is held.
    runs: bool,
    strut: ([usize; 2], [Vector3<f64>; 2], [f64; 2]),
    momentum: (usize, Vector3<f64>),
}

fn vehicle() -> impl Strategy<Value = Vehicle> {
    let course =
        prop::sample::select(vec![Course::Free, Course::Yawing, Course::Drifting, Course::Led, Course::Trailing]);
    let strut = ([0..3_usize, 0..3_usize], [vector(1.0), vector(1.0)], [0.0..50.0, 0.0..5.0])
        .prop_filter("between two bodies", |([from, to], ..)| from != to);
    let momentum = (0..3_usize, vector(3.0));
    ((link(), [link(), link()]), [tyred(), tyred(), tyred()], course, any::<bool>(), strut, momentum).prop_map(
        |((frame, links), wheels, course, runs, strut, momentum)| Vehicle {
            frame,
            links,
            wheels,
            course,
            runs,
            strut,
            momentum,
        },
    )
}

/// A vehicle as it is declared, and as the nonlinear dynamics have it.
struct Made {
    pair: Pair,
    root: Root,
    /// The places of the coordinates, what of each is a state, and whether the wheels determine its rate.
    coordinates: Vec<(usize, States, bool)>,
}

impl Vehicle {
    fn make(&self) -> Made {
        let mut pair = Pair::default();
        let root = pair.numeric.free_root();
        let mut coordinates = Vec::new();
        let mut freedoms = Vec::new();
        let carried = [
            (self.runs, "forward", "x: m;", root.x),
            (matches!(self.course, Course::Free | Course::Drifting | Course::Trailing), "lateral", "y: m;", root.y),
            (matches!(self.course, Course::Free | Course::Yawing | Course::Trailing), "yaw", "psi: rad;", root.yaw),
        ];
        for (_, word, declared, place) in carried.into_iter().filter(|(is, ..)| *is) {
            freedoms.push(format!("{word} {}", &declared[..declared.find(':').expect("a name")]));
            pair.coordinates.push_str(declared);
            coordinates.push((place, States::Rate, false));
        }
        let named = if freedoms.is_empty() { String::new() } else { format!(": {}", freedoms.join(", ")) };
        pair.parts.push_str(&format!("free b{named};\n"));
        if !self.runs {
            pair.parts.push_str("hold forward;\n");
        }
        let Link { mass, centre, .. } = self.frame;
        pair.body("b", root.pitch, mass, centre, self.frame.inertia());
        let mut carriers = vec![Carrier { name: "b".into(), joint: Some(root.pitch) }];
        for (index, link) in self.links.iter().enumerate() {
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, link);
            let place = next.joint.expect("a joint");
            // The wheel that rolls hangs on the last one.
            let follows = self.course == Course::Trailing && index == 1;
            if follows {
                let unit = if link.slides { "m" } else { "rad" };
                let declared = format!("q{place}: {unit};");
                let only = format!("q{place}: {unit}, only position;");
                pair.coordinates = pair.coordinates.replace(&declared, &only);
            }
            coordinates.push((place, if follows { States::Position } else { States::Both }, follows));
            carriers.push(next);
        }
        let rolls = match self.course {
            Course::Free => 0,
            Course::Led => 2,
            _ => 1,
        };
        for (index, tyred) in self.wheels.iter().enumerate() {
            let [x, y] = [[1.5, 0.0], [0.0, 0.6], [0.0, -0.6]][index];
            let Tyred { beside, radius, tyre, mass, axial, transverse, cornering, camber, trail, .. } = *tyred;
            let slips = index >= rolls;
            let on = if self.course == Course::Trailing && !slips { 2 } else { tyred.on };
            let carrier = carriers[on].clone();
            let joint = carrier.joint.expect("a joint");
            let relaxation = tyred.relaxation.filter(|_| slips).map(|length| {
                let deflection = pair.numeric.deflection();
                coordinates.push((deflection, States::Position, false));
                (length, deflection)
            });
            let slip = slips.then_some(Slip { cornering, camber, trail, relaxation });
            let [x, y] = [x + beside[0], y + beside[1]];
            let wheel = Wheel { carrier: joint, x, y, radius, tyre, mass, axial, transverse };
            pair.wheel(&format!("w{index}"), &carrier, wheel, slip);
        }
        let ([from, to], points, held) = self.strut;
        pair.strut("s", [&carriers[from], &carriers[to]], points, held);
        pair.rotor("spin", &carriers[self.momentum.0], self.momentum.1);
        Made { pair, root, coordinates }
    }
}

impl Made {
    fn check<const N: usize>(&self) -> Result<(), TestCaseError> {
        let Self { pair, root, coordinates } = self;
        let (compiled, values) = pair.compile(Some(9.81))?;
        let found: Coefficients<f64, N> = interpreted(&compiled, &values);
        let expected: Vec<States> = coordinates.iter().map(|(_, states, _)| *states).collect();
        prop_assert_eq!(found.states.to_vec(), expected);
        let mut drive = Drive::new(std::array::from_fn(|index| coordinates[index].0), Some(root.x));
        drive.following = std::array::from_fn(|index| coordinates[index].2);
        drive.axes = Some(*root);
        assert_close(&found, &pair.numeric.linearized_by(&drive), DIFFERENCES, "vehicle");
        Ok(())
    }
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn vehicles_on_wheels_that_slip_or_roll(vehicle in vehicle()) {
        let made = vehicle.make();
        match made.coordinates.len() {
            2 => made.check::<2>()?,
            3 => made.check::<3>()?,
            4 => made.check::<4>()?,
            5 => made.check::<5>()?,
            6 => made.check::<6>()?,
            7 => made.check::<7>()?,
            8 => made.check::<8>()?,
            count => unreachable!("{count} coordinates"),
        }
    }
}
