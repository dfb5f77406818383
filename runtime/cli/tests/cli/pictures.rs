//! Pictures: that they are written, hold what they should, and say so.

use crate::Directory;

/// The texts of a picture; they are drawn as outlines and labelled for readers that cannot see them.
fn texts(svg: &str) -> Vec<String> {
    let labels = svg.split("aria-label=\"").skip(1);
    labels.filter_map(|rest| rest.split_once('"')).map(|(text, _)| text.to_owned()).collect()
}

#[track_caller]
fn picture(arguments: &[&str]) -> Vec<String> {
    let directory = Directory::new(&arguments.join("-"));
    let run = directory.run(&[arguments, &["--plot", "picture.svg"]].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stderr.ends_with("wrote: picture.svg\n"), "{}", run.stderr);
    let svg = std::fs::read_to_string(directory.0.join("picture.svg")).unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    texts(&svg)
}

#[test]
fn eigenvalues_have_axes_modes_and_critical_speeds() {
    let texts = picture(&["analyze", "benchmark"]);
    for expected in [
        "forward speed v (m/s)",
        "eigenvalue λ (1/s)",
        "stable",
        "weave 4.2924",
        "capsize 6.0243",
        "double root 0.6843",
        "castering",
        "capsize",
        "weave, real part",
        "weave, imaginary part",
    ] {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
}

#[test]
fn every_bicycle_has_both_pictures() {
    for bicycle in ["benchmark", "balanceassistv1", "browser", "pista", "silver", "yellowrev", "pista-rider"] {
        assert!(picture(&["analyze", bicycle]).len() > 20);
        let side = picture(&["show", bicycle]);
        for expected in ["steer axis", "wheel base", "trail", "λ = ", "B  ", "H  ", "R  ", "F  "] {
            assert!(side.iter().any(|text| text.starts_with(expected)), "{expected} is not in {side:?}");
        }
    }
}

#[test]
fn a_side_view_copes_with_odd_geometry() {
    for setting in ["c=-0.1", "lam=-0.5", "lam=1.5", "xB=40", "zB=0.2", "rF=0.01"] {
        picture(&["show", "benchmark", "--set", setting]);
    }
}

#[test]
fn eigenvalues_can_be_drawn_at_any_speeds_and_gravity() {
    for speeds in ["5", "0:30:1", "0:0.001:0.001"] {
        picture(&["analyze", "benchmark", "--speeds", speeds]);
    }
    picture(&["analyze", "benchmark", "--gravity", "0"]);
}

#[test]
fn png_is_written_by_its_ending() {
    let directory = Directory::new("png");
    directory.run(&["analyze", "--plot", "picture.png"]);
    let bytes = std::fs::read(directory.0.join("picture.png")).unwrap();
    assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n"));
}
