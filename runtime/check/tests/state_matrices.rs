//! What explains a state matrix.

mod benchmark;

use benchmark::{K0, causes, checked, numbers, state_matrix, written};
use carvallo_check::{check, read};
use carvallo_design::input::Request;

#[test]
fn two_mistaken_entries_are_an_explanation() {
    let report = checked(&state_matrix(|_, _, k| {
        k[0][0] = -k[0][0];
        k[1][0] /= 2.0;
    }));
    let found = causes(&report);
    assert_eq!(
        found.first().map(String::as_str),
        Some("K0_11 has the other sign, and K0_21 is half of what it is here")
    );
}

/// K_12 = g K0_12 + v^2 K2_12 is no entry by itself.
#[test]
fn entries_at_the_speed_are_written_wrongly() {
    let one = checked(&state_matrix(|_, _, k| k[0][1] = -k[0][1]));
    assert_eq!(causes(&one), ["K_12 at 5 m/s has the other sign"]);
    let two = checked(&state_matrix(|_, c, k| {
        c[1][0] = -c[1][0];
        k[0][1] = -k[0][1];
    }));
    assert_eq!(causes(&two), ["C_21 at 5 m/s has the other sign, and K_12 at 5 m/s has the other sign"]);
}

#[test]
fn three_mistakes_are_told_one_by_one_and_each_once() {
    let report = checked(&state_matrix(|_, c, k| {
        k[0][0] = -k[0][0];
        k[1][0] /= 2.0;
        c[0][1] *= 2.0;
    }));
    let text = report.to_string();
    assert!(text.contains("\nThere are several mistakes: "), "{text}");
    assert!(!text.contains("\nNothing that was tried"), "{text}");
    for (what, count) in [("C1_12 is twice", 1), ("_11 has the other sign", 1), ("_21 is half", 1)] {
        assert_eq!(text.matches(what).count(), count, "{what}: {text}");
    }
}

/// One slip in M, which is in all of A, and another one in K0: ITxx has lost IRxx, and K0_22 the sine.
#[test]
fn two_slips_one_of_which_changes_m_are_found() {
    let sine = (std::f64::consts::PI / 10.0).sin();
    let report = checked(&state_matrix(|m, _, k| {
        // ITxx without its IRxx = 0.0603.
        m[0][0] -= 0.0603;
        // K0_22 = -SA sin(lam) without the sine.
        k[1][1] += 9.81 * (K0[1][1] / sine - K0[1][1]);
    }));
    let found = causes(&report);
    let has_both = |own: &String| own.contains("IRxx") && own.contains("K0_22");
    assert!(found.iter().any(has_both), "{report}");
}

#[test]
fn what_is_no_state_matrix_is_refused() {
    for (text, expected) in [
        ("speed = 5\nA = [[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]]", "`A` has no entry but 0"),
        (
            "speed = 1e200\nA = [[0, 0, 1, 0], [0, 0, 0, 1], [1, 2, 3, 4], [5, 6, 7, 8]]",
            "expected a speed of at most 1000000000 m/s",
        ),
    ] {
        let refused = read::read("mine.toml", text.into()).map(|_| ()).expect_err("nothing to check");
        assert!(refused.to_string().contains(expected), "{refused}");
    }
}

/// Rates before positions: [phi', delta', phi, delta].
#[test]
fn states_are_named_in_the_order_of_the_matrix() {
    let text = "speed = 5\nA = [[0, 0, 9.4897, -22.851], [0, 0, 11.719, -1.8384], [1, 0, 0, 0], [0, 1, 0, 0]]";
    let report = checked(text);
    assert_eq!(report.states, [["phi_rate", "delta_rate", "phi", "delta"]]);
    let line = "\n  Rows and columns of A: phi_rate, delta_rate, phi, delta\n";
    assert!(report.to_string().contains(line), "{report}");
}

#[test]
fn states_are_named_where_there_are_others() {
    let file = read::read("mine.toml", "speed = 5\nA = [[0, 1], [2, 3]]".into()).expect("a file that can be read");
    let design = file.design(&Request::default()).expect("a design");
    let told = check(&file.given(&design).expect("numbers"), &design).expect_err("two rows of four");
    assert!(told.contains("one for each state: phi, delta, phi_rate, delta_rate"), "{told}");
}

/// M_11 is 80.81722 in the paper, 80.82 with four digits.
#[test]
fn zeros_behind_fewer_digits_are_told() {
    let report = checked("M = [[80.820, 2.31941], [2.31941, 0.297842]]");
    assert_eq!((report.agrees, report.padded), (false, Some(4)), "{report}");
    assert!(report.to_string().contains("\nTo 4 digits all agree, with zeros behind: `digits = 4` in"), "{report}");
    let wrong = checked("M = [[80.920, 2.31941], [2.31941, 0.297842]]");
    assert_eq!((wrong.agrees, wrong.padded), (false, None));
}

/// The printed matrices twice at one speed, the second transposed, and with one more in A_31, as it should be.
#[test]
fn of_two_matrices_the_transposed_one_is_told_and_what_contradicts() {
    let right = numbers(5.0, |_, _, _| {});
    let transposed = |rows: [[f64; 4]; 4]| [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| rows[column][row]));
    let mut wrong = right;
    wrong[2][0] += 1.0;
    let both = |second: [[f64; 4]; 4]| {
        let [a, b] = [right, transposed(second)].map(|rows| written(rows, &|entry| format!("{entry:.8}")));
        checked(&format!("A = [{{ speed = 5, rows = {a} }}, {{ speed = 5, rows = {b} }}]"))
    };
    assert_eq!(causes(&both(right)), ["A no. 2 at 5 m/s was filled row by column: it is transposed"]);
    let report = both(wrong);
    let suspects = report.unexplained.as_ref().expect("suspects");
    assert_eq!(suspects.beside, ["A no. 2 at 5 m/s was filled row by column: it is transposed"], "{report}");
    assert_eq!(suspects.contradictions, ["A_31 at 5 m/s is 9.48977445 and 10.48977445"], "{report}");
    assert_eq!(suspects.wrong, ["A_31 of A no. 2 at 5 m/s"], "{report}");
}

/// Positions under each other's names, and rates under their own: entries of the rates of positions are wrong as well, which no
/// stiffness behind the matrix explains. By NumPy.
#[test]
fn positions_in_another_order_are_not_told_by_the_stiffness() {
    let report = checked(
        r#"{"speed": 5, "A": [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0],
            [-22.8515, 9.48977, -0.527612, -1.65258], [-18.3841, 11.7195, 18.384, -15.4243]]}"#,
    );
    let text = report.to_string();
    assert!(
        text.contains("\nNothing that was tried explains all numbers") && !text.contains("each by itself"),
        "{text}"
    );
    assert!(!text.contains("Behind A"), "{text}");
}
