//! The models that ship, and what is found of their stability, as JSON and TOML.

use std::fmt::Debug;

use carvallo::{CriticalSpeed, Mode, Model, Stability, StableRange, Verdict};
use carvallo_models::{RollingDisc, Whipple, each_model};
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

/// JSON with its names outside of quotes is TOML.
fn toml_of(model: &impl Serialize) -> String {
    let json = serde_json::to_value(model).unwrap();
    json.as_object().unwrap().iter().map(|(name, value)| format!("{name} = {value}\n")).collect()
}
