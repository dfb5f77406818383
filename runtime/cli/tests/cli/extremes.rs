//! Numbers of extreme size: in tables, and where doubles end.

use crate::Directory;
use crate::mistakes::check_options;

#[test]
fn tables_keep_their_columns_apart() {
    let directory = Directory::new("extreme-tables");
    for arguments in [
        &["--gravity", "1e300"][..],
        &["--gravity", "1e-300"],
        &["--speeds", "1e150"],
        &["--speeds", "0:1e6:1e3"],
        &["--set", "c=-0.3", "--speeds", "0:1e6:1e5"],
    ] {
        let text = directory.run(&[&["analyze"], arguments].concat()).ok();
        assert!(text.lines().all(|line| line.chars().count() < 110), "{text}");
        for line in text.lines().filter(|line| line.contains(", at λ = ")) {
            let speed = line.trim_start().trim_start_matches(|c: char| c.is_alphabetic() || c == ' ');
            let (speed, _) = speed.split_once("  ").unwrap();
            assert!(speed.parse::<f64>().is_ok(), "`{speed}` in {line}");
        }
        for line in text.lines().skip_while(|line| !line.contains("v (m/s)")).skip(1) {
            // The speed and two modes, each with two spaces after it.
            let mut rest = line.trim_start();
            for _ in 0..3 {
                let (number, after) = rest.split_once("  ").unwrap();
                let parts = number.trim_end_matches('i').rsplit_once(['+', '-']).filter(|_| number.ends_with('i'));
                assert!(parts.map_or(number, |(re, _)| re).parse::<f64>().is_ok(), "`{number}` in {line}");
                rest = after.trim_start();
            }
        }
    }
}

#[test]
fn numbers_keep_digits_to_read() {
    let directory = Directory::new("extreme-digits");
    let text = directory.run(&["analyze", "--gravity", "1e-300"]).ok();
    // The last digits are those of rounding.
    let line = text.lines().find(|line| line.contains("two real eigenvalues")).expect("a double root");
    assert!(line.contains("2.1847477316508") && line.contains("e-151 "), "{line}");
    assert!(!text.contains("λ = 0.0000") && !text.contains("±0.0000"), "{text}");
    let text = directory.run(&["analyze", "--gravity", "1e300"]).ok();
    assert!(text.contains("at λ = 1.208e150\n"), "{text}");
    let text = directory.run(&["analyze", "--speeds", "1e150"]).ok();
    assert!(text.lines().any(|line| line.trim_start().starts_with("1e150  ")), "{text}");
}

#[test]
fn numbers_do_not_become_zero_unseen() {
    let expected = "expected a number, or an expression such as `pi/10`: the value is too small to tell from zero";
    check_options(&["--set", "mB=1e-400"], &format!("--set mB=1e-400: `mB` is `1e-400`; {expected}"));
    check_options(&["--speeds", "1e-400"], "--speeds 1e-400: a speed is `1e-400`, too small to tell from zero");
    Directory::new("zero").run(&["analyze", "--set", "IHxz=0e-400"]).ok();
}

#[test]
fn parameters_of_extreme_size_are_named_where_there_is_no_answer() {
    let directory = Directory::new("extreme-parameters");
    for setting in ["mB=1e300", "w=1e300", "mB=1e30"] {
        let run = directory.run(&["analyze", "--set", setting]);
        let hint = format!("; parameters of extreme size: {}\n", setting.replace('=', " = "));
        assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""));
        assert!(run.stderr.ends_with(&hint), "{}", run.stderr);
    }
}
