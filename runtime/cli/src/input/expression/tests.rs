//! Expressions by hand.

use super::{Mistake, evaluate};

#[track_caller]
fn check(text: &str, expected: f64) {
    assert_eq!(evaluate(text).map(f64::to_bits), Ok(expected.to_bits()), "{text}");
}

/// Expected values are the doubles nearest to the exact values, from mpmath at 50 digits.
#[test]
fn angles_are_the_nearest_doubles() {
    check("pi/10", 0.314_159_265_358_979_3);
    check("18 deg", 0.314_159_265_358_979_3);
    check("18°", 0.314_159_265_358_979_3);
    check("atan(1/3)", 0.321_750_554_396_642_2);
}

#[test]
fn arithmetic_binds_as_in_formulas() {
    check(" 1 + 2*3 ", 7.0);
    check("2-3-4", -5.0);
    check("8/2/2", 2.0);
    check("-2^2", -4.0);
    check("2^-1", 0.5);
    check("--1", 1.0);
    check("2*(1 + sqrt(4))", 6.0);
    check("1e-3", 0.001);
    check(".5", 0.5);
}

#[test]
fn mistakes_are_named() {
    for (text, message) in [
        ("", "a value is missing at the end"),
        ("pi/", "a value is missing at the end"),
        ("1 2", "unexpected `2`"),
        ("1,02", "unexpected `,`"),
        ("(1", "a closing parenthesis is missing"),
        ("nan", "`nan` is not known"),
        ("sin 1", "`sin` needs its argument in parentheses"),
        ("1/0", "the value is not finite"),
        ("1e999", "the value is not finite"),
        ("sqrt(-1)", "the value is not finite"),
        (".", "`.` is not a number"),
        ("2 pi", "unexpected `p`"),
        ("1e-400", "the value is too small to tell from zero"),
        ("1e-200*1e-200", "the value is too small to tell from zero"),
    ] {
        assert_eq!(evaluate(text), Err(Mistake::Other(message.to_owned())), "{text}");
    }
    assert_eq!(["85 kg", "9.81 m/s^2"].map(evaluate), [Err(Mistake::Unit), Err(Mistake::Unit)]);
    check("0.0e-400", 0.0);
    assert_eq!(evaluate(&"(".repeat(100_000)), Err(Mistake::Other("nested too deeply".to_owned())));
    assert!(evaluate(&"-".repeat(100_000)).is_err());
}
