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

/// The numbers that are printed, transposed and of the other sign, and cut off to one decimal and to three; rounded ones tell nothing of it.
#[test]
fn a_matrix_in_another_form_is_told_to_be_cut_off() {
    let right = numbers(SPEED, |_, _, _| {});
    for decimals in [1, 3] {
        let unit = 10f64.powi(decimals as i32);
        let cut = |entry: f64| format!("{:.decimals$}", (entry * unit).trunc() / unit);
        let transposed = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| right[column][row]));
        let negative = right.map(|row| row.map(|entry| -entry));
        for (rows, form) in
            [(transposed, "A was filled row by column: it is transposed"), (negative, "A has the other sign")]
        {
            let report = checked(&format!("speed = {SPEED}\nA = {}", written(rows, &cut)));
            let expected = format!("{form}, and all numbers are cut off, not rounded");
            assert_eq!(causes(&report), [expected], "{report}");
        }
        let report = checked(&format!("speed = {SPEED}\nA = {}", written(negative, &|entry| format!("{entry:.4}"))));
        assert_eq!(causes(&report), ["A has the other sign"], "{report}");
    }
}

/// C1_21 has the other sign, and the matrix is transposed and cut off.
#[test]
fn a_slip_in_a_matrix_in_another_form_is_told_with_the_cutting_off() {
    let rows = numbers(SPEED, |_, c, _| c[1][0] = -c[1][0]);
    let rows = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| rows[column][row]));
    let cut = |entry: f64| format!("{:.3}", (entry * 1e3).trunc() / 1e3);
    let report = checked(&format!("speed = {SPEED}\nA = {}", written(rows, &cut)));
    let expected = "A was filled row by column: it is transposed, and C1_21 has the other sign, \
                    and all numbers are cut off, not rounded";
    assert_eq!(causes(&report).first().map(String::as_str), Some(expected), "{report}");
}
