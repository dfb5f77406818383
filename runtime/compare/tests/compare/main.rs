//! Comparisons of models that ship with functions by hand, right ones and wrong ones.

mod faults;
mod limits;
mod right;
