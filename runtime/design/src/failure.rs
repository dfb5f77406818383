//! Why there is no result.

use std::borrow::Cow;
use std::fmt;

/// Why there is no result.
#[derive(Debug)]
pub enum Failure {
    /// What the user asked for, or a file, is wrong; everything that is wrong at once.
    Input(Vec<Problem>),
    /// The analysis has no answer, or a file cannot be read or written.
    Run(String),
}

impl Failure {
    /// A single problem with what was asked for.
    pub fn usage(message: impl Into<String>) -> Self {
        Self::at(Place::Nowhere, message)
    }

    /// A single problem at a place.
    pub fn at(place: Place, message: impl Into<String>) -> Self {
        Self::Input(vec![Problem { place, message: message.into() }])
    }
}

/// So many problems are told; who has more has another kind of file, or one mistake many times.
const MOST: usize = if cfg!(feature = "full") { 50 } else { usize::MAX };

/// Of a message longer than this the middle is left out.
const LONGEST: usize = 4000;

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Run(message) => f.write_str(message),
            Self::Input(problems) => match problems.as_slice() {
                [problem] => problem.fmt(f),
                problems => {
                    write!(f, "{} problems", problems.len())?;
                    problems.iter().take(MOST).try_for_each(|problem| write!(f, "\n{problem}"))?;
                    match problems.len().saturating_sub(MOST) {
                        0 => Ok(()),
                        others => write!(f, "\n… and {others} more"),
                    }
                }
            },
        }
    }
}

/// One thing that is wrong, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where it is.
    pub place: Place,
    /// What is there, and what was expected.
    pub message: String,
}

/// Where something is wrong, in the order in which problems are told.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// The message says it.
    Nowhere,
    /// An option of the command line, as it was given.
    Option(String),
    /// A file and a line in it.
    Line(String, usize),
    /// A file as a whole.
    File(String),
}

impl std::error::Error for Failure {}

impl std::error::Error for Problem {}

impl Place {
    /// The file that it is in, or the place itself.
    pub fn file(&self) -> &str {
        match self {
            Self::Nowhere => "",
            Self::Option(label) | Self::Line(label, _) | Self::File(label) => label,
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Place::Nowhere => f.write_str(&shortened(&self.message)),
            place => write!(f, "{place}: {}", shortened(&self.message)),
        }
    }
}

/// No more of a message than who reads it can use: a value in it may be as long as a file.
fn shortened(message: &str) -> Cow<'_, str> {
    if !cfg!(feature = "full") || message.len() <= LONGEST {
        return Cow::Borrowed(message);
    }
    let [from, to] = [LONGEST / 2, message.len() - LONGEST / 2].map(|at| message.floor_char_boundary(at));
    Cow::Owned(format!("{} … {}", &message[..from], &message[to..]))
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nowhere => Ok(()),
            Self::Option(label) | Self::File(label) => f.write_str(label),
            Self::Line(label, line) => write!(f, "{label}:{line}"),
        }
    }
}
