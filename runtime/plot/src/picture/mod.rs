//! Pictures, as SVG or PNG from one drawing.

mod along;
mod axes;
mod bars;
mod beyond;
mod colors;
mod contributions;
mod critical;
mod curves;
mod eigenvalues;
mod font;
mod graph;
mod labels;
mod map;
mod marks;
mod motion;
mod overlay;
mod panels;
mod path;
mod places;
#[cfg(feature = "png")]
mod png;
mod scene;
mod series;
mod side_view;
mod side_views;
mod speed;
mod svg;
mod tornado;
#[cfg(feature = "turns")]
mod turns;

#[cfg(test)]
mod tests;

pub use self::along::draw_along;
pub use self::contributions::draw_contributions;
pub use self::curves::{Curve, extent, samples};
pub use self::map::{MapAxis, MapCell, draw_map};
pub use self::motion::draw_motion;
pub use self::overlay::draw_overlay;
pub use self::panels::{Panel, panels};
pub use self::scene::{Color, Paint, Scene};
pub use self::series::Series;
pub use self::side_view::draw_side_view;
pub use self::side_views::draw_side_views;
pub use self::speed::{Limits, draw_eigenvalues};
pub use self::tornado::draw_tornado;
#[cfg(feature = "turns")]
pub use self::turns::draw_turns;
