//! A motion as JSON and as comma-separated values.

mod csv;
#[cfg(feature = "units")]
mod json;
#[cfg(feature = "units")]
mod shown;

pub use self::csv::write_csv;
#[cfg(feature = "units")]
pub use self::csv::write_csv_in;
#[cfg(feature = "units")]
pub use self::json::write_json;
