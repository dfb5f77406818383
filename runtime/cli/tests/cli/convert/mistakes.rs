//! What is wrong with a file in a convention.

use crate::Directory;

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
        "m.txt:28: `w` is 1.03 m, but 1.02 m follows from `rr`, `rf`, `d1`, `d2`, `d3`; leave one of them out",
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
    let names = "paper, moore, pydy, principal, gyrostats, libbicycle, jbike6, geometry";
    bicycle(&["pista"], &format!("expected --to NAME, with one of {names}"));
    let [capital, own] = ["Moore", "moore"].map(|name| directory.run(&["convert", "benchmark", "--to", name]).stdout);
    assert!(own.contains("d1 = ") && capital == own, "{capital}");
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

/// A form is written where its ending is, and a script that is no file of parameters stays.
#[test]
fn files_are_of_the_form_that_they_are_called() {
    let directory = Directory::of_this_test();
    let run = |more: &[&str]| directory.run(&[&["convert", "pista", "--to", "moore", "--output"], more].concat());
    for name in ["pista", "pista.xlsx", "pista.md", "pista.py~"] {
        let message = "the name must end in .toml, .json, .yaml, .yml, .csv, .py, .m or .txt";
        run(&[name]).fails(2, &format!("error: --output {name}: {message}\n"));
    }
    let message = "the ending of its name is that of another format than --format; it must be .yaml or .yml";
    run(&["pista.m", "--format", "yaml"]).fails(2, &format!("error: --output pista.m: {message}\n"));
    directory.write("plan.py", "import os\nprint(os.getcwd())\n");
    let message = "this file is there, and is no file of parameters: give another name, or remove it";
    run(&["plan.py"]).fails(2, &format!("error: --output plan.py: {message}\n"));
    assert_eq!(std::fs::read_to_string(directory.0.join("plan.py")).unwrap(), "import os\nprint(os.getcwd())\n");
    // What was written before is written anew.
    for _ in 0..2 {
        assert_eq!(run(&["pista.py"]).code, Some(0));
        assert_eq!(run(&["pista.dat", "--format", "csv"]).code, Some(0));
    }
}
