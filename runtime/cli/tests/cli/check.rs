//! Somebody's numbers against those of the program. The matrices are those that are printed in Meijaard, Papadopoulos, Ruina &
//! Schwab (2007), rounded.

use crate::Directory;

const MATRICES: &str = "M = [[80.817, 2.3194], [2.3194, 0.29784]]
C1 = [[0, 33.866], [-0.85036, 1.6854]]
K0 = [[-80.95, -2.5995], [-2.5995, -0.80329]]
K2 = [[0, 76.597], [0, 2.6543]]
";

#[test]
fn numbers_that_agree_are_told_with_their_digits() {
    let directory = Directory::of_this_test();
    let text = directory.write("mine.toml", MATRICES).run(&["check", "mine.toml"]).ok();
    assert!(text.contains("\n  C1_21   kg m   -0.85036  -0.85035641  all 5\n"), "{text}");
    assert!(text.ends_with("\nAll 16 numbers agree to all digits given.\n"), "{text}");
}

#[test]
fn a_slip_is_named_and_the_exit_code_is_one() {
    let directory = Directory::of_this_test();
    let corner = MATRICES.replace("[0, 76.597]", "[0, 0]");
    let run = directory.write("mine.toml", corner).run(&["check", "mine.toml"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(1), ""));
    let expected = "1 of 16 numbers does not agree.

All come out as yours if
  K2 was filled row by column: K2_12 has the value of K2_21
";
    assert!(run.stdout.contains(expected), "{}", run.stdout);
}

/// What is far too large says nothing of the rounding of what stands beside it.
#[test]
fn wrong_numbers_do_not_agree_beside_enormous_ones() {
    let directory = Directory::of_this_test();
    for file in ["M = [[1e20, 2], [3, 4]]", "critical_speeds = { weave = 9e19, capsize = 9 }"] {
        let run = directory.write("mine.toml", file).run(&["check", "mine.toml", "--format", "csv"]);
        let last = run.stdout.lines().last().unwrap_or_default();
        assert!(run.code == Some(1) && last.ends_with(",false"), "{}", run.stdout);
    }
}

/// Of Meijaard et al. (2007): the eigenvalues at 5 m/s of Table 2, -14.07838969279822, -0.32286642900409 and
/// -0.77534188219585 ± 4.46486771378823i, and the matrices, with digits cut off.
#[test]
fn numbers_that_are_cut_off_are_told_so() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "speed = 5\neigenvalues = [-14.078, -0.322, \"-0.775+4.464i\"]");
    let run = directory.run(&["check", "mine.toml"]);
    let expected = "2 of 6 numbers are cut off, not rounded:
  -0.322 is -0.322866 cut off; rounded it is -0.323

All others agree to all digits given.
";
    assert!(run.code == Some(1) && run.stdout.ends_with(expected), "{}", run.stdout);

    directory.write("one.toml", MATRICES.replace("76.597", "76.59"));
    let run = directory.run(&["check", "one.toml"]);
    assert!(
        run.stdout
            .contains("1 of 16 numbers is cut off, not rounded:\n  76.59 is 76.5973 cut off; rounded it is 76.60\n"),
        "{}",
        run.stdout
    );
}

#[test]
fn a_slip_is_named_of_numbers_that_are_cut_off() {
    let directory = Directory::of_this_test();
    let cut = "M = [[80.81, 2.31], [2.31, 0.297]]\nC1 = [[0, 33.86], [-0.850, 1.685]]\nK2 = [[0, 0], [0, 2.65]]";
    let run = directory.write("mine.toml", cut).run(&["check", "mine.toml"]);
    let expected = "1 of 12 numbers does not agree.

All come out as yours if
  K2 was filled row by column: K2_12 has the value of K2_21
";
    assert!(run.stdout.contains(expected), "{}", run.stdout);
    assert!(run.stdout.contains("5 of 12 numbers are cut off, not rounded:\n  80.81 is 80.8172"), "{}", run.stdout);
}

#[test]
fn json_has_everything() {
    let directory = Directory::of_this_test();
    directory.write("mine.json", r#"{"critical_speeds": {"weave": 3.9607, "capsize": "6.0243"}}"#);
    let run = directory.run(&["check", "mine.json", "--format", "json"]);
    assert_eq!(run.code, Some(1));
    let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(json["agrees"], false);
    assert_eq!(json["numbers"][1]["name"], "capsize speed");
    assert_eq!(json["numbers"][1]["digits"], 5);
    let first = &json["explanations"][0]["explanations"][0]["causes"][0];
    assert_eq!(first, "IBxx is 19.2 kg m² in the place of 9.2: one digit too many");
}

#[test]
fn csv_has_the_numbers() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "critical_speeds = { weave = 3.9607, capsize = \"6.0243\" }");
    let run = directory.run(&["check", "mine.toml", "--format", "csv"]);
    assert_eq!(run.code, Some(1));
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines[0], "number,unit,yours,ours,digits,agrees");
    // Meijaard et al. (2007), Table 2, has 4.29238253634111 and 6.02426201538837.
    assert!(
        lines[1].starts_with("weave speed,m/s,3.9607,4.29238253634") && lines[1].ends_with(",1,false"),
        "{lines:?}"
    );
    assert!(
        lines[2].starts_with("capsize speed,m/s,6.0243,6.0242620153") && lines[2].ends_with(",5,true"),
        "{lines:?}"
    );
}

/// Meijaard et al. (2007), the benchmark: K2 has zeros, of which no digit can be the first.
#[test]
fn zeros_have_no_digits_to_trust() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "digits = 4\nK2 = [[0, 76.59734589573222], [0, 2.65431523794604]]");
    let text = directory.run(&["check", "mine.toml"]).ok();
    assert!(text.contains("\nAll 4 numbers agree"), "{text}");
}

#[test]
fn no_more_digits_are_told_than_are_trusted() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "digits = 3\nM = [[80.82, 2.319], [2.319, 0.2979]]");
    let text = directory.run(&["check", "mine.toml"]).ok();
    assert!(text.contains("\n  M_11    kg m²   80.82    80.8172  all 3\n"), "{text}");
}

#[test]
fn tolerances_are_not_negative() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "M = [[\"80.8 +/- -0.1\", 2.3194], [{ value = 2.3, tolerance = -1 }, 0.29784]]");
    let run = directory.run(&["check", "mine.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("`80.8 +/- -0.1`") && run.stderr.contains("the tolerance is -0.1; expected one >= 0"));
    let expected = "mine.toml:1: the tolerance of `M` in row 2, column 1 is -1; expected one >= 0\n";
    assert!(run.stderr.ends_with(expected), "{}", run.stderr);
}

/// Of a closed loop: what the program prints of it agrees with the law in the file, and with the wrong sign it is that.
#[test]
fn a_closed_loop_has_its_feedback_checked() {
    let directory = Directory::of_this_test();
    let law = ["--feedback", "Tdelta = -10*phi_rate + 3*v*delta"];
    let json = directory.run(&[&["analyze", "--format", "json", "--speeds", "3,5"][..], &law].concat()).stdout;
    directory.write("closed.json", json);
    let text = directory.run(&["check", "closed.json"]).ok();
    assert!(text.starts_with("Held against benchmark with feedback, by the equations of Whipple\n"), "{text}");
    let other = ["check", "closed.json", "--feedback", "Tdelta = 10*phi_rate - 3*v*delta"];
    let run = directory.run(&other);
    let expected = "\nAll come out as yours if\n  the feedback has the other sign\n";
    assert!(run.code == Some(1) && run.stdout.ends_with(expected), "{}", run.stdout);
    let run = directory.run(&["check", "closed.json", "--feedback", "Tdelta = 10*phi_rate + 3*v*delta"]);
    let expected = "\nAll come out as yours if\n  \"10*phi_rate\" in Tdelta has the other sign\n";
    assert!(run.code == Some(1) && run.stdout.ends_with(expected), "{}", run.stdout);
    // -M_12 is -2.3194, and what is fed back takes 3 from the entry.
    let one = r#"{"bicycle": "benchmark", "feedback": "Tdelta = -10*phi_rate + 3*phi", "Kc": [[0, 0], [-5.3194, 0]]}"#;
    let run = directory.run_with_input(&["check", "-"], one);
    assert!(run.stdout.contains("Kc_21 has the value of -M_12, before the loop is closed\n"), "{}", run.stdout);
}

/// C1_21 = -(mu ST + SF cos lam) of Meijaard et al. (2007) is -0.85036, with SF = 0.28/0.35 and lam = 18 deg: with half of the
/// second term -0.46993. What is fed back takes -10 from it, which makes 9.53007.
#[test]
fn causes_are_those_of_the_open_loop_and_numbers_those_of_the_closed_one() {
    let directory = Directory::of_this_test();
    let file = "feedback = \"Tdelta = -10*v*phi_rate\"\nC1 = [[0, 33.866], [9.5, 1.6854]]";
    let run = directory.run_with_input(&["check", "-"], file);
    assert!(run.stdout.contains("C1_21   kg m     9.5   9.14964  1, differs\n"), "{}", run.stdout);
    let cause = "  \"-(mu*ST + SF*cos(lam))\" in C1_21 is \"-(mu*ST + SF*cos(lam)/2)\", before the loop is closed\n";
    assert!(run.stdout.contains(cause), "{}", run.stdout);
    // What would tell is of the closed loop, as the number that was given.
    let tells: Vec<&str> = run.stdout.split("C1_21 with more digits: ").skip(1).collect();
    assert!(!tells.is_empty() && tells.iter().all(|text| text.starts_with("9.")), "{}", run.stdout);

    // Nothing explains 5: the formula is told with what is taken from it, and the term.
    let file = "feedback = [\"Tdelta = -10*v*phi_rate\", \"Tphi = 2*phi\"]\nKc = [[-5.123456, 0], [0, 0]]\nC1 = [[0, 33.866], [9.1496436, 1.6854]]";
    let run = directory.run_with_input(&["check", "-"], file);
    let expected = "and nothing that agrees does:\n    Kc_11 = 0, less \"2*phi\" of Tphi\n    \"2*phi\" of Tphi\n";
    assert!(run.stdout.contains(expected), "{}", run.stdout);
}

/// 4.29238253634111 and 6.02426201538837 m/s of Meijaard et al. (2007) times 3.6; the factor with the fewest digits is not
/// 1/3.6, and differs from it in the sixth.
#[test]
fn numbers_that_would_tell_explanations_apart_are_not_equal() {
    let directory = Directory::of_this_test();
    for digits in [5, 7, 8] {
        let [weave, capsize] =
            [4.29238253634111, 6.02426201538837].map(|speed: f64| format!("{:.digits$}", 3.6 * speed));
        let file = format!("critical_speeds = {{ weave = \"{weave}\", capsize = \"{capsize}\" }}");
        let text = directory.run_with_input(&["check", "-"], &file).stdout;
        assert!(text.contains("\n  speeds are in km/h in the place of m/s\n"), "{text}");
        for told in text.lines().filter_map(|line| line.trim().strip_prefix("What would tell: ")) {
            let both: Vec<&str> =
                told.split([' ', ':']).filter(|word| word.starts_with(|c: char| c.is_ascii_digit())).collect();
            assert!(both.len() == 2 && both[0] != both[1], "{told}");
        }
    }
}

/// Two causes in matrices of four digits, by the formulas of the hose with l = 0.5 m and f = 0.3 kg/m: of what several entries
/// share, C1_12 = C1_13 = C1_23 = 2 f l^2 = 0.15 without the factor 2, and K2_13 = K2_23 = f l = 0.15 with the other sign; and
/// K0_22 = 3/2 (m + f) l^2 = 0.1875 with the other sign beside f l without l.
#[test]
fn two_causes_are_found_of_entries_that_share_a_formula() {
    let directory = Directory::of_this_test();
    let file = |c: &str, k0: &str, k2: &str| {
        format!(
            "model = \"ThreePipes\"
M = [[0.1458, 0.09375, 0.03125], [0.09375, 0.08333, 0.03125], [0.03125, 0.03125, 0.02083]]
C1 = [[0.075, {c}, {c}], [0, 0.075, {c}], [0, 0, 0.075]]
K0 = [[0.3125, 0, 0], [0, {k0}, 0], [0, 0, 0.0625]]
K2 = [[-0.15, 0, {k2}], [0, -0.15, {k2}], [0, 0, 0]]"
        )
    };
    let text = directory.run_with_input(&["check", "-"], &file("0.075", "0.1875", "-0.15")).stdout;
    let expected = "All come out as yours if
  \"2*f*l^2\" in C1_12 and C1_13 and C1_23 is \"f*l^2\",
    and \"f*l\" in K2_13 and K2_23 is \"-f*l\"
";
    assert!(text.contains(expected), "{text}");
    let text = directory.run_with_input(&["check", "-"], &file("0.15", "-0.1875", "0.3")).stdout;
    assert!(text.contains("K0_22 has the other sign,\n    and \"f*l\" in K2_13 and K2_23 is \"f\"\n"), "{text}");
}

#[test]
fn reports_are_in_the_units_that_are_asked_for() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "critical_speeds = { weave = 4.3014, capsize = 6.0809 }");
    let run = directory.run(&["check", "mine.toml", "--units", "km/h,lb"]);
    // 4.3014 and, of Meijaard et al. (2007), 4.29238253634111 m/s times 3.6; 4.5 and 4 kg by 0.45359237.
    assert!(run.stdout.contains("  weave speed    km/h  15.485  15.45258  2, differs\n"), "{}", run.stdout);
    assert!(run.stdout.contains("mH is 9.920801798 lb in the place of 8.818490487"), "{}", run.stdout);
    // 33.86641391492494 kg m of the paper, by 0.45359237 kg and 0.0254 m.
    directory.write("matrix.toml", "C1 = [[0, 33.866], [-0.85036, 1.6854]]");
    let text = directory.run(&["check", "matrix.toml", "--units", "imperial"]).ok();
    assert!(text.contains("  C1_12   lb in   2939.4   2939.475  all 5\n"), "{text}");
    let message = "error: --units: JSON and CSV of this command are in units of the SI\n";
    directory.run(&["check", "mine.toml", "--units", "km/h", "--format", "csv"]).fails(2, message);
}

/// Of each kind of model: with the positions and rates of two coordinates, of six, with rates alone, and without a speed.
#[test]
fn what_the_program_prints_agrees_with_it() {
    let directory = Directory::of_this_test();
    let models =
        [&["--model", "Motorcycle", "--speeds", "5,10"][..], &["--model", "Car"], &["--model", "DoublePendulum"]];
    for arguments in [&["pista"][..]].into_iter().chain(models) {
        let json = directory.run(&[&["analyze", "--format", "json"], arguments].concat());
        let run = directory.run_with_input(&["check", "-"], &json.stdout);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{arguments:?}: {}", run.stdout);
    }
}

#[test]
fn what_is_not_understood_is_told_with_its_line() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", "M = [[1, 2], [3, four]]\n");
    assert_eq!(directory.run(&["check", "mine.toml"]).code, Some(2));
    directory.write("mine.toml", "eigenvalue = [1]\nM = [[1, \"two\"], [3, 4]]\n");
    let run = directory.run(&["check", "mine.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(
        run.stderr.contains("mine.toml:1: `eigenvalue` is not known in a file to check; expected M, "),
        "{}",
        run.stderr
    );
    assert!(run.stderr.contains("did you mean `eigenvalues`?"), "{}", run.stderr);
    assert!(run.stderr.contains("mine.toml:2: `M` in row 1, column 2 is `two`; expected a number"), "{}", run.stderr);
    directory.write("mine.toml", "M = [[1, 2, 3], [3, 4, 5]]\n");
    directory
        .run(&["check", "mine.toml"])
        .fails(2, "error: a row of M has 3 numbers; expected 2, one for each coordinate\n");
    directory.write("mine.toml", "A = [[1, 2], [3, 4]]\n");
    let message = "error: mine.toml:1: `A` has no speed; expected `speed` in m/s beside it\n";
    directory.run(&["check", "mine.toml"]).fails(2, message);
    directory.write("mine.toml", "name = \"mine\"\n");
    let run = directory.run(&["check", "mine.toml"]);
    assert!(run.stderr.contains("there are no numbers to check"), "{}", run.stderr);
    assert_eq!(directory.run(&["check", "nowhere.toml"]).code, Some(2));
}
