//! Nonlinear motion of shipped mechanisms, against figures and dynamics from elsewhere.

mod published;
