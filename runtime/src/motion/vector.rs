//! Arrays of one length for each model.

use core::fmt::Debug;

/// An array whose length belongs to a type: `[T; N]`.
pub trait Vector<T>: Copy + Debug + AsRef<[T]> + AsMut<[T]> {
    /// The array whose elements follow from their positions.
    #[must_use]
    fn from_fn(element: impl FnMut(usize) -> T) -> Self;
}

impl<T: Copy + Debug, const N: usize> Vector<T> for [T; N] {
    #[inline]
    fn from_fn(element: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(element)
    }
}
