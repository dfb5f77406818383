//! Measurements by their names, with what is missing and wrong among them.

use std::cell::RefCell;
use std::collections::BTreeMap;

use carvallo::{ParameterInfo, Sources, Uncertain};
use carvallo_design::input::{Named, Node, Raw, Value, computed, too_large};
use carvallo_design::number::shortest;
use carvallo_design::quantity::{Context, Measured, measured, no_names};
use carvallo_design::{Deviation, Failure, Given, Place, Problem, WHIPPLE};

use crate::doubts::doubts;
use crate::names::{OTHERS, hint, known};
use crate::origins::{impossible, large};
use crate::oscillation::{Oscillation, Recording};

/// A fit that explains less of a signal is told to be doubtful, ...
const DOUBTFUL: f64 = 0.9;
/// ... and one that explains less than half of it is of noise.
const NOISE: f64 = 0.5;

/// The angle that no bicycle has below 3.1416 degrees.
const HEAD_ANGLE: &str = "gamma";

/// What is in a file of measurements.
pub struct Table<'a> {
    label: String,
    name: Option<String>,
    sources: &'a Sources,
    numbers: BTreeMap<&'static str, Uncertain<'a>>,
    unused: Vec<String>,
    /// What was fitted to recordings.
    fitted: Vec<String>,
    missing: RefCell<Vec<String>>,
    problems: RefCell<Vec<Problem>>,
    warnings: RefCell<Vec<String>>,
}

impl<'a> Table<'a> {
    /// # Errors
    /// Everything that is wrong with names and values.
    pub fn read(Raw { label, members }: Raw, sources: &'a Sources) -> Result<Self, Failure> {
        let mut table = Self {
            label,
            name: None,
            sources,
            numbers: BTreeMap::new(),
            unused: Vec::new(),
            fitted: Vec::new(),
            missing: RefCell::default(),
            problems: RefCell::default(),
            warnings: RefCell::default(),
        };
        if let Some(Named { node, .. }) = members.iter().find(|member| member.name == "parameters") {
            let message =
                "these are parameters, and no measurements that they follow from; `carvallo analyze` reads such a file";
            return Err(Failure::at(node.place.clone(), message));
        }
        let mut places: BTreeMap<&str, Place> = BTreeMap::new();
        // A group of their own is as good as none.
        let flat = members.into_iter().flat_map(|member| match member.node.value {
            Value::Table(members) if member.name == "measurements" => members,
            value => vec![Named { name: member.name, node: Node { place: member.node.place, value } }],
        });
        for member in flat {
            match (member.name.as_str(), &member.node.value) {
                ("name", Value::Text(text)) => table.name = Some(text.clone()),
                ("kind" | "source", _) => {}
                (name, _) if OTHERS.contains(&name) => table.unused.push(format!("`{name}`")),
                (name, _) => {
                    let Some(info) = known(name) else {
                        let hint = hint(name).unwrap_or_default();
                        let message = format!("`{name}` is no measurement that is known{hint}");
                        table.problems.get_mut().push(Problem { place: member.node.place, message });
                        continue;
                    };
                    let place = member.node.place.clone();
                    if let Some(first) = places.insert(info.name, place.clone()) {
                        let message = format!("`{name}` is given twice; first at {first}");
                        table.problems.get_mut().push(Problem { place, message });
                        continue;
                    }
                    let member = match with_periods(member, &table.label) {
                        Ok((member, fitted)) => {
                            table.fitted.extend(fitted);
                            member
                        }
                        Err(Failure::Input(found)) => {
                            table.problems.get_mut().extend(found);
                            continue;
                        }
                        Err(unreadable) => return Err(unreadable),
                    };
                    match mean(member, info, sources) {
                        Ok(number) => drop(table.numbers.insert(info.name, number)),
                        Err(found) => table.problems.get_mut().extend(found),
                    }
                }
            }
        }
        let problems = table.problems.take();
        if problems.is_empty() { Ok(table) } else { Err(Failure::Input(problems)) }
    }

    /// A measurement; one that is missing is told of at the end.
    pub fn get(&self, name: &str) -> Uncertain<'a> {
        self.numbers.get(name).copied().unwrap_or_else(|| {
            let mut missing = self.missing.borrow_mut();
            if !missing.iter().any(|other| other == name) {
                missing.push(name.to_owned());
            }
            self.exact(1.0)
        })
    }

    pub fn has(&self, name: &str) -> bool {
        self.numbers.contains_key(name)
    }

    /// Whether fork and handlebar were measured each by itself.
    pub fn is_fork_split(&self) -> bool {
        self.has("mS") || self.has("mG")
    }

    pub fn exact(&self, value: f64) -> Uncertain<'a> {
        self.sources.exact(value)
    }

    /// What measurements cannot be together.
    pub fn problem(&self, message: String) {
        self.problems.borrow_mut().push(Problem { place: Place::File(self.label.clone()), message });
    }

    pub fn warn(&self, message: String) {
        self.warnings.borrow_mut().push(message);
    }

    /// The bicycle with these parameters.
    ///
    /// # Errors
    /// If measurements are missing, or are those of no bicycle.
    pub fn finish(self, parameters: Vec<(&'static str, Uncertain<'a>)>) -> Result<carvallo_design::Design, Failure> {
        let missing = self.missing.take();
        if !missing.is_empty() {
            // What does not fit may be for want of these.
            let names = missing.join(", ");
            let message = if self.numbers.is_empty() {
                "it has no measurements; `carvallo measure --example` prints a file to start from".to_owned()
            } else {
                format!("missing: {names}")
            };
            return Err(Failure::at(Place::File(self.label), message));
        }
        let problems = self.problems.take();
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        let written = |&(name, number): &(&str, Uncertain)| {
            let deviation = Some(number.deviation()).filter(|&deviation| deviation > 0.0);
            let deviation = deviation.map(|deviation| format!("+/-{}", shortest(deviation))).unwrap_or_default();
            (name.to_owned(), format!("{}{deviation}", shortest(number.value())))
        };
        let measured: Vec<(&str, f64)> = self.numbers.iter().map(|(name, number)| (*name, number.value())).collect();
        let doubts = doubts(&measured);
        let impossible: Vec<String> =
            parameters.iter().filter_map(|(name, number)| impossible(name, number.value())).collect();
        if !impossible.is_empty() {
            // Doubtful periods are the likely cause.
            let problem =
                |message: &String| Problem { place: Place::File(self.label.clone()), message: message.clone() };
            return Err(Failure::Input(impossible.iter().chain(&doubts).map(problem).collect()));
        }
        let mut design = computed(&WHIPPLE, &self.label, parameters.iter().map(written))?;
        let large: Vec<String> = too_large(WHIPPLE.info, &design.values()).into_iter().map(large(&design)).collect();
        design.warnings.extend(large);
        let numbers: Vec<Uncertain> = parameters.iter().map(|(_, number)| *number).collect();
        let covariance = self.sources.covariance(&numbers).map_err(|error| Failure::Run(error.to_string()))?;
        design.covariance = Some(covariance).filter(|covariance| !covariance.correlations().is_empty());
        design.name = self.name.unwrap_or_else(|| name_of(&self.label));
        design.source = Some(format!("measurements in {}", self.label));
        if !self.unused.is_empty() {
            let names = self.unused.join(", ");
            design.notes.push(format!("{}: no parameters depend on them, and not used: {names}", self.label));
        }
        design.notes.extend(self.fitted);
        design.warnings.extend(self.warnings.take().into_iter().chain(doubts));
        Ok(design)
    }
}

/// `Browser` of `data/BrowserMeasured.txt`.
fn name_of(label: &str) -> String {
    let file = label.rsplit(['/', '\\']).next().unwrap_or(label);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    stem.strip_suffix("Measured").filter(|name| !name.is_empty()).unwrap_or(stem).to_owned()
}

/// A measurement with the periods of recordings in their places, and what is said of each.
///
/// # Errors
/// What is wrong with a recording, or that it cannot be read.
fn with_periods(Named { name, node }: Named, label: &str) -> Result<(Named, Vec<String>), Failure> {
    let mut fitted = Vec::new();
    let is_period = known(&name).is_some_and(|info| info.unit == "s");
    let mut fit = |Node { place, value }: Node| {
        let Some(recording) = Recording::of(&value).filter(|_| is_period) else { return Ok(Node { place, value }) };
        let found = recording.map_err(Failure::usage).and_then(|recording| recording.period(label));
        let (Oscillation { period, deviation, r_squared, .. }, said) = found.map_err(|failure| match failure {
            Failure::Input(problems) => {
                let of = |problem: Problem| Problem {
                    place: place.clone(),
                    message: format!("`{name}`: {}", problem.message),
                };
                Failure::Input(problems.into_iter().map(of).collect())
            }
            Failure::Run(message) => Failure::Run(format!("{place}: `{name}`: {message}")),
        })?;
        if r_squared < NOISE {
            let message =
                format!("`{name}`: no decaying sine is in this signal, of which it explains {r_squared:.2}: {said}");
            return Err(Failure::at(place, message));
        }
        let doubt = if r_squared < DOUBTFUL { "; it is hardly a decaying sine" } else { "" };
        fitted.push(format!("`{name}` is {said}{doubt}"));
        Ok(Node { place, value: Value::Text(format!("{}+/-{}", shortest(period), shortest(deviation))) })
    };
    let node = match node {
        Node { place, value: Value::List(nodes) } => {
            Node { place, value: Value::List(nodes.into_iter().map(fit).collect::<Result<_, _>>()?) }
        }
        node => fit(node)?,
    };
    Ok((Named { name, node }, fitted))
}

/// A measurement, or the mean of several, which are independent of each other.
fn mean<'a>(
    Named { name, node: Node { place, value } }: Named,
    info: &'static ParameterInfo,
    sources: &'a Sources,
) -> Result<Uncertain<'a>, Vec<Problem>> {
    let single = |value: Value| vec![Node { place: place.clone(), value }];
    let nodes = match value {
        Value::List(nodes) if !nodes.is_empty() => nodes,
        // With a space behind each comma there is no mistaking it for a decimal one.
        Value::Text(text) if text.contains(", ") => {
            text.split(", ").flat_map(|text| single(Value::Text(text.trim().to_owned()))).collect()
        }
        value => single(value),
    };
    let count = nodes.len() as f64;
    let (mut sum, mut problems) = (sources.exact(0.0), Vec::new());
    for Node { place, value } in nodes {
        if name == HEAD_ANGLE
            && let Some(message) = in_radians(&name, &value)
        {
            problems.push(Problem { place: place.clone(), message });
        }
        let value = if info.unit == "rad" { in_degrees(value) } else { value };
        match (Named { name: name.clone(), node: Node { place, value } }).judge(info) {
            Ok(Given { value, deviation, .. }) => {
                sum = sum + sources.measured(value, deviation.map_or(0.0, |Deviation { value, .. }| value));
            }
            Err(found) => problems.extend(found),
        }
    }
    if problems.is_empty() { Ok(sum / count) } else { Err(problems) }
}

/// An angle without a unit is in degrees.
pub fn in_degrees(value: Value) -> Value {
    match value {
        Value::Text(text) | Value::Number(text) => {
            let context = Context { unit: "1", names: &no_names };
            Value::Text(match measured(&text, context) {
                Ok(Measured { mean, deviation: Some(deviation) }) => {
                    format!("({} +/- {}) deg", shortest(mean.value), shortest(deviation.value))
                }
                Ok(Measured { mean, deviation: None }) => format!("{} deg", shortest(mean.value)),
                Err(_) => text,
            })
        }
        Value::Table(mut members) if members.iter().all(|member| !member.name.starts_with("unit")) => {
            if let Some(place) = members.first().map(|member| member.node.place.clone()) {
                let node = Node { place, value: Value::Text("deg".to_owned()) };
                members.push(Named { name: "unit".to_owned(), node });
            }
            Value::Table(members)
        }
        other => other,
    }
}

/// That a plain number of degrees was probably meant in radians, of an angle that is never so small.
pub fn in_radians(name: &str, value: &Value) -> Option<String> {
    let (Value::Text(text) | Value::Number(text)) = value else { return None };
    let radians = text.trim().parse().ok().filter(|radians| (0.0..std::f64::consts::PI).contains(radians))?;
    let degrees = shortest((10.0 * f64::to_degrees(radians)).round() / 10.0);
    Some(format!(
        "`{name}` is {text} deg, since plain numbers are in degrees; for {degrees} degrees write \"{text} rad\", or \"{text} deg\" \
         if that is meant"
    ))
}
