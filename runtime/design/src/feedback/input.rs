//! What a force acts on, and what it is called.

use carvallo::ModelInfo;
use carvallo::simulation::Moving;

use crate::model::Shipped;
use crate::motion_names::is_called;
use crate::nearest::nearest;

/// What a force acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// The coordinate of this place.
    Coordinate(usize),
    /// What moves with coordinates, as a wheel that a motor drives: a force by its place among [`ModelInfo::forces`].
    Applied(usize),
}

impl Input {
    /// All that a model has: a force on each coordinate, and those of its mechanism that act on none.
    pub fn all(info: &ModelInfo) -> Vec<Self> {
        let others = (0..info.forces.len()).filter(|force| on(*force, info).is_none());
        (0..info.coordinates.len()).map(Self::Coordinate).chain(others.map(Self::Applied)).collect()
    }

    /// The one of a name, in letters of either case.
    ///
    /// # Errors
    /// If there is none: that, and those that there are.
    pub fn called(name: &str, info: &ModelInfo) -> Result<Self, String> {
        let all = Self::all(info);
        let is_called = |input: &&Self| input.names(info).iter().any(|own| is_called(own, own, name));
        all.iter().find(is_called).copied().ok_or_else(|| {
            let names: Vec<Vec<String>> = all.iter().map(|input| input.names(info)).collect();
            let hint = nearest(name, names.iter().flatten().map(String::as_str));
            let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
            let own: Vec<&str> = names.iter().map(|names| names[0].as_str()).collect();
            format!("`{name}` is no force on {}{hint}\nthey are {}", info.name, own.join(", "))
        })
    }

    /// What it may be called, its own name first: on a coordinate `Tdelta` for a torque, else `Fy`, then `delta`, `steer`, `steer torque`, and
    /// as the mechanism has it.
    pub fn names(self, info: &ModelInfo) -> Vec<String> {
        match self {
            Self::Applied(force) => vec![info.forces[force].name.to_owned(), info.forces[force].label.to_owned()],
            Self::Coordinate(place) => {
                let coordinate = &info.coordinates[place];
                let (own, other, kind) =
                    if coordinate.unit == "rad" { ("T", "F", "torque") } else { ("F", "T", "force") };
                let (name, label) = (coordinate.name, coordinate.label);
                let usual = [
                    format!("{own}{name}"),
                    format!("{other}{name}"),
                    name.to_owned(),
                    label.to_owned(),
                    format!("{label} {kind}"),
                ];
                let declared = info.forces.iter().filter(|force| force.position == name);
                usual
                    .into_iter()
                    .chain(declared.flat_map(|force| [force.name, force.label]).map(str::to_owned))
                    .collect()
            }
        }
    }

    /// What it is in words; nothing for a force on a coordinate that has no name of its own.
    pub fn label(self, info: &ModelInfo) -> Option<&'static str> {
        match self {
            Self::Applied(force) => Some(info.forces[force].label),
            Self::Coordinate(_) => None,
        }
    }

    /// The unit of the force as models declare it: `N*m` on an angle, `N` on a length; nothing on what is neither.
    pub fn unit(self, info: &ModelInfo) -> Option<&'static str> {
        match self {
            Self::Applied(force) => Some(info.forces[force].unit),
            Self::Coordinate(place) => match info.coordinates[place].unit {
                "rad" => Some("N*m"),
                "m" => Some("N"),
                _ => None,
            },
        }
    }

    /// The forces on the coordinates that a force of one makes, with parameters in declared order.
    pub fn shares(self, info: &ModelInfo, parameters: &[f64]) -> Vec<f64> {
        let one = |place: usize| (0..info.coordinates.len()).map(|row| if row == place { 1.0 } else { 0.0 }).collect();
        match self {
            Self::Coordinate(place) => one(place),
            Self::Applied(force) => {
                let model = Shipped::called(info.name).ok();
                model.and_then(|model| model.shares(parameters, force)).unwrap_or_default()
            }
        }
    }

    /// The place of the force in the nonlinear equations of a machine.
    pub(crate) fn in_machine(self, machine: &dyn Moving, info: &ModelInfo) -> Option<usize> {
        let forces = machine.info().forces;
        match self {
            Self::Applied(force) => machine.info().force(info.forces[force].name),
            Self::Coordinate(place) => forces.iter().position(|force| force.position == info.coordinates[place].name),
        }
    }
}

/// The coordinate that a force of the mechanism acts on.
fn on(force: usize, info: &ModelInfo) -> Option<usize> {
    info.coordinates.iter().position(|coordinate| coordinate.name == info.forces[force].position)
}
