//! Numbers of closed loops that nobody declared, or of which only some is declared.

mod benchmark;

use benchmark::{Matrix, causes, checked, checked_with, numbers, state_matrix, written};

const AT_ONE: &str = "(gains at 5 m/s: one speed does not tell how they depend on it)";

/// A at speeds with ten digits, in a list.
fn at_speeds(speeds: &[f64], mistake: impl Fn(f64, &mut Matrix, &mut Matrix)) -> String {
    let one = |&speed: &f64| {
        let rows = numbers(speed, |_, c, k| mistake(speed, c, k));
        format!("{{ speed = {speed}, rows = {} }}", written(rows, &|entry| format!("{entry:.9e}")))
    };
    format!("A = [{}]", speeds.iter().map(one).collect::<Vec<_>>().join(", "))
}

/// Tdelta = -10 phi' + 15 delta and A - B K with it: C_21 + 10 and K_22 - 15.
#[test]
fn a_closed_loop_that_was_not_declared_is_told() {
    let text = state_matrix(|_, c, k| {
        c[1][0] += 10.0;
        k[1][1] -= 15.0;
    });
    let law = "Tdelta = 15*delta - 10*phi_rate";
    let expected =
        format!("the loop is closed, in the span of Tdelta alone, by what --feedback '{law}' declares {AT_ONE}");
    assert_eq!(causes(&checked(&text)), [expected]);
    assert!(checked_with(&text, &[law]).agrees);
}

/// C1_21 is -0.7 and K0_22 -1.1 in the place of -0.85 and -0.803: with four digits some gains or other make that, too.
#[test]
fn few_digits_do_not_tell_a_closed_loop() {
    let report = checked(
        "speed = 5\nA = [[0, 0, 1, 0], [0, 0, 0, 1], [9.49, -23.21, -0.4343, -1.653], [11.72, -5.799, 15.13, -15.42]]",
    );
    assert!(causes(&report).iter().all(|cause| !cause.contains("--feedback")), "{report}");
    assert!(report.unexplained.is_none_or(|own| own.feedback.is_some()));
}

/// Gains as an optimal regulator has them are no slip of anybody's; mistakes in one equation alone look the same.
#[test]
fn gains_of_many_digits_are_told_beside_what_differs() {
    let gains = [-7.123456789, 3.987654321, -1.23456789, -0.56789123];
    let report = checked(&state_matrix(|_, c, k| {
        (k[1][0], k[1][1]) = (k[1][0] - gains[0], k[1][1] - gains[1]);
        (c[1][0], c[1][1]) = (c[1][0] - gains[2], c[1][1] - gains[3]);
    }));
    assert!(report.explanations.is_empty(), "{report}");
    let found = report.unexplained.and_then(|own| own.feedback).expect("a feedback");
    assert_eq!((found.forces, found.laws.len()), (vec!["Tdelta".to_owned()], 1));
    let (_, law) = found.laws[0].split_once(" = ").expect("a law");
    let values =
        law.replace("- ", "+ -").split(" + ").map(|term| term.split('*').next().unwrap_or("").parse()).collect();
    let values: Vec<f64> = Result::unwrap(values);
    for (value, expected) in values.iter().zip(gains) {
        assert!((value - expected).abs() < 2e-8, "{law}");
    }
}

/// Tdelta = -10 phi' is declared, and the loop is closed by Tdelta = -10 phi' + 15 delta - 7.5 delta'.
#[test]
fn what_comes_to_a_law_that_is_declared_is_told_with_all_of_it() {
    let text = state_matrix(|_, c, k| {
        c[1][0] += 10.0;
        c[1][1] += 7.5;
        k[1][1] -= 15.0;
    });
    let law = "Tdelta = -10*phi_rate + 15*delta - 7.5*delta_rate";
    let expected = format!(
        "the loop is closed by more than is declared, Tdelta = 15*delta - 7.5*delta_rate, in the span of Tdelta alone, by what \
         --feedback '{law}' declares {AT_ONE}"
    );
    assert_eq!(causes(&checked_with(&text, &["Tdelta = -10*phi_rate"])), [expected]);
    assert!(checked_with(&text, &[law]).agrees);
}

/// A gain of -12.5 that was declared as -10; and a law of another force, Tphi = -20 phi.
#[test]
fn another_gain_and_another_force_are_told_beside_what_is_declared() {
    let declared = "Tdelta = -10*phi_rate";
    let of_gain = causes(&checked_with(&state_matrix(|_, c, _| c[1][0] += 12.5), &[declared]));
    let law = "--feedback 'Tdelta = -12.5*phi_rate'";
    assert!(
        of_gain[0].contains("more than is declared, Tdelta = -2.5*phi_rate,") && of_gain[0].contains(law),
        "{of_gain:?}"
    );
    let of_force = causes(&checked_with(
        &state_matrix(|_, c, k| {
            c[1][0] += 10.0;
            k[0][0] += 20.0;
        }),
        &[declared],
    ));
    let laws = "--feedback 'Tdelta = -10*phi_rate' --feedback 'Tphi = -20*phi'";
    assert!(
        of_force[0].contains("more than is declared, Tphi = -20*phi,") && of_force[0].contains(laws),
        "{of_force:?}"
    );
}

/// C_21 + 10 (4.7 - v): Tdelta = -10 (4.7 - v) phi'. At 5 m/s alone that is 3 phi'.
#[test]
fn a_gain_with_two_powers_of_the_speed_is_told_from_two_speeds() {
    let mistake = |speed: f64, c: &mut Matrix, _: &mut Matrix| c[1][0] += 10.0 * (4.7 - speed);
    let law = "Tdelta = -47*phi_rate + 10*v*phi_rate";
    let expected = format!("the loop is closed, in the span of Tdelta alone, by what --feedback '{law}' declares");
    for speeds in [&[3.0, 5.0][..], &[3.0, 5.0, 7.0]] {
        let text = at_speeds(speeds, mistake);
        assert_eq!(causes(&checked(&text)), [expected.as_str()]);
        assert!(checked_with(&text, &["Tdelta = -10*(4.7 - v)*phi_rate"]).agrees);
    }
    let expected = "the loop is closed, in the span of Tdelta alone, by what --feedback 'Tdelta = 3*phi_rate' declares";
    assert_eq!(causes(&checked(&at_speeds(&[5.0], mistake))), [format!("{expected} {AT_ONE}")]);
}

/// K_21 + 2 + 0.3 v + 0.01 v^2, by all three powers.
#[test]
fn a_gain_with_three_powers_of_the_speed_takes_three_speeds() {
    let text = at_speeds(&[2.0, 5.0, 7.0], |speed, _, k| k[1][0] += 2.0 + 0.3 * speed + 0.01 * speed * speed);
    let law = "Tdelta = -2*phi - 0.3*v*phi - 0.01*v^2*phi";
    assert!(causes(&checked(&text))[0].ends_with(&format!("--feedback '{law}' declares")), "{}", checked(&text));
}

/// Tdelta = -10 phi' is declared, and Tdelta = -10 phi' - 2.5 delta closes the loop: eigenvalues of A - B K by NumPy (`numpy.linalg.eigvals`).
#[test]
fn a_further_gain_is_told_from_eigenvalues() {
    let text = r#"eigenvalues = {
        "4" = ["-11.4949047", "-6.86422131", "0.116001424", "6.72249298"],
        "5" = ["-13.0313117", "-8.24569568", "-0.0181917094", "6.58417943"],
        "6" = ["-14.7429356", "-9.3354464", "-0.119779182", "6.29675355"],
    }"#;
    let law = "Tdelta = -10*phi_rate - 2.5*delta";
    let found = causes(&checked_with(text, &["Tdelta = -10*phi_rate"]));
    assert!(found[0].ends_with(&format!("by what --feedback '{law}' declares")), "{found:?}");
    assert!(checked_with(text, &[law]).agrees);
}

/// Tdelta = -3 phi' in the printed matrices: eigenvalues of A - B K by NumPy, of which two are no real ones.
#[test]
fn a_gain_is_told_from_complex_eigenvalues() {
    let text = "speed = 4\neigenvalues = [-12.27965, -3.415015, \"1.652697 ± 1.126383i\"]";
    let found = causes(&checked(text));
    assert!(found[0].contains("by what --feedback 'Tdelta = -3*phi_rate' declares"), "{found:?}");
}

/// Tdelta = -2 v^2 phi in the printed matrices: eigenvalues of A - B K by NumPy.
#[test]
fn a_gain_with_the_square_of_the_speed_is_told_from_eigenvalues() {
    let text = r#"eigenvalues = {
        "4" = [-12.064401, 4.963076, "-2.8301136 ± 4.8478928i"],
        "6" = [-16.139842, 6.8180642, "-4.9102748 ± 8.4559308i"],
    }"#;
    let found = causes(&checked(text));
    assert!(found[0].ends_with("by what --feedback 'Tdelta = -2*v^2*phi' declares"), "{found:?}");
}

/// Tdelta = 10 (4.7 - v) phi' in the printed matrices: eigenvalues of A - B K by NumPy.
#[test]
fn a_gain_with_two_powers_of_the_speed_is_told_from_eigenvalues() {
    let text = r#"eigenvalues = {
        "4" = [-11.932274, "-0.69564638 ± 6.7352658i", -0.30662913],
        "6" = [8.2681475, -15.786277, -10.012847, 0.0018453346],
    }"#;
    let found = causes(&checked(text));
    assert!(found[0].ends_with("by what --feedback 'Tdelta = 47*phi_rate - 10*v*phi_rate' declares"), "{found:?}");
}
