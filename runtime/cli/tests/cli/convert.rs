//! Bicycles in the names and axes of others: held against what their programs make of them, there and back.

use std::collections::BTreeMap;

use crate::Directory;

/// The same bicycles in two conventions each, by the programs that have them; `conventions.py` beside it says which.
const PAIRS: &str = include_str!("../../../../tests/data/conventions.tsv");

/// The values of a side of a pair.
fn side(pair: &str, side: &str) -> BTreeMap<String, f64> {
    let rows = PAIRS.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect::<Vec<_>>());
    let rows = rows.filter(|row| row[0] == pair && row[1] == side);
    let values: BTreeMap<_, _> = rows.map(|row| (row[2].to_owned(), row[3].parse().unwrap())).collect();
    assert!(!values.is_empty(), "{pair} has no {side}");
    values
}

/// As BicycleParameters has it.
fn text(values: &BTreeMap<String, f64>) -> String {
    values.iter().map(|(name, value)| format!("{name} = {value:?}\n")).collect()
}

/// The parameters of a file, converted.
fn converted(directory: &Directory, file: &str, to: &str) -> BTreeMap<String, f64> {
    let run = directory.run(&["convert", file, "--to", to, "--format", "json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let values = json["parameters"].as_object().unwrap().iter();
    let number = |value: &serde_json::Value| value.as_f64().or_else(|| value["value"].as_f64()).unwrap();
    values.map(|(name, value)| (name.clone(), number(value))).collect()
}

/// Every value of `expected` is there, to so many parts of the largest.
#[track_caller]
fn close(found: &BTreeMap<String, f64>, expected: &BTreeMap<String, f64>, tolerance: f64) {
    for (name, value) in expected {
        let found = found.get(name).unwrap_or_else(|| panic!("{name} is missing in {found:?}"));
        assert!((found - value).abs() <= tolerance * value.abs().max(1.0), "{name} is {found}, not {value}");
    }
}

/// The benchmark in the newer names of Peterson's libbicycle, as its `derivation/benchmark_parameters.py` has it.
const LIBBICYCLE: [(&str, f64); 22] = [
    ("rear_Ixx", 7.684_799_791_449_106),
    ("rear_Iyy", 11.999_310_344_827_58),
    ("rear_Izz", 5.315_110_553_378_478),
    ("rear_Ixz", 4.262_158_094_617_231),
    ("rear_J", 0.12),
    ("rear_m", 87.0),
    ("rear_R", 0.3),
    ("rear_a", 0.459_905_837_685_617_5),
    ("rear_b", -0.466_941_942_235_536_3),
    ("rear_c", 0.953_457_069_612_184_7),
    ("front_Ixx", 0.433_537_975_531_100_7),
    ("front_Iyy", 0.574_685_714_285_714_2),
    ("front_Izz", 0.148_147_738_754_613_5),
    ("front_Ixz", 0.005_332_503_757_935_522),
    ("front_J", 0.28),
    ("front_m", 7.0),
    ("front_R", 0.35),
    ("front_a", -0.003_411_905_099_535_387),
    ("front_b", -0.211_401_040_016_169_9),
    ("front_c", -0.032_071_426_727_619_3),
    ("ls", 0.267_644_508_447_688_7),
    ("g", 9.81),
];

/// Written so, and read as attributes, in groups, and with the radii of crowns; the masses and radial moments of the wheels are of the
/// benchmark, since two gyrostats do not tell them.
#[test]
fn wheel_assemblies_of_libbicycle_come_out() {
    let directory = Directory::new("convert-libbicycle");
    let expected = LIBBICYCLE.map(|(name, value)| (name.to_owned(), value)).into();
    close(&converted(&directory, "benchmark", "libbicycle"), &expected, 4e-15);
    let of = |assembly: &str, separator: &str| -> String {
        let own = LIBBICYCLE.iter().filter_map(|(name, value)| Some((name.strip_prefix(assembly)?, value)));
        own.map(|(name, value)| format!("{assembly}{separator}{} = {value:?}\n", &name[1..])).collect()
    };
    let crowns = "rear.r = 0\nfront.r = 0\n";
    let [rear, front] = ["rear", "front"].map(|assembly| of(assembly, "."));
    let groups = ["rear", "front"].map(|which| of(which, ".").replace(&format!("{which}."), ""));
    let common = "ls = 0.2676445084476887\ng = 9.81\n";
    let json = LIBBICYCLE.map(|(name, value)| format!("\"{name}\": {value:?}")).join(", ");
    for (file, text) in [
        ("attributes.txt", format!("{rear}{front}{crowns}{common}")),
        ("members.txt", format!("{}{}{common}", rear.replace("rear.", "rear_."), front.replace("front.", "b.front_."))),
        ("underscores.py", format!("{}{}{common}", of("rear", "_"), of("front", "_"))),
        ("groups.toml", format!("{common}[rear]\n{}[front]\n{}", groups[0], groups[1])),
        ("whole.json", format!("{{{json}}}")),
    ] {
        directory.write(file, text);
        close(&converted(&directory, file, "libbicycle"), &expected, 4e-15);
        let older = converted(&directory, file, "gyrostats");
        close(&older, &side("gyrostats benchmark", "gyrostats"), 4e-15);
        let wheels = ["mR=2", "IRxx=0.0603", "mF=3", "IFxx=0.1405"].map(|wheel| ["--set", wheel]).concat();
        let run = directory.run(&[&["convert", file, "--to", "paper", "--format", "json"], &wheels[..]].concat());
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{}", run.stderr));
        for (name, value) in side("gyrostats benchmark", "paper") {
            let found = json["parameters"][&name].as_f64().unwrap();
            assert!((found - value).abs() <= 3e-14 * value.abs().max(1.0), "{file}: {name} is {found}, not {value}");
        }
    }
    // The trail of the paper is a `c`, too.
    for set in ["front_c=-0.04", "front.c=-0.04", "front_.c=-0.04"] {
        let run = directory.run(&["convert", "benchmark", "--set", set, "--to", "libbicycle", "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{}", run.stderr));
        let [front, rear] = ["front_c", "rear_c"].map(|name| json["parameters"][name].as_f64().unwrap());
        assert!(
            (front + 0.04).abs() < 1e-15 && (rear - 0.953_457_069_612_184_7).abs() < 4e-15,
            "{set}: {front}, {rear}"
        );
    }
    directory.write("crown.txt", format!("{rear}{front}rear.r = 0.02\n{common}"));
    let run = directory.run(&["show", "crown.txt"]);
    assert!(run.stderr.contains("it must be 0: wheels are edged here"), "{}", run.stderr);
}

/// Both ways, to the digits that the sources have.
#[test]
fn pairs_of_other_programs_come_out() {
    let directory = Directory::new("convert-pairs");
    for (pair, convention, tolerance) in [
        ("moore benchmark", "moore", 4e-15),
        // The sources have 12 digits.
        ("moore legs", "moore", 1e-11),
        ("pydy benchmark", "pydy", 4e-15),
        ("gyrostats benchmark", "gyrostats", 4e-15),
    ] {
        directory.write("paper.txt", text(&side(pair, "paper")));
        close(&converted(&directory, "paper.txt", convention), &side(pair, convention), tolerance);
    }
    for (pair, tolerance) in [
        ("moore benchmark", 4e-15),
        ("moore legs", 1e-11),
        ("pydy benchmark", 4e-15),
        ("principal browserjason", 4e-15),
        ("principal extendedoptf", 4e-14),
        ("principal moore2019", 4e-15),
    ] {
        directory.write("other.txt", text(&side(pair, pair.split(' ').next().unwrap())));
        close(&converted(&directory, "other.txt", "paper"), &side(pair, "paper"), tolerance);
    }
}

/// The front frame is one body in both, and its radii and angle are those of the published set.
#[test]
fn principal_axes_are_the_published_ones() {
    let directory = Directory::new("convert-principal");
    for (pair, tolerance) in [("principal browserjason", 4e-15), ("principal moore2019", 4e-15)] {
        let mut expected = side(pair, "principal");
        expected
            .retain(|name, _| name.starts_with("kH") || name == "alphaH" || name.starts_with("kR") && name != "kRbb");
        assert!(expected.len() > 5);
        directory.write("paper.txt", text(&side(pair, "paper")));
        close(&converted(&directory, "paper.txt", "principal"), &expected, tolerance);
    }
}

/// JBike6 computes matrices from its seven bodies, and so does the paper's bicycle that they are read as.
#[test]
fn seven_bodies_have_the_matrices_of_jbike6() {
    let directory = Directory::new("convert-jbike6");
    directory.write("bodies.txt", text(&side("jbike6 bodies", "jbike6")));
    let json: serde_json::Value = {
        let run = directory.run(&["analyze", "bodies.txt", "--format", "json"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert!(run.stderr.starts_with("note: bodies.txt: in the names of JBike6"), "{}", run.stderr);
        serde_json::from_str(&run.stdout).unwrap()
    };
    for (name, value) in side("jbike6 bodies", "matrices") {
        let (matrix, place) = name.split_at(name.len() - 2);
        let [row, column] = [0, 1].map(|at| place[at..=at].parse::<usize>().unwrap() - 1);
        let found = json["matrices"][matrix][row][column].as_f64().unwrap();
        assert!((found - value).abs() <= 1e-14 * value.abs().max(100.0), "{name} is {found}, not {value}");
    }
}

/// A script as JBike6 has them: in Latin-1, with lists of moments and parts of them, expressions and settings. The values are those of
/// a bicycle of the steer-by-wire project at Delft in its initial file of JBike6.
const SCRIPT: &str = "% JBini_City.m\n% Created \u{a9} 2015\napp_name = 'JBike6';\ngravity = 9.80665; % gravity\n\
    weave_speed_color = [0 1 0]; % green\n\t% bike name\n\tname = 'City bike';\n\twheelbase = 1.03; %meters\n\
    \tlambda =  0.2967; %radians\n\thead_angle = pi/2-lambda;\n  offset=0.044;\n\tDrearwheel = 0.6858;\n\
    \tmrearwheel = 8.5;\n\tIrearwheel =  [0.095625 0.095625  0.19125];\n\talphaIrearwheel = 0;\n\
    \tDfrontwheel =  0.6858;\n\tmfrontwheel = 1.84;\n\ttrail = (Dfrontwheel/2*sin(lambda)-offset)/cos(lambda);\n\
    \tIfrontwheel = 0.8*mfrontwheel*Dfrontwheel^2/4.*[1/2 1/2 1];\n\talphaIfrontwheel = 0;\n\tmrider = 80;\n\
    \txcmrider = 0.3;\n\tycmrider = 1.2;\n\tIrider = [10.53112887414928 2.46887112585073 12];\n\
    \talphaIrider = -0.25957305712326;\n\tmframe = 2.5;\n\
    \txcmframe = 0.4;\n\tycmframe = 0.6;\n\tIframe = [0.05857864376269, 0.34142135623731, 0.4];\n\
    \talphaIframe = 0.39269908169872;\n\tmfork = 1.5;\n\
    \tucmfork = 0;\n\tvcmfork = Dfrontwheel;\n\tIfork = mfork*(Dfrontwheel)^2/12.*[1 0.1^2 1];\n  Ifork(1:2:3)=0.096;\n\talphaIfork = lambda;\n\
    \tmbasket = 0;\n\tucmbasket = 0;\n\tvcmbasket = 0;\n\tIbasket = [0.00 0.00 0.00];\n\talphaIbasket = 0;\n\
    \tmrack = 4;\n\txcmrack = 0.4;\n\tycmrack = 0.55;\n\tIrack = [0.02 0.02 0.02];\n\talphaIrack = 0;\n";

#[test]
fn scripts_of_jbike6_are_read_as_they_are() {
    let directory = Directory::new("convert-script");
    let latin: Vec<u8> = SCRIPT.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
    assert!(std::str::from_utf8(&latin).is_err());
    directory.write("JBini_City.m", latin);
    let paper = converted(&directory, "JBini_City.m", "paper");
    let (sin, cos) = 0.2967_f64.sin_cos();
    let expected = [
        ("c", (0.3429 * sin - 0.044) / cos),
        ("lam", 0.2967),
        ("mB", 86.5),
        ("xB", (80.0 * 0.3 + 2.5 * 0.4 + 4.0 * 0.4) / 86.5),
        ("zB", -(80.0 * 1.2 + 2.5 * 0.6 + 4.0 * 0.55) / 86.5),
        ("IFxx", 0.8 * 1.84 * 0.6858 * 0.6858 / 8.0),
        ("zH", -0.6858 * cos),
        ("g", 9.80665),
    ];
    close(&paper, &expected.map(|(name, value)| (name.to_owned(), value)).into(), 4e-15);
    // The formulas of JBike6 for its seven bodies, at 30 digits; there steer to the left is positive.
    let json = directory.run(&["analyze", "JBini_City.m", "--format", "json"]).stdout;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    for (name, expected) in [
        ("M", [[129.560_969_317_222_2, 1.903_392_641_121_094], [1.903_392_641_121_094, 0.153_300_561_290_598_7]]),
        ("C1", [[0.0, 37.686_356_977_648_516], [-0.540_721_349_837_340_6, 1.003_016_812_829_301_8]]),
        (
            "K0",
            [[-104.229_338_498_849_26, -1.709_965_234_811_657_3], [-1.709_965_234_811_657_3, -0.499_935_683_637_170_8]],
        ),
        ("K2", [[0.0, 97.758_506_542_423_2], [0.0, 1.724_635_288_121_681_3]]),
    ] {
        for (row, expected) in json["matrices"][name].as_array().unwrap().iter().zip(expected) {
            for (found, expected) in row.as_array().unwrap().iter().zip(expected) {
                let found = found.as_f64().unwrap();
                assert!((found - expected).abs() < 2e-14 * expected.abs().max(10.0), "{name}: {found}, not {expected}");
            }
        }
    }
    let text = directory.run(&["show", "JBini_City.m"]);
    assert!(text.stdout.starts_with("name = \"City bike\"\n"), "{}", text.stdout);
    assert!(text.stderr.contains("not used: `app_name`, `weave_speed_color`\n"), "{}", text.stderr);
}

/// Every form of every convention reads back to the bicycle that it was written from.
#[test]
fn every_form_is_read_again() {
    let directory = Directory::new("convert-forms");
    let run = directory.run(&["convert", "browser-jason", "--to", "paper", "--format", "json"]);
    directory.write("paper.json", run.ok());
    let paper = converted(&directory, "paper.json", "paper");
    for convention in ["paper", "moore", "pydy", "principal", "gyrostats", "libbicycle", "jbike6", "geometry"] {
        for (format, ending) in [
            ("toml", "toml"),
            ("json", "json"),
            ("yaml", "yaml"),
            ("csv", "csv"),
            ("python", "py"),
            ("matlab", "m"),
            ("text", "txt"),
        ] {
            let file = format!("{convention}.{ending}");
            let run = directory.run(&["convert", "browser-jason", "--to", convention, "--output", &file]);
            assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{file}: {}", run.stderr);
            let split = ["mR", "IRxx", "mF", "IFxx"].map(|name| format!("{name}={:?}", paper[name]));
            let mut arguments = vec!["convert", &file, "--to", "paper", "--format", "json"];
            if matches!(convention, "gyrostats" | "libbicycle") {
                split.iter().for_each(|setting| arguments.extend(["--set", setting.as_str()]));
            }
            let run = directory.run(&arguments);
            assert_eq!(run.code, Some(0), "{file} ({format}): {}", run.stderr);
            let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            for (name, value) in &paper {
                let found = json["parameters"][name].as_f64().unwrap_or_else(|| panic!("{file}: {name}"));
                assert!(
                    (found - value).abs() <= 1e-14 * value.abs().max(1.0),
                    "{file}: {name} is {found}, not {value}"
                );
            }
        }
    }
}

/// A script whose comments stand behind statements, without a name that ends in `.m`.
#[test]
fn scripts_are_read_from_the_standard_input() {
    let directory = Directory::of_this_test();
    let json = ["--to", "paper", "--format", "json"];
    let whole: serde_json::Value =
        serde_json::from_str(&directory.run(&[&["convert", "benchmark"], &json[..]].concat()).ok()).unwrap();
    for convention in ["paper", "moore", "jbike6", "geometry"] {
        for format in ["matlab", "python"] {
            let script = directory.run(&["convert", "benchmark", "--to", convention, "--format", format]).stdout;
            let run = directory.run_with_input(&[&["convert", "-"], &json[..]].concat(), &script);
            assert_eq!(run.code, Some(0), "{convention} {format}: {}", run.stderr);
            let read: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            for name in ["w", "c", "lam", "mB", "IHxz", "IFyy"] {
                let [found, value] = [&read, &whole].map(|json| json["parameters"][name].as_f64().unwrap());
                assert!(
                    (found - value).abs() <= 1e-13 * value.abs().max(1.0),
                    "{convention} {format}: {name} is {found}"
                );
            }
        }
    }
}

/// Deviations of independent measurements become correlated ones in other parameters, and on the way back independent again.
#[test]
fn deviations_and_correlations_lead_back() {
    let directory = Directory::new("convert-deviations");
    let paper = directory.run(&["convert", "pista", "--to", "paper", "--format", "json"]).json();
    for convention in ["moore", "pydy", "principal", "geometry"] {
        for file in ["there.toml", "there.json"] {
            let run = directory.run(&["convert", "pista", "--to", convention, "--output", file]);
            assert_eq!(run.code, Some(0), "{}", run.stderr);
            let text = std::fs::read_to_string(directory.0.join(file)).unwrap();
            assert!(text.contains("correlations"), "{convention}: {text}");
            let run = directory.run(&["convert", file, "--to", "paper", "--format", "json"]);
            let back: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            for (name, value) in paper["parameters"].as_object().unwrap() {
                let [a, b] = [value, &back["parameters"][name]].map(|value| value["std"].as_f64());
                let (Some(a), Some(b)) = (a, b) else { panic!("{convention}: {name}") };
                assert!((a - b).abs() <= 1e-9 * a, "{convention}: {name} +/- {b}, not {a}");
            }
            let correlations = back["correlations"].as_object().into_iter().flatten();
            for (name, others) in correlations {
                for (other, value) in others.as_object().unwrap() {
                    assert!(value.as_f64().unwrap().abs() < 1e-9, "{convention}: {name} and {other}: {value}");
                }
            }
        }
    }
}

/// What was set is exact: on the way back deviations cancel, and rounding is none.
#[test]
fn what_is_exact_stays_exact() {
    let directory = Directory::new("convert-exact");
    for (convention, setting, exact) in
        [("moore", ["head_angle=72 deg", "trail=0.06"], ["lam", "c"]), ("pydy", ["lam=0.3", "w=1"], ["lam", "w"])]
    {
        let [first, second] = setting;
        let to = ["convert", "pista", "--to", convention, "--set", first, "--set", second, "--output", "there.json"];
        assert_eq!(directory.run(&to).code, Some(0), "{convention}");
        let run = directory.run(&["convert", "there.json", "--to", "paper", "--format", "json"]);
        let back: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        for name in exact {
            assert!(back["parameters"][name].is_number(), "{convention}: {name} is {}", back["parameters"][name]);
            assert!(back["correlations"].get(name).is_none(), "{convention}: {}", back["correlations"]);
        }
        assert!(back["parameters"]["mB"]["std"].is_number(), "{convention}: {}", back["parameters"]["mB"]);
    }
}

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

/// What is missing of Moore's parameters beside d1, d2, l1 and the radii.
const MOST_OF_MOORE: &str = "`d3`, `l2`, `l3`, `l4`, `mc`, `md`, `me`, `mf`, `ic11`, `ic33`, `ic31`, `id11`, `id22`, `ie11`, \
                             `ie33`, `ie31`, `if11`, `if22`, of the names of Moore (2012)";

/// What is wrong with a file in a convention is told by its names.
#[test]
fn mistakes_are_told_by_the_names_of_the_file() {
    let directory = Directory::new("convert-mistakes");
    let moore = directory.run(&["convert", "benchmark", "--to", "moore", "--format", "text"]).ok();
    let check = |text: String, message: &str| {
        directory.write("m.txt", text).run(&["analyze", "m.txt"]).fails(2, &format!("error: {message}\n"));
    };
    let without = |names: &[&str]| -> String {
        let is_left = |line: &&str| !names.iter().any(|name| line.starts_with(&format!("{name} =")));
        moore.lines().filter(is_left).map(|line| format!("{line}\n")).collect()
    };
    check(without(&["l3", "me"]), "m.txt: missing: `l3`, `me`, of the names of Moore (2012)");
    check(without(&["mc"]) + "mc = -3\n", "m.txt:27: `mc` is -3 kg; it must be >= 0");
    check(without(&["d1"]) + "d1 = 1 kg\n", "m.txt:27: `d1` is `1 kg`; `kg` is no unit for it: `d1` is in m");
    check(
        moore.clone() + "ic12 = 0.3\n",
        "m.txt:28: `ic12` is 0.3 kg m²; it must be 0: the bicycle is laterally symmetric",
    );
    check(moore.clone() + "d1 = 1\n", "m.txt:28: `d1` is given twice; first at m.txt:4");
    check(
        moore.clone() + "w = 1.03\n",
        "m.txt:28: `w` is 1.03 m, but 1.0199999999999998 m follows from the others in m.txt",
    );
    let near = without(&["d1", "d2"]) + "d1 = 0.001\nd2 = 0.001\n";
    check(near, "m.txt: the wheels do not both touch the ground with d1, d2 and d3: their centres are too near");

    check("d1 = 1\nd2 = 0.2\nl1 = 0.3\nrr = 0.3\nrf = 0.3\n".to_owned(), &format!("m.txt: missing: {}", MOST_OF_MOORE));
    let part = "% x\nname = 'a';\nwheelbase = 1;\nmrider = 3;\nDrearwheel = 0.6;\nmfork = 2;\nIfork(1:2:3) = 0.1;\n";
    let run = directory.write("part.m", part).run(&["show", "part.m"]);
    run.fails(2, "error: part.m:7: `Ifork(1:2:3)` is a part of a list; expected all of it before\n");

    let gyrostats = directory.run(&["convert", "benchmark", "--to", "gyrostats", "--format", "json"]);
    directory.write("g.json", gyrostats.stdout);
    let run = directory.run(&["convert", "g.json", "--to", "jbike6"]);
    let missing = "error: benchmark: two gyrostats do not tell how much of them the wheels are, which the names of JBike6 need; \
                   give --set mR=… --set IRxx=… --set mF=… --set IFxx=…\n";
    assert!(run.code == Some(2) && run.stderr.ends_with(missing), "{}", run.stderr);
    // But their motion is all there.
    let motion = |arguments: &[&str]| -> serde_json::Value {
        let run = directory.run(&[&["analyze"], arguments, &["--format", "json"]].concat());
        serde_json::from_str(&run.stdout).unwrap()
    };
    let (known, found) = (motion(&["benchmark"]), motion(&["g.json"]));
    for matrix in ["M", "C1", "K0", "K2"] {
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let [a, b] = [&known, &found].map(|json| json["matrices"][matrix][row][column].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-14 * a.abs().max(10.0), "{matrix}: {b}, not {a}");
        }
    }

    let bicycle = |arguments: &[&str], message: &str| {
        directory.run(&[&["convert"], arguments].concat()).fails(2, &format!("error: {message}\n"));
    };
    let known = "there is no parameterization `more`; there are paper, moore, pydy, principal, gyrostats, \
                 libbicycle, jbike6, geometry; did you mean `moore`?";
    bicycle(&["--to", "more"], &format!("--to more: {known}"));
    bicycle(
        &["--model", "Pendulum", "--to", "moore"],
        "Pendulum seconds: the model Pendulum has other parameters than a bicycle",
    );
    let sprung =
        "WhippleSprung benchmark: the names of Moore (2012) have no place for `k`, `d` of the model WhippleSprung";
    bicycle(&["--model", "WhippleSprung", "--to", "moore"], sprung);
    let wheel = "benchmark: the rear wheel has inertia and no mass, and so no radius of gyration";
    bicycle(&["--set", "mR=0", "--to", "principal"], wheel);
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
        usual.replace("fork_offset = 45 mm\n", ""),
        ": missing: `fork_offset` (or `trail`), of the geometry that manufacturers print",
    );
    fails(
        usual.to_owned() + "trail = 70 mm\n",
        ": `trail` is 70.0 mm, but 59.7 mm with the fork offset; leave one of them out",
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
