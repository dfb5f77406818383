//! How critical speeds change with the parameters, for people.

mod deviations;
mod table;

pub use self::table::render_table;
