//! By which equations of motion accelerations are.

use carvallo_design::Equations;
use carvallo_design::feedback::Law;

use super::{Predictor, ROUNDING, World};
use crate::given::{Accelerations, Given, Kind, Quantity};
use crate::machine::Machine;
use crate::motion::Nonlinear;

/// Nonlinear equations, and what they make of the machine as it is.
#[derive(Debug)]
pub struct Exact<'a> {
    motion: &'a Nonlinear,
    parameters: &'a [f64],
    attributes: Vec<f64>,
    accelerations: Result<Vec<f64>, String>,
}

impl Exact<'_> {
    /// The accelerations of a machine.
    pub fn accelerations(&self, given: &Accelerations, world: &World, feedback: &[Law]) -> Option<Vec<f64>> {
        if self.parameters == world.parameters && self.attributes == world.attributes {
            return self.accelerations.clone().ok();
        }
        self.motion.with_attributes(given, &world.attributes, &world.parameters, feedback)
    }
}

/// How many accelerations are off, and how far the farthest.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
struct Off {
    count: usize,
    far: f64,
}

impl Off {
    fn of(given: &Accelerations, found: Option<&Vec<f64>>) -> Self {
        let Some(found) = found else { return Self { count: usize::MAX, far: f64::INFINITY } };
        let values = given.values.iter().zip(found).filter_map(|(value, own)| Some((value.as_ref()?, own)));
        let off = values.map(|(value, own)| (value, (value.value - own).abs()));
        let far = off.filter(|(value, off)| *off > value.tolerance.max(ROUNDING[2] * value.value.abs()));
        far.fold(Self::default(), |all, (_, far)| all.and(Self { count: 1, far }))
    }

    fn and(self, other: Self) -> Self {
        Self { count: self.count.saturating_add(other.count), far: self.far.max(other.far) }
    }
}

impl<'a> Predictor<'a> {
    /// By which equations accelerations are: by those that were said, or with which they agree, or else by those that come nearer to all
    /// others.
    pub(super) fn meant(&self, machine: &'a Machine) -> Vec<Option<Exact<'a>>> {
        let all = &self.given.accelerations;
        let Some(motion) = machine.motion.as_ref() else { return all.iter().map(|_| None).collect() };
        let world = machine.world();
        let exact = |given: &Accelerations| Exact {
            motion,
            parameters: &machine.parameters,
            attributes: world.attributes.clone(),
            accelerations: motion.accelerations(given, &world.parameters, self.feedback),
        };
        let by_both: Vec<(Exact, [Off; 2])> = all
            .iter()
            .map(|given| {
                let exact = exact(given);
                let off = [
                    Off::of(given, self.linear(given, &world).as_ref()),
                    Off::of(given, exact.accelerations.as_ref().ok()),
                ];
                (exact, off)
            })
            .collect();
        let is_open =
            |given: &Accelerations, off: &[Off; 2]| given.equations.is_none() && off.iter().all(|off| off.count > 0);
        let open = all.iter().zip(&by_both).filter(|(given, (_, off))| is_open(given, off));
        let [of_linear, of_exact] =
            open.fold([Off::default(); 2], |sum, (_, (_, off))| [0, 1].map(|at| sum[at].and(off[at])));
        let meant = |(given, (exact, off)): (&Accelerations, (Exact<'a>, [Off; 2]))| {
            let is_exact = match given.equations {
                Some(said) => said == Kind::Nonlinear,
                None if is_open(given, &off) => of_exact < of_linear,
                None => off[1] < off[0],
            };
            is_exact.then_some(exact)
        };
        all.iter().zip(by_both).map(meant).collect()
    }

    /// The accelerations in a state of the machine as it is with a force of one more on a coordinate, or with none; `None` where there are
    /// none, or no such force.
    pub fn with_force(&self, state: usize, on: Option<usize>, world: &World) -> Option<Vec<f64>> {
        let mut given = self.given.accelerations[state].clone();
        if let Some(on) = on {
            given.forces[on] += 1.0;
        }
        match &self.nonlinear[state] {
            Some(exact) => exact.motion.accelerations(&given, &world.parameters, self.feedback).ok(),
            None => self.linear(&given, world),
        }
    }

    /// What was given with the other equations for those accelerations that do not agree and of which nothing is said of equations;
    /// `None` where there are none.
    pub fn by_other_equations(&self, machine: &Machine) -> Option<Given> {
        machine.motion.as_ref()?;
        let here = self.predict(&machine.world());
        let mut given = self.given.clone();
        let mut is_any = false;
        for (at, (quantity, _)) in self.numbers.iter().enumerate().filter(|(at, _)| !self.agrees(*at, here[*at])) {
            let Quantity::Acceleration(state, _) = *quantity else { continue };
            if self.given.accelerations[state].equations.is_none() {
                let other = if self.is_nonlinear(at) { Kind::Linear } else { Kind::Nonlinear };
                given.accelerations[state].equations = Some(other);
                is_any = true;
            }
        }
        is_any.then_some(given)
    }

    /// Why there are none of some numbers of the machine as it is: of its motion in a state, or of its equations at a speed.
    pub fn reasons(&self, world: &World) -> Vec<String> {
        let states = self.nonlinear.iter().zip(&self.given.accelerations).enumerate();
        let of_state = |(state, (exact, given)): (usize, (&Option<Exact>, &Accelerations))| {
            let why = exact.as_ref()?.accelerations.as_ref().err()?;
            Some(format!("in state {} at {} m/s: {why}", state + 1, given.speed))
        };
        let mut reasons: Vec<String> = states.filter_map(of_state).collect();
        let mut of_speeds = |equations: &dyn Equations| {
            for speed in self.given.speeds() {
                let why = equations.state_space(speed, world.gravity).err();
                reasons.extend(why.map(|why| format!("at {speed} m/s: {why}")));
            }
        };
        if let Err(why) = self.visit(world, &mut of_speeds) {
            reasons.push(why);
        }
        reasons
    }

    /// Whether the accelerations in a state are by the nonlinear equations.
    pub fn is_state_nonlinear(&self, state: usize) -> bool {
        self.nonlinear[state].is_some()
    }

    /// Whether a number is by the nonlinear equations.
    pub fn is_nonlinear(&self, at: usize) -> bool {
        matches!(self.numbers[at].0, Quantity::Acceleration(state, _) if self.is_state_nonlinear(state))
    }

    /// Whether any number is.
    pub fn has_nonlinear(&self) -> bool {
        (0..self.numbers.len()).any(|at| self.is_nonlinear(at))
    }
}
