//! The shifts of a sweep of the QR algorithm: two numbers close to eigenvalues, real or conjugate.

use crate::number::Number;
use crate::numeric::Square;

/// Two shifts: the eigenvalues of a matrix with the diagonal x, y and the product w of the other entries.
#[derive(Clone, Copy)]
pub(super) struct Shifts {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) w: f64,
}

/// The most rows of a block whose characteristic polynomial is used; none on a web page, which loads the faster.
const MOST: usize = if cfg!(target_family = "wasm") { 0 } else { 12 };

impl Shifts {
    /// The eigenvalues of the last block of two rows; if they are real, twice the one that is closer to the last entry.
    #[inline]
    pub(super) fn usual(h: &Square<f64>, last: usize) -> Self {
        let (x, y) = (h[last][last], h[last - 1][last - 1]);
        let w = h[last][last - 1] * h[last - 1][last];
        let half = 0.5 * (y - x);
        let discriminant = half * half + w;
        if discriminant < 0.0 {
            return Self { x, y, w };
        }
        let large = half + Number::sqrt(discriminant).copysign(half);
        let closer = x - if large == 0.0 { 0.0 } else { w / large };
        Self { x: closer, y: closer, w: 0.0 }
    }

    /// Two eigenvalues of a block, as far as its characteristic polynomial has them: a step of Bairstow's iteration takes a
    /// quarter of the time of a sweep, and shifts that err a little only take another sweep.
    pub(super) fn of_block(h: &Square<f64>, start: usize, last: usize) -> Self {
        const STEPS: usize = 12;
        const CLOSE: f64 = 1e-6;
        let usual = Self::usual(h, last);
        let degree = last + 1 - start;
        if degree > MOST {
            return usual;
        }
        let a = characteristic(h, start, degree);
        let (mut p, mut q) = (-(usual.x + usual.y), usual.x * usual.y - usual.w);
        for _ in 0..STEPS {
            // Divided by x^2 + p x + q twice.
            let [mut b1, mut b2, mut c1, mut c2, mut c3] = [0.0; 5];
            for &a in a[1..=degree].iter().rev() {
                // What comes last is what the next one waits for.
                (b1, b2) = ((a - q * b2) - p * b1, b1);
                (c1, c2, c3) = ((b1 - q * c2) - p * c1, c1, c2);
            }
            let b0 = (a[0] - q * b2) - p * b1;
            let determinant = c2 * c2 - c1 * c3;
            let (by_p, by_q) = ((b1 * c2 - b0 * c3) / determinant, (b0 * c2 - b1 * c1) / determinant);
            (p, q) = (p + by_p, q + by_q);
            let size = p.abs() + Number::sqrt(q.abs());
            // Where nothing more can be told apart: divided by zero.
            if !size.is_finite() {
                return usual;
            }
            if by_p.abs() <= CLOSE * size && by_q.abs() <= CLOSE * size * size {
                let half = -0.5 * p;
                return Self { x: half, y: half, w: half * half - q };
            }
        }
        usual
    }

    /// A pair about the last entry, as far away as the entries below the diagonal are large (Wilkinson & Reinsch 1971).
    #[cold]
    pub(super) fn exceptional(h: &Square<f64>, last: usize) -> Self {
        let size = h[last][last - 1].abs() + h[last - 1][last - 2].abs();
        let x = 0.75 * size + h[last][last];
        Self { x, y: x, w: -0.4375 * size * size }
    }
}

/// The coefficients of the characteristic polynomial of a block, ascending.
fn characteristic(h: &Square<f64>, start: usize, degree: usize) -> [f64; MOST + 1] {
    // Those of its leading blocks, all but the last, which is one.
    let mut leading = [[0.0; MOST + 1]; MOST + 1];
    for k in 0..degree {
        let (before, next) = leading.split_at_mut(k + 1);
        let [next, ..] = next else { break };
        next[1..k + 1].copy_from_slice(&before[k][..k]);
        let mut below = 1.0;
        for i in (0..=k).rev() {
            let row = &h[start + i][start..];
            let factor = below * row[k];
            for (next, of) in next[..i].iter_mut().zip(&before[i]) {
                *next -= factor * of;
            }
            next[i] -= factor;
            if i > 0 {
                below *= row[i - 1];
            }
        }
    }
    leading[degree][degree] = 1.0;
    leading[degree]
}
