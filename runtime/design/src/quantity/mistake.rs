//! What is wrong with the text of a value.

/// A text that is no value, and why.
#[derive(Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The part that is wrong.
    pub text: String,
    /// Whether it is that of the standard deviation.
    pub is_deviation: bool,
    /// Why it is none.
    pub reason: Reason,
}

/// Why a text has no value, as the end of a sentence.
#[derive(Debug, PartialEq, Eq)]
pub enum Reason {
    /// What stands behind the number is no unit that it can have.
    Unit(String),
    /// Anything else.
    Other(String),
}

impl From<String> for Reason {
    fn from(reason: String) -> Self {
        Self::Other(reason)
    }
}

impl Mistake {
    /// A value that is none.
    pub fn of_value(text: &str, reason: Reason) -> Self {
        Self { text: text.to_owned(), is_deviation: false, reason }
    }

    /// A standard deviation that is none.
    pub fn of_deviation(text: &str, reason: Reason) -> Self {
        Self { text: text.to_owned(), is_deviation: true, reason }
    }
}
