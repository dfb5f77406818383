//! Sine, cosine and tangent in single precision, without an operation in `f64` and without a library: the same to the last
//! bit on every platform, for every angle.
//!
//! The polynomials are those of the Cephes library (Moshier 1992, `sinf.c`), and quarter turns are taken off in parts (Cody &
//! Waite 1980). No multiply-add is fused, as in double precision. The C code that the compiler writes has the same steps.
//!
//! There is no table, no loop and no call: LLVM puts loops over designs into lanes around it.

use core::f32::consts::{FRAC_2_PI, FRAC_PI_4};

use crate::number::lane::Lane;

/// Adding this rounds to a whole number, whose last bits are then those of the sum.
const ROUND: f32 = 12_582_912.0; // 1.5 * 2^23

/// pi/2 in parts of 8 binary digits, which are exact times a number of quarter turns up to 2^16 (102,943 rad), and the rest.
const PARTS: [f32; 6] = [1.570_312_5, 4.577_636_7e-4, 2.598_762_5e-5, 7.543_713e-8, 6.002_665e-11, 7.443_548e-13];

/// From this angle in rad on, numbers are half a radian and more apart.
const LARGE: f32 = 4_194_304.0; // 2^22

/// Sine and cosine of an angle in rad; not a number, if the angle is not finite.
///
/// Up to 1e5 rad they differ from the exact ones by less than one unit in the last place: by 0.85, of all
/// numbers up to there. Beyond, they are those of an angle that differs by less than one unit in the last place of the angle;
/// and beyond 2^22 rad, where these units are half a radian and more, those of zero.
// Where LLVM has AVX-512 it would gather the parameters of such a loop, which takes three times as long as one design after the
// other; it does not around a call.
#[cfg_attr(target_feature = "avx512f", inline(never))]
#[cfg_attr(not(target_feature = "avx512f"), inline(always))]
pub(crate) fn sin_cos(angle: f32) -> (f32, f32) {
    let sum = |Sum { high, low }: Sum<f32>| high + low;
    let (sin, cos, rest, quarters) = unrounded(angle);
    // Once more: without quarter turns, one design after the other then takes no further instruction.
    if angle.abs() <= FRAC_PI_4 {
        return (sum(sin), sum(cos));
    }
    let (sin, cos) = moved(sin, cos, rest);
    let (sin, cos) = (sum(sin), sum(cos));
    let (s, c) = if quarters & 1 != 0 { (cos, sin) } else { (sin, cos) };
    let signed = |x: f32, quarters: u32| f32::from_bits(x.to_bits() ^ (quarters & 2) << 30);
    (signed(s, quarters), signed(c, quarters.wrapping_add(1)))
}

/// The tangent of an angle in rad: up to 1e5 rad to within 1.2 units in the last place, beyond as sine and cosine.
#[inline]
pub(crate) fn tan(angle: f32) -> f32 {
    let (sin, cos, rest, quarters) = unrounded(angle);
    let (sin, cos) = moved(sin, cos, rest);
    let (sin, cos) = (sin.normalized(), cos.normalized());
    let (s, c) = if quarters & 1 != 0 { (cos.negative(), sin) } else { (sin, cos) };
    let quotient = s.high / c.high;
    // What the rounded quotient leaves of the sine, by products of halves that are exact.
    let (q, d) = (Sum::halves(quotient), Sum::halves(c.high));
    let rest = ((s.high - q.high * d.high) - (q.high * d.low + q.low * d.high)) - q.low * d.low;
    quotient + ((rest + s.low) - quotient * c.low) / c.high
}

/// Sine and cosine of angles in rad, each as it is alone.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn sin_cos_of_lanes<T: Lane>(angle: T) -> (T, T) {
    let sum = |Sum { high, low }: Sum<T>| high + low;
    let is_near = angle.abs().less_or_equal(angle.like(FRAC_PI_4.into()));
    if T::all(is_near) {
        let (sin, cos) = near_zero(angle);
        return (sum(sin), sum(cos));
    }
    let (x, rounded) = reduced(angle);
    // An angle that is near is as it is, without a quarter turn, even where rounding would take one off.
    let high = T::select(is_near, angle, x.high);
    let low = T::select(is_near, angle.like(0.0), x.low);
    let (sin, cos) = near_zero(high);
    let (sin, cos) = moved(sin, cos, low);
    let (sin, cos) = (sum(sin), sum(cos));
    let [odd, half] = [0, 1].map(|digit| rounded.bit(digit) & !is_near);
    let (s, c) = (T::select(odd, cos, sin), T::select(odd, sin, cos));
    (T::select(half, -s, s), T::select(odd ^ half, -c, c))
}

/// A number in two parts, the second of which is small beside the first.
#[derive(Clone, Copy)]
struct Sum<T> {
    high: T,
    low: T,
}

impl<T: Lane> Sum<T> {
    /// The same with as much as possible in the first part.
    #[inline(always)]
    fn normalized(self) -> Self {
        let high = self.high + self.low;
        Self { high, low: (self.high - high) + self.low }
    }
}

impl Sum<f32> {
    /// A number in two halves of 12 digits, whose products are exact (Veltkamp 1968).
    #[inline(always)]
    fn halves(x: f32) -> Self {
        let large = x * 4097.0;
        let high = large - (large - x);
        Self { high, low: x - high }
    }

    #[inline(always)]
    fn negative(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

/// Sine and cosine, before their last addition, of an angle less a number of quarter turns and a small rest; the rest, and the
/// last digits of the number.
#[inline(always)]
fn unrounded(angle: f32) -> (Sum<f32>, Sum<f32>, f32, u32) {
    let (x, quarters) = if angle.abs() <= FRAC_PI_4 {
        (Sum { high: angle, low: 0.0 }, 0)
    } else {
        let (x, rounded) = reduced(angle);
        (x, rounded.to_bits())
    };
    let (sin, cos) = near_zero(x.high);
    (sin, cos, x.low, quarters)
}

/// Those of an angle between -pi/4 and pi/4.
#[inline(always)]
fn near_zero<T: Lane>(x: T) -> (Sum<T>, Sum<T>) {
    let number = |value: f32| x.like(value.into());
    let z = x * x;
    let s = number(-0.166_666_55) + z * (number(0.008_332_161) + z * number(-0.000_195_152_96));
    let c = number(0.041_666_646) + z * (number(-0.001_388_731_6) + z * number(2.443_315_7e-5));
    let half_square = number(0.5) * z;
    let one = number(1.0);
    let most = one - half_square;
    (Sum { high: x, low: (x * z) * s }, Sum { high: most, low: ((one - most) - half_square) + z * z * c })
}

/// Those of an angle that is larger by a small rest.
#[inline(always)]
fn moved<T: Lane>(sin: Sum<T>, cos: Sum<T>, rest: T) -> (Sum<T>, Sum<T>) {
    (Sum { low: sin.low + rest * cos.high, ..sin }, Sum { low: cos.low - rest * sin.high, ..cos })
}

/// An angle less the nearest multiple of pi/2, and a number whose last two digits are those of the number of quarter turns.
#[inline(always)]
fn reduced<T: Lane>(angle: T) -> (Sum<T>, T) {
    let number = |value: f32| angle.like(value.into());
    // What is not finite becomes not a number.
    let angle = T::select(angle.abs().less(number(LARGE)), angle, angle * number(0.0));
    let rounded = angle * number(FRAC_2_PI) + number(ROUND);
    let quarters = rounded - number(ROUND);
    let [first, second, third, fourth, fifth, sixth] = PARTS.map(|part| quarters * number(part));
    // The first three differences are exact; of the others the rounding is kept.
    let rest = ((angle - first) - second) - third;
    let middle = rest - fourth;
    let high = middle - fifth;
    let low = (((rest - middle) - fourth) + ((middle - high) - fifth)) - sixth;
    (Sum { high, low }.normalized(), rounded)
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::{sin_cos, tan};

    /// The last place of the `f32` nearest to a number.
    fn unit(x: f64) -> f64 {
        let nearest = (x as f32).abs();
        f64::from(f32::from_bits(nearest.to_bits() + 1)) - f64::from(nearest)
    }

    /// Numbers from one to another, one of so many.
    fn numbers(from: f32, to: f32, step: usize) -> impl Iterator<Item = f32> {
        (from.to_bits()..to.to_bits()).step_by(step).map(f32::from_bits)
    }

    /// Against the platform's in double precision. The bounds hold for every number, which takes minutes: all were tried.
    #[test]
    fn up_to_the_limit_the_last_place_is_right() {
        for x in numbers(1e-3, 1e5, 1009) {
            let (sin, cos) = f64::from(x).sin_cos();
            let found = sin_cos(x);
            for (name, found, exact, bound) in
                [("sin", found.0, sin, 0.85), ("cos", found.1, cos, 0.85), ("tan", tan(x), sin / cos, 1.2)]
            {
                let error = (f64::from(found) - exact).abs() / unit(exact);
                assert!(error < bound, "{name} {x}: {error}");
            }
        }
    }

    #[test]
    fn beyond_it_is_that_of_an_angle_that_is_as_near_as_the_next() {
        for x in numbers(1e5, 1e7, 1009) {
            let (sin, cos) = sin_cos(x);
            // The nearest angle with both.
            let wrapped = f64::from(x).rem_euclid(std::f64::consts::TAU);
            let found = f64::from(sin).atan2(f64::from(cos)).rem_euclid(std::f64::consts::TAU);
            let apart = (wrapped - found).abs().min(std::f64::consts::TAU - (wrapped - found).abs());
            if x < super::LARGE {
                assert!(apart < 0.51 * unit(x.into()), "{x}: {apart}");
                // Of an angle that may be by half a place beyond where the polynomials are at their best.
                let square = sin * sin + cos * cos;
                assert!((square - 1.0).abs() < 2e-5, "{x}: {square}");
            } else {
                assert_eq!((sin, cos), (0.0, 1.0), "{x}");
            }
        }
        assert_eq!(sin_cos(f32::MAX), (0.0, 1.0));
        for x in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
            let (sin, cos) = sin_cos(x);
            assert!(sin.is_nan() && cos.is_nan() && tan(x).is_nan());
        }
    }

    #[test]
    fn both_directions_are_mirrored() {
        for x in numbers(1e-6, 1e7, 10_007).chain([f32::MIN_POSITIVE, 1e-40]) {
            let ((sin, cos), (minus, same)) = (sin_cos(x), sin_cos(-x));
            assert_eq!((minus, same, tan(-x)), (-sin, cos, -tan(x)), "{x}");
        }
    }
}
