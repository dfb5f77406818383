//! Sine and cosine, the same to the last bit alone and in lanes.
//!
//! The angle less the nearest multiple of pi/2 goes into two polynomials. Polynomials and the parts of pi/2 are those of
//! fdlibm (Sun Microsystems 1993, `k_sin.c`, `k_cos.c`, `e_rem_pio2.c`). No multiply-add is fused: not every processor
//! has it, and results would depend on it.

use crate::number::lane::Lane;

/// Up to this angle in rad the number of quarter turns times the first parts of pi/2 has no rounding error.
const LIMIT: f64 = 1e5;

/// Adding this rounds to a whole number, whose last bits are then those of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52

const TWO_OVER_PI: f64 = core::f64::consts::FRAC_2_PI;

/// pi/2 in parts of 33 bits, and the rest.
const PARTS: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// A quarter of pi: angles up to here are as they are.
const QUARTER: f64 = core::f64::consts::FRAC_PI_4;

/// Sine and cosine of an angle in rad.
#[inline(always)]
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    // With no quarter turn to take off the general way gives the same.
    if angle.abs() <= QUARTER { kernel(angle, 0.0) } else { reduced(angle) }
}

#[inline(never)]
fn reduced(angle: f64) -> (f64, f64) {
    if angle.abs() <= LIMIT { within_limit(angle) } else { far(angle) }
}

/// Sine and cosine of angles in rad.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn sin_cos_of_lanes<T: Lane>(angle: T) -> (T, T) {
    if T::all(angle.abs().less_or_equal(angle.like(QUARTER))) {
        return kernel(angle, angle.like(0.0));
    }
    let (sin, cos) = within_limit(angle);
    let is_near = angle.abs().less_or_equal(angle.like(LIMIT));
    if T::all(is_near) {
        return (sin, cos);
    }
    (T::select(is_near, sin, angle.map(|angle| far(angle).0)), T::select(is_near, cos, angle.map(|angle| far(angle).1)))
}

#[inline(always)]
fn within_limit<T: Lane>(angle: T) -> (T, T) {
    let rounded = angle * angle.like(TWO_OVER_PI) + angle.like(ROUND);
    let quarters = rounded - angle.like(ROUND);
    let [first, second, third] = PARTS.map(|part| quarters * angle.like(part));
    // The first difference is exact; of the second the rounding is kept.
    let rest = angle - first;
    let high = rest - second;
    let low = ((rest - high) - second) - third;
    let near = high + low;
    let (sin, cos) = kernel(near, (high - near) + low);
    let (odd, half) = (rounded.bit(0), rounded.bit(1));
    let (sin, cos) = (T::select(odd, cos, sin), T::select(odd, sin, cos));
    (T::select(half, -sin, sin), T::select(odd ^ half, -cos, cos))
}

/// Sine and cosine of `x + y` between -pi/4 and pi/4, where y is the rounding of x.
#[inline(always)]
fn kernel<T: Lane>(x: T, y: T) -> (T, T) {
    let c = |value: f64| x.like(value);
    let z = x * x;
    let w = z * z;
    let half = c(0.5);

    let s = (c(0.008_333_333_333_322_49) + z * (c(-0.000_198_412_698_298_579_5) + z * c(2.755_731_370_707_006_8e-6)))
        + z * w * (c(-2.505_076_025_340_686_3e-8) + z * c(1.589_690_995_211_55e-10));
    let v = z * x;
    let sin = x - ((z * (half * y - v * s) - y) + v * c(0.166_666_666_666_666_32));

    let r = z * (c(0.041_666_666_666_666_6) + z * (c(-0.001_388_888_888_887_411) + z * c(2.480_158_728_947_673e-5)))
        + w * w
            * (c(-2.755_731_435_139_066_3e-7)
                + z * (c(2.087_572_321_298_175e-9) + z * c(-1.135_964_755_778_819_5e-11)));
    let one = c(1.0);
    let half_square = half * z;
    let most = one - half_square;
    let cos = most + (((one - most) - half_square) + (z * r - x * y));
    (sin, cos)
}

/// Where the multiple of pi/2 is not exact, and of what is no number.
#[cold]
fn far(angle: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return angle.sin_cos();
    #[cfg(not(feature = "std"))]
    libm::sincos(angle)
}
