//! State spaces as files for NumPy and MATLAB.
//!
//! Both have the matrices `A`, `B`, `C` and `D`, the forward `speed` where the equations depend on it, and the names and units of
//! what their rows and columns are: `states`, `inputs`, `outputs`, `state_units`, `input_units`, `output_units`.
//!
//! ```python
//! file = numpy.load("bicycle.npz")
//! system = control.ss(file["A"], file["B"], file["C"], file["D"])
//! ```
//!
//! ```matlab
//! load bicycle.mat
//! system = ss(A, B, C, D, 'StateName', states, 'InputName', inputs, 'OutputName', outputs);
//! ```

mod mat;
mod npy;
mod zip;

use std::io::{Result, Write};

use nalgebra::DMatrix;

use crate::signal::Signal;
use crate::state_space::StateSpace;

/// What a variable is.
enum Value {
    Matrix(DMatrix<f64>),
    Number(f64),
    Texts(Vec<String>),
}

/// What is in a file, in its order.
fn variables(space: &StateSpace) -> Vec<(&'static str, Value)> {
    let matrix = |matrix: &DMatrix<f64>| Value::Matrix(matrix.clone());
    let texts =
        |signals: &[Signal], text: fn(&Signal) -> &String| Value::Texts(signals.iter().map(text).cloned().collect());
    let mut variables =
        vec![("A", matrix(&space.a)), ("B", matrix(&space.b)), ("C", matrix(&space.c)), ("D", matrix(&space.d))];
    variables.extend(space.shown_speed().map(|speed| ("speed", Value::Number(speed))));
    if !space.speed_unit.is_declared() {
        variables.push(("speed_unit", Value::Texts(vec![space.speed_unit.written.clone()])));
    }
    for (names, units, signals) in [
        ("states", "state_units", &space.states),
        ("inputs", "input_units", &space.inputs),
        ("outputs", "output_units", &space.outputs),
    ] {
        variables.push((names, texts(signals, |signal| &signal.name)));
        variables.push((units, texts(signals, |signal| &signal.unit)));
    }
    variables
}

/// Writes an archive of NumPy, which `numpy.load` reads.
///
/// # Errors
/// If it cannot be written.
pub fn write_npz(space: &StateSpace, output: &mut dyn Write) -> Result<()> {
    let files = variables(space).into_iter().map(|(name, value)| (format!("{name}.npy"), npy::array(&value)));
    output.write_all(&zip::archive(&files.collect::<Vec<_>>()))
}

/// Writes a file of MATLAB, of level 5, which `load` reads there, and `scipy.io.loadmat` and Octave.
///
/// # Errors
/// If it cannot be written.
pub fn write_mat(space: &StateSpace, output: &mut dyn Write) -> Result<()> {
    output.write_all(&mat::file(&variables(space)))
}
