#![doc = include_str!("../README.md")]

mod accuracy;
mod assembly;
mod comparison;
mod designs;
mod executed;
mod explain;
mod macros;
mod number;
mod reference;
mod report;
mod side;
mod time;

pub use accuracy::{Accuracy, Worst};
pub use assembly::{Assembly, AssemblyError, Listing};
pub use comparison::Comparison;
pub use designs::Design;
pub use executed::{Executed, Instructions, NotCounted};
pub use explain::Explanation;
pub use number::{Counted, Exact, Operations, Real, count};
pub use reference::ReferenceKind;
pub use report::{Limits, Report, SideReport, TaskReport};
pub use time::{Contender, Task, Time};
