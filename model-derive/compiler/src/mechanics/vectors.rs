//! Vectors of formulas in the axes of the model.

use crate::symbolic::Form;

pub type Vector = [Form; 3];

/// What the axes are called in names of definitions.
pub const AXES: [char; 3] = ['x', 'y', 'z'];

/// The axes in the order in which they follow each other, beginning with each.
const CYCLE: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

pub fn zero() -> Vector {
    [(); 3].map(|()| Form::number(0))
}

pub fn add(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis| &a[axis] + &b[axis])
}

pub fn subtract(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis| &a[axis] - &b[axis])
}

pub fn scale(factor: &Form, a: &Vector) -> Vector {
    a.each_ref().map(|component| factor * component)
}

pub fn dot(a: &Vector, b: &Vector) -> Form {
    let [x, y, z] = [0, 1, 2].map(|axis| &a[axis] * &b[axis]);
    &(&x + &y) + &z
}

pub fn cross(a: &Vector, b: &Vector) -> Vector {
    CYCLE.map(|[_, next, last]| &(&a[next] * &b[last]) - &(&a[last] * &b[next]))
}

/// Each component in its shortest form.
pub fn tidy(a: &Vector) -> Vector {
    a.each_ref().map(Form::simplest)
}
