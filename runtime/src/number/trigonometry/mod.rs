//! Sine, cosine and tangent of our own, so that they are the same to the last bit on every platform.

pub(crate) mod double;
pub(crate) mod single;
