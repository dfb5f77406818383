//! State matrices that are otherwise as a whole, that contradict one another, or have other states, and speeds that are none.

mod benchmark;

use benchmark::{C1, K0, K2, M, Matrix, SPEED, causes, checked, numbers, written};
use carvallo_check::{check, read};
use carvallo_design::input::Request;

type StateMatrix = [[f64; 4]; 4];

fn transposed(a: StateMatrix) -> StateMatrix {
    [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| a[column][row]))
}

fn negative(a: StateMatrix) -> StateMatrix {
    a.map(|row| row.map(|entry| -entry))
}

/// phi', delta', phi, delta in the place of phi, delta, phi', delta'.
fn rates_first(a: StateMatrix) -> StateMatrix {
    [2, 3, 0, 1].map(|row: usize| [2, 3, 0, 1].map(|column: usize| a[row][column]))
}

fn file(rows: StateMatrix) -> String {
    format!("speed = {SPEED}\nA = {}", written(rows, &|entry| format!("{entry:.4}")))
}

#[test]
fn a_matrix_that_is_transposed_or_negative_is_one_cause() {
    let right = numbers(SPEED, |_, _, _| {});
    let slip = numbers(SPEED, |_, c, _| c[1][0] = -c[1][0]);
    let (other_sign, filled) = ("A has the other sign", "A was filled row by column: it is transposed");
    for (rows, expected) in [
        (transposed(right), filled.to_owned()),
        (negative(right), other_sign.to_owned()),
        (transposed(rates_first(right)), filled.to_owned()),
        (negative(rates_first(right)), other_sign.to_owned()),
        (transposed(slip), format!("{filled}, and C1_21 has the other sign")),
        (negative(slip), format!("{other_sign}, and C1_21 has the other sign")),
    ] {
        let report = checked(&file(rows));
        assert_eq!(causes(&report).first(), Some(&expected), "{report}");
        assert!(!report.agrees && report.explanations.len() == 1, "{report}");
    }
    assert!(checked(&file(right)).agrees && checked(&file(rates_first(right))).agrees);
}

/// Also without damping, where the transpose of a matrix looks like one with rates before positions.
#[test]
fn a_matrix_at_rest_is_transposed_and_one_in_km_per_hour_is_multiplied() {
    let text =
        format!("speed = 0\nA = {}", written(transposed(numbers(0.0, |_, _, _| {})), &|own| format!("{own:.6}")));
    assert_eq!(causes(&checked(&text)), ["A was filled row by column: it is transposed"]);
    let right = numbers(SPEED, |_, _, _| {});
    let times = |factor: f64| right.map(|row| row.map(|entry| factor * entry));
    for (rows, expected) in [
        (times(3.6), "A is multiplied by 3.6"),
        (times(1.0 / 3.6), "A is divided by 3.6"),
        (transposed(times(3.6)), "A was filled row by column and is multiplied by 3.6"),
    ] {
        let text = format!("speed = {SPEED}\nA = {}", written(rows, &|own| format!("{own:.6}")));
        assert_eq!(causes(&checked(&text)), [expected]);
    }
}

/// A = [0, 1; -K M^-1, -C M^-1].
#[test]
fn a_division_by_the_mass_matrix_from_the_right_is_told() {
    let c = C1.map(|row| row.map(|entry| SPEED * entry));
    let k = [0, 1].map(|row| [0, 1].map(|column| 9.81 * K0[row][column] + SPEED * SPEED * K2[row][column]));
    let determinant = M[0][0] * M[1][1] - M[0][1] * M[1][0];
    let inverse = [[M[1][1], -M[0][1]], [-M[1][0], M[0][0]]].map(|row| row.map(|entry| entry / determinant));
    let lower = |with: &Matrix, row: usize, column: usize| {
        -(with[row][0] * inverse[0][column] + with[row][1] * inverse[1][column])
    };
    let row = |row: usize| [lower(&k, row, 0), lower(&k, row, 1), lower(&c, row, 0), lower(&c, row, 1)];
    let text = file([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], row(0), row(1)]);
    assert_eq!(causes(&checked(&text)), ["all matrices are divided by M from the right"]);
}

/// C1 for v C1, K2 and v K2 for v^2 K2: in A, in C and K, and in eigenvalues by NumPy (`numpy.linalg.eigvals` of A with these).
#[test]
fn a_power_of_the_speed_that_is_forgotten_is_told() {
    let stiffness = |factor: f64| [0, 1].map(|row| [0, 1].map(|at| 9.81 * K0[row][at] + factor * K2[row][at]));
    let [c1, vk2, k2] =
        ["C1 stands in the place of v*C1", "v*K2 stands in the place of v^2*K2", "K2 stands in the place of v^2*K2"];
    for (text, expected) in [
        (file(numbers(SPEED, |_, c, _| *c = C1)), c1),
        (file(numbers(SPEED, |_, _, k| *k = stiffness(SPEED))), vk2),
        (file(numbers(SPEED, |_, _, k| *k = stiffness(1.0))), k2),
        (format!("speed = {SPEED}\nM = {M:?}\nK = {:?}", stiffness(SPEED)), vk2),
        ("speed = 5\neigenvalues = [\"0.9973291 ± 3.634898i\", -2.204168, -2.980878]".to_owned(), c1),
        (
            "eigenvalues = { \"5\" = [\"1.321556 ± 1.792197i\", -3.44308, -15.15197], \
             \"7\" = [\"0.614274 ± 1.693684i\", -3.769255, -19.79201] }"
                .to_owned(),
            vk2,
        ),
    ] {
        assert_eq!(causes(&checked(&text)), [expected], "{text}");
    }
}

/// Two rods of 1 m and 1 kg, the second one from the vertical: M = [[I + a^2 + l^2, l a], [l a, I + a^2]] with a = 1/2 and I = 1/12, and
/// K0 = diag(-a - l, -a); here it is from the first one.
#[test]
fn angles_that_are_absolute_are_told() {
    let text = "model = \"DoublePendulum\"\nM = [[1.333333, 0.5], [0.5, 0.333333]]\nK0 = [[-1.5, 0], [0, -0.5]]";
    assert_eq!(causes(&checked(text)), ["theta2 is theta1 + theta2 of here: it is absolute"]);
}

/// The matrices of the bicycle that is called browser, by the formulas of Meijaard et al. (2007) in NumPy, held against the benchmark.
#[test]
fn another_bicycle_that_ships_is_told() {
    let text = "M = [[6.2167, 0.334402], [0.334402, 0.219808]]\nC1 = [[0, 4.38682], [-0.44981, 0.577326]]\n\
                K0 = [[-9.46676, -0.561218], [-0.561218, -0.218383]]\nK2 = [[0, 8.50357], [0, 0.600081]]";
    assert_eq!(causes(&checked(text)), ["they are of `browser`, another machine that ships"]);
}

/// Beside the printed matrices, and beside the published critical speeds, eigenvalues with a mistake: by C1 in the place of v C1, and by
/// the formulas with c/w*sin(lam) in mu, both by NumPy.
#[test]
fn what_agrees_may_be_of_elsewhere() {
    let told = |text: &str| checked(text).unexplained.and_then(|own| own.elsewhere).expect(text);
    let matrices = format!("M = {M:?}\nC1 = {C1:?}\nK0 = {K0:?}\nK2 = {K2:?}");
    let found =
        told(&format!("{matrices}\nspeed = 5\neigenvalues = [\"0.9973291 ± 3.634898i\", -2.204168, -2.980878]"));
    assert_eq!(found.agreeing, ["matrices of the equations of motion"]);
    assert_eq!(found.causes, ["C1 stands in the place of v*C1"]);
    let found = told(
        "speed = 5\neigenvalues = [-10.0945, \"-1.07783 ± 6.69771i\", 0.318376]\n\
         critical_speeds = { weave = 4.2924, capsize = 6.0243 }",
    );
    assert_eq!(found.agreeing, ["critical speeds"]);
    assert_eq!(found.causes, ["\"(c/w)*cos(lam)\" in mu is \"(c/w)*sin(lam)\""]);
}

/// The second one has C1_21 with the other sign.
#[test]
fn the_slip_in_one_of_two_matrices_of_one_speed_is_told() {
    let [right, slip] = [1.0, -1.0].map(|sign| numbers(SPEED, |_, c, _| c[1][0] *= sign));
    let rows = |own: StateMatrix| format!("{{ speed = {SPEED}, rows = {} }}", written(own, &|own| format!("{own:.5}")));
    let report = checked(&format!("A = [{}, {}]", rows(right), rows(slip)));
    let found = report.unexplained.as_ref().and_then(|own| own.elsewhere.clone()).expect("an explanation");
    assert_eq!(
        (&found.agreeing[..], &found.causes[0][..]),
        (&["A no. 1 at 5 m/s".to_owned()][..], "C1_21 has the other sign")
    );
    let line =
        "What is given as A no. 1 at 5 m/s agrees. All others come out as yours, and that does not, if\n    C1_21 has";
    assert!(report.to_string().contains(line), "{report}");
}

/// All eigenvalues are real, which nothing says but that no two are equal: by NumPy from the formulas with - mF*w*rF in ITxz and -IFyy/rF in
/// SF.
#[test]
fn two_slips_are_told_from_real_eigenvalues() {
    let found = causes(&checked("speed = 5\neigenvalues = [-18.97821, -5.296089, 0.9244455, 5.515759]"));
    assert!(found[0].contains("\"- mF*w*rF\"") && found[0].contains("\"-IFyy/rF\""), "{found:?}");
}

/// M_11 is 5 % too large, and C_12 and K_21 are wrong as well: nobody has all of these.
#[test]
fn what_is_wrong_beside_it_is_told_of_the_matrix_as_it_should_have_been() {
    let rows = numbers(SPEED, |m, c, k| {
        m[0][0] *= 1.05;
        c[0][1] *= 1.37;
        k[1][0] *= 0.83;
    });
    let text = checked(&file(transposed(rows))).to_string();
    assert!(text.contains("\nA was filled row by column: it is transposed. Beside that:\n"), "{text}");
    assert!(text.contains("  What differs: A_31 at 5 m/s"), "{text}");
}

/// K at a speed is g K0 + v^2 K2.
#[test]
fn damping_and_stiffness_at_a_speed_are_negative_or_transposed_as_a_whole() {
    let k = [0, 1].map(|row| [0, 1].map(|column| 9.81 * K0[row][column] + SPEED * SPEED * K2[row][column]));
    let negative = k.map(|row| row.map(|entry| -entry));
    let text = format!("speed = {SPEED}\nM = {M:?}\nK = {negative:?}");
    assert_eq!(causes(&checked(&text)), ["K0 and K2 have the other sign"]);
    let transposed = [[k[0][0], k[1][0]], [k[0][1], k[1][1]]];
    let found = causes(&checked(&format!("speed = {SPEED}\nM = {M:?}\nK = {transposed:?}")));
    assert!(found.iter().any(|own| own == "K0 and K2 were filled row by column: they are transposed"), "{found:?}");
}

#[test]
fn matrices_of_one_speed_that_contradict_one_another_are_told() {
    let right = numbers(SPEED, |_, _, _| {});
    let mut other = rates_first(right);
    other[0][2] = 11.0;
    let rows =
        |rows: StateMatrix| format!("{{ speed = {SPEED}, rows = {} }}", written(rows, &|own| format!("{own:.3}")));
    let report = checked(&format!("A = [{}, {}]", rows(right), rows(other)));
    let found = report.unexplained.as_ref().map(|own| own.contradictions.clone()).unwrap_or_default();
    assert_eq!(found, ["A_31 at 5 m/s is 9.490 and 11.000"]);
    let line = "\nNo machine has all of these numbers: A_31 at 5 m/s is 9.490 and 11.000.\n";
    assert!(report.to_string().contains(line), "{report}");
    // Cut off and rounded they are of one number: 9.48977.
    other[0][2] = 9.489;
    let report = checked(&format!("A = [{}, {}]", rows(right), rows(other)));
    assert!(report.unexplained.is_none(), "{report}");
}

/// Figures of the formulation at 5 and at 8 m/s, by speeds in km/h: A at 5/3.6 and at 8/3.6 m/s.
#[test]
fn speeds_in_another_unit_are_told_once() {
    let rows = |speed: f64| {
        let rows = numbers(speed / 3.6, |_, _, _| {});
        format!("{{ speed = {speed}, rows = {} }}", written(rows, &|own| format!("{own:.9e}")))
    };
    let report = checked(&format!("A = [{}, {}]", rows(5.0), rows(8.0)));
    assert_eq!(causes(&report), ["speeds are in km/h in the place of m/s"]);
}

#[test]
fn states_that_are_none_are_told_with_the_reason() {
    let file = read::read(
        "mine.toml",
        format!(
            "speed = 5\nA = {:?}",
            [[0.0; 6]; 6].map(|mut row| {
                row[0] = 1.0;
                row
            })
        )
        .into(),
    )
    .expect("a file that can be read");
    let design =
        file.design(&Request { model: Some("CarTrailer".to_owned()), ..Request::default() }).expect("a design");
    let told = check(&file.given(&design).expect("numbers"), &design).expect_err("six rows of four");
    let expected = "a row of A has 6 numbers; expected 4, one for each state: q, y_rate, psi_rate, q_rate in this order, rates \
                    before positions, or each position with its rate; y and psi are no states, since nothing depends on where \
                    that is";
    assert_eq!(told, expected);
}

#[test]
fn a_bracket_that_is_missing_is_one_problem() {
    let text = "M = [[80.817, 2.3194], [2.3194, 0.29784]\nC1 = [[0.0, 33.866], [-0.85036, 1.6854]]\nK2 = [[0.0, 76.597], [0.0, 2.6543]]";
    let told = read::read("mine.toml", text.into()).map(|_| ()).expect_err("no TOML").to_string();
    assert_eq!(told, "mine.toml:1: this is not TOML: the list that begins here has no end, expected `]`");
}

#[test]
fn a_speed_that_is_none_is_told_once() {
    let right = written(numbers(SPEED, |_, _, _| {}), &|entry| format!("{entry:.4}"));
    let text = format!("speed = -5\nA = {right}\neigenvalues = [-14.078]");
    let told = read::read("mine.toml", text.into()).map(|_| ()).expect_err("no speed").to_string();
    assert!(told.contains("`speed` is `-5`: expected a speed >= 0 in m/s"), "{told}");
    assert!(!told.contains("has no speed"), "{told}");
}

#[test]
fn a_critical_speed_is_not_negative() {
    let told =
        read::read("mine.toml", b"critical_speeds = { weave = -0.01 }".to_vec()).map(|_| ()).expect_err("no speed");
    assert!(told.to_string().contains("weave speed is -0.01; it must be >= 0"), "{told}");
}

#[test]
fn feedback_by_the_inverse_of_the_speed_has_no_value_at_rest() {
    let right = written(numbers(0.0, |_, _, _| {}), &|entry| format!("{entry:.4}"));
    let text = format!("feedback = 'Tdelta = 2*phi_rate/v'\nspeed = 0\nA = {right}");
    let file = read::read("mine.toml", text.into()).expect("a file that can be read");
    let design = file.design(&Request::default()).expect("a design");
    let told = check(&file.given(&design).expect("numbers"), &design).expect_err("no value");
    assert!(told.contains("the feedback has 1/v in it"), "{told}");
}

#[test]
fn what_is_wrong_with_accelerations_is_told_once() {
    let told = |inside: &str| {
        let text = format!("accelerations = {{ {inside} }}");
        let file = read::read("mine.toml", text.into()).expect("a file that can be read");
        let design = file.design(&Request::default()).expect("a design");
        file.given(&design).map(|_| ()).expect_err("mistakes").to_string()
    };
    let found = told("speed = 4, state = { phi = 0.1 }, values = [0.9, 1.2]");
    assert!(found.contains("`values` is no table; expected a number of each coordinate, as { phi = 0.1 }"), "{found}");
    let found = told("speed = -4, state = { phi = 0.1 }, values = { phi = 0.9 }");
    assert!(found.contains("speed >= 0") && !found.contains("no `speed`"), "{found}");
}

/// Table 2 of Meijaard et al. (2007) at 5 m/s, with another real part below the axis.
#[test]
fn eigenvalues_without_their_conjugates_are_told() {
    let of = |below: &str| {
        checked(&format!(
            "speed = 5\neigenvalues = [-14.07838969, -0.32286643, \"-0.77534188+4.46486771i\", \"{below}\"]"
        ))
    };
    assert!(of("-0.77534188-4.46486771i").agrees);
    let report = of("-0.85534188-4.46486771i");
    let found = report.unexplained.as_ref().map(|own| own.contradictions.clone()).unwrap_or_default();
    let expected = ["-0.77534188+4.46486771i", "-0.85534188-4.46486771i"]
        .map(|own| format!("the eigenvalue {own} at 5 m/s without its conjugate"));
    assert_eq!(found, expected, "{report}");
}

/// The critical speeds of the benchmark bicycle, as published, one under the name of the other.
#[test]
fn critical_speeds_under_one_anothers_names_are_told() {
    let found = causes(&checked("critical_speeds = { weave = 6.024262, capsize = 4.292383 }"));
    assert_eq!(found, ["weave speed and capsize speed are exchanged"]);
}
