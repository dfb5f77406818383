//! What the coordinates of given matrices are: a list of names, or of tables with a name and of what `only` is a state.

use carvallo::States;

use crate::failure::Place;
use crate::input::document::Document;
use crate::input::tables::{Named, Node, Value};
use crate::matrices::Coordinate;

const EXPECTED: &str = "expected a list of names, or of tables such as { name = \"y\", only = \"rate\" }";
const ONLY: &str = "expected \"rate\", \"position\" or \"both\"";

/// The coordinates of so many rows, which are called `q1`, `q2` and so on unless a file says otherwise.
pub fn of(document: &mut Document, written: Vec<Named>, count: usize) -> Vec<Coordinate> {
    let mut written = written.into_iter();
    let (first, second) = (written.next(), written.next());
    if let Some(Named { name, node }) = second {
        document.problem(node.place, format!("`{name}` is given twice"));
    }
    let usual = || (1..=count).map(|index| Coordinate { name: format!("q{index}"), states: States::Both }).collect();
    let Some(Named { name, node: Node { place, value } }) = first else { return usual() };
    let before = document.problems.len();
    let coordinates = Reader { document, key: &name }.coordinates(&place, value);
    let found = coordinates.len();
    let is_readable = document.problems.len() == before;
    if is_readable && found != count {
        let names = if found == 1 { "name" } else { "names" };
        let message = format!("`{name}` has {found} {names}; expected {count}, one for each row of `M`");
        document.problem(place, message);
    }
    if is_readable && found == count { coordinates } else { usual() }
}

/// Reads the coordinates, and tells what is wrong with them.
struct Reader<'a> {
    document: &'a mut Document,
    /// What they are called in the file.
    key: &'a str,
}

impl Reader<'_> {
    fn coordinates(&mut self, place: &Place, value: Value) -> Vec<Coordinate> {
        let coordinates: Vec<(Place, Coordinate)> = match value {
            Value::List(list) => list.into_iter().filter_map(|node| self.coordinate(node)).collect(),
            Value::Table(members) if members.iter().any(|member| member.name == "names") => self.table(members),
            // By name what is a state of each.
            Value::Table(members) => members.into_iter().filter_map(|member| self.member(member)).collect(),
            _ => {
                self.problem(place, format!("`{}` cannot be read; {EXPECTED}", self.key));
                Vec::new()
            }
        };
        for (index, (place, Coordinate { name, .. })) in coordinates.iter().enumerate() {
            if coordinates[..index].iter().any(|(_, other)| other.name == *name) {
                self.problem(place, format!("two of the `{}` are called `{name}`", self.key));
            }
        }
        coordinates.into_iter().map(|(_, coordinate)| coordinate).collect()
    }

    /// `"y"`, or `{ name = "y", only = "rate" }`.
    fn coordinate(&mut self, Node { place, value }: Node) -> Option<(Place, Coordinate)> {
        match value {
            Value::Text(name) => self.named(place, &name, States::Both),
            Value::Table(members) => {
                let (mut name, mut states) = (None, Some(States::Both));
                for Named { name: member, node } in members {
                    match (member.as_str(), node.value) {
                        ("name", Value::Text(text)) => name = Some(text),
                        ("only", value) => states = self.states(&node.place, &value),
                        _ => self.problem(
                            &node.place,
                            format!("`{member}` is not known of a coordinate; expected `name` and `only`"),
                        ),
                    }
                }
                match name {
                    Some(name) => self.named(place, &name, states?),
                    None => {
                        self.problem(&place, "a coordinate has no `name`".to_owned());
                        None
                    }
                }
            }
            _ => {
                self.problem(&place, format!("a coordinate has no name; {EXPECTED}"));
                None
            }
        }
    }

    /// `{ names = ["y", "phi"], only = { y = "rate" } }`.
    fn table(&mut self, members: Vec<Named>) -> Vec<(Place, Coordinate)> {
        let (mut coordinates, mut only) = (Vec::new(), Vec::new());
        for Named { name, node: Node { place, value } } in members {
            match (name.as_str(), value) {
                ("names", Value::List(list)) => {
                    coordinates = list.into_iter().filter_map(|node| self.coordinate(node)).collect();
                }
                ("only", Value::Table(members)) => only = members,
                _ => self
                    .problem(&place, format!("`{name}` cannot be read; expected `names`, a list, and `only`, a table")),
            }
        }
        for Named { name, node } in only {
            let states = self.states(&node.place, &node.value);
            match (coordinates.iter_mut().find(|(_, coordinate)| coordinate.name == name), states) {
                (Some((_, coordinate)), Some(states)) => coordinate.states = states,
                (None, _) => self.problem(&node.place, format!("none of the `names` is `{name}`")),
                _ => {}
            }
        }
        coordinates
    }

    /// `y = "rate"`, or `y = { only = "rate" }`.
    fn member(&mut self, Named { name, node: Node { place, value } }: Named) -> Option<(Place, Coordinate)> {
        let states = match value {
            Value::Table(members) if members.is_empty() => States::Both,
            Value::Table(mut members) if members.len() == 1 && members[0].name == "only" => {
                let Node { place, value } = members.remove(0).node;
                self.states(&place, &value)?
            }
            value => self.states(&place, &value)?,
        };
        self.named(place, &name, states)
    }

    fn named(&mut self, place: Place, name: &str, states: States) -> Option<(Place, Coordinate)> {
        let name = name.trim();
        if name.is_empty() {
            self.problem(&place, "the name of a coordinate is empty".to_owned());
            return None;
        }
        Some((place, Coordinate { name: name.to_owned(), states }))
    }

    fn states(&mut self, place: &Place, value: &Value) -> Option<States> {
        let text = match value {
            Value::Text(text) => text.trim(),
            _ => "",
        };
        match text {
            "rate" => Some(States::Rate),
            "position" => Some(States::Position),
            "both" => Some(States::Both),
            _ => {
                let found = if text.is_empty() { "no such word".to_owned() } else { format!("`{text}`") };
                self.problem(place, format!("what is `only` a state is {found}; {ONLY}"));
                None
            }
        }
    }

    fn problem(&mut self, place: &Place, message: String) {
        self.document.problem(place.clone(), message);
    }
}
