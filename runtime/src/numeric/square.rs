//! Square matrices of a size that is known only when the program runs.

use core::ops::{Index, IndexMut};

/// A matrix of n x n numbers: `matrix[row][column]`.
///
/// What is computed for any number of coordinates is in these, so that it is compiled once, and not for each number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Square<T> {
    size: usize,
    /// Row by row.
    entries: Vec<T>,
}

impl<T: Copy> Square<T> {
    pub(crate) fn from_fn(size: usize, mut entry: impl FnMut(usize, usize) -> T) -> Self {
        let mut entries = Vec::with_capacity(size * size);
        for row in 0..size {
            entries.extend((0..size).map(|column| entry(row, column)));
        }
        Self { size, entries }
    }

    pub(crate) fn filled(size: usize, entry: T) -> Self {
        Self { size, entries: vec![entry; size * size] }
    }

    /// From the entries column by column, as nalgebra has them.
    pub(crate) fn from_columns(size: usize, entries: &[T]) -> Self {
        Self::from_fn(size, |row, column| entries[row + size * column])
    }

    #[inline]
    pub(crate) fn size(&self) -> usize {
        self.size
    }

    /// All entries, row by row.
    #[inline]
    pub(crate) fn entries(&self) -> &[T] {
        &self.entries
    }

    #[inline]
    pub(crate) fn entries_mut(&mut self) -> &mut [T] {
        &mut self.entries
    }

    pub(crate) fn rows(&self) -> impl DoubleEndedIterator<Item = &[T]> {
        self.entries.chunks_exact(self.size.max(1))
    }

    #[inline]
    pub(crate) fn rows_mut(&mut self) -> impl DoubleEndedIterator<Item = &mut [T]> {
        self.entries.chunks_exact_mut(self.size.max(1))
    }

    /// The rows from one on to before another.
    #[inline]
    pub(crate) fn rows_between_mut(&mut self, from: usize, to: usize) -> impl Iterator<Item = &mut [T]> {
        let size = self.size;
        self.entries[from * size..to * size].chunks_exact_mut(size.max(1))
    }

    pub(crate) fn column(&self, column: usize) -> impl Iterator<Item = T> {
        self.entries.iter().skip(column).step_by(self.size.max(1)).copied()
    }

    pub(crate) fn swap_rows(&mut self, a: usize, b: usize) {
        if a != b {
            let (a, b) = (a.min(b), a.max(b));
            let (above, below) = self.entries.split_at_mut(b * self.size);
            above[a * self.size..(a + 1) * self.size].swap_with_slice(&mut below[..self.size]);
        }
    }

    pub(crate) fn map<U>(&self, of: impl FnMut(T) -> U) -> Square<U> {
        Square { size: self.size, entries: self.entries.iter().copied().map(of).collect() }
    }
}

impl<T> Index<usize> for Square<T> {
    type Output = [T];

    #[inline]
    fn index(&self, row: usize) -> &[T] {
        &self.entries[row * self.size..(row + 1) * self.size]
    }
}

impl<T> IndexMut<usize> for Square<T> {
    #[inline]
    fn index_mut(&mut self, row: usize) -> &mut [T] {
        &mut self.entries[row * self.size..(row + 1) * self.size]
    }
}

/// The entries, row by row.
impl<T> AsMut<[T]> for Square<T> {
    fn as_mut(&mut self) -> &mut [T] {
        &mut self.entries
    }
}
