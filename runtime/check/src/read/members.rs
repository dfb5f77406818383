//! The members of a file: what each is, and the matrices and parameters among them.

use carvallo_design::input::{Named, Node, Value, matrix_of_rows};
use carvallo_design::{Problem, Shipped, nearest};

use super::numbers::{problem, rows, speed};
use crate::given::{Given, SystemMatrix};

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
const KNOWN: [&str; 23] = [
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
    "feedback",
    "digits",
    "g",
    "weave_speed",
    "capsize_speed",
];

/// The matrix whose number was written as the letters that look like it: `KO`, `Cl`.
fn of_digits(name: &str) -> Option<&'static str> {
    let digits = name.replace(['O', 'o'], "0").replace(['l', 'I', 'i'], "1");
    matrix_of_rows(&digits).map(|matrix| matrix.name())
}

/// What was read so far.
#[derive(Default)]
pub struct Reader {
    pub given: Given,
    pub accelerations: Option<Node>,
    pub model: Option<String>,
    pub bicycle: Option<String>,
    pub parameters: Vec<(String, String, String)>,
    pub feedback: Vec<(String, String)>,
    pub speed: Option<f64>,
    pub digits: Option<usize>,
    pub problems: Vec<Problem>,
}

impl Reader {
    /// Reads all members of a file.
    pub fn new(members: Vec<Named>) -> Self {
        let mut reader = Self::default();
        reader.speed = reader.top_speed(&members);
        members.into_iter().for_each(|member| reader.member(member));
        reader
    }

    /// Where nothing depends on the speed any will do, and none is needed: `null`, as `analyze` writes. One that is wrong is NaN: it
    /// is told once, and not again by what is of it.
    fn top_speed(&mut self, members: &[Named]) -> Option<f64> {
        let member = |name: &str| members.iter().find(|member| member.name == name);
        let model = member("model").and_then(|own| match &own.node.value {
            Value::Text(name) => Shipped::called(name).ok(),
            _ => None,
        });
        let is_free = model.is_some_and(|model| !model.depends_on_speed());
        let own = match member("speed") {
            Some(own) if !(is_free && matches!(own.node.value, Value::Other("null"))) => own,
            _ => return is_free.then_some(0.0),
        };
        let wrong = |problem| {
            self.problems.push(problem);
            f64::NAN
        };
        Some(speed(&own.node).unwrap_or_else(wrong))
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
            ("feedback", _) => self.laws(node),
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
                let hint = of_digits(name)
                    .or_else(|| nearest(name, KNOWN))
                    .map(|known| format!("; did you mean `{known}`?"))
                    .unwrap_or_default();
                let message = format!("`{name}` is not known in a file to check; expected {}{hint}", KNOWN.join(", "));
                self.problems.push(problem(&node.place, message));
            }
        }
    }

    /// One law of feedback or a list of them, which are judged with the model.
    fn laws(&mut self, node: Node) {
        match node.value {
            Value::Text(text) => self.feedback.push((node.place.to_string(), text)),
            Value::List(nodes) => nodes.into_iter().for_each(|node| self.laws(node)),
            Value::Other("null") => {}
            _ => {
                let message =
                    "`feedback` is no law; expected a text such as \"Tdelta = -10*phi_rate\", or a list of them";
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
}
