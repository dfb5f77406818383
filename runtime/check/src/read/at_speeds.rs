//! What is of a speed, or is one: state matrices, eigenvalues, critical speeds.

use carvallo::CriticalKind;
use carvallo_design::input::{Named, Node, Value};
use carvallo_design::{Place, Problem};

use super::eigenvalues;
use super::members::Reader;
use super::numbers::{problem, reading, rows, speed, speed_of};
use crate::given::{CriticalSpeed, Eigenvalues, Reading, Rows, StateMatrix};

/// Whether there are numbers, and all of them are 0.
fn is_zero(rows: &Rows) -> bool {
    let mut numbers = rows.iter().flatten().flatten().peekable();
    numbers.peek().is_some() && numbers.all(|reading| reading.value == 0.0)
}

impl Reader {
    /// The speed of a table, or else that of the file.
    fn speed_of(&mut self, members: &[Named], what: &str, place: &Place) -> Option<f64> {
        match members.iter().find(|member| member.name == "speed" || member.name == "v") {
            Some(member) if !matches!(member.node.value, Value::Other("null")) => {
                speed(&member.node).map_err(|problem| self.problems.push(problem)).ok()
            }
            _ => self.speed_or_problem(what, place),
        }
    }

    fn speed_or_problem(&mut self, what: &str, place: &Place) -> Option<f64> {
        if self.speed.is_none() {
            self.problems.push(problem(place, format!("`{what}` has no speed; expected `speed` in m/s beside it")));
        }
        self.speed
    }

    /// `A = [[…], …]` beside a speed, or a table with both, or several of them.
    pub fn state_matrices(&mut self, node: &Node) {
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
            Ok(rows) if is_zero(&rows) => {
                let why =
                    "`A` has no entry but 0; a state matrix has ones, by which the rates are those of the coordinates";
                self.problems.push(problem(&node.place, why));
            }
            Ok(rows) => self.given.state_matrices.push(StateMatrix { speed, rows }),
            Err(problems) => self.problems.extend(problems),
        }
    }

    /// A list beside a speed, `{ "5" = [ … ] }`, `{ speed = 5, values = [ … ] }`, or several of these.
    pub fn eigenvalues(&mut self, node: &Node) {
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
            Ok((values, unknown)) => {
                self.given.unknown.extend((0..unknown).map(|_| format!("an eigenvalue at {speed} m/s")));
                if !values.is_empty() {
                    self.given.eigenvalues.push(Eigenvalues { speed, values });
                }
            }
            Err(problems) => self.problems.extend(problems),
        }
    }

    /// `{ weave = 4.29, capsize = 6.02 }`, a list of speeds, or of tables with `kind` and `speed`.
    pub fn critical_speeds(&mut self, node: &Node) {
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

    pub fn critical_speed(&mut self, name: &str, node: &Node) {
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
            Ok(Some(speed)) if speed.value < 0.0 => {
                let message = format!("{what} is {}; it must be >= 0", speed.written);
                self.problems.push(problem(&node.place, message));
            }
            Ok(Some(speed)) => self.given.critical_speeds.push(CriticalSpeed { kind, name: what, speed }),
            Ok(None) => self.given.unknown.push(what),
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
