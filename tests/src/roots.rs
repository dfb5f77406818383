//! Roots of quartics at 320 bits.

use std::ops::{Add, Div, Mul, Sub};

use carvallo_compare::Real;

/// A complex number with 320 bits in each part.
#[derive(Clone, Copy, Debug)]
pub struct Complex {
    /// Real part.
    pub re: Real,
    /// Imaginary part.
    pub im: Real,
}

impl Complex {
    pub(crate) fn norm_sqr(self) -> Real {
        self.re * self.re + self.im * self.im
    }

    /// Rounded to `f64`.
    pub fn to_f64(self) -> nalgebra::Complex<f64> {
        nalgebra::Complex::new(self.re.to_f64(), self.im.to_f64())
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let norm = other.norm_sqr();
        let quotient = self * Self { re: other.re, im: -other.im };
        Self { re: quotient.re / norm, im: quotient.im / norm }
    }
}

/// The four roots of a quartic, by the simultaneous iteration of Aberth (1973) and Ehrlich (1967).
///
/// It starts on a circle, from no one's eigenvalues. At simple roots it converges cubically to 96 digits; at multiple
/// ones linearly, which the bound on the steps allows for: a double root is then good to some 40 digits.
pub fn roots([a4, a3, a2, a1, a0]: [Real; 5]) -> [Complex; 4] {
    let complex = |re| Complex { re, im: Real::from(0.0) };
    let (value, slope) = ([a4, a3, a2, a1, a0].map(complex), [(4.0, a4), (3.0, a3), (2.0, a2), (1.0, a1)]);
    let slope = slope.map(|(power, coefficient)| complex(Real::from(power) * coefficient));
    let horner = |coefficients: &[Complex], s| {
        coefficients[1..].iter().fold(coefficients[0], |value, &coefficient| value * s + coefficient)
    };
    let one = complex(Real::from(1.0));
    // Half the bound of Fujiwara (1916) on the magnitude of every root.
    let radius =
        [a3, a2, a1, a0].into_iter().zip(1..).map(|(a, power)| (a / a4).abs().to_f64().powf(1.0 / f64::from(power)));
    let radius = radius.fold(0.0, f64::max);
    let mut roots: [Complex; 4] = std::array::from_fn(|k| {
        let (sin, cos) = (0.4 + std::f64::consts::FRAC_PI_2 * k as f64).sin_cos();
        Complex { re: Real::from(radius * cos), im: Real::from(radius * sin) }
    });
    let small = Real::from(radius * 2f64.powi(-290));
    for _ in 0..400 {
        let mut largest_step = Real::from(0.0);
        for k in 0..4 {
            let root = roots[k];
            let at_root = horner(&value, root);
            if at_root.norm_sqr() == Real::from(0.0) {
                continue;
            }
            let newton = horner(&slope, root) / at_root;
            let repulsion = (0..4).filter(|&other| other != k).map(|other| one / (root - roots[other]));
            let step = one / repulsion.fold(newton, |sum, term| sum - term);
            roots[k] = root - step;
            largest_step = if step.norm_sqr() > largest_step { step.norm_sqr() } else { largest_step };
        }
        if largest_step <= small * small {
            break;
        }
    }
    roots
}

/// How many roots are what: what changes at critical speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Real roots.
    pub real: usize,
    /// Real roots above zero.
    pub unstable_real: usize,
    /// Complex roots with a positive real part, two of them for each pair.
    pub unstable_complex: usize,
}

impl Signature {
    /// Of a polynomial; its roots must be farther from zero, the imaginary axis and each other than 30 digits tell.
    pub fn of(polynomial: [Real; 5]) -> Self {
        let roots = roots(polynomial).map(|root| {
            let negligible = Real::from(2f64.powi(-100)) * (root.re.abs() + root.im.abs());
            (root.im.abs() <= negligible, root.re > Real::from(0.0))
        });
        let count = |real, unstable| roots.iter().filter(|root| **root == (real, unstable)).count();
        Self {
            real: count(true, true) + count(true, false),
            unstable_real: count(true, true),
            unstable_complex: count(false, true),
        }
    }

    /// Whether no root has a positive real part.
    pub fn is_stable(self) -> bool {
        self.unstable_real + self.unstable_complex == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_a_known_quartic() {
        // (s - 1) (s + 2) (s^2 + 2 s + 10)
        let roots = roots([1.0, 3.0, 10.0, 6.0, -20.0].map(Real::from));
        let mut found = roots.map(|root| root.to_f64());
        found.sort_by(|a, b| (a.re, a.im).partial_cmp(&(b.re, b.im)).unwrap());
        let expected = [(-2.0, 0.0), (-1.0, -3.0), (-1.0, 3.0), (1.0, 0.0)];
        for (found, (re, im)) in found.iter().zip(expected) {
            assert!((found - nalgebra::Complex::new(re, im)).norm() < 1e-80, "{found}");
        }
    }

    #[test]
    fn a_signature_counts_each_kind() {
        // (s^2 - 4) (s^2 + 2 s + 10)
        let signature = Signature::of([1.0, 2.0, 6.0, -8.0, -40.0].map(Real::from));
        assert_eq!(signature, Signature { real: 2, unstable_real: 1, unstable_complex: 0 });
        assert!(!signature.is_stable());
    }
}
