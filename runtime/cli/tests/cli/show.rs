//! Parameters with their units, sources, deviations and warnings.

use crate::Directory;

#[test]
fn values_keep_their_digits_units_and_source() {
    let text = Directory::new("show").run(&["show", "crescendo"]).ok();
    assert!(text.contains("source = \"BicycleParameters 1.5.2"), "{text}");
    let line = |start: &str| text.lines().find(|line| line.starts_with(start)).unwrap().to_owned();
    assert!(line("w = ").contains("# m"), "{text}");
    assert!(line("IBxx = ").contains("kg m²"), "{text}");
    let shipped = include_str!("../../../../generated/bicycles/crescendo.toml");
    for line in shipped.lines().filter(|line| line.contains("std")) {
        assert!(text.contains(line), "{line} is not in {text}");
    }
}

#[test]
fn without_a_design_it_is_the_benchmark() {
    let directory = Directory::new("show-nothing");
    assert_eq!(directory.run(&["show"]).ok(), directory.run(&["show", "benchmark"]).ok());
}

#[test]
fn expressions_stay_as_they_were_written() {
    let text = Directory::new("show-expression").run(&["show", "benchmark", "--set", "mB=170/2"]).ok();
    assert!(text.contains("lam = \"pi/10\""), "{text}");
    assert!(text.contains("mB = \"170/2\""), "{text}");
}

/// Three of the measured bicycles miss the triangle inequality of inertias by up to 2.4 %.
#[test]
fn inertias_that_no_body_can_have_are_a_warning() {
    let directory = Directory::new("warnings");
    let shipped = [
        "benchmark",
        "benchmark-2005",
        "balanceassistv1",
        "browser",
        "browserins",
        "crescendo",
        "fisher",
        "pista",
        "rigid",
        "silver",
        "yellow",
        "yellowrev",
        "browser-jason",
        "pista-rider",
    ];
    let warned: Vec<&str> = shipped
        .into_iter()
        .filter(|name| {
            let run = directory.run(&["show", name]);
            assert_eq!(run.code, Some(0));
            assert_eq!(run.stdout.contains("# warning: "), run.stderr.starts_with("warning: "));
            !run.stderr.is_empty()
        })
        .collect();
    assert_eq!(warned, ["browser", "yellow", "yellowrev"]);
    let run = directory.run(&["analyze", "browser", "--format", "csv"]);
    assert_eq!(run.code, Some(0));
    assert!(
        run.stderr.starts_with("warning: browser: no rigid body has the inertias of the rear frame B"),
        "{}",
        run.stderr
    );
}

/// Heights are often measured upwards; here z points down.
/// In a model that runs backwards the letters of the parameters belong to other bodies.
#[test]
fn bodies_are_called_as_the_model_calls_them() {
    let directory = Directory::of_this_test();
    for (setting, body) in [
        ("IRyy=5", "front wheel R"),
        ("IFyy=5", "rear wheel F"),
        ("IBxx=50", "main frame B"),
        ("IHxx=5", "steered frame H"),
    ] {
        let run = directory.run(&["show", "--model", "RearSteered", "--set", setting]);
        let start = format!("warning: backwards: no rigid body has the inertias of the {body}: ");
        assert!(run.stderr.starts_with(&start), "{}", run.stderr);
        let [name, letter] = [&body[..body.len() - 2], &body[body.len() - 1..]];
        let mass = run.stdout.lines().find(|line| line.starts_with(&format!("m{letter} = "))).unwrap();
        assert!(mass.contains(&format!("Mass of the {name}")), "{mass}");
    }
}

#[test]
fn a_centre_of_mass_below_the_ground_is_a_warning() {
    let run = Directory::new("below").run(&["show", "benchmark", "--set", "zB=0.9"]);
    let warning = "warning: benchmark: `zB` is 0.9 m, below the ground: z points down\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), warning));
}
