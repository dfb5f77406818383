//! What a comparison found.

mod limits;
mod text;

use carvallo::ModelInfo;
use serde::Serialize;

use crate::accuracy::Accuracy;
use crate::explain::Explanation;
use crate::number::Operations;
use crate::reference::ReferenceKind;
use crate::time::Time;

pub use limits::Limits;

/// What a comparison found: data, which reads as text by [`Display`](std::fmt::Display) and as [JSON](Report::to_json).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The model; in JSON its name.
    #[serde(serialize_with = "name_of")]
    pub model: &'static ModelInfo,
    /// The names of its parameters, in the order of those of designs.
    pub parameters: Vec<&'static str>,
    /// What exact entries come from.
    pub reference: ReferenceKind,
    /// How many designs were compared.
    pub designs: usize,
    /// The seed of the random designs; nothing where designs were given.
    pub seed: Option<u64>,
    /// The generated code, and then what it was compared with.
    pub sides: Vec<SideReport>,
    /// What was timed, if it was asked for.
    pub times: Vec<TaskReport>,
    /// Whether the program was compiled with optimization: without it times mean nothing.
    pub optimized: bool,
}

/// What was found of a side.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SideReport {
    /// Its name.
    pub name: String,
    /// Its operations; nothing if it has no function that counts.
    pub operations: Option<Operations>,
    /// Its errors in `f64`.
    pub double: Accuracy,
    /// Its errors in `f32`, if it has a function in it.
    pub single: Option<Accuracy>,
    /// What explains its differences.
    pub explanations: Vec<Explanation>,
    /// The entries that differ and that nothing explains.
    pub unexplained: Vec<String>,
    /// What explains its differences in `f32`, as that function may be another one.
    pub explanations_in_single: Vec<Explanation>,
    /// The entries that differ in `f32` and that nothing explains.
    pub unexplained_in_single: Vec<String>,
}

/// What a task took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TaskReport {
    /// What was computed.
    pub task: String,
    /// What each took: for one design, in ns.
    pub times: Vec<Time>,
}

impl From<(String, Vec<Time>)> for TaskReport {
    fn from((task, times): (String, Vec<Time>)) -> Self {
        Self { task, times }
    }
}

fn name_of<S: serde::Serializer>(model: &&'static ModelInfo, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(model.name)
}

impl Report {
    /// As JSON, indented, with the members of these structs. What is no finite number is `null`.
    #[must_use]
    pub fn to_json(&self) -> String {
        // Strings, numbers and lists of them can all be written.
        serde_json::to_string_pretty(self).expect("values that JSON has")
    }
}
