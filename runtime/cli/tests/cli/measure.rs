//! `carvallo measure`: from measurements to a file of parameters. What comes out of them is held against BicycleParameters in the
//! tests of `carvallo-measure`.

use serde_json::Value;

use crate::Directory;

fn with_example(directory: &Directory) -> String {
    let example = directory.run(&["measure", "--example"]).ok();
    directory.write("mine.toml", &example);
    example
}

/// A warning about the inertias of the Browser goes with everything.
fn measured(directory: &Directory, arguments: &[&str]) -> String {
    let run = directory.run(&[&["measure"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    run.stdout
}

fn mistake(directory: &Directory, text: &str) -> String {
    directory.write("wrong.toml", text);
    let run = directory.run(&["measure", "wrong.toml"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""));
    run.stderr
}

#[test]
fn what_it_writes_is_analyzed() {
    let directory = Directory::of_this_test();
    with_example(&directory);
    directory.write("bicycle.toml", measured(&directory, &["mine.toml"]));
    directory.write("bicycle.json", measured(&directory, &["mine.toml", "--format", "json"]));
    let sensitivity = |file: &str| directory.run(&["sensitivity", file, "--format", "json"]).stdout;
    let json: Value = serde_json::from_str(&sensitivity("bicycle.toml")).unwrap();
    assert_eq!(json["bicycle"], "Batavus Browser");
    assert_eq!(sensitivity("bicycle.toml"), sensitivity("bicycle.json"));
    // Published with its deviations, which are taken to be independent there.
    let shipped: Value = serde_json::from_str(&sensitivity("browser")).unwrap();
    for (name, published) in shipped["parameters"].as_object().unwrap() {
        for member in ["value", "std"] {
            let [found, published] =
                [&json["parameters"][name], published].map(|given| given[member].as_f64().unwrap());
            assert!((found / published - 1.0).abs() < 2e-6, "{member} of {name}: {found}, not {published}");
        }
    }
    let analyzed = directory.run(&["analyze", "bicycle.toml"]);
    assert_eq!(analyzed.code, Some(0), "{}", analyzed.stderr);
}

/// In other units, in lists, at the top, in JSON and as BicycleParameters writes them, they are the same.
#[test]
fn measurements_come_in_all_forms() {
    let directory = Directory::of_this_test();
    let example = with_example(&directory);
    let expected = measured(&directory, &["mine.toml", "--format", "json"]).replace("mine.toml", "FILE");
    let assert_same = |name: &str, text: String| {
        directory.write(name, text);
        assert_eq!(measured(&directory, &[name, "--format", "json"]).replace(name, "FILE"), expected, "{name}");
    };
    assert_same("top.toml", example.replace("[measurements]", ""));
    assert_same("deg.toml", example.replace("\"3.4 +/- 0.2\"", "\"(3.4 +/- 0.2) deg\""));
    let members = "{ value = 67.1, std = 0.2 }";
    assert_same("members.toml", example.replace("\"67.1 +/- 0.2\"", members));
    assert_same("list.toml", example.replace("nF = 13", "nF = [13, 12, 14]"));
    assert_same("text.toml", example.replace("nF = 13", "nF = \"13, 12, 14\""));
    let is_value = |line: &&str| line.contains(" = ") && !line.starts_with('#');
    let lines: Vec<(&str, &str)> = example
        .lines()
        .filter(is_value)
        .map(|line| line.split_once('#').map_or(line, |(line, _)| line).split_once('=').unwrap())
        .map(|(name, value)| (name.trim(), value.trim().trim_matches('"')))
        .collect();
    let text: Vec<String> = lines.iter().map(|(name, value)| format!("{name} = {value}\n")).collect();
    assert_same("plain.txt", text.concat().replace(" +/- ", "+/-"));
    let json: Vec<String> = lines.iter().map(|(name, value)| format!("\"{name}\": \"{value}\"")).collect();
    assert_same("object.json", format!("{{{}}}", json.join(", ")));
    let piped = directory.run_with_input(&["measure", "-", "--format", "json"], &example);
    assert_eq!(piped.stdout.replace("<stdin>", "FILE"), expected);
}

#[test]
fn mistakes_are_told_at_their_place() {
    let directory = Directory::of_this_test();
    let example = with_example(&directory);
    let of = |from: &str, to: &str| {
        assert!(example.contains(from), "{from}");
        mistake(&directory, &example.replace(from, to))
    };
    assert_eq!(of("TtB3 = \"1.8397694 +/- 0.000011\"", ""), "error: wrong.toml: missing: TtB3\n");
    let line = example.lines().position(|line| line.starts_with("mH")).unwrap() + 1;
    let at = |message: &str| format!("error: wrong.toml:{line}: {message}\n");
    assert_eq!(of("mH = \"3.22", "mH = \"-3.22"), at("`mH` is -3.22 kg; it must be > 0"));
    assert_eq!(
        of("mH = \"3.22 +/- 0.02\"", "mH = \"3.22 m\""),
        at("`mH` is `3.22 m`; `m` is no unit for it: `mH` is in kg")
    );
    assert_eq!(of("mH = ", "mh = "), at("`mh` is no measurement that is known; did you mean `mH`?"));
    assert!(of("mH = ", "mB = ").contains("this is not TOML: duplicate key"));
    assert!(
        of("138.7", "183.4")
            .contains("`alphaB1` and `alphaB2` are the same direction, so that their lines do not meet")
    );
    let none = mistake(&directory, "");
    assert!(
        none.contains("it has no measurements; `carvallo measure --example` prints a file to start from"),
        "{none}"
    );
    let parameters = mistake(&directory, "model = \"Whipple\"\n[parameters]\nw = 1.02\n");
    assert!(parameters.starts_with("error: wrong.toml:2: these are parameters, and no measurements"), "{parameters}");
    // A period in the place of another one: of the wheel, less than that of a point at its centre.
    let short = of("TcF1 = \"1.48112737", "TcF1 = \"0.9");
    assert!(short.contains("`IFyy` is -0.0"), "{short}");
    assert!(short.contains("it must be >= 0: it follows from `TcF1`, `lF` and `mF`\n"), "{short}");
    // 67.1 degrees are 1.1711 rad.
    let radians = of("gamma = \"67.1 +/- 0.2\"", "gamma = 1.1711");
    assert!(radians.contains("for 67.1 degrees write \"1.1711 rad\""), "{radians}");
    // Ten times a period is a hundred times the moment of inertia; nobody wrote that in another unit.
    directory.write("slow.toml", example.replace("TcR1 = \"1.36108970", "TcR1 = \"13.6108970"));
    let slow = directory.run(&["measure", "slow.toml"]);
    let told = "kg m², too large for a bicycle: it follows from `TcR1`, `lR` and `mR`\n";
    assert!(slow.code == Some(0) && slow.stderr.contains(told), "{}", slow.stderr);
    assert!(!slow.stderr.contains("write that unit"), "{}", slow.stderr);
    let nothing = directory.run(&["measure"]);
    assert_eq!(nothing.code, Some(2));
    let absent = directory.run(&["measure", "absent.txt"]);
    assert_eq!((absent.code, absent.stderr.as_str()), (Some(2), "error: there is no file absent.txt\n"));
}

/// Names that manufacturers have for what is measured, and a distance of one turn beside thirteen turns.
#[test]
fn usual_mistakes_have_hints() {
    let directory = Directory::of_this_test();
    let example = directory.run(&["measure", "--example"]).ok();
    let with = |old: &str, new: &str| {
        directory.write("a.toml", example.replacen(old, new, 1));
        directory.run(&["measure", "a.toml"])
    };
    for (old, new, hint) in [
        ("\nw = ", "\nwheelbase = ", "`wheelbase` is no measurement that is known; it is measured as `w`"),
        ("\ngamma = ", "\nhead_angle = ", "`head_angle` is no measurement that is known; it is measured as `gamma`"),
        ("\nf = ", "\nrake = ", "`rake` is no measurement that is known; it is measured as `f`"),
        ("\nf = ", "\ntrail = ", "`trail` is no measurement that is known; the trail follows from the fork offset `f`"),
        ("\nnR = ", "\nnr = ", "`nr` is no measurement that is known; did you mean `nR`?"),
    ] {
        let run = with(old, new);
        assert!(run.code == Some(2) && run.stderr.contains(hint), "{hint}: {}", run.stderr);
    }
    // 27.85 m/13 = 2.1423 m.
    let run = with("\ndR = \"27.85", "\ndR = \"2.1423");
    let warning =
        "the radius `rR` is 0.02623 m by `dR` and `nR`, too small for a bicycle; is `dR` the distance of all turns?";
    assert!(run.code == Some(0) && run.stderr.contains(warning), "{}", run.stderr);
}
