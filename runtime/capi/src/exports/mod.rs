//! The functions of C. Each says what of its arguments may be NULL, and what its pointers must point to otherwise: that is all
//! that there is to its safety.

mod batch;
mod eigenvalues;
mod library;
mod machine;
mod stability;

pub use batch::*;
pub use eigenvalues::*;
pub use library::*;
pub use machine::*;
pub use stability::*;
