//! Time, in turns.

mod contest;
mod tasks;

pub use contest::{Contender, Task, Time};
pub use tasks::{batch, one_by_one};
