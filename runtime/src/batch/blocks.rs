//! Numbers of many designs, laid out for lanes.

#[cfg(feature = "rayon")]
use rayon::prelude::*;

use super::{BatchError, InLanes};
use crate::model::Model;

/// Some numbers for each of many designs, such as its parameters or the entries of its matrices: a structure of arrays in
/// blocks of as many designs as the widest registers hold: eight in `f64`, sixteen in `f32`.
///
/// A block holds the first number of its designs, then their second numbers, and so on. So lanes are loaded as they
/// lie, the last one as fast as the first, and memory is read in one stream. Columns, one for each parameter, take up to twice as
/// long in the cache, and from memory between as long and a fifth longer. Blocks begin at multiples of 64 bytes.
#[derive(Clone, Debug)]
pub struct Blocks<T = f64> {
    numbers: Vec<T>,
    /// Where the first block begins.
    start: usize,
    width: usize,
    len: usize,
}

impl<T: InLanes> Blocks<T> {
    /// The number of designs in a block.
    pub const SIDE: usize = super::side::<T>();

    /// For `len` designs `width` numbers each, all of them zero.
    #[must_use]
    pub fn zeros(width: usize, len: usize) -> Self {
        let size = len.div_ceil(Self::SIDE) * Self::SIDE * width;
        let numbers = vec![T::from_f64(0.0); size + Self::SIDE - 1];
        // A vector of another address than expected costs time, not correctness.
        let start = numbers.as_ptr().align_offset(64).min(Self::SIDE - 1);
        Self { numbers, start, width, len }
    }

    /// The parameters of designs.
    #[must_use]
    pub fn of_designs<const N: usize, M: Model<N, Scalar = T>>(designs: &[M]) -> Self {
        let mut blocks = Self::zeros(M::INFO.parameters.len(), designs.len());
        for (index, design) in designs.iter().enumerate() {
            for (position, number) in design.parameters().as_ref().iter().enumerate() {
                blocks.set(index, position, *number);
            }
        }
        blocks
    }

    /// Room for the entries of the matrices of `len` designs, in the order of
    /// [`ModelInfo::entries`](crate::ModelInfo::entries).
    #[must_use]
    pub fn for_entries<const N: usize, M: Model<N, Scalar = T>>(len: usize) -> Self {
        Self::zeros(M::INFO.entries.len(), len)
    }

    /// Columns of equal length, one for each number of a design.
    ///
    /// # Errors
    /// If their lengths differ.
    pub fn from_columns(columns: &[&[T]]) -> Result<Self, BatchError> {
        let len = columns.first().map_or(0, |column| column.len());
        if let Some((position, column)) = columns.iter().enumerate().find(|(_, column)| column.len() != len) {
            return Err(BatchError::Length { what: "column", position, expected: len, found: column.len() });
        }
        let mut blocks = Self::zeros(columns.len(), len);
        for (position, column) in columns.iter().enumerate() {
            for (index, number) in column.iter().enumerate() {
                blocks.set(index, position, *number);
            }
        }
        Ok(blocks)
    }

    /// The number of designs.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no design.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// How many numbers each design has.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// A number of a design.
    ///
    /// # Panics
    /// If there is no such design or number.
    #[must_use]
    pub fn get(&self, design: usize, position: usize) -> T {
        self.numbers[self.place(design, position)]
    }

    /// Replaces a number of a design.
    ///
    /// # Panics
    /// If there is no such design or number.
    pub fn set(&mut self, design: usize, position: usize, number: T) {
        let place = self.place(design, position);
        self.numbers[place] = number;
    }

    /// The numbers at a position, of one design after the other.
    ///
    /// # Panics
    /// If there is no such position.
    pub fn column(&self, position: usize) -> impl ExactSizeIterator<Item = T> + '_ {
        assert!(position < self.width, "there is no number {position}: each design has {}", self.width);
        (0..self.len).map(move |design| self.get(design, position))
    }

    /// All blocks, also of the designs that fill up the last one.
    pub(super) fn numbers(&self) -> &[T] {
        &self.numbers[self.start..][..self.size()]
    }

    /// All blocks, also of the designs that fill up the last one.
    pub(super) fn numbers_mut(&mut self) -> &mut [T] {
        let size = self.size();
        &mut self.numbers[self.start..][..size]
    }

    /// So many designs after so many, a multiple of those in a block, for one core after the other.
    #[cfg(feature = "rayon")]
    pub(super) fn parts(&self, designs: usize) -> impl IndexedParallelIterator<Item = &[T]> {
        self.numbers().par_chunks((self.width * designs).max(1))
    }

    /// So many designs after so many, a multiple of those in a block, for one core after the other.
    #[cfg(feature = "rayon")]
    pub(super) fn parts_mut(&mut self, designs: usize) -> impl IndexedParallelIterator<Item = &mut [T]> {
        let numbers = (self.width * designs).max(1);
        self.numbers_mut().par_chunks_mut(numbers)
    }

    fn size(&self) -> usize {
        self.len.div_ceil(Self::SIDE) * Self::SIDE * self.width
    }

    fn place(&self, design: usize, position: usize) -> usize {
        let Self { start, width, len, .. } = *self;
        assert!(design < len && position < width, "there is no number {position} of design {design}: {len} of {width}");
        start + (design / Self::SIDE * width + position) * Self::SIDE + design % Self::SIDE
    }
}

/// Equal if the designs have the same numbers, whatever fills up the last block.
impl<T: InLanes> PartialEq for Blocks<T> {
    fn eq(&self, other: &Self) -> bool {
        self.width == other.width
            && self.len == other.len
            && (0..self.width).all(|position| self.column(position).eq(other.column(position)))
    }
}
