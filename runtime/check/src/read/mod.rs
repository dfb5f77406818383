//! Files with somebody's numbers, in JSON or TOML, and which machine they are of.

mod eigenvalues;
mod motion;
mod numbers;

use carvallo::CriticalKind;
use carvallo_design::input::{self, Named, Node, Raw, Request, Value, matrix_of_rows};
use carvallo_design::{Design, Failure, Place, Problem, Shipped, WHIPPLE, nearest};

use self::numbers::{problem, reading, rows, speed, speed_of};
use crate::given::{CriticalSpeed, Eigenvalues, Given, Reading, StateMatrix, SystemMatrix};

/// A file with somebody's numbers.
#[derive(Debug)]
pub struct File {
    label: String,
    /// The numbers but for accelerations, whose names depend on the model.
    given: Given,
    accelerations: Option<Node>,
    model: Option<String>,
    bicycle: Option<String>,
    parameters: Vec<(String, String, String)>,
}

/// What stands beside numbers in what the program itself prints, and what describes a file.
const IGNORED: [&str; 12] = [
    "name",
    "kind",
    "source",
    "title",
    "note",
    "notes",
    "comment",
    "coordinates",
    "stable_ranges",
    "undecided_ranges",
    "matrix_standard_deviations",
    "states",
];

/// What may be given.
const KNOWN: [&str; 22] = [
    "M",
    "C-1",
    "C0",
    "C1",
    "Kc",
    "K0",
    "K1",
    "K2",
    "A",
    "speed",
    "eigenvalues",
    "critical_speeds",
    "accelerations",
    "matrices",
    "bicycle",
    "set",
    "model",
    "parameters",
    "digits",
    "g",
    "weave_speed",
    "capsize_speed",
];

/// Reads a file, or with `-` the standard input.
///
/// # Errors
/// Everything that is wrong with it, or that it cannot be read.
pub fn load(path: &str) -> Result<File, Failure> {
    File::new(input::load_raw(path)?)
}

/// Reads the contents of a file; the ending of its label tells the format, or else what is in it.
///
/// # Errors
/// Everything that is wrong with it.
pub fn read(label: &str, bytes: Vec<u8>) -> Result<File, Failure> {
    File::new(input::read_raw(label, bytes)?)
}

impl File {
    fn new(raw: Raw) -> Result<Self, Failure> {
        let mut reader = Reader::default();
        reader.speed = reader.top_speed(&raw.members);
        raw.members.into_iter().for_each(|member| reader.member(member));
        let Reader { given, accelerations, model, bicycle, parameters, mut problems, digits, .. } = reader;
        let mut given = given;
        if given.numbers().is_empty() && accelerations.is_none() && problems.is_empty() {
            let message = "there are no numbers to check; expected matrices such as `M`, `A`, `eigenvalues`, \
                           `critical_speeds` or `accelerations`";
            problems.push(problem(&Place::File(raw.label.clone()), message));
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        if let Some(digits) = digits {
            given.each_reading(&mut |reading| reading.limit(digits));
        }
        Ok(Self { label: raw.label, given, accelerations, model, bicycle, parameters })
    }

    /// The design that the numbers are of: what is asked for, or else what the file says, or else the benchmark bicycle;
    /// with the parameters of the file.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn design(&self, asked: &Request) -> Result<Design, Failure> {
        let model = asked.model.clone().or_else(|| self.model.clone());
        let shipped = model.as_deref().map(Shipped::called).transpose().map_err(Failure::usage)?.unwrap_or(&WHIPPLE);
        let is_shipped = |name: &String| input::names(shipped).contains(&name.as_str());
        let mut parameters = asked.parameters.clone();
        if parameters.is_none() {
            // What the program prints has the name of the machine, and all of its parameters.
            parameters = self.bicycle.clone().filter(|name| self.parameters.is_empty() || is_shipped(name));
        }
        let name = |(_, name, _): &(String, String, String)| input::position(name, shipped.info);
        let given: Vec<usize> = self.parameters.iter().filter_map(name).collect();
        let is_whole = (0..shipped.info.parameters.len())
            .all(|at| given.contains(&at) || !shipped.info.parameters[at].used || shipped.info.gravity == Some(at));
        if parameters.is_none() && is_whole && asked.overrides.is_empty() {
            let values = self.parameters.iter().map(|(_, name, value)| (name.clone(), value.clone()));
            return input::given(shipped, &self.label, values);
        }
        let overrides = self.parameters.iter().chain(&asked.overrides).cloned().collect();
        input::load(&Request { model, parameters, overrides, ..asked.clone() })
    }

    /// The numbers, with names that belong to a design.
    ///
    /// # Errors
    /// Everything that is wrong with accelerations.
    pub fn given(&self, design: &Design) -> Result<Given, Failure> {
        let mut given = self.given.clone();
        if let Some(node) = &self.accelerations {
            given.accelerations = motion::accelerations(node, design.info()).map_err(Failure::Input)?;
        }
        Ok(given)
    }

    /// What the file is called.
    pub fn label(&self) -> &str {
        &self.label
    }
}

#[derive(Default)]
struct Reader {
    given: Given,
    accelerations: Option<Node>,
    model: Option<String>,
    bicycle: Option<String>,
    parameters: Vec<(String, String, String)>,
    speed: Option<f64>,
    digits: Option<usize>,
    problems: Vec<Problem>,
}

impl Reader {
    fn top_speed(&mut self, members: &[Named]) -> Option<f64> {
        let own = members.iter().find(|member| member.name == "speed")?;
        speed(&own.node).map_err(|problem| self.problems.push(problem)).ok()
    }

    fn member(&mut self, Named { name, node }: Named) {
        match (name.as_str(), &node.value) {
            ("speed", _) => {}
            ("model", Value::Text(text)) => self.model = Some(text.clone()),
            ("bicycle" | "set" | "design", Value::Text(text)) => self.bicycle = Some(text.clone()),
            ("digits", Value::Number(text)) => match text.parse() {
                Ok(digits @ 1..=17) => self.digits = Some(digits),
                _ => self.problems.push(problem(&node.place, format!("`digits` is {text}; expected 1 to 17"))),
            },
            ("parameters", Value::Table(_)) => self.parameters(node),
            ("g" | "gravity", _) => self.parameter(Named { name: "g".to_owned(), node }),
            ("matrices", Value::Table(_)) => {
                if let Value::Table(members) = node.value {
                    members.into_iter().for_each(|member| self.matrix(&member.name, &member.node));
                }
            }
            ("A", _) => self.state_matrices(&node),
            // Beside a speed they have it, and gravity, in them.
            ("C" | "D" | "K", _) if self.speed.is_some() => self.system_matrix(&name, &node),
            ("eigenvalues", _) => self.eigenvalues(&node),
            ("critical_speeds" | "critical", _) => self.critical_speeds(&node),
            ("weave_speed" | "weave", _) => self.critical_speed("weave", &node),
            ("capsize_speed" | "capsize", _) => self.critical_speed("capsize", &node),
            ("accelerations", _) => self.accelerations = Some(node),
            (name, _) if IGNORED.contains(&name) => {}
            (name, _) if matrix_of_rows(name).is_some() => self.matrix(name, &node),
            (name, _) => {
                let hint = nearest(name, KNOWN).map(|known| format!("; did you mean `{known}`?")).unwrap_or_default();
                let message = format!("`{name}` is not known in a file to check; expected {}{hint}", KNOWN.join(", "));
                self.problems.push(problem(&node.place, message));
            }
        }
    }

    fn parameters(&mut self, node: Node) {
        if let Value::Table(members) = node.value {
            members.into_iter().for_each(|member| self.parameter(member));
        }
    }

    /// A parameter by its text, which is judged with the model.
    fn parameter(&mut self, Named { name, node }: Named) {
        let text = match &node.value {
            Value::Number(text) | Value::Text(text) => text.clone(),
            Value::Table(members) => {
                let member = |name: &str| {
                    members.iter().find(|member| member.name == name).and_then(|member| match &member.node.value {
                        Value::Number(text) | Value::Text(text) => Some(text.clone()),
                        _ => None,
                    })
                };
                let unit = member("unit").map(|unit| format!(" {unit}")).unwrap_or_default();
                member("value").map(|value| format!("{value}{unit}")).unwrap_or_default()
            }
            _ => String::new(),
        };
        self.parameters.push((node.place.to_string(), name, text));
    }

    fn matrix(&mut self, name: &str, node: &Node) {
        let Some(matrix) = matrix_of_rows(name) else {
            return self.problems.push(problem(&node.place, format!("`{name}` is no matrix")));
        };
        if self.given.matrices.iter().any(|(known, _)| *known == matrix) {
            return self.problems.push(problem(&node.place, format!("`{matrix}` is given twice")));
        }
        match rows(name, node) {
            Ok(rows) => self.given.matrices.push((matrix, rows)),
            Err(problems) => self.problems.extend(problems),
        }
    }

    fn system_matrix(&mut self, name: &str, node: &Node) {
        match (self.speed, rows(name, node)) {
            (Some(speed), Ok(rows)) => {
                self.given.system_matrices.push(SystemMatrix { speed, is_stiffness: name == "K", rows });
            }
            (_, found) => self.problems.extend(found.err().into_iter().flatten()),
        }
    }

    /// The speed of a table, or else that of the file.
    fn speed_of(&mut self, members: &[Named], what: &str, place: &Place) -> Option<f64> {
        match members.iter().find(|member| member.name == "speed" || member.name == "v") {
            Some(member) => speed(&member.node).map_err(|problem| self.problems.push(problem)).ok(),
            None => self.speed_or_problem(what, place),
        }
    }

    fn speed_or_problem(&mut self, what: &str, place: &Place) -> Option<f64> {
        if self.speed.is_none() {
            self.problems.push(problem(place, format!("`{what}` has no speed; expected `speed` in m/s beside it")));
        }
        self.speed
    }

    /// `A = [[…], …]` beside a speed, or a table with both, or several of them.
    fn state_matrices(&mut self, node: &Node) {
        match &node.value {
            Value::Table(members) => {
                let speed = self.speed_of(members, "A", &node.place);
                let is_rows = |member: &&Named| matches!(member.name.as_str(), "A" | "rows" | "matrix");
                match (speed, members.iter().find(is_rows)) {
                    (Some(speed), Some(member)) => self.state_matrix(speed, &member.node),
                    (Some(_), None) => self.problems.push(problem(&node.place, "`A` is a table without `rows`")),
                    (None, _) => {}
                }
            }
            Value::List(nodes) if nodes.iter().any(|node| matches!(node.value, Value::Table(_))) => {
                nodes.iter().for_each(|node| self.state_matrices(node));
            }
            _ => {
                if let Some(speed) = self.speed_or_problem("A", &node.place) {
                    self.state_matrix(speed, node);
                }
            }
        }
    }

    fn state_matrix(&mut self, speed: f64, node: &Node) {
        match rows("A", node) {
            Ok(rows) => self.given.state_matrices.push(StateMatrix { speed, rows }),
            Err(problems) => self.problems.extend(problems),
        }
    }

    /// A list beside a speed, `{ "5" = [ … ] }`, `{ speed = 5, values = [ … ] }`, or several of these.
    fn eigenvalues(&mut self, node: &Node) {
        match &node.value {
            Value::Table(members) if members.iter().any(|member| member.name == "values") => {
                let speed = self.speed_of(members, "eigenvalues", &node.place);
                if let (Some(speed), Some(member)) = (speed, members.iter().find(|member| member.name == "values")) {
                    self.eigenvalues_at(speed, &member.node);
                }
            }
            Value::Table(members) if members.iter().all(|member| speed_of(&member.name).is_ok()) => {
                for Named { name, node } in members {
                    if let Ok(speed) = speed_of(name) {
                        self.eigenvalues_at(speed, node);
                    }
                }
            }
            Value::List(nodes) if nodes.iter().any(|node| matches!(&node.value, Value::Table(members) if members.iter().any(|member| member.name == "values"))) => {
                nodes.iter().for_each(|node| self.eigenvalues(node));
            }
            _ => {
                if let Some(speed) = self.speed_or_problem("eigenvalues", &node.place) {
                    self.eigenvalues_at(speed, node);
                }
            }
        }
    }

    fn eigenvalues_at(&mut self, speed: f64, node: &Node) {
        match eigenvalues::values(node) {
            Ok(values) if values.is_empty() => {}
            Ok(values) => self.given.eigenvalues.push(Eigenvalues { speed, values }),
            Err(problems) => self.problems.extend(problems),
        }
    }

    /// `{ weave = 4.29, capsize = 6.02 }`, a list of speeds, or of tables with `kind` and `speed`.
    fn critical_speeds(&mut self, node: &Node) {
        match &node.value {
            Value::Table(members) => members.iter().for_each(|member| self.critical_speed(&member.name, &member.node)),
            Value::List(nodes) => {
                for node in nodes {
                    let Value::Table(members) = &node.value else {
                        self.critical_speed("critical", node);
                        continue;
                    };
                    let member = |name: &str| members.iter().find(|member| member.name == name).map(|own| &own.node);
                    match (member("kind").map(|node| &node.value), member("speed")) {
                        (Some(Value::Text(kind)), Some(speed)) => self.critical_speed(kind, speed),
                        (_, Some(speed)) => self.critical_speed("critical", speed),
                        _ => self.problems.push(problem(&node.place, "a critical speed has no `speed`")),
                    }
                }
            }
            _ => self.critical_speed("critical", node),
        }
    }

    fn critical_speed(&mut self, name: &str, node: &Node) {
        if let Value::List(nodes) = &node.value {
            return nodes.iter().for_each(|node| self.critical_speed(name, node));
        }
        let kind = match name {
            "weave" | "flutter" | "wobble" => Some(CriticalKind::Weave),
            "capsize" | "divergence" => Some(CriticalKind::Capsize),
            "double_root" | "double root" => Some(CriticalKind::DoubleRoot),
            "critical" => None,
            other => {
                let message = format!(
                    "`{other}` is no kind of critical speed; expected weave, capsize, flutter, divergence or double_root"
                );
                return self.problems.push(problem(&node.place, message));
            }
        };
        let what = format!("{} speed", name.replace('_', " "));
        match speed_reading(node, &what) {
            Ok(Some(speed)) => self.given.critical_speeds.push(CriticalSpeed { kind, name: what, speed }),
            Ok(None) => {}
            Err(problem) => self.problems.push(problem),
        }
    }
}

/// A speed with its digits: in m/s, or in another unit, which scales what a digit is worth.
fn speed_reading(node: &Node, what: &str) -> Result<Option<Reading>, Problem> {
    let Value::Text(text) = &node.value else { return reading(node, what) };
    let units = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E')).map(|at| text.split_at(at));
    let Some((digits, unit)) = units else { return reading(node, what) };
    let scale =
        speed_of(&format!("1 {unit}")).map_err(|why| problem(&node.place, format!("{what} is `{text}`: {why}")))?;
    let plain = Node { place: node.place.clone(), value: Value::Text(digits.trim().to_owned()) };
    let own = reading(&plain, what)?;
    Ok(own.map(|own| Reading {
        value: own.value * scale,
        tolerance: own.tolerance * scale,
        written: text.clone(),
        ..own
    }))
}
