//! Operations on bounds, rounded to a side that is known.

/// Below this the error of a product may not be a number that `f64` has.
pub const TINY: f64 = 1e-290;

/// The greatest `f64` that is known to be at most the sum.
pub fn add_down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if sum.is_infinite() {
        return if a.is_infinite() || b.is_infinite() || sum < 0.0 { sum } else { f64::MAX };
    }
    // The rounding error, exactly (Knuth).
    let shadow = sum - a;
    let error = (a - (sum - shadow)) + (b - shadow);
    if error < 0.0 { sum.next_down() } else { sum }
}

/// The greatest `f64` that is known to be at most the product; an infinite bound is no number, and zero times it zero.
pub fn mul_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let product = a * b;
    if product.is_infinite() {
        return if a.is_infinite() || b.is_infinite() || product < 0.0 { product } else { f64::MAX };
    }
    let positive = (a > 0.0) == (b > 0.0);
    if product.abs() < TINY {
        return if positive { product.next_down().max(0.0) } else { product.next_down() };
    }
    if a.mul_add(b, -product) < 0.0 { product.next_down() } else { product }
}

/// At most one divided by a positive number.
pub fn recip_down(value: f64) -> f64 {
    let quotient = value.recip();
    if quotient.mul_add(value, -1.0) > 0.0 { quotient.next_down() } else { quotient }
}

/// At least one divided by a positive number.
pub fn recip_up(value: f64) -> f64 {
    let quotient = value.recip();
    if quotient.mul_add(value, -1.0) < 0.0 { quotient.next_up() } else { quotient }
}
