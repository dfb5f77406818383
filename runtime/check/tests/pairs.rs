//! Two slips at once in what matrices make: the damping and stiffness at a speed, state matrices, and eigenvalues.
//!
//! The numbers come from the formulas and the parameters of Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1, written out here
//! with the slips: C1_21 = -(mu ST + SF cos lam) without its minus, and K2_12 = (ST - mT zT) cos(lam)/w with a plus.

use carvallo_check::{Report, check, read};
use carvallo_design::input::Request;

const SPEED: f64 = 5.0;

fn checked(text: &str) -> Report {
    let file = read::read("mine.toml", text.into()).expect("a file that can be read");
    let design = file.design(&Request::default()).expect("a design");
    check(&file.given(&design).expect("numbers"), &design).expect("a report")
}

/// M of the paper, and C and K at the speed with both slips.
fn matrices() -> [[[f64; 2]; 2]; 3] {
    let m = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
    let (w, lam) = (1.02, std::f64::consts::PI / 10.0);
    let (sr, sf, mu) = (0.12 / 0.3, 0.28 / 0.35, 0.08 * lam.cos() / 1.02);
    let (st, first_moment) = (sr + sf, -(2.0 * 0.3 + 85.0 * 0.9 + 4.0 * 0.7 + 3.0 * 0.35));
    let c1 = [[0.0, 33.86641391492494], [mu * st + sf * lam.cos(), 1.68540397397560]];
    let k0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
    let k2 = [[0.0, (st + first_moment) * lam.cos() / w], [0.0, 2.65431523794604]];
    let c = c1.map(|row| row.map(|entry| SPEED * entry));
    let k = [0, 1].map(|row| [0, 1].map(|column| 9.81 * k0[row][column] + SPEED * SPEED * k2[row][column]));
    [m, c, k]
}

#[track_caller]
fn both_are_found(text: &str) {
    let report = checked(text);
    let first = &report.explanations.first().unwrap_or_else(|| panic!("{report}")).explanations;
    let causes: Vec<String> = first.iter().map(|own| own.causes.join(", and ")).collect();
    let expected = "\"-(mu*ST + SF*cos(lam))\" in C1_21 is \"(mu*ST + SF*cos(lam))\", and \"((ST - mT*zT)/w)*cos(lam)\" in K2_12 \
                    is \"((ST + mT*zT)/w)*cos(lam)\"";
    assert!(causes.iter().any(|own| own == expected), "{causes:?}");
}

#[test]
fn two_slips_are_found_in_damping_and_stiffness_at_a_speed() {
    let [_, c, k] = matrices();
    both_are_found(&format!("speed = {SPEED}\nC = {c:?}\nK = {k:?}"));
}

#[test]
fn two_slips_are_found_behind_a_state_matrix() {
    let [[[a, b], [_, d]], c, k] = matrices();
    let determinant = a * d - b * b;
    let inverse = [[d / determinant, -b / determinant], [-b / determinant, a / determinant]];
    let lower = |with: [[f64; 2]; 2], row: usize, column: usize| {
        -(inverse[row][0] * with[0][column] + inverse[row][1] * with[1][column])
    };
    let row = |at: usize| [lower(k, at, 0), lower(k, at, 1), lower(c, at, 0), lower(c, at, 1)];
    let row = |at: usize| row(at).map(|entry| format!("{entry:.6}")).join(", ");
    both_are_found(&format!("speed = {SPEED}\nA = [[0, 0, 1, 0], [0, 0, 0, 1], [{}], [{}]]", row(0), row(1)));
}

/// The eigenvalues of `A = [0, 1; -M^-1 K, -M^-1 C]` of these matrices by NumPy (`numpy.linalg.eigvals`), with nine digits.
#[test]
fn two_slips_are_found_from_eigenvalues() {
    both_are_found(
        r#"eigenvalues = {
            "2" = ["3.11008504", "-4.05783927", "-2.50546596 ± 6.15217104i"],
            "4" = ["2.98608928", "-3.91224879", "-5.49560640 ± 15.4116353i"],
            "6" = ["2.84767165", "-4.06173973", "-8.33099519 ± 23.9043872i"],
        }"#,
    );
}
