//! Results in other units: numbers, and headings that tell the truth about them.

use crate::Directory;

/// The weave and capsize speeds of the benchmark as the paper prints them, in m/s.
const PRINTED: [f64; 2] = [4.292_382_536_341_11, 6.024_262_015_388_37];

#[track_caller]
fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found}, not {expected}");
}

/// The line that begins so, and the number behind that.
#[track_caller]
fn number(text: &str, start: &str) -> f64 {
    let line = text.lines().find_map(|line| line.trim_start().strip_prefix(start)).unwrap_or_else(|| panic!("{text}"));
    line.split_whitespace().next().unwrap().parse().unwrap()
}

#[test]
fn speeds_are_in_the_unit_of_their_headings() {
    let directory = Directory::new("units");
    for (unit, factor) in [("km/h", 3.6), ("mph", 3600.0 / 1609.344), ("ft/s", 1.0 / 0.3048), ("cm/s", 100.0)] {
        let run = |format: &str| {
            let arguments = ["analyze", "--units", unit, "--speeds", "0,4.5,9", "--format", format];
            directory.run(&arguments).ok()
        };
        let table = run("table");
        assert!(
            table.contains(&format!("Critical speeds ({unit})\n")) && table.contains(&format!("v ({unit})")),
            "{table}"
        );
        assert!(table.contains(&format!(" {unit}\n")) && !table.contains("(m/s)"), "{table}");
        close(number(&table, "weave "), factor * PRINTED[0]);
        close(number(&table, "capsize "), factor * PRINTED[1]);
        close(number(&table, "self-stable from "), factor * PRINTED[0]);

        let csv = run("csv");
        let mut lines = csv.lines().map(|line| line.split(',').next().unwrap());
        assert_eq!(lines.next(), Some(format!("speed ({unit})").as_str()));
        lines.zip([0.0, 4.5, 9.0]).for_each(|(found, speed)| close(found.parse().unwrap(), factor * speed));

        let json: serde_json::Value = serde_json::from_str(&run("json")).unwrap();
        assert_eq!(json["speed_unit"], unit);
        close(json["critical_speeds"][1]["speed"].as_f64().unwrap(), factor * PRINTED[0]);
        close(json["stable_ranges"][0][1].as_f64().unwrap(), factor * PRINTED[1]);
        close(json["eigenvalues"][2]["speed"].as_f64().unwrap(), factor * 9.0);
        // Parameters stay as they are, and are read again.
        assert_eq!(json["parameters"]["w"], 1.02);
        directory.write("result.json", run("json")).run(&["analyze", "result.json"]).ok();

        let markdown = run("markdown");
        assert!(markdown.contains(&format!("v ({unit}) |")) && !markdown.contains("(m/s)"), "{markdown}");
    }
    let json = directory.run(&["analyze", "--format", "json"]).json();
    assert!(json.get("speed_unit").is_none());
}

/// Eigenvalues do not change, whatever the speeds are written in; and tables have round speeds of that unit.
#[test]
fn round_speeds_of_a_unit_have_the_eigenvalues_of_these_speeds() {
    let directory = Directory::new("units-round");
    let shown = directory.run(&["analyze", "--units", "km/h"]).ok();
    let speeds: Vec<String> = [0, 5, 10, 15, 20, 25, 30, 35].map(|speed| format!("{speed} km/h")).into();
    let given = directory.run(&["analyze", "--units", "km/h", "--speeds", &speeds.join(",")]).ok();
    let rows = |text: &str| -> Vec<String> {
        text.lines().skip_while(|line| !line.contains("v (km/h)")).skip(1).map(str::to_owned).collect()
    };
    assert!(rows(&shown).len() >= 8);
    assert_eq!(rows(&shown)[..8], rows(&given)[..]);
    assert!(rows(&given)[3].starts_with("       15 "), "{given}");
}

#[test]
fn pictures_and_lists_say_their_unit() {
    let directory = Directory::new("units-pictures");
    let run = directory.run(&["analyze", "--units", "km/h", "--plot", "a.svg", "--speeds", "0:10:1"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let svg = std::fs::read_to_string(directory.0.join("a.svg")).unwrap();
    assert!(svg.contains("forward speed v (km/h)") && svg.contains("weave 15.4526"), "{svg}");
    let list = directory.run(&["bicycles", "--units", "km/h"]).ok();
    assert!(list.starts_with("bicycle          weave (km/h)     capsize (km/h)   stable (km/h)"), "{list}");
    assert!(list.contains("benchmark        15.4526          21.6873          15.4526 to 21.6873"), "{list}");
}

/// What is shown in other units reads back to the same bicycle.
#[test]
fn parameters_in_other_units_are_read_again() {
    let directory = Directory::new("units-show");
    let plain = directory.run(&["convert", "pista", "--to", "paper", "--format", "json"]).json();
    for units in ["mm,deg,g", "imperial", "cm,kg*cm^2"] {
        directory.write("other.toml", directory.run(&["show", "pista", "--units", units]).ok());
        let run = directory.run(&["convert", "other.toml", "--to", "paper", "--format", "json"]);
        let other: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        for (name, value) in plain["parameters"].as_object().unwrap() {
            for member in ["value", "std"] {
                let [a, b] = [value, &other["parameters"][name]].map(|value| value[member].as_f64());
                let (a, b) = (a.unwrap(), b.unwrap());
                assert!((a - b).abs() <= 4e-16 * a.abs(), "{units}: {name} {member} is {b}, not {a}");
            }
        }
    }
    let text = directory.run(&["show", "--units", "in,lb"]).ok();
    assert!(text.contains("w = \"40.15748031496063 in\"") && text.contains("mB = \"187.39292285714595 lb\""), "{text}");
}

#[test]
fn mistakes_in_units_are_told() {
    let directory = Directory::new("units-mistakes");
    let run = |units: &str| directory.run(&["analyze", "--units", units]);
    run("furlong").fails(
        2,
        "error: --units furlong: `furlong` is no unit; expected such as mm, in, deg, kg, lb, km/h, mph or kg*cm^2\n",
    );
    run("mm,cm").fails(2, "error: --units mm,cm: `mm` and `cm` are units of the same quantity\n");
    run("").fails(2, "error: --units : expected units such as mm,deg,km/h, or imperial\n");
    let run = directory.run(&["convert", "--to", "moore", "--format", "python", "--units", "mm"]);
    run.fails(2, "error: --units: this form has no place for units; toml, json, yaml and csv have\n");
}

/// Units by their names go before those of `imperial`, and pounds of mass stand beside newtons and pounds of force: an inch is 0.0254 m,
/// and a pound 0.45359237 kg.
#[test]
fn units_stand_beside_imperial_and_pounds_beside_forces() {
    let directory = Directory::of_this_test();
    let analyze = directory.run(&["analyze", "--units", "imperial,km/h"]).stdout;
    assert!(analyze.contains("15.452") && !analyze.contains("mph"), "{analyze}");
    let show = directory.run(&["show", "--units", "imperial,mm"]).ok();
    assert!(show.contains("w = \"1020 mm\"") && show.contains("mB = \"187.39292285714595 lb\""), "{show}");
    let simulate = ["simulate", "--speed", "5", "--duration", "0", "--initial", "phi=0", "--format", "csv", "--units"];
    for (units, force) in [("N,lb", "(N)"), ("lb,N", "(N)"), ("lb,lbf", "(lbf)"), ("lbf,lb", "(lbf)"), ("lb", "(lb)")] {
        let motion = directory.run(&[&simulate[..], &[units]].concat());
        assert!(motion.stdout.contains(&format!("force_R_z {force}")), "{units}: {}{}", motion.stdout, motion.stderr);
    }
}

/// State spaces in degrees, millimetres and km/h are those in SI units, entry by entry, with every form saying so.
#[test]
fn control_is_in_other_units() {
    let directory = Directory::new("units-control");
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let degree = std::f64::consts::PI / 180.0;
    let close = |found: f64, expected: f64| {
        assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found} is not {expected}");
    };
    let units = ["--units", "km/h,deg,mm"];
    let both = |arguments: &[&str]| -> [serde_json::Value; 2] {
        [&[][..], &units].map(|units| {
            // Some have nothing in mm, which a note tells.
            let run = directory.run(&[arguments, units, &["--format", "json"]].concat());
            serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{error}: {}", run.stderr))
        })
    };
    let [plain, shown] = both(&["statespace", "--speed", "5", "--inputs", "Tdelta", "--outputs", "phi,delta_rate,y"]);
    assert_eq!((number(&shown["speed"]), shown["speed_unit"].as_str()), (18.0, Some("km/h")));
    assert!(plain.get("speed_unit").is_none());
    let names: Vec<&str> = shown["states"].as_array().unwrap().iter().map(|of| of["unit"].as_str().unwrap()).collect();
    assert_eq!(names, ["deg", "deg", "deg/s", "deg/s", "deg", "mm"]);
    for (matrix, row, column, factor) in
        [("A", 3, 0, 1.0), ("A", 5, 4, 1e3 * degree), ("B", 3, 0, 1.0 / degree), ("C", 2, 5, 1.0), ("C", 1, 3, 1.0)]
    {
        let entry = |space: &serde_json::Value| number(&space[matrix][row][column]);
        close(entry(&shown), factor * entry(&plain));
    }
    // Gains are in degrees, and poles in 1/s whatever the units.
    let [plain, shown] = both(&["transfer", "--speed", "5", "--inputs", "Tdelta", "--outputs", "phi"]);
    let [plain, shown] = [&plain, &shown].map(|json| &json["transfer_functions"][0]);
    assert_eq!(shown["unit"], "deg/(N*m)");
    close(number(&shown["gain"]), number(&plain["gain"]) / degree);
    close(number(&shown["zeros"][0]["re"]), number(&plain["zeros"][0]["re"]));
    // What is given is so still, with its own unit or that of the SI.
    let [plain, shown] = both(&["respond", "--speed", "5", "--initial", "phi=0.1", "--outputs", "phi,psi_rate"]);
    close(number(&shown["excitation"]["initial"]["phi"]), 0.1 / degree);
    for name in ["phi", "psi_rate"] {
        let at = |json: &serde_json::Value| number(&json["rows"][70]["outputs"][name]);
        assert!((at(&shown) - at(&plain) / degree).abs() < 1e-12 * (at(&plain) / degree).abs().max(1.0));
    }
    let [plain, shown] = both(&["controllability", "--speeds", "5", "--inputs", "Tdelta"]);
    close(number(&shown["rows"][0]["speed"]), 18.0);
    close(number(&shown["lost"][0]["speed"]), 3.6 * number(&plain["lost"][0]["speed"]));
    assert_eq!(shown["rows"][0]["controllability"], plain["rows"][0]["controllability"]);
    let asked = ["lqr", "--speeds", "4", "--inputs", "Tdelta", "--weight", "y_rate=1", "--sensitivity"];
    let [plain, shown] = both(&asked);
    assert_eq!(shown["speed_unit"], "km/h");
    for path in ["gains", "sensitivities"] {
        let of = |json: &serde_json::Value| {
            let found = &json["regulators"][0][path];
            number(if path == "gains" { &found[0][0] } else { &found["mB"][0][0] })
        };
        close(of(&shown), of(&plain) * degree);
    }
    let table = directory.run(&["lqr", "--speeds", "4", "--inputs", "Tdelta", "--units", "deg,km/h"]).ok();
    assert!(table.contains("    v (km/h)  phi (N m/deg)  delta (N m/deg)  phi_rate (N m s/deg)"), "{table}");
    assert!(table.contains("\n        14.4 "), "{table}");
    let emitted = ["lqr", "--speeds", "4", "--inputs", "Tdelta", "--units", "deg", "--emit", "c"];
    directory.run(&emitted).fails(2, "error: --units: with --emit all is in units of the SI\n");
}

/// The same motion and the same circles, in other units, which every form tells.
#[test]
fn motions_and_turns_are_in_other_units() {
    let directory = Directory::new("units-motions");
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let degree = std::f64::consts::PI / 180.0;
    let close = |found: f64, expected: f64| {
        assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found} is not {expected}");
    };
    let units = ["--units", "km/h,deg,mm"];
    let both = |arguments: &[&str]| -> [serde_json::Value; 2] {
        [&[][..], &units].map(|units| {
            // Some have nothing in mm, which a note tells.
            let run = directory.run(&[arguments, units, &["--format", "json"]].concat());
            serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{error}: {}", run.stderr))
        })
    };
    let ride = ["simulate", "--speed", "4.6", "--initial", "phi_rate=0.5", "--duration", "1"];
    let [plain, shown] = both(&ride);
    assert!(plain.get("units").is_none());
    assert_eq!((&shown["units"]["x"], &shown["units"]["phi"]), (&"mm".into(), &"deg".into()));
    for (member, name, factor) in [
        ("positions", "x", 1e3),
        ("rates", "x", 3.6),
        ("positions", "phi", 1.0 / degree),
        ("accelerations", "delta", 1.0 / degree),
    ] {
        let last = |json: &serde_json::Value| number(&json["rows"].as_array().unwrap().last().unwrap()[member][name]);
        close(last(&shown), factor * last(&plain));
    }
    let table = directory.run(&[&ride[..], &["--units", "km/h,mm"]].concat()).ok();
    assert!(table.contains("  t (s)  v (km/h)     x (mm)"), "{table}");
    assert!(table.contains("\n      1   16.6381  4542.3970 "), "{table}");
    let csv = directory.run(&[&ride[..], &units, &["--format", "csv"]].concat()).ok();
    assert!(csv.starts_with("t (s),x (mm),y (mm),psi (deg),") && csv.contains(",phi_rate (deg/s),"), "{csv}");
    let [plain, shown] = both(&["turns", "--steer", "5 deg"]);
    assert_eq!(shown["units"]["speed"], "km/h");
    let turn = |json: &serde_json::Value| json["families"][0]["turns"][0].clone();
    let (plain, shown) = (turn(&plain), turn(&shown));
    close(number(&shown["speed"]), 3.6 * number(&plain["speed"]));
    close(number(&shown["radius"]), 1e3 * number(&plain["radius"]));
    close(number(&shown["positions"]["delta"]), 5.0);
    close(number(&shown["rates"]["psi"]), number(&plain["rates"]["psi"]) / degree);
    let table = directory.run(&["turns", "--steer", "5 deg", "--units", "km/h,rad"]).ok();
    assert!(
        table.contains("km/h") && table.contains("steer delta (rad)") && table.contains("yaw rate (rad/s)"),
        "{table}"
    );
    let csv = directory.run(&["turns", "--steer", "5 deg", "--units", "km/h,deg", "--format", "csv"]).ok();
    assert!(csv.starts_with("capsize_speed (km/h),speed (km/h),radius (m),phi (deg),"), "{csv}");
}

/// Columns of sweeps say their unit, and are designs again as they are.
#[test]
fn sweeps_have_units_in_their_headings() {
    let directory = Directory::new("units-sweep");
    let arguments = ["sweep", "--vary", "lam=17 deg:19 deg:1 deg", "--vary", "w=1.02", "--eigenvalues", "5"];
    let plain = directory.run(&arguments).stdout;
    let shown = directory.run(&[&arguments[..], &["--units", "km/h,deg,mm"]].concat()).stdout;
    let [plain, shown] = [plain, shown].map(|text| {
        text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect::<Vec<Vec<String>>>()
    });
    let names = ["lam (deg)", "w (mm)", "weave_count", "weave_1 (km/h)"];
    assert_eq!(shown[0][..4], names);
    assert!(shown[0].contains(&"eigenvalue_1_re_at_5".to_owned()));
    close(shown[2][0].parse().unwrap(), 18.0);
    assert_eq!(shown[2][1], "1020.0");
    close(shown[2][3].parse().unwrap(), 3.6 * PRINTED[0]);
    let at = |name: &str| shown[0].iter().position(|heading| heading == name).unwrap();
    close(shown[2][at("stable_to_1 (km/h)")].parse().unwrap(), 3.6 * PRINTED[1]);
    assert_eq!(shown[2][at("eigenvalue_4_re_at_5")], plain[2][at("eigenvalue_4_re_at_5")]);
    let designs: String = shown.iter().map(|row| format!("{},{}\n", row[0], row[1])).collect();
    directory.write("designs.csv", designs);
    let again = directory.run(&["sweep", "--designs", "designs.csv"]).stdout;
    let weave: f64 = again.lines().nth(2).unwrap().split(',').nth(3).unwrap().parse().unwrap();
    close(weave, PRINTED[0]);
    let run = directory.run(&["sweep", "--vary", "w=1,1.1", "--units", "furlong"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
}

/// Speeds and parameters in tables.
#[test]
fn comparisons_and_optima_have_units_in_tables() {
    let directory = Directory::new("units-compared");
    let compare = ["compare", "benchmark", "benchmark:w=1.1", "--units", "km/h,mm"];
    let table = directory.run(&compare).stdout;
    assert!(table.contains("Critical speeds (km/h)\n") && !table.contains("m/s"), "{table}");
    close(number(&table, "weave "), format!("{:.4}", 3.6 * PRINTED[0]).parse().unwrap());
    let line = table.lines().find(|line| line.trim_start().starts_with("w ")).unwrap();
    assert_eq!(line.split_whitespace().collect::<Vec<_>>(), ["w", "mm", "1020", "1100"]);
    assert!(table.contains("1020 → 1100 mm"), "{table}");
    let optimize =
        ["optimize", "--vary", "w=0.9:1.2", "--minimize", "weave-speed", "--starts", "1", "--units", "imperial"];
    let run = directory.run(&[&optimize[..], &["--output", "best.toml"]].concat());
    assert!(run.stdout.contains("Critical speeds (mph)\n") && !run.stdout.contains("m/s"), "{}", run.stdout);
    let best = std::fs::read_to_string(directory.0.join("best.toml")).unwrap();
    assert!(best.contains(" in\""), "{best}");
    directory.run(&["analyze", "best.toml"]).ok();
}

/// Differences, optima, effects and measured parameters as JSON and CSV: each number by hand, from that in units of the SI, and each
/// with its unit.
#[test]
fn documents_of_designs_have_units() {
    let directory = Directory::of_this_test();
    let both = |arguments: &[&str], units: &str| {
        let json = |more: &[&str]| -> serde_json::Value {
            let run = directory.run(&[arguments, &["--format", "json"], more].concat());
            assert!(run.code == Some(0) && !run.stderr.contains("--units"), "{arguments:?}: {}", run.stderr);
            serde_json::from_str(&run.stdout).unwrap()
        };
        (json(&[]), json(&["--units", units]))
    };
    let csv = |arguments: &[&str], units: &str| -> Vec<Vec<String>> {
        let csv = directory.run(&[arguments, &["--format", "csv", "--units", units]].concat()).ok();
        csv.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
    };
    let ratio = |(plain, shown): &(serde_json::Value, serde_json::Value), path: &str, factor: f64| {
        let of = |json: &serde_json::Value| json.pointer(path).and_then(serde_json::Value::as_f64).unwrap();
        close(of(shown), factor * of(plain));
    };

    let compare = ["compare", "benchmark", "benchmark:w=1.1"];
    let jsons = both(&compare, "km/h");
    assert_eq!((&jsons.0["speed_unit"], &jsons.1["speed_unit"]), (&serde_json::Value::Null, &"km/h".into()));
    close(jsons.1["designs"][0]["critical_speeds"][1]["speed"].as_f64().unwrap(), 3.6 * PRINTED[0]);
    for of in ["from", "to", "difference", "contributions/w"] {
        ratio(&jsons, &format!("/differences/0/critical_speeds/0/{of}"), 3.6);
    }
    assert_eq!(jsons.1["designs"][1]["parameters"]["w"], 1.1);
    let rows = csv(&compare, "km/h,mm");
    assert_eq!(rows[0].join(",").matches("(km/h)").count(), 4);
    assert_eq!(rows[1][5..9], ["w", "mm", "1020.0", "1100.0"]);
    close(rows[1][3].parse().unwrap(), 3.6 * PRINTED[0]);

    let optimize = ["optimize", "--vary", "w=0.9:1.2", "--minimize", "weave-speed", "--starts", "1"];
    let jsons = both(&optimize, "km/h,cm");
    assert_eq!((&jsons.1["goal"]["unit"], &jsons.1["varied"]["w"]["unit"]), (&"km/h".into(), &"cm".into()));
    ratio(&jsons, "/goal/after", 3.6);
    ratio(&jsons, "/search/speeds/1", 3.6);
    ratio(&jsons, "/varied/w/after", 100.0);
    assert_eq!(jsons.1["varied"]["w"]["low"], 90.0);
    assert_eq!(csv(&optimize, "cm")[1][1..3], ["cm", "102.0"]);

    let sensitivity = ["sensitivity", "pista"];
    let jsons = both(&sensitivity, "km/h,mm,deg");
    let degree = std::f64::consts::PI / 180.0;
    ratio(&jsons, "/parameters/w/std", 1e3);
    ratio(&jsons, "/parameters/lam/one_percent", 1.0 / degree);
    ratio(&jsons, "/critical_speeds/1/derivatives/lam", 3.6 * degree);
    ratio(&jsons, "/critical_speeds/1/derivatives/mB", 3.6);
    ratio(&jsons, "/critical_speeds/1/eigenvalue_derivatives/lam/im", degree);
    ratio(&jsons, "/critical_speeds/1/standard_deviation", 3.6);
    ratio(&jsons, "/critical_speeds/1/condition", 1.0);
    let rows = csv(&sensitivity, "km/h,mm,deg");
    assert!(rows[0].iter().any(|name| name == "weave derivative (km/h per unit)"), "{:?}", rows[0]);
    let weave = jsons.1["critical_speeds"].as_array().unwrap().iter().find(|event| event["kind"] == "weave").unwrap();
    let w = weave["derivatives"]["w"].as_f64().unwrap();
    let column = rows[0].iter().position(|name| name == "weave derivative (km/h per unit)").unwrap();
    assert_eq!((rows[1][1].as_str(), rows[1][column].parse::<f64>().unwrap()), ("mm", w));
    // What is written is the same bicycle.
    directory.write("effects.json", jsons.1.to_string());
    let again = directory.run(&["sensitivity", "effects.json", "--format", "json"]).json();
    close(again["parameters"]["lam"]["std"].as_f64().unwrap(), jsons.0["parameters"]["lam"]["std"].as_f64().unwrap());

    directory.write("mine.toml", directory.run(&["measure", "--example"]).ok());
    let jsons = both(&["measure", "mine.toml"], "mm,lb");
    assert_eq!(jsons.1["parameters"]["w"], serde_json::json!({"value": 1121.0, "std": 2.0, "unit": "mm"}));
    // A pound is 0.45359237 kg.
    ratio(&jsons, "/parameters/mB/value", 1.0 / 0.453_592_37);
    directory.write("measured.json", jsons.1.to_string());
    let again = directory.run(&["convert", "measured.json", "--to", "paper", "--format", "json"]).stdout;
    let again: serde_json::Value = serde_json::from_str(&again).unwrap();
    assert_eq!(again["parameters"]["w"], serde_json::json!({"value": 1.121, "std": 0.002}));
}

/// What is written in pounds and inches is the same rider.
#[test]
fn riders_may_be_in_other_units() {
    let directory = Directory::new("units-rider");
    let measures = directory.run(&["rider", "--example"]).ok();
    let with_deviation = measures.replace("mass = 72", "mass = \"72+/-1\"");
    assert_ne!(with_deviation, measures);
    directory.write("me.toml", with_deviation);
    let mass = |units: &[&str]| {
        let rider = directory.run(&[&["rider", "me.toml"], units].concat()).ok();
        directory.write("rider.toml", &rider);
        let design = directory.run(&["show", "browser", "--add", "rider.toml"]).ok();
        let value = |name: &str| design.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
        (rider, ["mB = ", "xB = ", "zB = ", "IBxx = ", "IBxz = "].map(value))
    };
    let (rider, shown) = mass(&["--units", "imperial"]);
    assert!(rider.contains(" lb\"") && rider.contains("# lb*in²") || rider.contains("# lb in²"), "{rider}");
    let (own, expected) = mass(&[]);
    assert!(own.contains("# kg m²") && !own.contains("lb"), "{own}");
    let number = |line: &str| -> f64 {
        let digits = line.split_once('=').unwrap().1.split('#').next().unwrap().replace(['{', '}', '"'], "");
        digits.trim().trim_start_matches("value = ").split(',').next().unwrap().trim().parse().unwrap()
    };
    for (found, expected) in shown.iter().zip(&expected) {
        let (found, expected) = (number(found), number(expected));
        assert!((found - expected).abs() < 1e-13 * expected.abs().max(1.0), "{found}, {expected}");
    }
}

/// A column in millimetres in the place of metres is told once, with the name that it was given; what is ordinary is not.
#[test]
fn slips_of_units_are_told_once() {
    let directory = Directory::new("units-slips");
    directory.write("mm.csv", "w,c,mB\n1020,80,85\n1030,81,86\n1040,82,87\n");
    // A single design with a light wheel, and inertia of a heavy one, is none.
    directory.write("odd.csv", "IFyy,mF\n0.2,2\n0.28,3\n0.28,0.005\n");
    directory.write("moore.csv", "d1,d3\n953,0.032\n954,0.032\n");
    directory.write("degrees.csv", "head_angle\n72\n70\n73\n").write("none.csv", "head_angle\n720\n700\n730\n");
    directory.write("one.csv", "lam\n0.3\n0.31\n0.32\n18\n").write("headed.csv", "lam [deg]\n18\n20\n");
    let vary = |vary: &'static str| vec!["sweep", "--vary", vary];
    for (arguments, expected) in [
        (
            vary("w=900:1200:100"),
            vec![
                "`w`: 1200 is too large for a bicycle, and ordinary in mm; write that unit with its values, as in `1200 mm`",
            ],
        ),
        (
            vary("w=90:120:10"),
            vec![
                "`w`: 120 is too large for a bicycle, and ordinary in cm; write that unit with its values, as in `120 cm`",
            ],
        ),
        (
            vary("mB=60000,85000"),
            vec![
                "`mB`: 85000 is too large for a bicycle, and ordinary in g; write that unit with its values, as in `85000 g`",
            ],
        ),
        (
            vary("IBxx=92000,93000"),
            vec![
                "`IBxx`: 93000 is too large for a bicycle, and ordinary in kg*cm^2; write that unit with its values, as in `93000 kg*cm^2`",
            ],
        ),
        (vary("fork_offset=30:60:10"), vec!["`fork_offset`: with 60 `c` is "]),
        (vary("w=0.9:1.2:0.1"), vec![]),
        (vary("mB=0.001,0.01,85"), vec![]),
        (vary("head_angle=1 deg:80 deg:1 deg"), vec![]),
        (vec!["sweep", "--random", "w=900..1200", "--samples", "20"], vec!["`w`: "]),
        (vec!["sweep", "--designs", "mm.csv"], vec!["`w`: 1040 is too large", "`c`: 82 is too large"]),
        (vec!["sweep", "--designs", "odd.csv"], vec![]),
        (
            vec!["sweep", "--designs", "degrees.csv"],
            vec!["`head_angle` is 73 rad; it must be > 0 and < 3.141592653589793 (for degrees write `73 deg`)"],
        ),
        (vary("lam=0:20:5"), vec!["`lam` is 20 rad; it must be > "]),
        (vec!["sweep", "--designs", "none.csv"], vec![]),
        (vec!["sweep", "--designs", "one.csv"], vec![]),
        (vec!["sweep", "--designs", "headed.csv"], vec![]),
        (vec!["sweep", "--designs", "moore.csv"], vec!["`d1`: with 954 `w` is "]),
        (vec!["analyze", "--along", "w=900:1200", "--speed", "5"], vec!["`w`: 1200 is too large"]),
        (vec!["analyze", "--along", "fork_offset=-60:-30", "--speed", "5"], vec!["`fork_offset`: with -60 `c` is "]),
        (vec!["analyze", "--along", "w=0.9:1.2", "--speed", "5"], vec![]),
        (vec!["optimize", "--vary", "w=900:1200", "--minimize", "w", "--starts", "1"], vec!["`w`: 1200 is too large"]),
    ] {
        let run = directory.run(&arguments);
        let warnings: Vec<&str> = run.stderr.lines().filter_map(|line| line.strip_prefix("warning: ")).collect();
        assert_eq!(warnings.len(), expected.len(), "{arguments:?}: {}", run.stderr);
        for (warning, expected) in warnings.iter().zip(&expected) {
            assert!(warning.starts_with(expected), "{arguments:?}: {warning}");
        }
    }
}

/// Effects and derivatives by the units that are shown, from those of the JSON, which are in SI units.
#[test]
fn sensitivities_are_in_the_units_of_their_headings() {
    let directory = Directory::of_this_test();
    let table = directory.run(&["sensitivity", "--units", "km/h,mm,deg", "--plot", "tornado.svg"]).stdout;
    let json = directory.run(&["sensitivity", "--format", "json"]).json();
    let weave = json["critical_speeds"].as_array().unwrap().iter().find(|event| event["kind"] == "weave").unwrap();
    assert!(table.contains("Weave and capsize speeds (km/h)\n"), "{table}");
    assert!(table.contains("changes (km/h), and the derivative (km/h per unit)"), "{table}");
    for (name, unit, per_unit, value) in [("w", "mm", 1e-3, "1020"), ("lam", "deg", 1_f64.to_radians(), "18")] {
        let line = table.lines().find(|line| line.trim_start().starts_with(&format!("{name} "))).unwrap();
        let cells: Vec<&str> = line.split_whitespace().collect();
        assert_eq!((cells[1], cells[3]), (value, unit), "{line}");
        let derivative = weave["derivatives"][name].as_f64().unwrap();
        let of = |place: usize| cells[place].parse::<f64>().unwrap();
        let effect = 3.6 * derivative * json["parameters"][name]["one_percent"].as_f64().unwrap();
        assert!((of(4) - effect).abs() < 1e-6 && (of(5) - 3.6 * derivative * per_unit).abs() < 1e-6, "{line}");
    }
    let picture = std::fs::read_to_string(directory.0.join("tornado.svg")).unwrap();
    assert!(picture.contains("change of the critical speed (km/h)") && picture.contains("weave speed, 15.4526 km/h"));
}

/// Ten pound-force inches are 1.129848290276167 N m, by the figures of NIST SP 811.
#[test]
fn torques_are_in_pounds_of_force() {
    let directory = Directory::of_this_test();
    let motion = |force: &str, rate: &str| {
        let arguments = ["--duration", "0.1", "--initial", rate, "--force", force, "--format", "csv"];
        directory.run(&[&["simulate", "--speed", "5"], &arguments[..]].concat()).ok()
    };
    let expected = motion("Tdelta=1.129848290276167", "phi_rate=0.5235987755982988");
    for torque in ["10 lb*in", "10 lbf*in", "160 oz*in"] {
        assert_eq!(motion(&format!("Tdelta={torque}"), "phi_rate=30 deg/s"), expected, "{torque}");
    }
    let shown = directory.run(&["statespace", "--speed", "5", "--inputs", "Tdelta", "--units", "imperial"]).ok();
    assert!(shown.contains("steer torque  lb in"), "{shown}");
    let feedback =
        ["simulate", "--speed", "5", "--duration", "0.1", "--feedback", "Tdelta=-1.129848290276167*phi_rate"];
    let run = directory.run(&[&feedback[..], &["--initial", "phi_rate=1", "--units", "lb*in"]].concat()).ok();
    assert!(run.contains("Tdelta (lb in)") && run.contains("-10.0000"), "{run}");
}

/// Values that were given in a unit are written in it as they were given.
#[test]
fn conversions_make_no_digits() {
    let directory = Directory::of_this_test();
    let vary = ["--vary", "w=100 cm:120 cm:5 cm", "--vary", "lam=10 deg:30 deg:5 deg", "--units", "cm,deg"];
    let table = directory.run(&[&["sweep"], &vary[..]].concat()).stdout;
    let found: Vec<String> =
        table.lines().skip(1).map(|line| line.split(',').take(2).collect::<Vec<_>>().join(" ")).collect();
    let pair = |w: u32| (10..=30).step_by(5).map(move |lam| format!("{w}.0 {lam}.0"));
    let expected: Vec<String> = (100..=120).step_by(5).flat_map(pair).collect();
    assert_eq!(found, expected);
    let shown =
        directory.run(&["analyze", "--speeds", "0 km/h:20 km/h:1.1 km/h", "--units", "km/h", "--format", "csv"]).ok();
    let speeds: Vec<&str> = shown.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    let expected: Vec<String> = (0..=18).map(|k| format!("{:.1}", f64::from(11 * k) / 10.0)).collect();
    assert_eq!(speeds, expected);
}

/// A unit that is asked for has effect, or is told to have none; of `imperial` it is enough if one has.
#[test]
fn units_without_effect_are_told() {
    let directory = Directory::of_this_test();
    for (arguments, unused) in [
        (&["simulate", "--speed", "5", "--duration", "1", "--units", "deg/s,km/h"][..], "`deg/s`"),
        (&["analyze", "--units", "mm,km/h,kg"], "`mm`, `kg`"),
        (&["convert", "--to", "moore", "--units", "deg,mm"], "`deg`"),
        (&["statespace", "--speed", "5", "--units", "deg,kg"], "`kg`"),
        (&["analyze", "--along", "mB=60:100", "--speed", "5", "--units", "km/h,lb,in"], "`in`"),
    ] {
        let run = directory.run(arguments);
        let message = format!("note: --units: nothing here is in {unused}\n");
        assert!(run.code == Some(0) && run.stderr.ends_with(&message), "{arguments:?}: {}", run.stderr);
    }
    directory.run(&["analyze", "--units", "imperial"]).ok();
}

/// A torque of feedback, the forces of the ground and the energies, in what people have at hand.
#[test]
fn forces_and_energies_of_motions_have_units() {
    let directory = Directory::of_this_test();
    let simulate = ["simulate", "--speed", "5", "--duration", "0", "--initial", "phi_rate=0.5"];
    let simulate = [&simulate[..], &["--feedback", "Tdelta=-2*phi_rate", "--format"]].concat();
    let run = |more: &[&str]| directory.run(&[&simulate[..], more].concat());
    let csv = |more: &[&str]| run(&[&["csv"], more].concat()).ok();
    let of = |csv: &str, name: &str| -> f64 {
        let [header, row] = csv.lines().collect::<Vec<_>>()[..] else { panic!("two lines: {csv}") };
        let column = header.split(',').position(|own| own == name).unwrap_or_else(|| panic!("no {name}: {header}"));
        row.split(',').nth(column).unwrap().parse().unwrap()
    };
    // A pound-force is 4.4482216152605 N, and a foot 0.3048 m.
    let (pound, foot_pound) = (4.448_221_615_260_5, 1.355_817_948_331_400_4);
    let (plain, shown) = (csv(&[]), csv(&["--units", "lbf,lbf*ft"]));
    close(of(&shown, "Tdelta (lbf*ft)"), -1.0 / foot_pound);
    let forces = ["R", "F"].map(|wheel| of(&plain, &format!("force_{wheel}_z (N)")));
    // The ground bears the weight, but for what its circle about the ground takes: 94 kg by 9.81 N/kg, 80.95 kg m by (0.5 rad/s)^2.
    assert!((forces[0] + forces[1] + 94.0 * 9.81 - 80.95 * 0.25).abs() < 1e-3, "{forces:?}");
    close(of(&shown, "force_R_z (lbf)"), forces[0] / pound);
    close(of(&shown, "kinetic_energy (lbf*ft)"), of(&plain, "kinetic_energy (J)") / foot_pound);
    let json = run(&["json", "--units", "lbf,lbf*ft"]).json();
    assert_eq!(json["feedback_force_units"], serde_json::json!({"Tdelta": "lbf*ft"}));
    assert_eq!((&json["contact_force_unit"], &json["energy_unit"]), (&"lbf".into(), &"lbf*ft".into()));
    let row = &json["rows"][0];
    close(row["feedback_forces"]["Tdelta"].as_f64().unwrap(), -1.0 / foot_pound);
    close(row["contact_forces"]["R"][2].as_f64().unwrap(), forces[0] / pound);
    close(row["energy"]["kinetic"].as_f64().unwrap(), of(&plain, "kinetic_energy (J)") / foot_pound);
    let json = run(&["json"]).json();
    for absent in ["units", "rate_units", "feedback_force_units", "contact_force_unit", "energy_unit"] {
        assert!(json.get(absent).is_none(), "{absent}");
    }
}

/// Rates of a motion have their own units, and without these those of positions by time.
#[test]
fn rates_of_motions_have_units() {
    let directory = Directory::of_this_test();
    let simulate = ["simulate", "--speed", "5", "--duration", "0", "--initial", "phi_rate=0.5", "--format"];
    let run = |more: &[&str]| directory.run(&[&simulate[..], more].concat());
    let csv = run(&["csv", "--units", "mm,km/h,deg/s"]).ok();
    let [header, row] = csv.lines().collect::<Vec<_>>()[..] else { panic!("two lines: {csv}") };
    let of = |name: &str| row.split(',').nth(header.split(',').position(|own| own == name).unwrap()).unwrap();
    // 5 m/s, and 0.5 rad/s.
    assert_eq!((of("x_rate (km/h)"), of("phi_rate (deg/s)")), ("18.0", "28.64788975654116"));
    assert!(header.contains(",phi (rad),") && header.contains(",x_acceleration (mm/s^2),"), "{header}");
    let json = run(&["json", "--units", "km/h"]).json();
    assert_eq!((json["rate_units"]["x"].as_str(), json["rows"][0]["rates"]["x"].as_f64()), (Some("km/h"), Some(18.0)));
    let json = run(&["json", "--units", "mm"]).json();
    assert!(json["rate_units"].is_null() && json["rows"][0]["rates"]["x"].as_f64() == Some(5000.0), "{json}");
}
