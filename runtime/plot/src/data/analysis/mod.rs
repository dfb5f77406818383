//! An analysis along the speed as JSON and as comma-separated values.

mod csv;
mod json;

pub use self::csv::write_csv;
pub use self::json::write_json;
#[cfg(feature = "units")]
pub(super) use self::json::{Event, Range, events, ranges};
