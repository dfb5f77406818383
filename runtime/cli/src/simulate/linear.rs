//! The motion of the linear equations, of any model.

use carvallo::simulation::{Force, LinearMotion, SimulationError};
use carvallo::{Model, Rate, States};
use carvallo_models::WhippleMechanism;

use super::force::{Channel, forces};
use super::initial::{Givable, Initial, initial};
use super::motion::{Motion, Quantity, Row};
use super::options::Options;
use crate::analysis::extremes;
use crate::design::Design;
use crate::failure::{Failure, Problem};
use crate::number::shortest;

/// What the path of a bicycle is told by, behind its lean and steer; the first is its yaw.
const PATH: [Quantity; 5] = [
    Quantity::new("psi", "yaw", "rad"),
    Quantity::new("x", "x", "m"),
    Quantity::new("y", "y", "m"),
    Quantity::new("thetaR", "rear wheel", "rad"),
    Quantity::new("thetaF", "front wheel", "rad"),
];

/// The order in which quantities of bicycles are told: that of the paper.
pub const ORDER: [&str; 8] = ["x", "y", "psi", "phi", "pitch", "delta", "thetaR", "thetaF"];

const OF_YAW: &str = "it follows from steer";
const OF_SPEED: &str = "it follows from --speed";

/// What a motion begins with, and what acts on it.
pub struct Given {
    initial: Initial,
    forces: Vec<Force>,
}

/// The linear equations of a design, with what may be given of their motion.
pub struct Linear {
    pub givable: Vec<Givable>,
    pub channels: Vec<Channel>,
    has_path: bool,
}

impl Linear {
    pub fn new(design: &Design) -> Self {
        let info = design.info();
        let coordinates = info.coordinates.iter().map(|coordinate| Givable {
            quantity: Quantity::new(coordinate.name, coordinate.label, coordinate.unit),
            position: Ok(()),
            rate: match coordinate.states {
                States::Position => Err("it is of first order, and its rate follows"),
                States::Rate | States::Both => Ok(()),
            },
        });
        let has_path = kinematics(design).is_some();
        let path = PATH.iter().filter(|_| has_path).map(|quantity| Givable {
            quantity: *quantity,
            position: Ok(()),
            rate: Err(if matches!(quantity.name, "psi" | "y") { OF_YAW } else { OF_SPEED }),
        });
        let channels = info.coordinates.iter().map(|coordinate| Channel {
            names: vec![coordinate.name.to_owned(), format!("T{}", coordinate.name), coordinate.label.to_owned()],
            unit: match coordinate.unit {
                "rad" => "N*m",
                "m" => "N",
                _ => "1",
            },
        });
        Self { givable: coordinates.chain(path).collect(), channels: channels.collect(), has_path }
    }

    /// What is given: the initial state, and the forces until the end of the motion.
    ///
    /// # Errors
    /// Everything that is wrong with the options.
    pub fn read(&self, design: &Design, options: &Options, duration: f64) -> Result<Given, Vec<Problem>> {
        let model = design.info().name;
        let state = initial(&options.initial, &self.givable, model);
        match (state, forces(&options.force, &self.channels, duration, model)) {
            (Ok(initial), Ok(forces)) => Ok(Given { initial, forces }),
            (state, forces) => Err(state.err().into_iter().chain(forces.err()).flatten().collect()),
        }
    }

    /// The motion at the times, the first of which is zero.
    ///
    /// # Errors
    /// If there is none.
    pub fn run(self, design: Design, given: Given, speed: f64, times: &[f64]) -> Result<Motion, Failure> {
        let Given { initial, forces } = given;
        let title = design.title();
        let fail = |message: String| Failure::Run(format!("{title}: {message}{}", extremes(&design)));
        let motion = design.equations.motion(speed, design.gravity().unwrap_or(0.0));
        let mut motion = motion.map_err(|error| fail(error.to_string()))?;
        if let Some(kinematics) = kinematics(&design) {
            let forward = Rate { speed: 1.0, rates: [0.0; 2], coordinates: [0.0; 2], heading: 0.0 };
            let [yaw, others @ ..] =
                [kinematics.yaw, forward, kinematics.lateral, kinematics.wheel_R, kinematics.wheel_F];
            motion = motion.followed_by(speed, &yaw, &others);
        }
        let count = design.info().coordinates.len();
        let run = |motion: &LinearMotion, times: &[f64]| {
            motion.run(&initial.positions, &initial.rates[..count], &forces, times)
        };
        let (snapshots, end) = match run(&motion, times) {
            Ok(snapshots) => (snapshots, None),
            // What there is until then.
            Err(SimulationError::OutOfRange { time }) => {
                let reached = times.partition_point(|before| *before < time);
                let snapshots = run(&motion, &times[..reached]).map_err(|error| fail(error.to_string()))?;
                let reason = "the motion then leaves the range of floating-point numbers";
                (snapshots, Some(format!("the motion ends before {} s: {reason}", shortest(time))))
            }
            Err(error) => return Err(fail(error.to_string())),
        };
        let quantities: Vec<Quantity> = self.givable.iter().map(|givable| givable.quantity).collect();
        let order = order(&quantities, self.has_path);
        let arranged = |values: &[f64]| order.iter().map(|&place| values[place] + 0.0).collect();
        let rows = snapshots.iter().map(|snapshot| Row {
            t: snapshot.time,
            positions: arranged(&snapshot.positions),
            rates: arranged(&snapshot.rates),
            accelerations: arranged(&snapshot.accelerations),
            energy: None,
            contact_forces: Vec::new(),
        });
        Ok(Motion {
            is_linear: true,
            quantities: order.iter().map(|&place| quantities[place]).collect(),
            wheels: Vec::new(),
            rows: rows.collect(),
            end,
            design,
        })
    }
}

/// The places of quantities in the order in which they are told.
fn order(quantities: &[Quantity], has_path: bool) -> Vec<usize> {
    let mut places: Vec<usize> = (0..quantities.len()).collect();
    if has_path {
        places.sort_by_key(|&place| ORDER.iter().position(|name| *name == quantities[place].name));
    }
    places
}

/// What follows from lean and steer, of the models whose parameters are those of the shipped bicycles.
fn kinematics(design: &Design) -> Option<carvallo_models::WhippleMechanismKinematics> {
    let bicycle = WhippleMechanism::INFO;
    if !(design.model.is_whipple() || design.model.is_called(bicycle.name)) {
        return None;
    }
    let values: Option<Vec<f64>> = bicycle.parameters.iter().map(|parameter| design.value(parameter.name)).collect();
    Some(WhippleMechanism::from_slice(&values?).ok()?.kinematics())
}
