//! The models that ship, and what is found of their stability, as JSON and TOML.

use std::fmt::Debug;

use carvallo::{Coefficients, CriticalSpeed, Mode, Model, Stability, StableRange, States, System, Verdict};
use carvallo_models::{Car, RollingDisc, Whipple, each_model};
use carvallo_tests::published::CRITICAL_SPEEDS_2007;
use serde::Serialize;
use serde::de::DeserializeOwned;

const DISC: RollingDisc = RollingDisc { r: 0.3, m: 1.0, Ia: 0.045, It: 0.0225, g: 9.81 };

#[test]
fn parameters_have_their_names() {
    let text = r#"{"r":0.3,"m":1.0,"Ia":0.045,"It":0.0225,"g":9.81}"#;
    assert_eq!(serde_json::to_string(&DISC).unwrap(), text);
    assert_eq!(serde_json::from_str::<RollingDisc>(text).unwrap(), DISC);
    let toml = "g = 9.81\nr = 0.3\nIa = 0.045\nIt = 0.0225\nm = 1";
    assert_eq!(toml::from_str::<RollingDisc>(toml).unwrap(), DISC);
    // The nearest numbers of another kind.
    let single = toml::from_str::<RollingDisc<f32>>(toml).unwrap();
    assert_eq!([single.r, single.Ia], [0.3_f32, 0.045]);
}

#[test]
fn what_is_missing_or_unknown_is_named() {
    let read = |text: &str| serde_json::from_str::<RollingDisc>(text).unwrap_err().to_string();
    let missing = read(r#"{"r":0.3,"m":1,"Ia":0.045,"g":9.81}"#);
    assert!(missing.starts_with("missing field `It`"), "{missing}");
    let unknown = read(r#"{"r":0.3,"m":1,"Ia":0.045,"Itt":0.0225,"g":9.81}"#);
    assert!(unknown.starts_with("unknown field `Itt`, expected one of `r`, `m`, `Ia`, `It`, `g`"), "{unknown}");
    let twice = read(r#"{"r":0.3,"r":0.3}"#);
    assert!(twice.starts_with("duplicate field `r`"), "{twice}");
    let text = read(r#"{"r":"0.3"}"#);
    assert!(text.contains("expected f64"), "{text}");
}

/// Reading looks at no domain.
#[test]
fn what_was_read_is_validated_afterwards() {
    let disc: RollingDisc = serde_json::from_str(r#"{"r":-0.3,"m":1,"Ia":0.045,"It":0.0225,"g":9.81}"#).unwrap();
    assert_eq!(disc.validate().unwrap_err().to_string(), "RollingDisc: `r` is -0.3 m; it must be > 0");
}

#[test]
fn every_set_of_every_model_is_read_back() {
    fn check<const N: usize, M>() -> usize
    where
        M: Model<N, Scalar = f64> + Serialize + DeserializeOwned + PartialEq + Debug,
    {
        for set in M::INFO.sets {
            let model = M::from_slice(set.values).unwrap();
            let json = serde_json::to_value(model).unwrap();
            for (parameter, value) in M::INFO.parameters.iter().zip(set.values) {
                assert_eq!(json[parameter.name], *value, "{} of {}", parameter.name, M::INFO.name);
            }
            assert_eq!(json.as_object().map(serde_json::Map::len), Some(M::INFO.parameters.len()));
            assert_eq!(serde_json::from_value::<M>(json).unwrap(), model);
            let toml = toml::from_str::<M>(&toml_of(&model)).unwrap();
            assert_eq!(toml, model);
        }
        M::INFO.sets.len()
    }
    assert!(each_model!(check).iter().sum::<usize>() > 10);
    assert_eq!(serde_json::to_value(Whipple::BENCHMARK).unwrap()["mB"], 85.0);
}

/// The words and members of `runtime/cli/docs/json.md`.
#[test]
fn stability_has_the_words_of_the_command_line() {
    let stability = Stability::new(&Whipple::BENCHMARK.coefficients(), 9.81).unwrap();
    let [_, weave_speed, capsize_speed] = CRITICAL_SPEEDS_2007;
    let json = serde_json::to_value(&stability.critical_speeds).unwrap();
    let weave = json.as_array().unwrap().iter().find(|speed| speed["kind"] == "weave").unwrap();
    assert!((weave["speed"].as_f64().unwrap() - weave_speed).abs() < 1e-12, "{weave}");
    assert_eq!((&weave["change"], &weave["eigenvalue"]["re"]), (&"stabilizes".into(), &0.0.into()));
    assert!(weave["eigenvalue"]["im"].as_f64().unwrap() > 0.0);
    let again: Vec<CriticalSpeed> = serde_json::from_value(json).unwrap();
    assert_eq!(again, stability.critical_speeds);
    let ranges = serde_json::to_value(&stability.stable_ranges).unwrap();
    assert!((ranges[0]["to"].as_f64().unwrap() - capsize_speed).abs() < 1e-12, "{ranges}");
    assert_eq!(serde_json::from_value::<Vec<StableRange>>(ranges).unwrap(), stability.stable_ranges);
    let words = |verdict: Verdict, mode: Mode| serde_json::to_string(&(verdict, mode)).unwrap();
    assert_eq!(words(Verdict::Marginal, Mode::Castering), r#"["marginal","castering"]"#);
}

/// The names and rows of `runtime/cli/docs/files.md`.
#[test]
fn matrices_have_the_names_of_files() {
    let car = Car::OVERSTEERING.coefficients();
    let json = serde_json::to_value(car).unwrap();
    let names: Vec<&str> = json.as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(names, ["C-1", "C1", "M", "states"]);
    assert_eq!(json["C-1"][0][1], car.cm1[(0, 1)]);
    assert_ne!(json["C-1"][0][1], 0.0);
    assert_eq!(json["states"], serde_json::json!(["rate", "rate"]));
    assert_eq!(serde_json::from_value::<Coefficients<f64, 2>>(json).unwrap(), car);
    let toml = "M = [[2.0, 0.0], [0.0, 1.0]]\nK0 = [[-9.0, 1.5], [0.5, -3.0]]\n";
    let read: Coefficients<f32, 2> = toml::from_str(toml).unwrap();
    assert_eq!((read.k0[(0, 1)], read.k0[(1, 0)], read.states), (1.5, 0.5, [States::Both; 2]));
    assert_eq!(toml::from_str::<Coefficients<f32, 2>>(&toml_of(&read)).unwrap(), read);
    let system = car.at(20.0, 0.0).unwrap();
    let json = serde_json::to_value(system).unwrap();
    assert_eq!((&json["C"][0][1], json.get("K")), (&system.c[(0, 1)].into(), None));
    assert_eq!(serde_json::from_value::<System<2>>(json).unwrap(), system);
}

#[test]
fn matrices_of_another_size_are_refused() {
    for (text, expected) in [
        (r#"{"M": [[1.0]]}"#, "`M` has 1 rows: expected 2, one for each coordinate"),
        (r#"{"M": [[1, 0], [0]]}"#, "`M` has 1 entries in row 2: expected 2, one for each coordinate"),
        (r#"{"K0": [[1, 0], [0, 1]]}"#, "missing field `M`"),
        (r#"{"M": [[1, 0], [0, 1]], "K3": [[1]]}"#, "unknown field `K3`"),
        (
            r#"{"M": [[1, 0], [0, 1]], "states": ["rate"]}"#,
            "`states` has 1 members: expected 2, one for each coordinate",
        ),
    ] {
        let error = serde_json::from_str::<Coefficients<f64, 2>>(text).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
    }
}

/// JSON with its names outside of quotes is TOML.
fn toml_of(model: &impl Serialize) -> String {
    let json = serde_json::to_value(model).unwrap();
    json.as_object().unwrap().iter().map(|(name, value)| format!("{name} = {value}\n")).collect()
}
