//! What files say that is not whole: numbers that are not known, rows that are too long, names that look like others.

use carvallo_check::{Report, check, read};
use carvallo_design::input::Request;

fn report(name: &str, text: &str) -> Result<Report, String> {
    let file = read::read(name, text.into()).map_err(|failure| failure.to_string())?;
    let design = file.design(&Request::default()).map_err(|failure| failure.to_string())?;
    let given = file.given(&design).map_err(|failure| failure.to_string())?;
    check(&given, &design)
}

/// The numbers are those of the paper (2007), Appendix 2, and Table 2.
#[test]
fn what_is_not_known_is_named() {
    let json = r#"{
        "M": [[80.81722, null], ["?", 0.29784188199686]],
        "eigenvalues": {"5": [-14.07838969279822, null]},
        "critical_speeds": {"weave": null, "capsize": 6.0242620153883},
        "accelerations": {"speed": 0, "state": {"phi": 0}, "values": {"phi": 0, "delta": null}}
    }"#;
    let found = report("mine.json", json).expect("a report");
    let named = ["M_12", "M_21", "an eigenvalue at 5 m/s", "weave speed", "delta'' in state 1 at 0 m/s"];
    assert_eq!((found.agrees, &found.unknown[..]), (true, &named.map(str::to_owned)[..]));
    let told = format!("Not known, and not compared, are {}.\n", named.join(", "));
    assert!(found.to_string().contains(&told), "{found}");
    assert!(found.json().contains("\"unknown\": [\n    \"M_12\",\n"), "{}", found.json());
}

#[test]
fn what_accelerations_are_in_is_known() {
    let json =
        r#"{"accelerations": {"speed": 5, "state": {"phi": null}, "forces": {"delta": "?"}, "values": {"phi": 1}}}"#;
    let message = report("mine.json", json).expect_err("an error");
    for name in ["phi", "delta"] {
        let told = format!("`{name}` is not known; accelerations are those of one number, such as 0");
        assert!(message.contains(&told), "{message}");
    }
}

#[test]
fn a_row_of_another_length_is_named() {
    let of = |text: &str| report("mine.json", text).expect_err("an error");
    assert_eq!(of(r#"{"M": [[1, 2], [3, 4, 5]]}"#), "row 2 of M has 3 numbers; expected 2, one for each coordinate");
    assert_eq!(of(r#"{"K0": [[1], [3, 4]]}"#), "row 1 of K0 has 1 number; expected 2, one for each coordinate");
    let states = "row 4 of A has 3 numbers; expected 4, one for each state: phi, delta, phi_rate, delta_rate in this \
                  order, rates before positions, or each position with its rate";
    let matrix = r#"{"speed": 5, "A": [[0, 0, 1, 0], [0, 0, 0, 1], [9, 1, 1, 1], [1, 1, 1]]}"#;
    assert_eq!(of(matrix), states);
}

#[test]
fn letters_that_look_like_digits_have_a_hint() {
    for (name, meant) in [("KO", "K0"), ("Ko", "K0"), ("Cl", "C1"), ("CI", "C1")] {
        let message = report("mine.json", &format!(r#"{{"{name}": [[1, 2], [3, 4]]}}"#)).expect_err("an error");
        assert!(message.ends_with(&format!("; did you mean `{meant}`?")), "{name}: {message}");
    }
}

#[test]
fn a_list_in_the_place_of_tables_is_told_once() {
    let message = report("mine.json", r#"{"speed": 5, "accelerations": [1, 2]}"#).expect_err("an error");
    assert_eq!(message, "mine.json:1: `accelerations` has no tables; expected `speed`, `state` and `values` in each");
}
