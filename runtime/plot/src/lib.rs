//! Analyses of designs, as data and as pictures: what the command line prints and draws, for every program.
//!
//! A [`Design`](carvallo_design::Design) comes from a file, or from what ships; [`analysis`] computes what is shown of it,
//! [`data`] writes that as JSON and CSV, and [`picture`] draws it.
//!
//! | of | computed by | data | picture |
//! | --- | --- | --- | --- |
//! | a design along the speed | [`Analysis`](analysis::Analysis) | [`data::analysis`] | [`draw_eigenvalues`](picture::draw_eigenvalues) |
//! | along a parameter | [`AlongAnalysis`](analysis::along::AlongAnalysis) | [`data::along`] | [`draw_along`](picture::draw_along) |
//! | its sensitivities | [`Changes`](analysis::sensitivity::Changes) | [`data::sensitivity`] | [`draw_tornado`](picture::draw_tornado) |
//! | several of them beside each other | [`Comparison`](analysis::compare::Comparison) | [`data::compare`] | [`draw_overlay`](picture::draw_overlay), [`draw_side_views`](picture::draw_side_views), [`draw_contributions`](picture::draw_contributions) |
//! | its motion in time | [`Linear`](analysis::simulation::Linear), [`Nonlinear`](analysis::simulation::Nonlinear) | [`data::motion`] | [`draw_motion`](picture::draw_motion) |
//! | its steady turns | [`Families`](analysis::turns::Families) | [`data::turns`] | [`draw_turns`](picture::draw_turns) |
//! | its transfer functions | [`Transfers`](analysis::transfer::Transfers) | [`data::transfer`] | [`draw_bode`](picture::draw_bode), [`draw_nyquist`](picture::draw_nyquist) |
//! | its responses in time | [`Responses`](analysis::response::Responses) | [`data::response`] | [`draw_response`](picture::draw_response) |
//! | what excites and shows its modes | [`Controllability`](analysis::controllability::Controllability) | [`data::controllability`] | [`draw_controllability`](picture::draw_controllability) |
//! | many designs | | | [`draw_map`](picture::draw_map) |
//! | the design itself | | [`data::matrices`] | [`draw_side_view`](picture::draw_side_view) |
//!
//! A picture is a [`Scene`](picture::Scene), from which [`svg`](picture::Scene::svg) makes a text and, with the feature `png`,
//! `png` the bytes of a file. What goes wrong is a [`Failure`](carvallo_design::Failure), which displays as the command line
//! tells it.
//!
//! The eigenvalues of the benchmark bicycle (Meijaard, Papadopoulos, Ruina & Schwab 2007, figure 4):
//!
//! ```
//! use carvallo_design::input::{self, Request};
//! use carvallo_plot::analysis::Analysis;
//! use carvallo_plot::picture::{Limits, draw_eigenvalues};
//!
//! let benchmark = Analysis::new(input::load(&Request::default())?)?;
//! let picture = draw_eigenvalues(&benchmark, Limits { x: (0.0, 10.0), y: None })?;
//! let svg = picture.svg();
//! assert!(svg.contains("<title>Eigenvalues of benchmark against forward speed</title>"));
//! # Ok::<(), carvallo_design::Failure>(())
//! ```

pub mod analysis;
pub mod data;
pub mod picture;
