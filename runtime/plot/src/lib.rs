//! Analyses of designs, as data and as pictures: what the command line prints and draws, for every program.
//!
//! A [`Design`](carvallo_design::Design) comes from a file, or from what ships; [`analysis`] computes what is shown of it,
//! [`data`] writes that as JSON and CSV, and [`picture`] draws it, as SVG and, with the feature `png`, as PNG.
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
