//! A question: an object of JSON, read as parameter files are.

use carvallo_design::Failure;
use carvallo_design::input::{Named, Value, read_raw};

/// The members of an object, by their names. What is asked for leaves it.
pub struct Question(Vec<Named>);

impl Question {
    /// Reads the bytes of an object.
    ///
    /// # Errors
    /// If they are none.
    pub fn read(bytes: &[u8]) -> Result<Self, Failure> {
        Ok(Self(read_raw("question.json", bytes.to_vec())?.members))
    }

    fn take(&mut self, name: &str) -> Option<Value> {
        let place = self.0.iter().position(|named| named.name == name)?;
        Some(self.0.swap_remove(place).node.value)
    }

    /// A text, if there is one.
    ///
    /// # Errors
    /// If it is something else.
    pub fn text(&mut self, name: &str) -> Result<Option<String>, Failure> {
        self.take(name).map(|value| text(name, value)).transpose()
    }

    /// A number, if there is one.
    ///
    /// # Errors
    /// If it is something else.
    pub fn number(&mut self, name: &str) -> Result<Option<f64>, Failure> {
        let number = |value| match value {
            Value::Number(digits) => digits.parse().map_err(|_| wrong(name, "a number")),
            _ => Err(wrong(name, "a number")),
        };
        self.take(name).map(number).transpose()
    }

    /// A list of texts, if there is one.
    ///
    /// # Errors
    /// If it is something else.
    pub fn texts(&mut self, name: &str) -> Result<Option<Vec<String>>, Failure> {
        self.take(name).map(|value| texts(name, value)).transpose()
    }

    /// A list of lists of texts; nothing in the place of none.
    ///
    /// # Errors
    /// If it is something else.
    pub fn lists(&mut self, name: &str) -> Result<Vec<Vec<String>>, Failure> {
        match self.take(name) {
            None => Ok(Vec::new()),
            Some(Value::List(nodes)) => nodes.into_iter().map(|node| texts(name, node.value)).collect(),
            Some(_) => Err(wrong(name, "a list of lists")),
        }
    }

    /// An object in it, if there is one.
    ///
    /// # Errors
    /// If it is something else.
    pub fn object(&mut self, name: &str) -> Result<Option<Self>, Failure> {
        let object = |value| match value {
            Value::Table(members) => Ok(Self(members)),
            _ => Err(wrong(name, "an object")),
        };
        self.take(name).map(object).transpose()
    }
}

fn texts(name: &str, value: Value) -> Result<Vec<String>, Failure> {
    match value {
        Value::List(nodes) => nodes.into_iter().map(|node| text(name, node.value)).collect(),
        _ => Err(wrong(name, "a list of texts")),
    }
}

fn text(name: &str, value: Value) -> Result<String, Failure> {
    match value {
        Value::Text(text) => Ok(text),
        _ => Err(wrong(name, "a text")),
    }
}

fn wrong(name: &str, expected: &str) -> Failure {
    Failure::usage(format!("`{name}` of the question is not {expected}"))
}

/// What is missing in a question.
pub fn missing(name: &str) -> Failure {
    Failure::usage(format!("the question has no `{name}`"))
}
