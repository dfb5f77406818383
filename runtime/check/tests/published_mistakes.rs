//! Mistakes that were made in public, each as somebody with it would have his numbers: they must be found.
//!
//! The numbers come from the formulas of Meijaard, Papadopoulos, Ruina & Schwab (2007) with the mistake, evaluated at 30 digits
//! by mpmath (`mistakes.py` beside this), or are printed where the mistake was found.

use carvallo_check::{Report, check, read};
use carvallo_design::input::Request;

fn checked(text: &str) -> Report {
    let file = read::read("mine.toml", text.into()).expect("a file that can be read");
    let design = file.design(&Request::default()).expect("a design");
    check(&file.given(&design).expect("numbers"), &design).expect("a report")
}

/// The causes of the first group.
#[track_caller]
fn explained(text: &str) -> Vec<String> {
    let report = checked(text);
    assert!(!report.agrees, "{report}");
    let first = report.explanations.first().unwrap_or_else(|| panic!("nothing explains it:\n{report}"));
    first.explanations.iter().map(|own| own.causes.join(", and ")).collect()
}

const M: &str = "M = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]]\n";
const C1: &str = "C1 = [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]]\n";
const K0: &str = "K0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]]\n";
const K2: &str = "K2 = [[0, 76.59734589573222], [0, 2.65431523794604]]\n";

#[test]
fn the_published_matrices_agree() {
    let report = checked(&[M, C1, K0, K2].concat());
    assert!(report.agrees, "{report}");
    assert_eq!(report.numbers.len(), 16);
}

/// A public MATLAB script: K2 = [K2phiphi K2delphi; K2delphi K2deldel].
#[test]
fn a_corner_of_k2() {
    let causes = explained(&[M, C1, K0, "K2 = [[0, 0], [0, 2.65431523794604]]"].concat());
    assert_eq!(causes[0], "K2 was filled row by column: K2_12 has the value of K2_21");
}

/// A public replication of the paper, with IBxx = 19.2: by its matrices, and by its weave speed.
#[test]
fn a_digit_too_many() {
    let expected = ["IBxx is 19.2 kg m² in the place of 9.2: one digit too many"];
    let m = "M = [[90.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]]\n";
    assert_eq!(explained(&[m, C1, K0, K2].concat()), expected);
    assert_eq!(explained("critical_speeds = { weave = 3.9607, capsize = 6.0243 }"), expected);
}

/// A public script, with mH = 4.5 and IHxx = 0.0589.
#[test]
fn another_mass() {
    assert_eq!(explained("critical_speeds = { weave = 4.3014, capsize = 6.0809 }"), ["mH is 4.5 kg in the place of 4"]);
}

/// A bicycle of BicycleParameters, with the inertias of its wheels exchanged: 4.99781 m/s, and 4.99180 as measured.
#[test]
fn exchanged_wheels() {
    let text = "bicycle = \"browser-jason\"\ncritical_speeds = { weave = 4.99180 }\nM = [[-1, -1], [-1, -1]]";
    let report = checked(&text.replace("M = [[-1, -1], [-1, -1]]", ""));
    let all = report.explanations.iter().flat_map(|group| &group.explanations);
    let causes: Vec<&str> = all.flat_map(|own| &own.causes).map(String::as_str).collect();
    assert!(causes.iter().any(|cause| cause.starts_with("IRxx and IFxx are exchanged")), "{report}");
}

/// A public script: the height of the centre of mass with a sign and a radius wrong.
#[test]
fn two_slips_in_one_height() {
    let text = &std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/height.toml")).expect("a file");
    assert_eq!(
        explained(text)[0],
        "\"(-rR*mR + zB*mB + zH*mH - rF*mF)/mT\" in zT is \"(-rR*mR + zB*mB + zH*mH + rR*mF)/mT\""
    );
}
