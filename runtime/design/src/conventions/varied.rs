//! One design after the other, each with its own values of some parameters, by the names of a convention or of the model.

use carvallo::ModelInfo;

use super::Convention;
use super::dual::Dual;
use super::held::Ranks;
use super::moved::{changes, moves};
use super::name::{Name, Need, Values};
use super::naming::{At, Naming, Varying, prepared};
use super::read::list;
use crate::design::Design;
use crate::input::position;
use crate::number::with_unit;

/// More names than this are not listed.
const LISTED: usize = 6;

/// How far beside a value another one is tried, relatively.
const BESIDE: f64 = 1e-3;

/// What is given twice may differ by so much, relatively.
const SAME: f64 = 1e-6;

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
    /// The parameters of the paper that change with them, in its order, but for those that are among them.
    follow: Vec<&'static str>,
}

impl Varied {
    /// For the columns of a table, of which some may be something else. What does not vary is that of the design: in the
    /// convention, if parameters of one vary, unless they are all that it needs. Of what stands in each other's place there, what
    /// was set is kept rather than what was given, and that rather than what follows.
    ///
    /// # Errors
    /// If the design cannot be expressed in the convention; or if something that was set changes with what varies.
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
            Some(convention) => Some(Foreign::new(design, convention, varied, checked)?),
            None => None,
        };
        let varied = Self { info, own: own.collect(), foreign };
        match varied.overridden(design) {
            Some(message) => Err(message),
            None => Ok(varied),
        }
    }

    /// Puts the values of the columns, as far as they have one, in the place of those of the model, which are of the design or of
    /// one before.
    ///
    /// # Errors
    /// A value that its parameter cannot have, or that there is no such bicycle; or two values of one parameter.
    pub fn put(&self, value: impl Fn(usize) -> Option<f64>, parameters: &mut [f64]) -> Result<(), String> {
        if let Some(foreign) = &self.foreign {
            for (name, value) in (foreign.convention.to_paper)(&foreign.values(&value)?)?.iter() {
                if let Some(at) = self.info.position(name) {
                    parameters[at] = value.value;
                }
            }
        }
        for &(column, position) in &self.own {
            let Some(value) = value(column) else { continue };
            if self.follows(position) {
                self.check(position, value, parameters[position])?;
            }
            parameters[position] = value;
        }
        Ok(())
    }

    /// That a value which a column gives is the one that follows from others.
    fn check(&self, position: usize, given: f64, found: f64) -> Result<(), String> {
        if (given - found).abs() <= SAME * given.abs().max(found.abs()) {
            return Ok(());
        }
        let parameter = &self.info.parameters[position];
        let [given, found] = [given, found].map(|value| with_unit(value, parameter.unit));
        Err(format!("`{}` is {given}, but {found} follows from the others", parameter.name))
    }

    /// The derivatives of the parameters of the model by each column, at values of these.
    ///
    /// # Errors
    /// As of [`put`](Self::put).
    pub fn derivatives(&self, columns: usize, value: impl Fn(usize) -> Option<f64>) -> Result<Vec<Vec<f64>>, String> {
        let mut derivatives = vec![vec![0.0; self.info.parameters.len()]; columns];
        if let Some(foreign) = &self.foreign {
            let values = foreign.values(&value)?;
            for (at, (column, _)) in foreign.columns.iter().enumerate() {
                for (name, value) in (foreign.convention.to_paper)(&values.varied(at))?.iter() {
                    if let Some(position) = self.info.position(name) {
                        derivatives[*column][position] = value.slope;
                    }
                }
            }
        }
        for &(column, position) in &self.own {
            derivatives[column][position] = 1.0;
        }
        Ok(derivatives)
    }

    /// The value that the design has itself in a column, if it is known.
    pub fn start(&self, column: usize) -> Option<f64> {
        let Foreign { start, columns, .. } = self.foreign.as_ref()?;
        let at = columns.iter().position(|(own, _)| *own == column)?;
        start.iter().nth(at).map(|(_, value)| value.value).filter(|value| value.is_finite())
    }

    /// The parameters of the model that change, by their names.
    pub fn changing(&self) -> Vec<&'static str> {
        let foreign = self.foreign.iter().flat_map(|foreign| {
            let own = foreign.columns.iter().filter_map(|(_, name)| position(name.name, self.info));
            own.map(|at| self.info.parameters[at].name).chain(foreign.follow.iter().copied())
        });
        foreign.chain(self.own.iter().map(|(_, position)| self.info.parameters[*position].name)).collect()
    }

    /// Why two of the columns cannot vary beside each other, if that is so: one is a parameter that follows from another.
    pub fn conflict(&self) -> Option<String> {
        let Foreign { columns, .. } = self.foreign.as_ref()?;
        let (_, position) = self.own.iter().find(|(_, position)| self.follows(*position))?;
        let names: Vec<&str> = columns.iter().map(|(_, name)| name.name).collect();
        let (name, vary) = (self.info.parameters[*position].name, if names.len() == 1 { "varies" } else { "vary" });
        Some(format!("`{name}` follows from {}, which {vary}, too; both cannot be held", list(&names)))
    }

    /// Why there is no design with these columns, whatever their values, if that is so: the design's own make none.
    pub fn contradiction(&self) -> Option<String> {
        let Foreign { convention, start, .. } = self.foreign.as_ref()?;
        let is_known = start.iter().all(|(_, value)| value.value.is_finite());
        (convention.to_paper)(start).err().filter(|_| is_known)
    }

    /// Why one of the columns cannot vary by itself, if that is so: with no other value near its own there is such a bicycle, as
    /// where it says what others say, too.
    pub fn fixed(&self) -> Option<String> {
        let Foreign { convention, start, columns, .. } = self.foreign.as_ref()?;
        (convention.to_paper)(start).ok()?;
        columns.iter().enumerate().find_map(|(at, (_, name))| {
            let own = start.iter().nth(at)?.1.value;
            let beside = |step: f64| {
                let mut values = start.clone();
                values.set(at, own + step * own.abs().max(0.1));
                (convention.to_paper)(&values).err()
            };
            let reason = beside(BESIDE).and(beside(-BESIDE))?;
            Some(format!("`{}` cannot vary by itself in {}: {reason}", name.name, convention.title))
        })
    }

    /// Why something that was set cannot hold, if that is so: it changes with what varies.
    fn overridden(&self, design: &Design) -> Option<String> {
        let own = |set: &str| {
            let changes = |(_, position): &&(usize, usize)| changes(set, design, *position);
            self.own.iter().find(changes).map(|(_, position)| vec![self.info.parameters[*position].name])
        };
        let foreign = |set: &str| {
            let foreign = self.foreign.as_ref().filter(|foreign| !foreign.keeps(set, self.info))?;
            Some(foreign.columns.iter().map(|(_, name)| name.name).collect())
        };
        let (set, by) = design.set.iter().find_map(|set| Some((set, own(set).or_else(|| foreign(set))?)))?;
        let (shown, vary) = varying(&by);
        Some(format!("`{set}` is set, but changes with {shown}, which {vary}; leave one of them out"))
    }

    /// Whether a parameter of the model follows from those of the convention that vary.
    fn follows(&self, position: usize) -> bool {
        let name = self.info.parameters[position].name;
        self.foreign.as_ref().is_some_and(|foreign| foreign.follow.contains(&name))
    }

    /// What varies by other names than the model's, what of the design is kept with it, and what follows.
    pub fn note(&self) -> Option<String> {
        let Foreign { convention, start, columns, follow: follows, .. } = self.foreign.as_ref()?;
        let is_own = |name: &str| position(name, self.info).is_some();
        let varied: Vec<&str> = columns.iter().map(|(_, name)| name.name).collect();
        let foreign: Vec<&str> = varied.iter().copied().filter(|name| !is_own(name)).collect();
        let (shown, vary) = varying(&foreign);
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
        // `c` is the trail itself.
        let is_itself = |name: &&str| columns.iter().any(|(_, own)| own.others.contains(name));
        let follows: Vec<&str> = follows.iter().copied().filter(|name| !is_itself(name)).collect();
        let follow = match follows.len() {
            0 => String::new(),
            count if count > LISTED => ", and those of the paper follow".to_owned(),
            1 => format!(", and {} follows", list(&follows)),
            _ => format!(", and {} follow", list(&follows)),
        };
        Some(format!("{shown} {vary} in {}: {kept}{follow}", convention.title))
    }
}

impl Foreign {
    fn new(
        design: &Design,
        convention: &'static Convention,
        columns: Vec<(usize, &'static Name)>,
        checked: Vec<(usize, &'static Name)>,
    ) -> Result<Self, String> {
        let start = start(design, convention, &columns)?;
        let slopes = slopes(convention, &start, columns.len());
        let is_own = |name: &str| columns.iter().any(|(_, own)| own.name == name);
        let changes = |name: &str| slopes.iter().any(|slopes| slopes.get(name).is_some_and(|it| it.slope != 0.0));
        let names = crate::model::WHIPPLE.info.parameters.iter().map(|parameter| parameter.name);
        let follow = names.filter(|name| !is_own(name) && changes(name)).collect();
        Ok(Self { convention, start, columns, checked, follow })
    }

    /// Whether something that was set stays.
    fn keeps(&self, set: &str, info: &ModelInfo) -> bool {
        match self.convention.parameter(&prepared(set, self.convention)) {
            Some(name) => self.start.get(name.name).is_some(),
            None => {
                let slopes = slopes(self.convention, &self.start, self.columns.len());
                slopes.iter().all(|slopes| !moves(set, slopes, info))
            }
        }
    }

    /// All that the convention needs, with the values of the columns.
    fn values(&self, value: &impl Fn(usize) -> Option<f64>) -> Result<Values, String> {
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
        Ok(values)
    }
}

/// Names of what varies, and the verb for them.
fn varying(names: &[&str]) -> (String, &'static str) {
    let shown = if names.len() > LISTED { format!("{} parameters", names.len()) } else { list(names) };
    (shown, if names.len() == 1 { "varies" } else { "vary" })
}

/// The design in the convention, without what stands in the place of those that vary, which are put before it.
fn start(
    design: &Design,
    convention: &'static Convention,
    varied: &[(usize, &'static Name)],
) -> Result<Values, String> {
    let names: Vec<&str> = varied.iter().map(|(_, name)| name.name).collect();
    let set: Vec<&'static str> =
        design.set.iter().filter_map(|name| Some(convention.parameter(&prepared(name, convention))?.name)).collect();
    let of_file = design.reading.as_ref().filter(|reading| reading.convention == convention);
    let given = of_file.map(|reading| reading.given.clone()).unwrap_or_default();
    let is_whole = convention.needed().iter().all(|group| group.iter().any(|name| names.contains(name)));
    let mut paper = Values::default();
    design.info().parameters.iter().zip(design.values()).for_each(|(info, value)| paper.push(info.name, value.into()));
    let expressed = if is_whole { Values::default() } else { (convention.from_paper)(&paper)? };
    let others = (convention.complete)(&paper, &given);
    let known = |name: &str| expressed.get(name).or_else(|| others.get(name));
    let mut start = Values::default();
    for (_, name) in varied {
        let mut names = [name.name].into_iter().chain(name.others.iter().copied());
        let own = known(name.name).or_else(|| names.find_map(|name| paper.get(name)));
        // Of what is not told, any number will do until each design has its own.
        start.push(name.name, own.unwrap_or(Dual::constant(f64::NAN)));
    }
    if is_whole {
        // Gravity is not part of a bicycle.
        if !names.contains(&"g") {
            start.copy("g", &paper, "g");
        }
        return Ok(start);
    }
    let of_given: Vec<&'static str> = given.iter().map(|(name, _)| name).collect();
    let held = convention.held(Ranks { varied: &names, set: &set, given: &of_given });
    let is_varied = |name: &str| names.contains(&name);
    let is_kept = |name: &str| !is_varied(name) && (held.contains(&name) || !convention.has_alternatives(name));
    expressed.iter().filter(|(name, _)| is_kept(name)).for_each(|(name, value)| start.push(name, value));
    let mut missing = Vec::new();
    for name in held.iter().copied().filter(|name| !is_varied(name)) {
        match known(name) {
            Some(value) if start.get(name).is_none() => start.push(name, value),
            Some(_) => {}
            None => missing.push(name),
        }
    }
    if missing.is_empty() {
        return Ok(start);
    }
    Err(format!("{} must be known beside {}: give what is missing by --set", list(&missing), list(&names)))
}

/// What becomes of the parameters of the paper by each of the first so many values that varies: at the start, and beside it, where
/// what does not change at the start by chance does.
fn slopes(convention: &Convention, start: &Values, columns: usize) -> Vec<Values> {
    let mut beside = start.clone();
    for (at, (_, value)) in start.iter().enumerate().take(columns) {
        beside.set(at, 1.01 * value.value + 0.01);
    }
    let by = |values: &Values, column: usize| (convention.to_paper)(&values.varied(column)).ok();
    [start, &beside].into_iter().flat_map(|values| (0..columns).filter_map(|column| by(values, column))).collect()
}
