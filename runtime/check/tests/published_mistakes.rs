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

fn file(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/");
    std::fs::read_to_string(format!("{folder}{name}")).expect("a file beside the test")
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
    let report = checked("bicycle = \"browser-jason\"\ncritical_speeds = { weave = 4.99180 }");
    let all = report.explanations.iter().flat_map(|group| &group.explanations);
    let causes: Vec<&str> = all.flat_map(|own| &own.causes).map(String::as_str).collect();
    assert!(causes.iter().any(|cause| cause.starts_with("IRxx and IFxx are exchanged")), "{report}");
}

/// A public script: the height of the centre of mass with a sign and a radius wrong.
#[test]
fn two_slips_in_one_height() {
    assert_eq!(
        explained(&file("height.toml"))[0],
        "\"(-rR*mR + zB*mB + zH*mH - rF*mF)/mT\" in zT is \"(-rR*mR + zB*mB + zH*mH + rR*mF)/mT\""
    );
}

/// A public script for the motorcycle of Sharp (1971), with the sign of f wrong in both places: what he prints comes out with the
/// other one.
#[test]
fn the_sign_of_a_length_of_a_motorcycle() {
    let printed = file("sharp_1971.toml");
    assert!(checked(&printed).agrees);
    // 0.093 ft
    let causes = explained(&format!("parameters = {{ f = -0.0283464 }}\n{printed}"));
    assert_eq!(causes, ["f has the other sign (f = 0.0283464 m)"]);
}

/// A public note on the same motorcycle, with the trail along the ground: 0.38 ft / cos(0.4715) for 0.38 ft.
#[test]
fn the_trail_of_a_motorcycle() {
    let text = format!("parameters = {{ t = \"0.115824/cos(0.4715)\" }}\n{}", file("sharp_1971.toml"));
    let causes = explained(&text);
    assert_eq!(causes, ["t is perpendicular to the steer axis in the place of along the ground (t = 0.115824 m)"]);
}

/// A public script: the accelerations of lean and steer without M.
#[test]
fn accelerations_without_mass() {
    // -g K0 - v^2 K2 and -v C1 at 5 m/s, of the printed matrices.
    let text = "speed = 5\nA = [[0, 0, 1, 0], [0, 0, 0, 1], [794.12, -1889.4, 0, -169.33], [25.501, -58.478, 4.2518, -8.4270]]";
    assert_eq!(explained(text), ["accelerations are not divided by M"]);
}

/// A public script that says it follows the paper, with gyroscopic terms of its own: C1 and K2 are skew, and K0 has no S_A. That
/// is no slip, and it is said so; what is one is named.
#[test]
fn invented_terms() {
    let mine = "C1 = [[0, -8.83], [8.83, 1.68540397]]\nK2 = [[0, -8.83], [8.83, 2.65431524]]\n";
    let k0 = "K0 = [[-80.95, -2.59951685], [-2.59951685, -0.30901699]]\n";
    let report = checked(&[M, k0, mine].concat());
    let suspects = report.unexplained.expect("nothing explains it");
    assert_eq!(suspects.wrong, ["K0_22", "C1_12", "C1_21", "K2_12", "K2_21"]);
    assert_eq!(suspects.parts[0].numbers, ["K0_22"]);
    assert_eq!(suspects.parts[0].causes[0], "\"-SA*sin(lam)\" in K0_22 is \"-sin(lam)\"");
}

/// Damping and stiffness at a speed: v C1 and g K0 + v^2 K2 of the printed matrices at 5 m/s, and with a wrong sign of K0.
#[test]
fn damping_and_stiffness_at_a_speed() {
    let c = "speed = \"18 km/h\"\nC = [[0, 169.3321], [-4.251782, 8.427020]]\n";
    assert!(checked(&format!("{c}K = [[-794.1195, 1889.432], [-25.50126, 58.47756]]")).agrees);
    let causes = explained(&format!("{c}K = [[794.1195, 1940.435], [25.50126, 74.23820]]"));
    assert_eq!(causes[0], "K0 has the other sign");
}

/// State matrices at 5 m/s, computed from the printed matrices in Python, with what is said of each.
const A: &str =
    "speed = 5\nA = [[0, 0, 1, 0], [0, 0, 0, 1], [9.48977, A32, -0.527612, A34], [11.7195, A42, 18.384, A44]]";

fn state_matrix(entries: [&str; 4]) -> String {
    let names = ["A32", "A34", "A42", "A44"];
    names.iter().zip(entries).fold(A.to_owned(), |text, (name, entry)| text.replace(name, entry))
}

#[test]
fn an_entry_of_a_state_matrix() {
    let sign = state_matrix(["22.8515", "-1.65258", "-18.3841", "-15.4243"]);
    assert_eq!(explained(&sign), ["A_32 at 5 m/s has the other sign"]);
    let exchanged = state_matrix(["-22.8515", "-18.3841", "-1.65258", "-15.4243"]);
    assert_eq!(explained(&exchanged), ["A_34 at 5 m/s and A_42 at 5 m/s are exchanged"]);
    let digits = state_matrix(["-22.8515", "-1.65258", "-18.3841", "-15.2443"]);
    assert_eq!(explained(&digits), ["A_44 at 5 m/s has two digits exchanged"]);
}

/// Behind A stand C and K: of K0_12 with the other sign, and C1_22 = 1.5.
#[test]
fn the_matrices_behind_a_state_matrix() {
    let report = checked(&state_matrix(["-23.6642", "-1.76761", "-12.0551", "-11.416"]));
    let behind = report.unexplained.expect("nothing explains it").behind.expect("a state matrix");
    let expected =
        ["C_22 at 5 m/s is 7.49998 in the place of 8.42702", "K_12 at 5 m/s is 1940.44 in the place of 1889.43"];
    assert_eq!((&behind.wrong[..], behind.count), (&expected.map(str::to_owned)[..], 8));
    assert_eq!(behind.parts[0].numbers, ["K_12 at 5 m/s"]);
    assert_eq!(behind.parts[0].causes[1], "K0_12 has the other sign");
}

/// Basu-Mandal, Chatterjee & Papadopoulos (2007), Table 1: lean and steer, their rates and the spin of the rear wheel, 8.912989661489
/// rad/s, in a state far from upright, and the accelerations of lean and steer. Lean is pi/2 - psi there, steer is -psif.
const BASU_MANDAL: &str = "accelerations = { speed = \"8.9129896614890*0.3\", state = { phi = \"pi/2 - 0.9501292851472\", \
    phi_rate = -0.6068425835418, delta = -0.2311385135743, delta_rate = -0.4859824687093 }, \
    values = { phi = PHI, delta = DELTA } }";

#[test]
fn accelerations_are_checked_by_the_nonlinear_equations() {
    let of = |phi: &str, delta: &str| BASU_MANDAL.replace("PHI", phi).replace("DELTA", delta);
    let report = checked(&of("7.8555281128244", "4.6198904039403"));
    assert!(report.agrees, "{report}");
    let names = report.numbers.iter().map(|number| number.name.split(" at ").next().unwrap_or_default());
    assert_eq!(names.collect::<Vec<_>>(), ["phi'' in state 1", "delta'' in state 1"]);
    assert!(report.numbers[0].name.ends_with(" m/s by the nonlinear equations"), "{report}");
    let causes = explained(&of("7.8555281128244", "-4.6198904039403"));
    assert!(causes[0].starts_with("delta'' in state 1 at 2.67389689844"), "{causes:?}");
    assert!(causes[0].ends_with(" by the nonlinear equations has the other sign"), "{causes:?}");
    // At 5 m/s and 0.01 rad by the matrix A of the printed matrices.
    let linear = "accelerations = { speed = 5, equations = \"linear\", state = { phi = 0.01 }, values = { phi = 0.0948977, delta = 0.117195 } }";
    assert!(checked(linear).agrees);
}

/// The same linear state by other names, at the speed of the file.
#[test]
fn states_are_called_as_people_do() {
    for text in [
        "accelerations = { state = { lean = 0.01 }, values = { roll_acceleration = 0.0948977, steer = 0.117195 } }",
        "accelerations = { state = { roll = 0.01, lean_dot = 0 }, forces = { steering_torque = 0 }, values = { \"phi''\" = 0.0948977 } }",
    ] {
        let report = checked(&format!("speed = 5\n{}", text.replace("{ state", "{ equations = \"linear\", state")));
        assert!(report.agrees, "{report}");
    }
}

/// The same state and accelerations, by somebody who counts otherwise.
#[test]
fn accelerations_in_other_coordinates_are_told_as_a_whole() {
    let [phi, phi_rate] = [std::f64::consts::FRAC_PI_2 - 0.9501292851472, -0.6068425835418];
    let [delta, delta_rate] = [-0.2311385135743, -0.4859824687093];
    let right = [7.8555281128244, 4.6198904039403];
    let told = |state: [f64; 4], values: [f64; 2]| {
        let [phi, delta, phi_rate, delta_rate] = state;
        explained(&format!(
            "accelerations = {{ speed = \"8.9129896614890*0.3\", equations = \"nonlinear\", state = {{ phi = {phi:.12}, delta = {delta:.12}, \
             phi_rate = {phi_rate:.12}, delta_rate = {delta_rate:.12} }}, values = {{ phi = {:.9}, delta = {:.9} }} }}",
            values[0], values[1]
        ))
    };
    let state = [phi, delta, phi_rate, delta_rate];
    let in_degrees = |values: &[f64]| values.iter().map(|value| value.to_degrees()).collect::<Vec<_>>();
    let degrees: [f64; 4] = in_degrees(&state).try_into().expect("four");
    let accelerations: [f64; 2] = in_degrees(&right).try_into().expect("two");
    assert_eq!(told(state, accelerations), ["accelerations are in degrees/s^2"]);
    assert_eq!(told(degrees, right), ["the state is in degrees"]);
    assert_eq!(told(degrees, accelerations), ["state and accelerations are in degrees"]);
    let mirrored = told([phi, -delta, phi_rate, -delta_rate], [right[0], -right[1]]);
    // By symmetry, the same as a lean that is.
    assert_eq!(mirrored, ["phi was counted positive the other way", "delta was counted positive the other way"]);
    assert_eq!(told(state, [right[1], right[0]]), ["accelerations of phi and delta are exchanged"]);
    let exchanged = told([delta, phi, delta_rate, phi_rate], [right[1], right[0]]);
    assert_eq!(exchanged, ["phi and delta are exchanged"]);
    assert_eq!(told(state, right.map(|value| -value)), ["accelerations have the other sign"]);
}

/// Of the double pendulum, from Lagrange's equations in absolute angles by hand in Python: at 0.7 and -1.1 rad, 0.3 and 2 rad/s, and
/// with m2 = 2 kg in the place of 1.
#[test]
fn another_parameter_makes_nonlinear_accelerations() {
    let of = |values: &str| {
        format!(
            "model = \"DoublePendulum\"\naccelerations = {{ speed = 0, state = {{ theta1 = 0.7, theta2 = -1.1, \
             theta1_rate = 0.3, theta2_rate = 2 }}, values = {{ {values} }} }}"
        )
    };
    assert!(checked(&of("theta1 = 7.1201022843, theta2 = -17.5745563682")).agrees);
    // The angle of the upper link from the vertical: the sum of both.
    let absolute = "model = \"DoublePendulum\"\naccelerations = { speed = 0, state = { theta1 = 0.7, theta2 = -0.4, theta1_rate = 0.3, \
                    theta2_rate = 2.3 }, values = { theta1 = 7.1201022843, theta2 = -10.4544540839 } }";
    assert_eq!(explained(absolute), ["theta2 is theta1 + theta2 of here: it is absolute"]);
    let causes = explained(&of("theta1 = 7.0650298850, theta2 = -18.9701534780"));
    assert!(
        causes.iter().any(|cause| cause.starts_with("m2 is ") && cause.contains("(m2 = 2 kg)")
            || cause.starts_with("m2 is 2 kg in the place of 1")),
        "{causes:?}"
    );
}

#[test]
fn a_model_without_nonlinear_equations_says_so() {
    let text = "model = \"CantileveredPipe\"\naccelerations = { speed = 0, equations = \"nonlinear\", values = { first = 1 } }";
    let file = read::read("mine.toml", text.into()).expect("a file that can be read");
    let design = file.design(&Request::default()).expect("a design");
    let message = check(&file.given(&design).expect("numbers"), &design).expect_err("no such equations");
    assert_eq!(message, "the model CantileveredPipe has no nonlinear equations for accelerations");
}

/// Two slips in two formulas that are seen in the same entries: SR with `IRyy*rR` and IAxz with `+ mH`, in the formulas of
/// `mistakes.py`, to nine digits.
const TWO_SLIPS: &str = "M = [[80.81722, 2.3781071], [2.3781071, 0.336961707]]
C1 = [[0, 33.8392622], [-0.823204683, 1.70318571]]
K0 = [[-80.95, -2.59951685], [-2.59951685, -0.803294885]]
K2 = [[0, 76.2579493], [0, 2.65431524]]";

#[test]
fn two_slips_at_once() {
    let causes = explained(TWO_SLIPS);
    let [sr, iaxz] =
        ["\"IRyy/rR\" in SR is \"IRyy*rR\"", "\"- mH*(xH - xA)*(zH - zA)\" in IAxz is \"+ mH*(xH - xA)*(zH - zA)\""];
    assert!(causes[0].contains(sr) && causes[0].contains(iaxz), "{causes:?}");
}
