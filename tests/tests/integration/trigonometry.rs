//! Sine and cosine of the runtime against arithmetic at 320 bits.

use carvallo::{Number, Scalar};
use carvallo_compare::Real;

/// The distance from the exact value in units of the last place of a number type with that epsilon.
fn error(computed: f64, exact: Real, epsilon: f64) -> f64 {
    let size = exact.abs().to_f64();
    let unit = epsilon * 2f64.powf(size.log2().floor());
    let difference = (Real::from(computed) - exact).abs().to_f64();
    if difference == 0.0 { 0.0 } else { difference / unit }
}

/// The largest error of sine and cosine over angles, of type T.
fn largest<T: Scalar>(angles: impl Iterator<Item = f64>, epsilon: f64) -> f64 {
    let errors = angles.map(|angle| {
        let angle = T::from_f64(angle);
        let exact = Real::from(angle.to_f64());
        let (sin, cos) = angle.sin_cos();
        assert_eq!([sin, cos], [angle.sin(), angle.cos()]);
        error(sin.to_f64(), exact.sin(), epsilon).max(error(cos.to_f64(), exact.cos(), epsilon))
    });
    errors.fold(0.0, f64::max)
}

/// Angles of every size up to a limit, of both signs, that repeat no pattern.
fn of_every_size(count: u32, limit: f64) -> impl Iterator<Item = f64> {
    let golden = 0.618_033_988_749_894_8;
    (1..=count).map(move |i| {
        let fraction = (f64::from(i) * golden).fract();
        let size = limit * 2f64.powf(-30.0 * (f64::from(i) / f64::from(count)));
        if i % 2 == 0 { size * fraction } else { -size * fraction }
    })
}

/// The numbers nearest to multiples of a quarter of pi, where one of the two is next to zero, and their neighbours.
fn near_quarters(most: u32) -> impl Iterator<Item = f64> {
    (0..most).flat_map(|i| {
        let nearest = f64::from(i) * std::f64::consts::FRAC_PI_4;
        [nearest, nearest.next_up(), nearest.next_down(), -nearest]
    })
}

#[test]
fn sine_and_cosine_are_within_one_unit_in_the_last_place() {
    let most = [
        largest::<f64>(of_every_size(4000, 1.6), f64::EPSILON),
        largest::<f64>(of_every_size(2000, 1e5), f64::EPSILON),
        largest::<f64>(near_quarters(500), f64::EPSILON),
        largest::<f32>(of_every_size(4000, 1e5), f32::EPSILON.into()),
        largest::<f32>(near_quarters(500), f32::EPSILON.into()),
    ];
    assert!(most.iter().all(|error| *error < 1.0), "{most:?}");
}

#[test]
fn angles_beyond_the_limit_are_those_of_the_platform() {
    for angle in [1.000_001e5, -3e7, 1e22, 1e300] {
        assert_eq!(Number::sin_cos(angle), f64::sin_cos(angle));
    }
    for angle in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sin, cos) = Number::sin_cos(angle);
        assert!(sin.is_nan() && cos.is_nan());
        let (sin, cos) = Number::sin_cos(angle as f32);
        assert!(sin.is_nan() && cos.is_nan());
    }
    assert_eq!(Number::sin_cos(0.0), (0.0, 1.0));
    assert!(Number::sin(-0.0_f64).is_sign_negative());
}
