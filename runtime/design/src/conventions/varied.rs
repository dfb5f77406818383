//! One design after the other, each with its own values of some parameters, by the names of a convention or of the model.

use carvallo::ModelInfo;

use super::Convention;
use super::dual::Dual;
use super::name::{Name, Need, Values};
use super::naming::{At, Naming, Varying};
use super::read::list;
use crate::design::Design;
use crate::input::position;
use crate::number::with_unit;

/// More names than this are not listed.
const LISTED: usize = 6;

/// Puts the values of parameters that vary into those of a model.
#[derive(Clone, Debug)]
pub struct Varied {
    info: &'static ModelInfo,
    /// The columns of parameters of the model, with their positions.
    own: Vec<(usize, usize)>,
    foreign: Option<Foreign>,
}

/// Those of a convention.
#[derive(Clone, Debug)]
struct Foreign {
    convention: &'static Convention,
    /// The design in the convention, those that vary first and in their order.
    start: Values,
    columns: Vec<(usize, &'static Name)>,
    checked: Vec<(usize, &'static Name)>,
}

impl Varied {
    /// For the columns of a table, of which some may be something else. What does not vary is that of the design: in the
    /// convention, if parameters of one vary, unless they are all that it needs.
    ///
    /// # Errors
    /// If the design cannot be expressed in the convention.
    pub fn new(design: &Design, naming: &Naming, columns: &[Option<&Varying>]) -> Result<Self, String> {
        let info = design.info();
        let columns = || columns.iter().enumerate().filter_map(|(at, column)| Some((at, (*column)?.at)));
        let own = columns().filter_map(|(at, of)| if let At::Model(own) = of { Some((at, own)) } else { None });
        let foreign = |of: fn(At) -> Option<&'static Name>| -> Vec<(usize, &'static Name)> {
            columns().filter_map(|(at, own)| Some((at, of(own)?))).collect()
        };
        let checked = foreign(|at| if let At::Checked(name) = at { Some(name) } else { None });
        let varied = foreign(|at| if let At::Convention(name) = at { Some(name) } else { None });
        let foreign = match naming.convention().filter(|_| !varied.is_empty()) {
            Some(convention) => {
                let start = start(design, convention, &varied)?;
                Some(Foreign { convention, start, columns: varied, checked })
            }
            None => None,
        };
        Ok(Self { info, own: own.collect(), foreign })
    }

    /// Puts the values of the columns, as far as they have one, in the place of those of the model, which are of the design or of
    /// one before.
    ///
    /// # Errors
    /// A value that its parameter cannot have, or that there is no such bicycle.
    pub fn put(&self, value: impl Fn(usize) -> Option<f64>, parameters: &mut [f64]) -> Result<(), String> {
        if let Some(foreign) = &self.foreign {
            for (name, value) in foreign.paper(&value)?.iter() {
                if let Some(at) = self.info.position(name) {
                    parameters[at] = value.value;
                }
            }
        }
        for &(column, position) in &self.own {
            if let Some(value) = value(column) {
                parameters[position] = value;
            }
        }
        Ok(())
    }

    /// The value that the design has itself in a column, if it is known.
    pub fn start(&self, column: usize) -> Option<f64> {
        let Foreign { start, columns, .. } = self.foreign.as_ref()?;
        let at = columns.iter().position(|(own, _)| *own == column)?;
        start.iter().nth(at).map(|(_, value)| value.value).filter(|value| value.is_finite())
    }

    /// What varies by other names than the model's, what of the design is kept with it, and what follows.
    pub fn note(&self) -> Option<String> {
        let Foreign { convention, start, columns, .. } = self.foreign.as_ref()?;
        let is_own = |name: &str| position(name, self.info).is_some();
        let varied: Vec<&str> = columns.iter().map(|(_, name)| name.name).collect();
        let foreign: Vec<&str> = varied.iter().copied().filter(|name| !is_own(name)).collect();
        let vary = if foreign.len() == 1 { "varies" } else { "vary" };
        let shown = if foreign.len() > LISTED { format!("{} parameters", foreign.len()) } else { list(&foreign) };
        if !start.iter().skip(varied.len()).any(|(name, _)| name != "g") {
            return Some(format!("{shown} {vary} as all of {}; those of the paper follow", convention.title));
        }
        let kept: Vec<&str> =
            start.iter().skip(varied.len()).map(|(name, _)| name).filter(|name| !is_own(name)).collect();
        let kept = match kept.len() {
            0 => "all else stays as it is".to_owned(),
            count if count > LISTED => "all other parameters of it stay as they are".to_owned(),
            _ => format!("{} and all else of it stay as they are", list(&kept)),
        };
        let follows = self.follows();
        let follow = match follows.len() {
            0 => String::new(),
            count if count > LISTED => ", and those of the paper follow".to_owned(),
            1 => format!(", and {} follows", list(&follows)),
            _ => format!(", and {} follow", list(&follows)),
        };
        Some(format!("{shown} {vary} in {}: {kept}{follow}", convention.title))
    }

    /// The parameters of the paper that change, by the derivatives of the conversion, without those that vary themselves.
    fn follows(&self) -> Vec<&'static str> {
        let Some(Foreign { convention, start, columns, .. }) = &self.foreign else { return Vec::new() };
        let mut found: Vec<&str> = Vec::new();
        for column in 0..columns.len() {
            let Ok(paper) = (convention.to_paper)(&start.varied(column)) else { continue };
            let is_new = |name: &str| columns.iter().all(|(_, own)| own.name != name);
            found.extend(paper.iter().filter(|(name, value)| value.slope != 0.0 && is_new(name)).map(|(name, _)| name));
        }
        // As the paper has them, each once.
        let names = crate::model::WHIPPLE.info.parameters.iter().map(|parameter| parameter.name);
        names.filter(|name| found.contains(name)).collect()
    }
}

impl Foreign {
    fn paper(&self, value: &impl Fn(usize) -> Option<f64>) -> Result<Values, String> {
        let mut values = self.start.clone();
        for (at, (column, name)) in self.columns.iter().enumerate() {
            let Some(value) = value(*column) else { continue };
            if !name.domain.contains(value) {
                return Err(format!("`{}` is {}; it must be {}", name.name, with_unit(value, name.unit), name.domain));
            }
            values.set(at, value);
        }
        for (column, name) in &self.checked {
            let Some(value) = value(*column) else { continue };
            let (required, what, reason) = match name.need {
                Need::Zero(reason) => (0.0, "0".to_owned(), reason),
                Need::Equal(other, reason) => match values.get(other) {
                    Some(Dual { value, .. }) => {
                        (value, format!("that of `{other}`, {}", with_unit(value, name.unit)), reason)
                    }
                    None => continue,
                },
                _ => continue,
            };
            if (value - required).abs() > 1e-9 * value.abs().max(required.abs()) {
                return Err(format!("`{}` is {}; it must be {what}: {reason}", name.name, with_unit(value, name.unit)));
            }
        }
        (self.convention.to_paper)(&values)
    }
}

/// The design in the convention, without what stands in the place of those that vary, which are put before it.
fn start(
    design: &Design,
    convention: &'static Convention,
    varied: &[(usize, &'static Name)],
) -> Result<Values, String> {
    let is_varied = |name: &str| varied.iter().any(|(_, own)| own.name == name);
    let is_whole = convention.needed().iter().all(|group| group.iter().any(|name| is_varied(name)));
    let mut paper = Values::default();
    design.info().parameters.iter().zip(design.values()).for_each(|(info, value)| paper.push(info.name, value.into()));
    let expressed = if is_whole { Values::default() } else { (convention.from_paper)(&paper)? };
    let in_place = |name: &str| {
        convention.alternatives.iter().any(|group| group.contains(&name) && group.iter().any(|other| is_varied(other)))
    };
    let mut kept = expressed.clone();
    kept.retain(|name| !is_varied(name) && !in_place(name));
    // Gravity is not part of a bicycle.
    if is_whole && !is_varied("g") {
        kept.copy("g", &paper, "g");
    }
    let mut start = Values::default();
    for (_, name) in varied {
        let mut names = [name.name].into_iter().chain(name.others.iter().copied());
        let own = expressed.get(name.name).or_else(|| names.find_map(|name| paper.get(name)));
        // Of what is not told, any number will do until each design has its own.
        start.push(name.name, own.unwrap_or(Dual::constant(f64::NAN)));
    }
    kept.iter().for_each(|(name, value)| start.push(name, value));
    Ok(start)
}
