//! The functions of expressions, under the names that Python, NumPy, MATLAB and C have for them.

use std::f64::consts::PI;

/// Of one argument; angles are in radians.
pub fn of_one(name: &str) -> Option<fn(f64) -> f64> {
    Some(match name {
        "sin" => f64::sin,
        "cos" => f64::cos,
        "tan" => f64::tan,
        "asin" | "arcsin" => f64::asin,
        "acos" | "arccos" => f64::acos,
        "atan" | "arctan" => f64::atan,
        "sqrt" => f64::sqrt,
        "exp" => f64::exp,
        "abs" | "fabs" => f64::abs,
        "radians" | "deg2rad" => |degrees| degrees * PI / 180.0,
        "degrees" | "rad2deg" => |radians| radians * 180.0 / PI,
        _ => return None,
    })
}

/// Of two arguments.
pub fn of_two(name: &str) -> Option<fn(f64, f64) -> f64> {
    Some(match name {
        "atan2" | "arctan2" => f64::atan2,
        "hypot" => f64::hypot,
        "pow" | "power" => f64::powf,
        _ => return None,
    })
}

/// A name without the module that Python finds it in: `sqrt` for `math.sqrt`.
pub fn without_module(name: &str) -> &str {
    ["math.", "np.", "numpy."].iter().find_map(|module| name.strip_prefix(module)).unwrap_or(name)
}
