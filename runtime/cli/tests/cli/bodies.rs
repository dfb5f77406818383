//! `--add`: bodies joined to frames, against BicycleParameters, published sets and arithmetic by hand.

use serde_json::Value;

use crate::{BENCHMARK, Directory};

/// BicycleParameters, data/riders/Jason/Parameters/JasonBrowserBenchmark.txt.
const JASON: &str = "mB = 72.0+/-2.0\nxB = 0.2909+/-0.0\nyB = 0.0+/-0.0\nzB = -1.1091+/-0.0\nIBxx = 7.9985+/-0.0\n\
                     IBxz = -1.9272+/-0.0\nIByy = 8.0689+/-0.0\nIBzz = 2.3624+/-0.0\n";

/// `combine_bike_rider` of BicycleParameters 1.5.2 with uncertainties 3.2.3, of the shipped browser and Jason: value and
/// deviation.
const BROWSER_AND_JASON: [(&str, f64, f64); 7] = [
    ("xB", 0.28909943411648203, 0.0003757297428338847),
    ("zB", -1.040292283210937, 0.0017155441437212893),
    ("mB", 81.86, 2.000099997500125),
    ("IBxx", 11.35822782891604, 0.0284751583305407),
    ("IByy", 12.217332897646934, 0.028663068086089823),
    ("IBzz", 3.1211248578428963, 0.0034001841243437),
    ("IBxz", -1.9694273509701732, 0.015396371193683757),
];

/// Of the same, by `uncertainties.correlation_matrix`.
const CORRELATIONS: [(&str, &str, f64); 5] = [
    ("zB", "xB", -1.15343950e-01),
    ("mB", "zB", -9.79161984e-01),
    ("IByy", "IBxx", 9.86032570e-01),
    ("IBxz", "xB", -9.88097142e-01),
    ("IBxz", "IBzz", 2.35508742e-01),
];

impl Directory {
    /// The parameters of the benchmark with bodies, and nothing else.
    fn parameters_with(&self, settings: &[&str], bodies: &[&str]) -> Value {
        let options =
            settings.iter().flat_map(|set| ["--set", set]).chain(bodies.iter().flat_map(|body| ["--add", body]));
        let arguments: Vec<&str> = ["sensitivity", "--format", "json"].into_iter().chain(options).collect();
        self.run(&arguments).json()["parameters"].clone()
    }

    fn value_with(&self, bodies: &[&str], name: &str) -> f64 {
        self.parameters_with(&[], bodies)[name]["value"].as_f64().unwrap()
    }

    fn mistake_of(&self, body: &str) -> String {
        let run = self.run(&["show", "--add", body]);
        assert_eq!(run.code, Some(2), "{}", run.stdout);
        run.stderr
    }
}

#[track_caller]
fn assert_close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs().max(0.1), "{found}, not {expected}");
}

#[test]
fn a_rider_is_combined_as_bicycle_parameters_does() {
    let directory = Directory::of_this_test();
    directory.write("jason.txt", JASON);
    let json = directory.run(&["sensitivity", "browser", "--add", "jason.txt", "--format", "json"]).json();
    assert_eq!(json["bicycle"], "browser + 72 kg");
    for (name, value, deviation) in BROWSER_AND_JASON {
        let found = &json["parameters"][name];
        assert_close(found["value"].as_f64().unwrap(), value);
        assert_close(found["std"].as_f64().unwrap(), deviation);
    }
    for (first, second, correlation) in CORRELATIONS {
        assert!((json["correlations"][first][second].as_f64().unwrap() - correlation).abs() < 1e-9);
    }
    // Published as `meijaard2007_browser_jason`, where the frame was measured with other moments of inertia.
    let shipped = directory.run(&["sensitivity", "browser-jason", "--format", "json"]).json();
    for name in ["mB", "xB", "zB"] {
        let [found, published] = [&json, &shipped].map(|json| json["parameters"][name]["value"].as_f64().unwrap());
        assert!((found - published).abs() < 5e-12, "{name}: {found}, not {published}");
    }
}

/// Published as `benchmark-pistarider.yml` of BicycleParameters, of the Pista and the same rider; its frame's moments of inertia
/// were 1e-4 kg m^2 others.
#[test]
fn the_published_pista_with_its_rider_comes_out() {
    let directory = Directory::of_this_test();
    directory.write("jason.txt", JASON);
    let joined = directory.run(&["sensitivity", "pista", "--add", "jason.txt", "--format", "json"]).json();
    let published = directory.run(&["sensitivity", "pista-rider", "--format", "json"]).json();
    for (name, bound) in [("mB", 5e-12), ("xB", 5e-12), ("zB", 5e-12), ("IBxx", 1e-4), ("IBzz", 1e-4), ("IBxz", 1e-4)] {
        let [found, published] = [&joined, &published].map(|json| json["parameters"][name]["value"].as_f64().unwrap());
        assert!((found - published).abs() < bound, "{name}: {found}, not {published}");
    }
}

/// The rider of the example, which is measured on a Browser, is that of `JASON` to the rounded places.
#[test]
fn a_rider_from_a_few_measures_is_joined() {
    let directory = Directory::of_this_test();
    directory.write("me.toml", directory.run(&["rider", "--example"]).ok());
    directory.write("rider.toml", directory.run(&["rider", "me.toml"]).ok());
    directory.write("jason.txt", JASON.replace("+/-2.0", ""));
    let [found, published] = ["rider.toml", "jason.txt"].map(|rider| directory.parameters_with(&[], &[rider]));
    for name in ["mB", "xB", "zB", "IBxx", "IByy", "IBzz", "IBxz"] {
        let [found, published] = [&found, &published].map(|all| all[name]["value"].as_f64().unwrap());
        assert!((found - published).abs() < 2e-3, "{name}: {found}, not {published}");
    }
    // What ships says of the Pista that it has no rider.
    let ridden = directory.run(&["analyze", "pista", "--add", "rider.toml"]).ok();
    assert!(ridden.starts_with("pista + rider") && !ridden.contains("no rider"), "{ridden}");
    let missing = directory.run_with_input(&["rider", "-"], "mass = 72\n");
    assert_eq!(missing.code, Some(2));
    assert!(missing.stderr.starts_with("error: <stdin>: missing: lean, lower_leg"), "{}", missing.stderr);
}

/// Beside nothing else a body is what it is: boxes, cylinders and spheres by their formulas.
#[test]
fn moments_of_inertia_are_those_of_the_shape() {
    let directory = Directory::of_this_test();
    let bare = ["mB=0", "IBxx=0", "IByy=0", "IBzz=0", "IBxz=0"];
    let assert_moments = |body: &str, expected: [f64; 4]| {
        let found = directory.parameters_with(&bare, &[body]);
        for (name, expected) in ["IBxx", "IByy", "IBzz", "IBxz"].into_iter().zip(expected) {
            assert_close(found[name]["value"].as_f64().unwrap(), expected);
        }
        assert_eq!([&found["mB"]["value"], &found["xB"]["value"]], [12.0, 0.3]);
    };
    let at = "mass=12 kg, at=(30 cm, 0, -0.9)";
    assert_moments(at, [0.0; 4]);
    assert_moments(&format!("{at}, box=(0.1, 0.2, 0.3)"), [0.13, 0.10, 0.05, 0.0]);
    assert_moments(&format!("{at}, cylinder=(0.1, 0.2), axis=y"), [0.07, 0.06, 0.07, 0.0]);
    assert_moments(&format!("{at}, cylinder=(0.1, 0.2), axis=z"), [0.07, 0.07, 0.06, 0.0]);
    assert_moments(&format!("{at}, sphere=0.1"), [0.048, 0.048, 0.048, 0.0]);
    assert_moments(&format!("{at}, Ixx=0.2, Iyy=0.25, Izz=0.3, Ixz=-0.05"), [0.2, 0.25, 0.3, -0.05]);
    assert_moments(&format!("{at}, box=(0.1, 0.2, 0.3), tilt=90 deg"), [0.05, 0.10, 0.13, 0.0]);
    // Half of a right angle: Ixx = Izz = 0.09, and Ixz = (Izz - Ixx)/2, negative as it is longest along x = z, behind and up.
    assert_moments(&format!("{at}, box=(0.1, 0.2, 0.3), tilt=45 deg"), [0.09, 0.10, 0.09, -0.04]);
}

/// Two halves of a box are that box, wherever it is cut, and so are both sides.
#[test]
fn parts_make_the_whole() {
    let directory = Directory::of_this_test();
    let whole = ["mass=12, at=(0.3, 0, -0.9), box=(0.4, 0.2, 0.1)"];
    let lengthwise =
        ["mass=3, at=(0.15, 0, -0.9), box=(0.1, 0.2, 0.1)", "mass=9, at=(0.35, 0, -0.9), box=(0.3, 0.2, 0.1)"];
    let flat =
        ["mass=6, at=(0.3, 0, -0.925), box=(0.4, 0.2, 0.05)", "mass=6, at=(0.3, 0, -0.875), box=(0.4, 0.2, 0.05)"];
    let sides = ["mass=6, at=(0.3, 0.05, -0.9), box=(0.4, 0.1, 0.1), sides=both"];
    let expected = directory.parameters_with(&[], &whole);
    for parts in [&lengthwise[..], &flat, &sides] {
        let found = directory.parameters_with(&[], parts);
        for name in ["mB", "xB", "zB", "IBxx", "IByy", "IBzz", "IBxz"] {
            assert_close(found[name]["value"].as_f64().unwrap(), expected[name]["value"].as_f64().unwrap());
        }
    }
}

/// The front frame of the benchmark, 4 kg at (0.9, -0.7), with 1 kg at (0.6, -1.2): by hand, the reduced mass is 0.8 kg.
#[test]
fn the_front_frame_takes_bodies_too() {
    let directory = Directory::of_this_test();
    let found = directory.parameters_with(&[], &["mass=1, at=(0.6, 0, -1.2), to=front"]);
    let expected = [
        ("mH", 5.0),
        ("xH", 0.84),
        ("zH", -0.8),
        ("IHxx", 0.05892 + 0.8 * 0.25),
        ("IHyy", 0.06 + 0.8 * 0.34),
        ("IHzz", 0.00708 + 0.8 * 0.09),
        ("IHxz", -0.00756 - 0.8 * 0.15),
        ("mB", 85.0),
    ];
    for (name, value) in expected {
        assert_close(found[name]["value"].as_f64().unwrap(), value);
    }
    assert_eq!(directory.value_with(&["mass=1, x=0.6, z=-1.2, to=H"], "IHxz"), found["IHxz"]["value"]);
    let leaning = directory.run(&["show", "--model", "WhippleLeaning", "--add", "mass=1, at=(0, 0, -1), to=U"]).ok();
    assert!(leaning.lines().any(|line| line.starts_with("mU = ")), "{leaning}");
}

/// Whatever reads a design reads it with its bodies; what varies then replaces the whole.
#[test]
fn every_command_takes_them() {
    let directory = Directory::of_this_test();
    directory.write(
        "rack.toml",
        "name = \"rack\"\nto = \"rear\"\nmass = 5\nat = [-0.1, 0, -0.75]\nbox = [0.4, 0.2, 0.02]\n",
    );
    let shown = directory.run(&["show", "--add", "rack.toml"]).ok();
    assert!(shown.starts_with("name = \"benchmark + rack\"\n"), "{shown}");
    directory.write("joined.toml", shown);
    for command in [&["analyze"][..], &["sensitivity"], &["turns"], &["sweep", "--vary", "c=0.06,0.08"]] {
        let with = |design: &[&str]| directory.run(&[command, design].concat()).stdout;
        assert_eq!(with(&["--add", "rack.toml"]), with(&["joined.toml"]), "{command:?}");
    }
    let sweep = ["sweep", "--vary", "mB=85,90"];
    let mass = directory.run(&[&sweep[..], &["--add", "rack.toml"]].concat()).stdout;
    assert!(mass.lines().nth(2).unwrap().starts_with("90.0,"), "{mass}");
    directory.write("rack.json", "{\"mass\": {\"value\": 5, \"std\": 0.1}, \"x\": -0.1, \"z\": \"-75 cm\"}");
    assert_eq!(directory.value_with(&["rack.json"], "mB"), 90.0);
    let plot = directory.run(&["analyze", "--add", "rack.toml", "--plot", "rack.svg"]);
    assert_eq!(plot.code, Some(0), "{}", plot.stderr);
}

#[test]
fn mistakes_are_told_at_their_place() {
    let directory = Directory::of_this_test();
    let of = |body: &str| directory.mistake_of(body);
    assert!(of("mass=1, at=(0, 0.2, -1)").contains("`y` is 0.2 m, beside the plane of symmetry"));
    assert!(of("mass=1, at=(0, 0, -1), sides=both").contains("`sides` is `both`, but `y` is 0"));
    assert!(of("mass=-1, at=(0, 0, -1)").contains("`mass` is -1 kg; it must be >= 0"));
    assert!(of("at=(0, 0, -1)").contains("a body needs its `mass`"));
    assert!(of("mass=1").contains("a body needs its place"));
    assert!(of("mass=1, at=(0, 0)").contains("`at` has 2 numbers; it must have 3"));
    assert!(of("mass=1, at=(0, 0, -1 kg)").contains("`kg` is no unit for it: `z` is in m"));
    assert!(of("mass=1, at=(0, 0, -1), bax=(1, 1, 1)").contains("a body has no `bax`; did you mean `box`?"));
    assert!(of("mass=1, at=(0, 0, -1), cylinder=(1, 1)").contains("the `axis` of the cylinder is missing"));
    assert!(of("mass=1, at=(0, 0, -1), sphere=1, Ixx=1").contains("its moments of inertia are given in two ways"));
    assert!(
        of("mass=1, at=(0, 0, -1), Ixx=1, Iyy=9, Izz=1").contains("of no body is one more than the others together")
    );
    assert!(of("mass=1, mB=2, at=(0, 0, -1)").contains("`mB` is given twice; first at --add"));
    assert!(of("mass=1, at=(0, 0, -1), to=rear wheel").contains("a wheel turns"));
    let nowhere = of("mass=1, at=(0, 0, -1), to=seat");
    assert!(
        nowhere.contains("Whipple has no frame `seat`; there is `B`, the rear frame and `H`, the front frame"),
        "{nowhere}"
    );
    assert!(of("nothing.toml").contains("--add 'nothing.toml': there is no file `nothing.toml`; expected a file, or"));
    directory.write("rack.toml", "mass = 5\nat = [0, 0, -1]\nmas = 3\n");
    assert!(of("rack.toml").contains("rack.toml:3: a body has no `mas`; did you mean `mass`?"));
    directory.write("benchmark.toml", BENCHMARK);
    assert!(of("benchmark.toml").contains("a body has no `parameters`"));
    let pendulum = directory.run(&["show", "--model", "Pendulum", "--add", "mass=1, at=(0, 0, -1)"]);
    assert!(pendulum.stderr.contains("Pendulum has no frame that a body can be joined to"), "{}", pendulum.stderr);
    let replaced = directory.run(&["show", "--add", "rack.svg", "--plot", "rack.svg"]);
    assert_eq!(replaced.code, Some(2));
}

/// What is in another unit is told of the body, and not of what it makes of the frame.
#[test]
fn bodies_in_other_units_are_told_as_they_were_written() {
    let directory = Directory::of_this_test();
    for (body, names, example) in [
        (
            "mass=75, at=(300,0,-1100)",
            "`x`, `z` are too large for a bicycle, and ordinary in mm; write that unit behind each",
            "300 mm",
        ),
        (
            "mass=5, at=(30,0,-90)",
            "`x`, `z` are too large for a bicycle, and ordinary in cm; write that unit behind each",
            "30 cm",
        ),
        (
            "mass=5000, at=(0.3,0,-0.9)",
            "`mass` is too large for a bicycle, and ordinary in g; write that unit behind it",
            "5000 g",
        ),
        (
            "mass=5, at=(0.3,0,-0.9), box=(400,200,20)",
            "`box` is too large for a bicycle, and ordinary in mm; write that unit behind it",
            "400 mm",
        ),
        (
            "mass=5, at=(0.3,0,-0.9), Ixx=900, Iyy=900, Izz=900",
            "`Ixx`, `Iyy`, `Izz` are too large for a bicycle, and ordinary in kg*cm^2; write that unit behind each",
            "900 kg*cm^2",
        ),
    ] {
        let run = directory.run(&["show", "pista", "--add", body]);
        let mass = body.split(['=', ',']).nth(1).unwrap();
        let message = format!("warning: pista + {mass} kg: --add '{body}': {names}, as in `{example}`\n");
        assert_eq!((run.code, run.stderr), (Some(0), message));
    }
}
