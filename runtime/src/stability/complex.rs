//! Eigenvalues for serde, as the JSON of the command line has them.

use nalgebra::Complex;
use serde::{Deserialize, Serialize};

/// `{"re": -0.5, "im": 2.0}`, of which only the functions are used that serde makes.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Complex<f64>", deny_unknown_fields)]
pub struct Parts {
    re: f64,
    im: f64,
}
