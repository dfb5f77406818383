//! Geometry as manufacturers print it.

use std::collections::BTreeMap;

use super::close;
use crate::Directory;

/// A bicycle in the paper's parameters takes settings in those that manufacturers print: the fork offset stays where the head
/// angle changes, as that of a fork in a steeper frame.
#[test]
fn geometry_changes_any_bicycle() {
    let directory = Directory::new("convert-settings");
    let changed = |settings: &[&str]| {
        let mut arguments = vec!["convert", "benchmark", "--to", "paper", "--format", "json"];
        settings.iter().for_each(|setting| arguments.extend(["--set", setting]));
        let run = directory.run(&arguments);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert!(run.stderr.contains("note: benchmark: changed in"), "{}", run.stderr);
        serde_json::from_str::<serde_json::Value>(&run.stdout).unwrap()
    };
    let value = |json: &serde_json::Value, name: &str| json["parameters"][name].as_f64().unwrap();
    let offset = |c: f64, lam: f64| 0.35 * lam.sin() - c * lam.cos();
    let steeper = changed(&["head_angle=75 deg"]);
    let lam = 15_f64.to_radians();
    assert!((value(&steeper, "lam") - lam).abs() < 1e-15);
    let kept = offset(0.08, std::f64::consts::PI / 10.0);
    assert!((value(&steeper, "c") - (0.35 * lam.sin() - kept) / lam.cos()).abs() < 1e-15);
    assert_eq!([value(&steeper, "w"), value(&steeper, "zB")], [1.02, -0.9]);

    let both = changed(&["head_angle=75 deg", "trail=60 mm", "wheel=28-622", "mB=90"]);
    assert!((value(&both, "c") - 0.06).abs() < 1e-16 && (value(&both, "rF") - 0.339).abs() < 1e-15);
    assert_eq!(value(&both, "mB"), 90.0);
    let run = directory.run(&["show", "--set", "mf=3"]);
    run.fails(2, "error: --set mf=3: `mf` is not a parameter of Whipple; did you mean `mF`?\n");
}

/// Manufacturers print some of several quantities that say the same.
#[test]
fn geometry_is_read_as_it_is_printed() {
    let directory = Directory::new("convert-geometry");
    let masses: String = crate::BENCHMARK
        .lines()
        .skip_while(|line| *line != "[parameters]")
        .skip(1)
        .filter(|line| !["w ", "c ", "lam ", "rR ", "rF ", "g "].iter().any(|name| line.starts_with(name)))
        .map(|line| format!("{line}\n"))
        .collect();
    let read = |geometry: &str| {
        directory
            .write("g.txt", format!("{geometry}{masses}"))
            .run(&["convert", "g.txt", "--to", "paper", "--format", "json"])
    };
    let usual = "wheelbase = 1012 mm\nhead_angle = 72.5 deg\nfork_offset = 45 mm\nwheel = 28-622\n";
    let paper = |geometry: &str| -> BTreeMap<String, f64> {
        let run = read(geometry);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        let values = json["parameters"].as_object().unwrap().iter();
        values.map(|(name, value)| (name.clone(), value.as_f64().unwrap())).collect()
    };
    let lam = 17.5_f64.to_radians();
    let c = (0.339 * lam.sin() - 0.045) / lam.cos();
    let expected: BTreeMap<String, f64> = [("w", 1.012), ("lam", lam), ("c", c), ("rR", 0.339), ("rF", 0.339)]
        .map(|(name, value)| (name.to_owned(), value))
        .into();
    close(&paper(usual), &expected, 1e-15);
    for other in [
        usual.replace("fork_offset = 45 mm", &format!("trail = {c}")),
        usual.replace("fork_offset", "rake"),
        usual.replace("fork_offset = 45 mm", "fork_offset = 45 mm\ntrail = 60 mm"),
        usual.replace("head_angle = 72.5 deg", "lam = 17.5 deg"),
        usual.replace("wheel = 28-622", "rear_wheel = 700x28C\nfront_wheel_diameter = 678 mm"),
        usual.replace("wheel = 28-622", "wheel_circumference = 0.678*pi"),
        usual.replace("wheel = 28-622", "rR = 339 mm\nrF = 339 mm"),
        // A right triangle with the sides 9, 40 and 41, and the rest of the wheel base.
        usual.replace(
            "wheelbase = 1012 mm",
            "chainstay = 410 mm\nbb_drop = 90 mm\nfront_center = sqrt(0.612^2 + 0.09^2)",
        ),
    ] {
        close(&paper(&other), &expected, 1e-15);
    }
    let fails = |geometry: String, message: &str| {
        let run = read(&geometry);
        assert_eq!((run.code, run.stderr.as_str()), (Some(2), format!("error: g.txt{message}\n").as_str()));
    };
    fails(
        usual.replace("72.5 deg", "72.5"),
        ":2: `head_angle` is 72.5 rad; it must be > 0 and < 3.141592653589793 (for degrees write `72.5 deg`)",
    );
    fails(
        usual.replace("28-622", "28"),
        ":4: `wheel` is `28`; expected the size on its tyre, such as 28-622, 700x28C or 26x2.1, or `wheel_diameter`",
    );
    fails(
        usual.replace("28-622", "700c"),
        ":4: `wheel` is `700c`; expected the size on its tyre, such as 28-622, 700x28C or 26x2.1, or `wheel_diameter`",
    );
    fails(
        usual.replace("fork_offset = 45 mm\n", ""),
        ": missing: `fork_offset` (or `trail`), of the geometry that manufacturers print",
    );
}

/// The trail and the tilt of the head are 5 cm and 90 - 70 degrees in the names of the paper, too.
#[test]
fn geometry_is_set_in_models_that_have_more_than_the_bicycle() {
    let directory = Directory::of_this_test();
    for model in ["WhippleLeaning", "WhippleSprung", "WhippleTyres", "BalanceAssist", "FlywheelBicycle"] {
        let speeds = |set: [&str; 2]| -> Vec<f64> {
            let [one, other] = set;
            let run = directory.run(&["analyze", "--model", model, "--set", one, "--set", other, "--format", "json"]);
            assert_eq!(run.code, Some(0), "{model}: {}", run.stderr);
            let found: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            let speed = |event: &serde_json::Value| event["speed"].as_f64().unwrap();
            found["critical_speeds"].as_array().unwrap().iter().map(speed).collect()
        };
        let (found, expected) = (speeds(["trail=5cm", "head_angle=70deg"]), speeds(["c=0.05", "lam=20deg"]));
        assert!(!expected.is_empty() && found.len() == expected.len(), "{model}: {found:?}");
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-9 * expected, "{model}: {found}, expected {expected}");
        }
    }
}

/// A size of both wheels says what those of each do, or of one, to the 5 mm of diameters as they are printed: 28-622 is 678 mm.
#[test]
fn a_size_of_both_wheels_is_that_of_each() {
    let directory = Directory::of_this_test();
    let own = directory.run(&["convert", "benchmark", "--to", "geometry", "--format", "text"]).ok();
    let with = |without: &str, lines: &str| {
        let left = own.lines().filter(|line| !line.contains(without)).map(|line| format!("{line}\n"));
        let text: String = left.chain([lines.to_owned()]).collect();
        directory.write("g.txt", text).run(&["convert", "g.txt", "--to", "paper"])
    };
    for (without, lines, message) in [
        (
            "nothing",
            "wheel_diameter = 700 mm",
            "`wheel_diameter` is 0.7 m, but 0.6 m follows from `rear_wheel_diameter`",
        ),
        (
            "rear_wheel_d",
            "wheel_diameter = 600 mm",
            "`wheel_diameter` is 0.6 m, but 0.7 m follows from `front_wheel_diameter`",
        ),
        ("wheel_diameter", "wheel = 28-622\nrR = 0.1", "`wheel` is 0.678 m, but 0.2 m follows from `rR`"),
        (
            "wheel_diameter",
            "wheel = 28-622\nrear_wheel_diameter = 0.6",
            "`wheel` is 0.678 m, but 0.6 m follows from `rear_wheel_diameter`",
        ),
        ("wheel_diameter", "wheel = 28-622\nrF = 0.25", "`wheel` is 0.678 m, but 0.5 m follows from `rF`"),
        (
            "wheel_diameter",
            "wheel_circumference = 2100 mm\nrF = 0.342",
            "`wheel_circumference` is 2.1 m, but 2.14885 m follows from `rF`",
        ),
    ] {
        let line = own.lines().filter(|line| !line.contains(without)).count() + 1;
        with(without, lines).fails(2, &format!("error: g.txt:{line}: {message}; leave one of them out\n"));
    }
    // The one of its own counts for its wheel, and what is said twice is told.
    let radii = |run: &crate::Run| -> Vec<String> {
        let is_radius = |line: &&str| line.starts_with("rR = ") || line.starts_with("rF = ");
        let value = |line: &str| line.split_whitespace().nth(2).unwrap().to_owned();
        run.stdout.lines().filter(is_radius).map(value).collect()
    };
    for (rear, radius, note) in [
        (
            "337 mm",
            "0.337",
            "`wheel` is 0.678 m, but 0.674 m follows from `rR`, 4.0 mm off; it does not count for that wheel",
        ),
        ("0.339", "0.339", "`wheel` says what `rR` says, too"),
    ] {
        let run = with("wheel_diameter", &format!("wheel = 28-622\nrR = {rear}\n"));
        assert!(run.stderr.contains(&format!("note: g.txt: {note}\n")), "{}", run.stderr);
        assert_eq!((run.code, radii(&run)), (Some(0), vec![radius.to_owned(), "0.339".to_owned()]));
    }
    // So does what is set, whatever the file says.
    let set = directory.run(&["convert", "g.txt", "--to", "paper", "--set", "rR=0.1"]);
    assert_eq!((set.code, radii(&set)), (Some(0), vec!["0.1".to_owned(), "0.339".to_owned()]));
    directory.write("d.csv", "wheel_diameter,rR\n0.678,0.337\n0.678,0.1\n");
    let swept = directory.run(&["sweep", "g.txt", "--designs", "d.csv"]).stdout;
    let rows: Vec<&str> = swept.lines().skip(1).collect();
    let message = "the diameter of both wheels is 678.0 mm, but 200.0 mm of the rear and 678.0 mm of the front one";
    assert!(rows[0].ends_with(',') && rows[1].contains(message), "{swept}");
}

/// What is wrong with a value says nothing of others: 72.5 rad are no head angle, of which a trail would follow.
#[test]
fn nothing_is_judged_by_a_value_that_is_wrong() {
    let directory = Directory::of_this_test();
    let own = directory.run(&["convert", "benchmark", "--to", "geometry", "--format", "text"]).ok();
    let head = own.lines().find(|line| line.starts_with("head_angle")).unwrap();
    let run = directory
        .write("g.txt", own.replace(head, "head_angle = 72.5") + "trail = 61 mm\n")
        .run(&["convert", "g.txt", "--to", "paper"]);
    let errors: Vec<&str> = run.stderr.lines().filter(|line| line.starts_with("error")).collect();
    assert!(run.code == Some(2) && !run.stderr.contains("`trail`"), "{}", run.stderr);
    assert!(errors.len() == 1 && errors[0].contains("`head_angle`"), "{}", run.stderr);
}
