//! One number that is not known: a parameter, a definition or a factor of the speeds has another value.

use carvallo::Expression;

use super::solve::{relation, solve};
use super::{Cause, Found};
use crate::conventions::Convention;
use crate::machine::Machine;
use crate::predict::{Predictor, World};

/// What may have another value.
#[derive(Clone, Copy, Debug)]
pub enum Unknown<'a> {
    /// The parameter at a position, with a convention or without one.
    Parameter(Option<&'a Convention>, usize),
    /// The definition at a position, whatever its formula is.
    Definition(usize),
    /// A factor of all speeds.
    Speed,
}

impl<'a> Unknown<'a> {
    /// Every parameter that is used, with a convention or without one.
    pub fn parameters(machine: &Machine, convention: Option<&'a Convention>) -> impl Iterator<Item = Self> {
        // Nonlinear equations depend on more of them.
        let is_nonlinear = machine.motion.is_some();
        let all = machine.info.parameters.iter().enumerate();
        let all = all.filter(move |(_, parameter)| parameter.used || is_nonlinear);
        all.map(move |(at, _)| Self::Parameter(convention, at))
    }

    /// The value with which all numbers come out, with the fewest digits; none that cannot be.
    pub fn solve(self, machine: &Machine, predictor: &Predictor) -> Option<f64> {
        let old = match self {
            Self::Parameter(_, at) => machine.parameters[at],
            Self::Definition(at) => machine.values.definition(at),
            Self::Speed => 1.0,
        };
        // What cannot be is nobody's, unless it is a slip of the pen.
        let can_be = |x: &f64| match self {
            Self::Parameter(_, at) => {
                machine.info.parameters[at].domain.contains(*x) || relation(machine.parameters[at], *x).is_some()
            }
            Self::Definition(_) | Self::Speed => true,
        };
        // Of what is searched for where nothing else was found there is much.
        let is_by_determinants = matches!(self, Self::Parameter(Some(_), _) | Self::Definition(_));
        solve(predictor, old, &|x| self.world(machine, x), is_by_determinants).filter(can_be)
    }

    /// What explains the numbers with this value.
    pub fn found(self, machine: &Machine, x: f64) -> Option<Found<'a>> {
        let causes = match self {
            Self::Parameter(convention, at) => {
                convention.map(Cause::Convention).into_iter().chain([Cause::Parameter(at, x)]).collect()
            }
            Self::Definition(at) => vec![Cause::Definition(at, x)],
            Self::Speed => vec![Cause::Speed(x)],
        };
        Some(Found { causes, world: self.world(machine, x)? })
    }

    fn world(self, machine: &Machine, x: f64) -> Option<World> {
        match self {
            Self::Parameter(convention, at) => {
                let mut parameters = machine.parameters.clone();
                if let Some(convention) = convention {
                    convention.change_parameters(&mut parameters);
                }
                parameters[at] = x;
                let old = machine.world_of(&parameters);
                let Some(convention) = convention else { return Some(old) };
                let mut own = World::default();
                convention.change_matrices(&old, &mut own, machine.formulas.count);
                Some(own)
            }
            Self::Definition(at) => {
                let mut own = machine.values.clone();
                let number = Expression::Number(String::new(), x);
                machine.formulas.change(&[at], &number, &machine.parameters, &mut own);
                Some(machine.world_from(own, &machine.parameters))
            }
            Self::Speed => {
                let world = machine.world_with(&Convention::of_speeds("", x, &machine.feedback));
                (x > 0.0).then_some(world)
            }
        }
    }
}
