//! The motion of the linear equations, of any model.

use std::ops::ControlFlow;

use carvallo::simulation::{LinearMotion, SimulationError, Snapshot};
use carvallo::{Rate, States};
use carvallo_design::feedback::Input;
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure};

use super::force::Channel;
use super::initial::Givable;
use super::motion::{Motion, Quantity, Row, fed_back, order, time};
use super::solver::{Given, Solver};
use super::watch::{Happened, happened, looked_at};
use crate::analysis::{OUT_OF_RANGE, TOO_LONG, extremes};

/// What the path of a bicycle is told by, behind its lean and steer; the first is its yaw.
const PATH: [Quantity; 5] = [
    Quantity::new("psi", "yaw", "rad"),
    Quantity::new("x", "x", "m"),
    Quantity::new("y", "y", "m"),
    Quantity::new("thetaR", "rear wheel", "rad"),
    Quantity::new("thetaF", "front wheel", "rad"),
];

const OF_YAW: &str = "it follows from steer";
pub const OF_SPEED: &str = "it follows from --speed";

/// The linear equations of a design, with what may be given of their motion.
pub struct Linear {
    givable: Vec<Givable>,
    channels: Vec<Channel>,
    /// What the forces of the channels act on.
    inputs: Vec<Input>,
}

impl Linear {
    /// The linear equations of a design.
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
        let has_path = design.kinematics().is_some();
        let path = PATH.iter().filter(|_| has_path).map(|quantity| Givable {
            quantity: *quantity,
            position: Ok(()),
            rate: Err(if matches!(quantity.name, "psi" | "y") { OF_YAW } else { OF_SPEED }),
        });
        let inputs = Input::all(info);
        let channel = |input: &Input| Channel { names: input.names(info), unit: input.unit(info).unwrap_or("1") };
        let channels = inputs.iter().map(channel).collect();
        Self { givable: coordinates.chain(path).collect(), channels, inputs }
    }
}

impl Solver for Linear {
    fn givable(&self) -> &[Givable] {
        &self.givable
    }

    fn channels(&self) -> &[Channel] {
        &self.channels
    }

    fn run<'a>(
        &self,
        design: &'a Design,
        given: &Given,
        speed: f64,
        times: &[f64],
        reach: &dyn Fn(f64) -> ControlFlow<()>,
    ) -> Result<Motion<'a>, Failure> {
        let Given { initial, forces, watches } = given;
        let title = design.title();
        let fail = |message: String| Failure::Run(format!("{title}: {message}{}", extremes(design)));
        let motion = design.equations.motion(speed, design.gravity().unwrap_or(0.0));
        let mut motion = motion.map_err(|error| fail(error.to_string()))?;
        for input in &self.inputs {
            if let Input::Applied(force) = input {
                motion = motion.with_force(&design.model.shares(&design.values(), *force).unwrap_or_default());
            }
        }
        if let Some(kinematics) = design.kinematics() {
            let forward = Rate { speed: 1.0, rates: [0.0; 2], coordinates: [0.0; 2], heading: 0.0 };
            let [yaw, others @ ..] =
                [kinematics.yaw, forward, kinematics.lateral, kinematics.wheel_R, kinematics.wheel_F];
            motion = motion.followed_by(speed, &yaw, &others);
        }
        let count = design.info().coordinates.len();
        let run = |motion: &LinearMotion, times: &[f64]| {
            motion.run(&initial.positions, &initial.rates[..count], forces, times)
        };
        let (mut snapshots, mut end) = match run(&motion, times) {
            Ok(snapshots) => (snapshots, None),
            // What there is until then.
            Err(error @ (SimulationError::OutOfRange { time } | SimulationError::TooLong { time })) => {
                let reached = times.partition_point(|before| *before < time);
                let snapshots = run(&motion, &times[..reached]).map_err(|error| fail(error.to_string()))?;
                let reason = match error {
                    SimulationError::TooLong { .. } => TOO_LONG,
                    _ => OUT_OF_RANGE,
                };
                (snapshots, Some(format!("the motion ends before {} s: {reason}", shortest(time))))
            }
            Err(error) => return Err(fail(error.to_string())),
        };
        let mut events = Vec::new();
        if cfg!(feature = "events") && !watches.is_empty() {
            let fastest = design.equations.eigenvalues(speed, design.gravity().unwrap_or(0.0));
            let fastest = fastest.map_err(|error| fail(error.to_string()))?;
            let fastest = fastest.iter().fold(0.0, |most: f64, value| most.max(value.im));
            let moments = looked_at(&times[..snapshots.len()], fastest);
            let after = |before: &Snapshot, time: f64| {
                let mut both = motion.run(&before.positions, &before.rates[..count], forces, &[before.time, time])?;
                both.pop().ok_or(SimulationError::OutOfRange { time })
            };
            let found = run(&motion, &moments).and_then(|moments| happened(&moments, watches, &after, reach));
            let (found, ends) = found.map_err(|error| fail(error.to_string()))?;
            if let Some((place, last)) = found.last().filter(|_| ends) {
                snapshots.retain(|snapshot| snapshot.time < last.time);
                snapshots.push(last.clone());
                end = Some(format!("the motion ends at {} s: {}", time(last.time), watches[*place].end()));
            }
            events = found;
        }
        let quantities: Vec<Quantity> = self.givable.iter().map(|givable| givable.quantity).collect();
        let order = order(&quantities);
        let arranged = |values: &[f64]| order.iter().map(|&place| values[place] + 0.0).collect();
        let told = |snapshot: &Snapshot| Row {
            t: snapshot.time,
            positions: arranged(&snapshot.positions),
            rates: arranged(&snapshot.rates),
            accelerations: arranged(&snapshot.accelerations),
            energy: None,
            contact_forces: Vec::new(),
            feedback: fed_back(design, speed, &quantities, &snapshot.positions, &snapshot.rates),
        };
        let events = events.iter().map(|(watch, snapshot)| Happened { watch: *watch, row: told(snapshot) });
        Ok(Motion {
            is_linear: true,
            quantities: order.iter().map(|&place| quantities[place]).collect(),
            wheels: Vec::new(),
            rows: snapshots.iter().map(told).collect(),
            events: events.collect(),
            end,
            notes: initial.doubts.clone(),
            design,
        })
    }
}
