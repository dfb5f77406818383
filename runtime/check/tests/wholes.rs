//! Matrices of the benchmark bicycle that are otherwise as a whole: in other units, with the speed or g in them, under the key of another
//! one, with one angle in degrees; and eigenvalues in hertz. The matrices are those that are printed in Meijaard, Papadopoulos, Ruina &
//! Schwab (2007), section 5, and units those of the international yard and pound agreement (1959) and of the SI.

mod benchmark;

use std::f64::consts::PI;
use std::sync::OnceLock;

use benchmark::{C1, K0, K2, M, Matrix, SPEED, causes, numbers, written};
use carvallo_check::machine::Machine;
use carvallo_check::{Report, check, check_machine, read};
use carvallo_design::input::Request;

/// The bicycle, of which everything that may be mistaken is made once.
fn checked(text: &str) -> Report {
    static MACHINE: OnceLock<Machine> = OnceLock::new();
    let file = read::read("mine.toml", text.into()).expect("a file that can be read");
    let design = file.design(&Request::default()).expect("a design");
    let machine = MACHINE.get_or_init(|| Machine::new(&design).expect("formulas"));
    check_machine(&file.given(&design).expect("numbers"), machine).expect("a report")
}

/// With twelve digits, or with fewer.
fn matrices(all: &[(&str, Matrix)], digits: usize) -> String {
    let row = |row: [f64; 2]| format!("[{:.digits$e}, {:.digits$e}]", row[0], row[1]);
    let matrix = |(name, rows): &(&str, Matrix)| format!("{name} = [{}, {}]\n", row(rows[0]), row(rows[1]));
    all.iter().map(matrix).collect()
}

fn times(factor: f64, matrix: Matrix) -> Matrix {
    matrix.map(|row| row.map(|entry| factor * entry))
}

/// M, C1, K0 and K2 times a factor each.
fn scaled(m: f64, c1: f64, k0: f64, k2: f64) -> [(&'static str, Matrix); 4] {
    [("M", times(m, M)), ("C1", times(c1, C1)), ("K0", times(k0, K0)), ("K2", times(k2, K2))]
}

/// The only explanation.
#[track_caller]
fn only(text: &str, expected: &str) {
    let report = checked(text);
    assert_eq!(causes(&report), [expected], "{report}");
}

#[test]
fn a_factor_of_all_matrices_is_one_cause() {
    let all = |factor: f64| scaled(factor, factor, factor, factor);
    let (pound, inch) = (0.45359237, 0.0254);
    for (factor, expected) in [
        (2.20462, "multiplied by 2.20462, as for lb in the place of kg"),
        (2.2, "multiplied by 2.2, as for lb in the place of kg"),
        (1.0 / (pound * inch * inch), "multiplied by 3417.17, as for lb*in^2 in the place of kg*m^2"),
        (1e6, "multiplied by 1000000, as for kg*mm^2 in the place of kg*m^2"),
        (1.0 / 9.80665, "multiplied by 0.101972, as for kgf in the place of N"),
        (12.5, "multiplied by 12.5"),
        (1.0 / 7.0, "divided by 7"),
    ] {
        only(&matrices(&all(factor), 11), &format!("all matrices are {expected}"));
    }
    // One matrix, or M with C and K at a speed.
    only(&matrices(&all(2.20462)[..1], 11), "all matrices are multiplied by 2.20462, as for lb in the place of kg");
    let of_speed = [
        ("M", M),
        ("C", times(SPEED, C1)),
        ("K", [0, 1].map(|row| [0, 1].map(|at| K0[row][at] * 9.81 + 25.0 * K2[row][at]))),
    ];
    let text = matrices(&of_speed.map(|(name, own)| (name, times(1e7, own))), 11);
    let expected = "all matrices are multiplied by 10000000, as for g*cm^2 in the place of kg*m^2";
    only(&format!("speed = {SPEED}\n{text}"), expected);
    let mut wrong = all(12.5);
    wrong[3].1[1][1] *= 1.01;
    let report = checked(&matrices(&wrong, 11));
    assert!(!causes(&report).iter().any(|own| own.contains("12.5")), "{report}");
}

/// Lengths in mm make kg m^2 a million times as large, m/s and N/kg a thousand times.
#[test]
fn lengths_in_another_unit_are_one_cause() {
    let [mm, inch] = [1e3, 1.0 / 0.0254];
    let pound = 1.0 / 0.45359237;
    let all = "lengths are in mm in the place of m, in g and speeds as well";
    only(&matrices(&scaled(mm * mm, mm, mm, 1.0), 11), all);
    let all = "lengths are in inches, in g and speeds as well, and masses in lb";
    only(&matrices(&scaled(pound * inch * inch, pound * inch, pound * inch, pound), 11), all);
}

#[test]
fn the_speed_in_matrices_is_one_cause() {
    for digits in [11, 3] {
        only(
            &matrices(&scaled(1.0, 5.0, 1.0, 25.0), digits),
            "the speed is in the matrices, as 5 m/s: they are multiplied already",
        );
    }
    let of_one = |c1: f64, k2: f64| matrices(&scaled(1.0, c1, 1.0, k2), 11);
    only(&of_one(5.0, 1.0), "the speed is in C1, as 5 m/s: it is multiplied already");
    only(&of_one(1.0, 30.25), "the speed is in K2, as 5.5 m/s: it is multiplied already");
    // No bicycle goes at 100 or 1000 m/s: C1 is in cm or mm; and g is no speed.
    for factor in [100.0, 1000.0, 9.81] {
        let report = checked(&of_one(factor, 1.0)).to_string();
        assert!(!report.contains("the speed is in"), "C1 times {factor}: {report}");
    }
}

/// The standard acceleration, and the bicycle's 9.81.
#[test]
fn another_g_inside_of_k0_is_told_as_that() {
    for (gravity, digits) in [(9.80665, 11), (9.80665, 4), (9.8, 4)] {
        let expected = format!("g is in K0, as {gravity} N/kg in the place of 9.81: it is multiplied already");
        only(&matrices(&scaled(1.0, 1.0, gravity, 1.0), digits), &expected);
    }
    only(&matrices(&scaled(1.0, 1.0, 9.81, 1.0), 11), "g is in K0: it is multiplied already");
}

#[test]
fn a_matrix_under_the_key_of_another_one_is_told_as_a_whole() {
    let under = |all: &[(&str, Matrix)], expected: &str| only(&matrices(all, 11), expected);
    under(&[("M", M), ("C1", C1), ("Kc", K0), ("K2", K2)], "K0 stands under Kc");
    under(&[("M", M), ("C1", C1), ("Kc", times(9.81, K0)), ("K2", K2)], "g*K0 stands under Kc");
    under(&[("M", M), ("C0", C1), ("K0", K0), ("K2", K2)], "C1 stands under C0");
    under(&[("M", M), ("C1", K0), ("K0", K0), ("K2", K2)], "K0 stands under C1");
    let exchanged = "C1 and K2 are exchanged: each stands under the other";
    under(&[("M", M), ("C1", K2), ("K0", K0), ("K2", C1)], exchanged);
}

/// Of a pendulum M = m l^2, C0 = c and K0 = m l.
#[test]
fn numbers_of_one_coordinate_are_exchanged_as_well() {
    let pendulum = "model = \"Pendulum\"\nparameters = { m = 2, l = 1.5, c = 0.3, g = 9.81 }\n";
    let file = |matrices: &str| read::read("mine.toml", format!("{pendulum}{matrices}").into()).expect("a file");
    for (matrices, expected) in [
        ("M = 3.0000\nC0 = 0.30000\nK0 = 4.5000", "M and K0 are exchanged: each stands under the other"),
        ("M = 4.5000\nC0 = 0.30000\nKc = 3.0000", "K0 stands under Kc"),
    ] {
        let file = file(matrices);
        let design = file.design(&Request::default()).expect("a design");
        let report = check(&file.given(&design).expect("numbers"), &design).expect("a report");
        assert_eq!(causes(&report), [expected], "{report}");
    }
}

/// With q in degrees its column is by pi/180 smaller, and with its equation by degree its row as well.
#[test]
fn one_angle_in_degrees_is_one_cause() {
    let degree = PI / 180.0;
    let column = |own: Matrix| own.map(|row| [row[0], degree * row[1]]);
    let both = |own: Matrix| [column(own)[0], column(own)[1].map(|entry| degree * entry)];
    let all = |change: &dyn Fn(Matrix) -> Matrix| {
        matrices(&[("M", M), ("C1", C1), ("K0", K0), ("K2", K2)].map(|(name, own)| (name, change(own))), 11)
    };
    only(&all(&column), "steer is in degrees");
    only(&all(&both), "steer is in degrees, and so was its equation");
    // Of a state matrix it is the same whether one is in degrees or the other one was taken for degrees.
    let units = [1.0, 1.0 / degree, 1.0, 1.0 / degree];
    let right = numbers(SPEED, |_, _, _| {});
    let rows = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| right[row][column] * units[row] / units[column]));
    let report = checked(&format!("speed = {SPEED}\nA = {}", written(rows, &|entry| format!("{entry:.9e}"))));
    let told = ["steer is in degrees", "lean in rad was taken for degrees and converted"];
    assert_eq!(causes(&report), told, "{report}");
}

/// Table 2 of the paper, at 5 m/s.
#[test]
fn eigenvalues_in_hertz_or_degrees_are_one_cause() {
    let weave = [-0.77534188219585, 4.46486771378823];
    let real = [-0.32286642900409, -14.07838969279822];
    for (factor, unit) in [(0.5 / PI, "Hz"), (180.0 / PI, "degrees per second")] {
        for (of_real, what) in [(factor, "eigenvalues"), (1.0, "imaginary parts of eigenvalues")] {
            let [re, im] = [of_real * weave[0], factor * weave[1]];
            let [capsize, castering] = real.map(|own| of_real * own);
            let text = format!(
                "speed = 5\neigenvalues = [\"{re:.8}+{im:.8}i\", \"{re:.8}-{im:.8}i\", {capsize:.8}, {castering:.8}]"
            );
            only(&text, &format!("{what} are in {unit} in the place of 1/s"));
        }
    }
    let parts = [weave[0], real[0], real[1]].map(|own| format!("{:.8}", own / (2.0 * PI))).join(", ");
    only(&format!("speed = 5\neigenvalues = [{parts}]"), "eigenvalues are in Hz in the place of 1/s");
}
