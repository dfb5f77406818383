//! The ways in which steady turns are printed.

mod csv;
mod json;
mod table;

pub use self::csv::write_csv;
pub use self::json::write_json;
pub use self::table::render_table;
