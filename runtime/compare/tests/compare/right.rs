//! Functions by hand that are right.

use carvallo::{Model, Number, Rows};
use carvallo_compare::{AssemblyError, Comparison, Limits, NotCounted, compare};
use carvallo_models::{Pendulum, PendulumMatrices, Whipple};

fn by_hand<T: Number>(p: &Pendulum<T>) -> PendulumMatrices<T> {
    let Pendulum { m, l, c, .. } = *p;
    PendulumMatrices { m: Rows([[m * l * l]]), c0: Rows([[c]]), k0: Rows([[m * l]]) }
}

fn in_double(p: &Pendulum) -> PendulumMatrices {
    by_hand(p)
}

carvallo_compare::test!(Pendulum, by_hand);
carvallo_compare::test!(Pendulum, in_double: f64, Limits { ulps: 2.0, ..Limits::default() });

#[test]
fn operations_and_errors_are_told() {
    let report = compare!(Pendulum, by_hand).report().expect("designs");
    let [generated, hand] = &report.sides[..] else { panic!("two sides") };
    // m l, and that times l; by hand m l twice.
    assert_eq!(generated.operations.map(|all| (all.multiplications, all.total())), Some((2, 2)));
    assert_eq!(hand.operations.map(|all| all.total()), Some(3));
    for side in [generated, hand] {
        let single = side.single.as_ref().expect("a function in `f32`");
        // Two roundings of half a unit, of a value that may be just above a power of two.
        assert!(side.double.ulps > 0.0 && side.double.ulps <= 2.0, "{report}");
        assert!(single.ulps > 0.0 && single.ulps <= 2.0, "{report}");
    }
    assert_eq!(report.designs, 501);
}

#[test]
fn the_report_is_data() {
    let report = compare!(Pendulum, in_double: f64).random_designs(10).report().expect("designs");
    let json: serde_json::Value = serde_json::from_str(&report.to_json()).expect("JSON");
    assert_eq!(json["model"], "Pendulum");
    assert_eq!(json["parameters"], serde_json::json!(["m", "l", "c", "g"]));
    assert_eq!(json["reference"], "formulas");
    assert_eq!(json["sides"][1]["name"], "in_double");
    assert_eq!(json["sides"][1]["operations"], serde_json::Value::Null);
    assert!(json["sides"][1]["double"]["ulps"].as_f64().expect("a number") <= 2.0);
}

#[test]
fn the_code_of_both_is_shown() {
    let assembly = match compare!(Pendulum, by_hand).assembly() {
        Err(AssemblyError::NoObjdump) => return,
        assembly => assembly.expect("a program with names"),
    };
    let names: Vec<_> = assembly.listings.iter().map(|listing| (listing.name.as_str(), listing.scalar)).collect();
    assert_eq!(names, [("generated", "f64"), ("by_hand", "f64"), ("generated", "f32"), ("by_hand", "f32")]);
    for listing in &assembly.listings {
        assert!(!listing.instructions.is_empty(), "{assembly}");
        // Functions end so, whatever is done before.
        #[cfg(target_arch = "x86_64")]
        assert!(listing.mnemonics().contains_key("ret"), "{assembly}");
    }
}

/// A function that does the same twice executes more than once and less than three times as many instructions; loops and what comes
/// with them are in both.
#[test]
fn executed_instructions_are_counted() {
    fn twice(p: &Whipple) -> carvallo::Coefficients<f64, 2> {
        let other = std::hint::black_box(*p).coefficients();
        std::hint::black_box(other);
        std::hint::black_box(*p).coefficients()
    }
    let comparison = Comparison::<Whipple, 2>::of(Whipple::coefficients).against("twice", twice).random_designs(20);
    match comparison.instructions() {
        Ok(counted) => {
            let [once, twice] = &counted.sides[..] else { panic!("{counted}") };
            assert_eq!([once.name.as_str(), twice.name.as_str(), once.scalar], ["generated", "twice", "f64"]);
            let ratio = twice.instructions / once.instructions;
            assert!(once.instructions > 100.0 && 1.5 < ratio && ratio < 3.0, "{counted}");
            assert!(counted.to_json().contains("\"instructions\""), "{counted}");
        }
        Err(error @ NotCounted::NoValgrind) => eprintln!("SKIPPED: {error}"),
        Err(error) => panic!("{error}"),
    }
}
