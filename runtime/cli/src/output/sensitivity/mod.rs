//! How critical speeds change with the parameters, for people.

mod deviations;
mod table;

pub use self::deviations::{contributions, matrices_with_deviations, with_deviation};
pub use self::table::{RANKING, RANKING_MORE, notes, ranking, render_table};
