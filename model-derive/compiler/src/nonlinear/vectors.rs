//! Vectors and symmetric tensors of quantities.

use super::quantity::Quantity;

pub type Vector<'a> = [Quantity<'a>; 3];
/// By rows.
pub type Tensor<'a> = [Vector<'a>; 3];

pub fn add<'a>(a: Vector<'a>, b: Vector<'a>) -> Vector<'a> {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

pub fn subtract<'a>(a: Vector<'a>, b: Vector<'a>) -> Vector<'a> {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

pub fn negative(a: Vector<'_>) -> Vector<'_> {
    a.map(|component| -component)
}

pub fn scale<'a>(factor: Quantity<'a>, a: Vector<'a>) -> Vector<'a> {
    a.map(|component| factor * component)
}

pub fn dot<'a>(a: Vector<'a>, b: Vector<'a>) -> Quantity<'a> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross<'a>(a: Vector<'a>, b: Vector<'a>) -> Vector<'a> {
    [[1, 2], [2, 0], [0, 1]].map(|[next, last]| a[next] * b[last] - a[last] * b[next])
}

/// A tensor times a vector.
pub fn times<'a>(tensor: &Tensor<'a>, vector: Vector<'a>) -> Vector<'a> {
    tensor.map(|row| dot(row, vector))
}

pub fn add_tensors<'a>(a: &Tensor<'a>, b: &Tensor<'a>) -> Tensor<'a> {
    [0, 1, 2].map(|row| add(a[row], b[row]))
}

/// The unit vector along an axis.
pub fn unit(some: Quantity<'_>, axis: usize) -> Vector<'_> {
    [0, 1, 2].map(|other| some.number(if other == axis { 1.0 } else { 0.0 }))
}

pub fn zero(some: Quantity<'_>) -> Vector<'_> {
    [some.number(0.0); 3]
}
