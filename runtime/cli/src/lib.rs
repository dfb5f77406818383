//! What the command line reads, and what it says of it: the part that strangers' files reach.

pub mod failure;
pub mod input;
pub mod model;
pub mod number;
