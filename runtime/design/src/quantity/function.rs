//! The functions of expressions, under the names that Python, NumPy, MATLAB and C have for them.

use std::f64::consts::PI;

/// A function of one number.
pub type One = fn(f64) -> f64;

/// A function of two numbers.
pub type Two = fn(f64, f64) -> f64;

/// Of one argument; angles are in radians.
pub fn of_one(name: &str) -> Option<One> {
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

/// The derivative of one of these.
pub fn slope_of_one(name: &str, at: f64) -> f64 {
    match name {
        "sin" => at.cos(),
        "cos" => -at.sin(),
        "tan" => 1.0 / at.cos().powi(2),
        "asin" | "arcsin" => 1.0 / (1.0 - at * at).sqrt(),
        "acos" | "arccos" => -1.0 / (1.0 - at * at).sqrt(),
        "atan" | "arctan" => 1.0 / (1.0 + at * at),
        "sqrt" => 0.5 / at.sqrt(),
        "exp" => at.exp(),
        "abs" | "fabs" => at.signum(),
        "radians" | "deg2rad" => PI / 180.0,
        _ => 180.0 / PI,
    }
}

/// Of two arguments.
pub fn of_two(name: &str) -> Option<Two> {
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
