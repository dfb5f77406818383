//! Nonlinear motion of mechanisms: what a model has whose declaration says `nonlinear;`.
//!
//! The equations are those of the same bodies, joints and wheels as the matrices, and exact. They are written in
//! **positions**, one for each joint, of which the heights of the wheels determine some, and in **speeds**, which are
//! the rates of those positions whose rates rolling leaves free. [`MotionInfo`] tells which is which.
//!
//! Of a machine on wheels the first two positions are the place x, y on the ground where its first wheel touches it, along
//! the axes of the ground: x forward at the start, y to the right, z down. Then come yaw, lean and pitch, in this order
//! each turned by those before it, then the joints, and the angles of the wheels. An angle is positive about its axis, so
//! a wheel that rolls forward turns at a negative rate.
//!
//! Where the declaration says `derivatives;` as well, the equations can be had to first order about any state: see
//! [`Linearizable`].

mod close;
mod error;
mod info;
mod linearization;
mod none;
mod traits;
mod vector;

pub use close::close;
pub use error::MotionError;
pub use info::{AppliedInfo, MotionInfo, PositionInfo, PositionKind, WheelInfo};
pub use linearization::{Linearizable, Linearization, UncheckedPartials};
pub use none::NoMotion;
pub use traits::{Energy, Motion, Unchecked};
pub use vector::Vector;
