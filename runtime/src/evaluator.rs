//! The program of a model over any kind of number.

use crate::Number;

/// The parameters of a model over one kind of number, and the program that makes its matrices of them.
///
/// The macro `model!` implements it beside [`Model`](crate::Model), for all kinds of numbers at once; functions over many
/// designs run it in lanes.
pub trait Evaluator<T: Number, const N: usize>: Copy {
    /// An array of T.
    type Entries: Copy + AsRef<[T]>;

    /// The parameters, each by its position in declared order.
    fn from_parameters(parameter: impl FnMut(usize) -> T) -> Self;

    /// The entries of the matrices that differ, in the order of [`ModelInfo::entries`](crate::ModelInfo::entries).
    fn entries(&self) -> Self::Entries;

    /// The rows of M, C0, C1, Kc, K0 and K2.
    fn rows(&self) -> [[[T; N]; N]; 6];
}
