//! One mistake in a state matrix of which all numbers are cut off to three decimals, and not rounded.

mod benchmark;

use benchmark::{Matrix, SPEED, causes, checked, numbers, written};

fn cut_off(mistake: impl Fn(&mut Matrix, &mut Matrix, &mut Matrix)) -> String {
    let digits = |entry: f64| format!("{:.3}", (entry * 1e3).trunc() / 1e3);
    format!("speed = {SPEED}\nA = {}", written(numbers(SPEED, mistake), &digits))
}

/// ITxx without its IRxx = 0.0603: none of the numbers that it leaves shows that they are cut off.
#[test]
fn a_slip_that_changes_all_numbers_is_told_with_the_cutting_off() {
    let report = checked(&cut_off(|m, _, _| m[0][0] -= 0.0603));
    let expected = "ITxx is without \"IRxx\", and all numbers are cut off, not rounded";
    assert_eq!(causes(&report).first().map(String::as_str), Some(expected), "{report}");
    // What is not told with it is another cause of the same reading.
    assert!(causes(&report).iter().all(|own| own.ends_with("all numbers are cut off, not rounded")), "{report}");
}

/// C1_21 has the other sign: two of the numbers that it leaves are cut off.
#[test]
fn what_is_seen_to_be_cut_off_is_told_once() {
    let report = checked(&cut_off(|_, c, _| c[1][0] = -c[1][0]));
    let same = "\"-(mu*ST + SF*cos(lam))\" in C1_21 is \"(mu*ST + SF*cos(lam))\"";
    assert_eq!(causes(&report), ["C1_21 has the other sign", same], "{report}");
    assert!(report.to_string().contains("2 of 16 numbers are cut off, not rounded:"), "{report}");
}

/// The same numbers rounded: nobody cuts off.
#[test]
fn rounded_numbers_are_not_told_to_be_cut_off() {
    let rows = numbers(SPEED, |m, _, _| m[0][0] -= 0.0603);
    let report = checked(&format!("speed = {SPEED}\nA = {}", written(rows, &|entry| format!("{entry:.3}"))));
    assert!(causes(&report).iter().any(|own| own == "ITxx is without \"IRxx\""), "{report}");
    assert!(causes(&report).iter().all(|own| !own.contains("cut off")), "{report}");
}
