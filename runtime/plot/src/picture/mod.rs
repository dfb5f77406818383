//! Pictures, as SVG or PNG from one drawing.

mod along;
mod axes;
mod bars;
mod beyond;
#[cfg(feature = "control")]
mod bode;
mod colors;
#[cfg(feature = "units")]
mod contributions;
#[cfg(feature = "control")]
mod controllability;
mod critical;
mod curves;
mod eigenvalues;
mod font;
#[cfg(feature = "units")]
mod graph;
mod labels;
#[cfg(feature = "control")]
mod locus;
mod map;
mod marks;
#[cfg(feature = "units")]
mod motion;
#[cfg(feature = "control")]
mod nyquist;
#[cfg(feature = "units")]
mod overlay;
mod panels;
#[cfg(feature = "units")]
mod path;
mod phasors;
mod places;
#[cfg(feature = "png")]
mod png;
mod replaced;
#[cfg(feature = "control")]
mod response;
#[cfg(feature = "control")]
mod scales;
mod scene;
mod series;
#[cfg(feature = "units")]
mod side_view;
#[cfg(feature = "units")]
mod side_views;
#[cfg(feature = "control")]
mod sigma;
mod speed;
mod svg;
mod tornado;
#[cfg(feature = "turns")]
mod turns;

#[cfg(test)]
mod tests;

pub use self::along::draw_along;
#[cfg(feature = "control")]
pub use self::bode::draw_bode;
#[cfg(feature = "units")]
pub use self::contributions::draw_contributions;
#[cfg(feature = "control")]
pub use self::controllability::draw_controllability;
pub use self::curves::{Curve, extent, samples};
#[cfg(feature = "control")]
pub use self::locus::draw_locus;
pub use self::map::{MOST_CELLS, MapAxis, MapCell, draw_map};
#[cfg(feature = "units")]
pub use self::motion::draw_motion;
#[cfg(feature = "control")]
pub use self::nyquist::draw_nyquist;
#[cfg(feature = "units")]
pub use self::overlay::draw_overlay;
pub use self::panels::{Panel, panels};
pub use self::phasors::{MOST_SPEEDS, draw_phasors};
pub use self::replaced::may_be_replaced;
#[cfg(feature = "control")]
pub use self::response::draw_response;
pub use self::scene::{Color, Paint, Scene};
pub use self::series::Series;
#[cfg(feature = "units")]
pub use self::side_view::draw_side_view;
#[cfg(feature = "units")]
pub use self::side_views::draw_side_views;
#[cfg(feature = "control")]
pub use self::sigma::draw_sigma;
pub use self::speed::{Limits, draw_eigenvalues};
pub use self::tornado::draw_tornado;
#[cfg(feature = "turns")]
pub use self::turns::draw_turns;

/// What a picture of transfer functions is called.
#[cfg(feature = "control")]
fn transfer_title(what: &str, transfers: &crate::analysis::transfer::Transfers) -> String {
    let speed = transfers.space.speed_text().map(|speed| format!(" at {speed}"));
    format!("{what} of {}{}", transfers.design.title(), speed.unwrap_or_default())
}
