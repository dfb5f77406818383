use std::f64::consts::{FRAC_PI_2, PI};

use super::Interval;

const INFINITY: f64 = f64::INFINITY;

fn positive() -> Interval {
    Interval::open(0.0, INFINITY)
}

#[test]
fn bounds_that_are_exact_stay() {
    let [half, two] = [0.5, 2.0].map(Interval::point);
    let mass = Interval::closed(0.0, INFINITY).without_upper();
    let cases = [
        ("2 + 1/2", two.plus(half), Interval::point(2.5)),
        ("[-1, 2] * [3, 4)", Interval::closed(-1.0, 2.0).times(Interval::closed(3.0, 4.0).without_upper()), {
            Interval::closed(-4.0, 8.0)
        }),
        ("[0, inf) + (0, inf)", mass.plus(positive()), positive()),
        ("[0, inf) * (0, inf)", mass.times(positive()), mass),
        ("-(0, 1]", -Interval::closed(0.0, 1.0).without_lower(), Interval::closed(-1.0, 0.0).without_upper()),
        ("1/[2, 4)", Interval::closed(2.0, 4.0).without_upper().reciprocal(), {
            Interval::closed(0.25, 0.5).without_zero()
        }),
        ("1/(-inf, -2]", Interval::closed(-INFINITY, -2.0).without_lower().reciprocal(), {
            Interval::closed(-0.5, 0.0).without_upper().without_zero()
        }),
        ("(-2, 1]^2", Interval::closed(-2.0, 1.0).without_lower().power(2), Interval::closed(0.0, 4.0)),
        ("[-2, 1]^3", Interval::closed(-2.0, 1.0).power(3), Interval::closed(-8.0, 1.0)),
        ("sqrt [-1, 4]", Interval::closed(-1.0, 4.0).sqrt(), Interval::closed(0.0, 2.0)),
        ("sin [0, 7]", Interval::closed(0.0, 7.0).sin(), Interval::closed(-1.0, 1.0)),
        ("cos of all", Interval::ALL.cos(), Interval::closed(-1.0, 1.0)),
        ("[1, 3] and (2, 4)", Interval::closed(1.0, 3.0).intersection(Interval::open(2.0, 4.0)), {
            Interval::closed(2.0, 3.0).without_lower()
        }),
    ];
    for (name, found, expected) in cases {
        assert_eq!(found, expected, "{name}");
    }
}

/// Exact values to 20 digits: 0.1 + 0.2 = 0.30000000000000001665 in doubles, 0.1² = 0.010000000000000001110,
/// √3 = 1.7320508075688772935.
#[test]
fn bounds_that_are_rounded_move_outward() {
    let [tenth, fifth] = [0.1, 0.2].map(Interval::point);
    let cases = [
        ("0.1 + 0.2", tenth.plus(fifth), (0.3, 0.300_000_000_000_000_04)),
        ("0.1 * 0.1", tenth.times(tenth), (0.01, 0.010_000_000_000_000_002)),
        ("1/3", Interval::point(3.0).reciprocal(), (0.333_333_333_333_333_3, 0.333_333_333_333_333_37)),
        ("sqrt 3", Interval::point(3.0).sqrt(), (1.732_050_807_568_877_2, 1.732_050_807_568_877_4)),
        ("1e308 + 1e308", Interval::point(1e308).plus(Interval::point(1e308)), (f64::MAX, INFINITY)),
    ];
    for (name, found, (lower, upper)) in cases {
        assert_eq!((found.lower.value, found.upper.value), (lower, upper), "{name}");
    }
}

#[test]
fn zero_is_excluded_where_it_is_not_reached() {
    let right = Interval::open(-FRAC_PI_2, FRAC_PI_2);
    let apart = Interval::ALL.without_zero();
    let excluded = [
        ("x > 0", positive()),
        ("products of numbers that underflow", Interval::point(1e-300).power(2)),
        ("cos inside right angles", right.cos()),
        ("sin between 0 and pi", Interval::open(0.0, PI).sin()),
        ("sin of what is not zero, between -pi and pi", Interval::open(-PI, PI).without_zero().sin()),
        ("tan of what is not zero", right.without_zero().tan()),
        ("-1/x^3", -apart.power(-3)),
        ("x^2 + 1", Interval::ALL.power(2).plus(Interval::point(1.0))),
        ("root of x > 0", positive().sqrt()),
    ];
    for (name, values) in excluded {
        assert!(values.excludes_zero(), "{name}: {values:?}");
    }
    let included = [
        ("x >= 0", Interval::closed(0.0, 1.0)),
        ("x - y for positive ones", positive().plus(-positive())),
        ("sin between -1 and 1", Interval::open(-1.0, 1.0).sin()),
        ("cos between 0 and pi", Interval::open(0.0, PI).cos()),
        ("sin of what is not zero", apart.sin()),
        ("1 + cos inside half turns, where it rounds to 0", Interval::point(1.0).plus(Interval::open(-PI, PI).cos())),
        ("1 - sin inside right angles, where it rounds to 0", Interval::point(1.0).plus(-right.sin())),
        ("1 + cos of all", Interval::point(1.0).plus(Interval::ALL.cos())),
        ("1 + cos up to 4", Interval::point(1.0).plus(Interval::closed(0.0, 4.0).cos())),
    ];
    for (name, values) in included {
        assert!(!values.excludes_zero(), "{name}: {values:?}");
    }
}

/// An operation on one number, by interval and by the standard library, and how often the latter rounds.
type Operation = (&'static str, fn(Interval) -> Interval, fn(f64) -> f64, usize);

#[test]
fn results_hold_the_values_of_numbers_inside() {
    let operations: [Operation; 8] = [
        ("sin", Interval::sin, f64::sin, 1),
        ("cos", Interval::cos, f64::cos, 1),
        ("tan", Interval::tan, f64::tan, 1),
        ("sqrt", Interval::sqrt, f64::sqrt, 1),
        ("reciprocal", Interval::reciprocal, f64::recip, 1),
        ("square", |x| x.power(2), |x| x * x, 1),
        ("cube", |x| x.power(3), |x| x * x * x, 2),
        ("power -2", |x| x.power(-2), |x| (x * x).recip(), 3),
    ];
    let mut state = 1_u64;
    let mut random = |size: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        size * ((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    };
    // Rounded once a number inside does not leave the bounds, which are doubles themselves.
    let inside = |values: Interval, value: f64, roundings: usize| {
        let moved = |end: f64, shift: fn(f64) -> f64| (1..roundings).fold(end, |end, _| shift(end));
        let (lower, upper) = (values.lower.value, values.upper.value);
        moved(lower, f64::next_down) <= value && value <= moved(upper, f64::next_up)
    };
    for size in [0.1, 1.0, 10.0, 1e3] {
        for _ in 0..2_000 {
            let (a, b, c, d) = (random(size), random(size), random(size), random(size));
            let [one, two] = [(a, b), (c, d)].map(|(a, b)| Interval::closed(a.min(b), a.max(b)));
            let (x, y) = (a + (b - a) * random(1.0).abs(), c + (d - c) * random(1.0).abs());
            assert!(inside(one.plus(two), x + y, 1), "{x} + {y} of {one:?} and {two:?}");
            assert!(inside(one.times(two), x * y, 1), "{x} * {y} of {one:?} and {two:?}");
            for (name, interval, function, roundings) in operations {
                let value = function(x);
                if value.is_finite() {
                    assert!(inside(interval(one), value, roundings), "{name} {x} of {one:?}");
                }
            }
        }
    }
}
