//! Settings in a convention.

use crate::Directory;

/// The fork offset of a measured bicycle, which the trail is set in the place of, was correlated with others.
#[test]
fn what_gives_way_to_a_setting_loses_its_correlations() {
    let directory = Directory::of_this_test();
    assert_eq!(directory.run(&["convert", "pista", "--to", "geometry", "--output", "pista.toml"]).code, Some(0));
    for bicycle in ["pista", "pista.toml"] {
        let run =
            directory.run(&["sweep", bicycle, "--vary", "head_angle=68 deg:74 deg:2 deg", "--set", "trail=60 mm"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
    }
}

/// Settings in another convention than the paper's and than that of the file: as if the file were in the paper's names.
#[test]
fn settings_may_be_in_another_convention_than_the_file() {
    let directory = Directory::new("convert-third");
    let with_deviations = directory.run(&["show", "browser-jason"]).ok();
    directory.write("paper.toml", with_deviations);
    let moore = directory.run(&["convert", "paper.toml", "--to", "moore", "--output", "moore.toml"]);
    assert_eq!(moore.code, Some(0), "{}", moore.stderr);
    let set = ["--set", "trail=60 mm", "--set", "head_angle=70 deg", "--set", "mB=90"];
    let speeds = |file: &str| {
        let run = directory.run(&[&["sensitivity", file, "--format", "json"], &set[..]].concat());
        assert!(run.stderr.contains("changed in the geometry that manufacturers print"), "{}", run.stderr);
        let found: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        found["critical_speeds"].as_array().unwrap().clone()
    };
    let (found, expected) = (speeds("moore.toml"), speeds("paper.toml"));
    assert!(!expected.is_empty() && found.len() == expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        let [found, expected] = [found, expected].map(|event| event["speed"].as_f64().unwrap());
        assert!((found - expected).abs() < 1e-10, "{found}, expected {expected}");
    }
    directory
        .run(&["analyze", "moore.toml", "--set", "trial=60 mm"])
        .fails(2, "error: --set trial=60 mm: `trial` is not a parameter of Whipple; did you mean `trail`?\n");
    // A script of MATLAB under another ending.
    let script = directory.run(&["convert", "pista", "--to", "jbike6"]).stdout;
    directory.write("script.toml", script);
    let run = directory.run(&["analyze", "script.toml", "--format", "json"]);
    assert!(run.code == Some(0) && run.stderr.contains("in the names of JBike6"), "{}", run.stderr);
}

/// d1 = cos(lam)*(w + c - rR*tan(lam)) of Moore (2012): 1.0292338 m with w = 1.1 m and lam as it follows from d1 = 0.95 m.
#[test]
fn settings_that_cannot_hold_together_are_refused() {
    let directory = Directory::of_this_test();
    let fails = |settings: &[&str], message: &str| {
        let settings: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
        directory.run(&[&["show", "benchmark"][..], &settings].concat()).fails(2, &format!("error: --set {message}\n"));
    };
    fails(
        &["d1=0.95", "w=1.1"],
        "w=1.1: `w` and `d1`, at --set d1=0.95, cannot both hold: `d1` would be 1.029233798542342 m",
    );
    for [first, second] in [["w=1.1", "front_center=0.6"], ["c=0.05", "fork_offset=0.06"]] {
        let [one, other] = [first, second].map(|setting| setting.split('=').next().unwrap());
        let message = format!(
            "{second}: `{other}` stands in the place of `{one}`, which is set, too, at --set {first}; both cannot hold"
        );
        fails(&[first, second], &message);
    }
    // What agrees, and what has nothing to do with each other, is set. f = rF*sin(lam) - c*cos(lam).
    let lam = std::f64::consts::PI / 10.0;
    let offset = format!("fork_offset={}", 0.35 * lam.sin() - 0.06 * lam.cos());
    assert_eq!(directory.run(&["show", "benchmark", "--set", "trail=0.06", "--set", &offset]).code, Some(0));
    assert_eq!(directory.run(&["show", "benchmark", "--set", "d1=0.95", "--set", "mB=90"]).code, Some(0));
    // In two conventions, neither of which is the paper's: d1 is as it was with the fork offset of the benchmark.
    let moore = directory.run(&["convert", "benchmark", "--to", "moore"]).stdout;
    directory.write("moore.toml", moore);
    let run = directory.run(&["show", "moore.toml", "--set", "d1=0.95", "--set", "fork_offset=0.05"]);
    assert!(
        run.code == Some(2) && run.stderr.contains("`fork_offset` and `d1`, at --set d1=0.95, cannot both hold"),
        "{}",
        run.stderr
    );
}
