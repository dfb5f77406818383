//! A coin that rolls, for Python.

use pyo3::prelude::*;

carvallo::model! {
    /// A coin that rolls: it stays up while it is fast.
    pub model Coin {
        parameters { r: m, > 0; m: kg, > 0; g: N/kg, >= 0, gravity; }
        mechanism {
            wheel D: mass m, at (0, 0, -r), radius r, axial m*r^2/2, radial m*r^2/4;
            free D: lean phi, yaw psi;
        }
        coordinates { phi "lean": rad; psi "yaw": rad; }
        set euro { r = 11.625 mm; m = 7.5 g; g = 9.81; }
    }
}

#[pymodule]
fn _coin(module: &Bound<'_, PyModule>) -> PyResult<()> {
    carvallo_python::add_model::<2, Coin>(module)
}
