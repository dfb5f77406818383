//! One of the sides that are compared: a function from parameters to matrices, in one number type or several.

use std::hint::black_box;

use carvallo::{Coefficients, Evaluator, MatrixName, Model, Scalar};

use crate::number::{Counted, Operations, count};

/// A function of parameters.
type Function<R> = Box<dyn Fn(&[f64]) -> R>;
/// A function of designs that makes what can be run again and again.
type Runs = Box<dyn Fn(&[Vec<f64>]) -> Box<dyn FnMut()>>;

/// A side, for models of any number of coordinates.
pub struct Side {
    pub name: String,
    pub double: Code,
    pub single: Option<Code>,
    /// What it does at parameters.
    pub operations: Option<Function<Operations>>,
}

/// A function in one number type.
pub struct Code {
    /// The entries of all matrices at parameters.
    pub entries: Function<Vec<f64>>,
    /// A loop over designs, which is to be run again and again.
    pub each: Runs,
    /// Where its code begins: that of the function alone, inlined into nothing.
    pub address: usize,
}

impl Code {
    /// A function of parameters that `design` makes of numbers.
    pub fn new<const N: usize, T: Scalar, D: 'static, O: Into<Coefficients<T, N>> + 'static>(
        design: fn(&[f64]) -> D,
        function: impl Fn(&D) -> O + Copy + 'static,
    ) -> Self {
        Self {
            entries: Box::new(move |parameters| entries(&function(&design(parameters)).into())),
            each: Box::new(move |designs| {
                let designs: Vec<D> = designs.iter().map(|parameters| design(parameters)).collect();
                // Once before, so that the memory of the results is there.
                let mut results: Vec<O> = designs.iter().map(function).collect();
                Box::new(move || each(black_box(&designs), black_box(&mut results), function))
            }),
            address: address(function),
        }
    }
}

/// A loop that is compiled by itself, and in which the function is called at one place: so a compiler that inlines it here
/// does so for every side.
#[inline(never)]
fn each<D, O>(designs: &[D], results: &mut [O], function: impl Fn(&D) -> O) {
    for (result, design) in results.iter_mut().zip(designs) {
        *result = function(design);
    }
}

/// The function by itself.
#[inline(never)]
fn alone<D, O, F: Fn(&D) -> O>(function: F, design: &D) -> O {
    function(design)
}

fn address<D, O, F: Fn(&D) -> O>(_: F) -> usize {
    let alone: fn(F, &D) -> O = alone;
    alone as usize
}

/// The entries of all matrices, matrix by matrix and row by row.
fn entries<const N: usize, T: Scalar>(coefficients: &Coefficients<T, N>) -> Vec<f64> {
    let rows = MatrixName::ALL.into_iter().flat_map(|name| (0..N).map(move |row| (name, row)));
    rows.flat_map(|(name, row)| (0..N).map(move |column| coefficients.matrix(name)[(row, column)].to_f64())).collect()
}

/// The design with these parameters.
pub fn design<const N: usize, M: Model<N, Scalar = f64>>(parameters: &[f64]) -> M {
    M::from_slice(parameters).expect("a value for every parameter")
}

/// The same in single precision.
pub fn single<const N: usize, M: Model<N, Scalar = f64>>(parameters: &[f64]) -> M::Over<f32> {
    M::Over::from_parameters(|position| parameters[position] as f32)
}

/// What a function does at a design.
pub fn counted<const N: usize, M: Model<N, Scalar = f64>, O>(
    function: impl Fn(&M::Over<Counted>) -> O + 'static,
) -> Function<Operations> {
    Box::new(move |parameters| {
        let design = M::Over::from_parameters(|position| Counted(parameters[position]));
        count(|| function(&design)).1
    })
}
