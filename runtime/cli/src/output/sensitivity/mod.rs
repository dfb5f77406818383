//! How critical speeds change with the parameters, for people.

mod deviations;
mod table;

pub use self::deviations::{contributions, matrices_with_deviations, with_deviation};
pub use self::table::{RANKING, notes, ranking, ranking_more, render_table};
