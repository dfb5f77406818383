#![doc = include_str!("../README.md")]

mod double;
mod formulas;
mod list;
mod places;
mod slip;
mod text;
mod token;
mod units;
mod words;

pub use double::DoubleSlip;
pub use formulas::{Change, Formula, Formulas, Subject, Values};
pub use list::FormulaSlip;
pub use places::{entry_name, index, indices, place};
pub use slip::{Kind, Slip};
pub use text::slips;
pub use words::{double_words, slip_words};
