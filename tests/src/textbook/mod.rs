//! Mechanisms whose linearized equations are in books and papers, each a function from its parameters to its matrices.
//!
//! Nothing here comes out of the compiler's mechanics: every formula is written by hand, from a source that its file
//! names, and says whether the source was at hand or the formula was found anew and how it was checked then. Axes,
//! signs and the form of the equations are those of the rest of the project, x forward, y to the right, z down:
//!
//! ```text
//! M q'' + (C0 + v C1) q' + (Kc + g K0 + v^2 K2) q = f
//! ```

pub mod disc;
pub mod pendulum;
pub mod rider;
pub mod skateboard;
pub mod tyres;
