//! Expressions by hand.

use super::super::no_names;
use super::parse;

#[track_caller]
fn check(text: &str, expected: f64) {
    let found = parse(text, &no_names).map(|parsed| (parsed.value.to_bits(), parsed.rest));
    assert_eq!(found, Ok((expected.to_bits(), "")), "{text}");
}

/// Expected values are the doubles nearest to the exact values, from mpmath at 50 digits.
#[test]
fn angles_are_the_nearest_doubles() {
    check("pi/10", 0.314_159_265_358_979_3);
    check("18 deg", 0.314_159_265_358_979_3);
    check("18°", 0.314_159_265_358_979_3);
    check("math.radians(18)", 0.314_159_265_358_979_3);
    check("np.deg2rad(18)", 0.314_159_265_358_979_3);
    check("atan(1/3)", 0.321_750_554_396_642_2);
    check("numpy.arctan2(1, 3)", 0.321_750_554_396_642_2);
}

#[test]
fn arithmetic_binds_as_in_formulas() {
    check(" 1 + 2*3 ", 7.0);
    check("2-3-4", -5.0);
    check("8/2/2", 2.0);
    check("-2^2", -4.0);
    check("-2**2", -4.0);
    check("2^-1", 0.5);
    check("2**-1", 0.5);
    check("2 ** 3*4", 32.0);
    check("2*-1", -2.0);
    check("3·2×2", 12.0);
    check("2*(1 + sqrt(4))", 6.0);
    check("pow(2, 3) - hypot(3, 4)", 3.0);
    check("1e-3", 0.001);
    check("5D-1", 0.5);
    check("5d-1", 0.5);
    check("1.D0", 1.0);
    check(".5", 0.5);
    check("1./4", 0.25);
}

#[test]
fn mistakes_are_named() {
    let signs = "a sign after a sign; a difference has one sign, and a standard deviation `+/-` behind the whole value";
    for (text, message) in [
        ("", "a value is missing at the end"),
        ("pi/", "a value is missing at the end"),
        ("(1", "a closing parenthesis is missing"),
        ("nan", "`nan` is not known"),
        ("sin 1", "`sin` needs its argument in parentheses"),
        ("atan2(1)", "`atan2` has two arguments"),
        (".", "`.` is not a number"),
        ("1e-400", "the value is too small to tell from zero"),
        ("1e-200*1e-200", "the value is too small to tell from zero"),
        ("85+-5", signs),
        ("85 - -5", signs),
        ("0.08-+0.001", signs),
        ("2*(3+-1)", signs),
        ("--1", signs),
        ("2*--1", signs),
        ("2^--1", "unexpected `-`"),
    ] {
        assert_eq!(parse(text, &no_names).map(|parsed| parsed.value), Err(message.to_owned()), "{text}");
    }
    check("0.0e-400", 0.0);
    assert_eq!(parse(&"(".repeat(100_000), &no_names).err().as_deref(), Some("nested too deeply"));
    assert_eq!(parse(&"-".repeat(100_000), &no_names).err().as_deref(), Some(signs));
}
