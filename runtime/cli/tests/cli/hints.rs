//! That messages about slips say what to do instead.

use crate::Directory;
use crate::mistakes::{check, check_file, check_options};

#[test]
fn degrees_are_hinted_at_as_they_were_typed() {
    let range = "it must be > -1.5707963267948966 and < 1.5707963267948966";
    check_options(&["--set", "lam=95 deg"], &format!("--set lam=95 deg: `lam` is 1.6580627893946132 rad; {range}"));
    let hint = "(for degrees write `18.50 deg`)";
    check_options(&["--set", "lam=18.50"], &format!("--set lam=18.50: `lam` is 18.5 rad; {range} {hint}"));
    check_options(&["--set", "lam=95"], &format!("--set lam=95: `lam` is 95 rad; {range}"));
}

#[test]
fn units_of_another_quantity_are_refused() {
    let fits = |unit: &str, name: &str, own: &str| format!("`{unit}` is no unit for it: `{name}` is in {own}");
    check("m", "mB = 85", "mB = \"85 m\"", &format!("bike.toml:19: `mB` is `85 m`; {}", fits("m", "mB", "kg")));
    check_options(&["--set", "w=1 lb"], &format!("--set w=1 lb: `w` is `1 lb`; {}", fits("lb", "w", "m")));
    check_options(&["--set", "w=18 deg"], &format!("--set w=18 deg: `w` is `18 deg`; {}", fits("deg", "w", "m")));
    let or_degrees = "rad, or in degrees with `deg` as in `18 deg`";
    let message = format!("--set lam=18 grad: `lam` is `18 grad`; {}", fits("grad", "lam", or_degrees));
    check_options(&["--set", "lam=18 grad"], &message);
    let deviation = format!("bike.toml:19: the standard deviation of `mB` is `1 m`; {}", fits("m", "mB", "kg"));
    check("m-deviation", "mB = 85", "mB = \"85 +/- 1 m\"", &deviation);
}

#[test]
fn options_without_what_they_need() {
    check_options(&["--set", "=3"], "--set =3: expected NAME=VALUE, such as mB=90");
    check_options(&["--speeds", ",,,"], "--speeds ,,,: a speed is empty; it must be a finite number");
    let descending = "--speeds 10:0:-1: the range ends at 0, before it begins at 10; it must ascend";
    check_options(&["--speeds", "10:0:-1"], descending);
    check_options(&["--speeds", "0:10:100"], "--speeds 0:10:100: the step is 100 m/s, longer than the range");
}

/// By what the parameters are, in the words of their descriptions.
#[test]
fn names_in_words_point_to_parameters() {
    for (name, hint) in [
        ("tilt", "; did you mean `lam`?"),
        ("steer axis tilt", "; did you mean `lam`?"),
        ("mass of the rear wheel", "; did you mean `mR`?"),
        ("head", "; did you mean `head_angle`?"),
        ("mass", ""),
    ] {
        let message = format!("--set {name}=1: `{name}` is not a parameter of Whipple{hint}");
        check_options(&["--set", &format!("{name}=1")], &message);
    }
}

#[test]
fn a_picture_needs_a_range_of_speeds() {
    let message = "--plot x.svg: a picture needs a range of speeds, such as --speeds 0:10:0.1";
    for speeds in ["5", "5,5", "5:5:1"] {
        check_options(&["--speeds", speeds, "--plot", "x.svg"], message);
    }
}

#[test]
fn files_without_parameters() {
    for (name, text) in [
        ("bike.toml", ""),
        ("bike.toml", "name = \"mine\"\n[parameters]\n"),
        ("bike.json", ""),
        ("bike.json", "{}"),
        ("bike.json", "{\"parameters\": {}}"),
        ("bike.yml", "# nothing yet\n"),
        ("bike.txt", ""),
    ] {
        let message = "it has no parameters; `carvallo show benchmark` prints a file to start from";
        check_file(name, text, &format!("{name}: {message}"));
    }
}

/// A warning, since it may be meant; on the standard error, since the results are right for what was given.
#[test]
fn values_in_other_units_are_warned_of() {
    let run = Directory::of_this_test().run(&["analyze", "--set", "w=1020", "--set", "rR=300", "--format", "csv"]);
    let warning = "warning: benchmark: `w`, `rR` are too large for a bicycle, and ordinary in mm; write that unit behind \
                   each, as in `1020 mm`\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), warning));
    Directory::of_this_test().run(&["analyze", "--set", "w=1020 mm", "--set", "rR=300 mm"]).ok();
}

/// What others call a parameter is told to be theirs; what is nearly called so is hinted at, in files as in options.
#[test]
fn names_of_others_are_hinted_at() {
    let geometry = "is not a parameter of Whipple; it is one of the geometry that manufacturers print, in which a file has all parameters; \
                    `--set head_angle=…` changes it of another bicycle";
    let directory = Directory::of_this_test();
    let run = directory.write("mine.toml", "head_angle = 1.2\n").run(&["analyze", "mine.toml"]);
    assert!(
        run.code == Some(2) && run.stderr.contains(&format!("mine.toml:1: `head_angle` {geometry}")),
        "{}",
        run.stderr
    );
    let trial = "`trial` is not a parameter of Whipple; did you mean `trail`?";
    check_options(&["--set", "trial=0.05"], &format!("--set trial=0.05: {trial}"));
    let run = directory.write("mine.txt", "w = 1.02\ntrial = 0.08\n").run(&["analyze", "mine.txt"]);
    assert!(run.stderr.contains(&format!("mine.txt:2: {trial}")), "{}", run.stderr);
}

/// Their centres are hypot(0.6, 0.05) m apart, of wheels of 0.3 and 0.35 m.
#[test]
fn wheels_that_overlap_are_warned_of() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["show", "benchmark", "--set", "w=0.6"]);
    let warning = "warning: benchmark: the wheels overlap: with `w` their centres are 0.6021 m apart, and `rR` and `rF` are 0.6500 m \
                   together\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), warning));
    // hypot(0.65, 0.05) m is more than 0.65 m.
    assert_eq!(directory.run(&["show", "benchmark", "--set", "w=0.65"]).stderr, "");
}

/// What people write for what they mean, where it is clear; where it is not, what it may be.
#[test]
fn usual_names_are_understood() {
    let directory = Directory::of_this_test();
    let lines = |arguments: &[&str]| directory.run(arguments).ok();
    let own =
        lines(&["simulate", "--speed", "5", "--duration", "1", "--initial", "phi_rate=0.5", "--force", "Tdelta=1"]);
    for (rate, torque) in [
        ("phi_dot", "steer_torque"),
        ("phidot", "steering torque"),
        ("roll_rate", "handlebar_torque"),
        ("phi'", "steer"),
    ] {
        let (rate, torque) = (format!("{rate}=0.5"), format!("{torque}=1"));
        let arguments = ["simulate", "--speed", "5", "--duration", "1", "--initial", &rate, "--force", &torque];
        assert_eq!(lines(&arguments), own, "{rate}, {torque}");
    }
    let own = lines(&["transfer", "--speed", "5", "--inputs", "Tdelta", "--outputs", "phi,phi_rate"]);
    assert_eq!(lines(&["transfer", "--speed", "5", "--inputs", "steer_torque", "--outputs", "roll,roll_dot"]), own);
    let lqr = |inputs: &str, weights: [&str; 2]| {
        let weights = weights.map(|weight| ["--weight", weight]).concat();
        lines(&[&["lqr", "--speeds", "5", "--inputs", inputs], &weights[..]].concat())
    };
    let own = lqr("Tdelta", ["phi=3", "Tdelta=2"]);
    assert_eq!(lqr("steer_torque", ["roll=3", "steering torque=2"]), own);
    let gains = |law: &str| {
        let run = lines(&["analyze", "--feedback", law, "--format", "csv"]);
        assert!(run.lines().count() > 2, "{run}");
        run
    };
    assert_eq!(gains("steer_torque = -10*roll_rate"), gains("Tdelta = -10*phi_rate"));
    for set in ["hta=72 deg", "head_tube_angle='72 deg'", "caster_angle=18 deg"] {
        let run = directory.run(&["convert", "--set", set, "--to", "paper", "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        let tilt = json["parameters"]["lam"].as_f64().unwrap();
        assert!((tilt - 18_f64.to_radians()).abs() < 1e-15, "{set}: {tilt}");
    }
    check_options(
        &["--set", "caster=0.08"],
        "--set caster=0.08: `caster` is not a parameter of Whipple; did you mean `trail`, a length, or `caster_angle`, the \
         tilt of the steer axis?",
    );
}

/// 5 rad are 286.479 degrees.
#[test]
fn states_in_degrees_are_hinted_at() {
    let directory = Directory::of_this_test();
    let note = "note: `delta` is 5 rad, which is 286.5 degrees; for degrees write `5 deg`\n";
    for command in
        [&["simulate", "--duration", "0.1"][..], &["simulate", "--linear", "--duration", "0.1"], &["respond"]]
    {
        let run = |initial: &str| directory.run(&[command, &["--speed", "5", "--initial", initial]].concat());
        let stderr = run("delta=5").stderr;
        assert!(stderr.contains(note), "{stderr}");
        let [quoted, plain] = ["delta='5 deg'", "delta=5 deg"].map(|initial| run(initial).ok());
        assert_eq!(quoted, plain);
    }
}

/// Of 5 degrees there is a turn, of 5 rad none.
#[test]
fn steers_in_degrees_are_hinted_at() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["turns", "--steer", "0.1, 5", "--format", "csv"]);
    assert_eq!(run.stderr, "note: `steer` is 5 rad, which is 286.5 degrees; for degrees write `5 deg`\n");
    let turns = directory.run(&["turns", "--steer", "'5 deg'", "--format", "csv"]).ok();
    assert!(turns.lines().count() > 1, "{turns}");
}

/// One mistake, and not one for each cell.
#[test]
fn tables_of_designs_are_no_parameters() {
    let message = "this is a table with a design in each row, which `carvallo sweep --designs` reads";
    for (name, text) in [
        ("bikes.csv", ",bike,w,c,lam,g\n0,one,1.02,0.08,pi/10,9.81\n1,other,1.1,0.08,pi/10,9.81\n"),
        ("bikes.txt", "name;w;c;lam;mB [kg]\none;1,02;0,08;0,314;85\n"),
    ] {
        check_file(name, text, &format!("{name}:1: {message}"));
    }
}

#[test]
fn measurements_are_no_parameters() {
    let directory = Directory::of_this_test();
    let text = directory.run(&["measure", "--example"]).ok();
    let line = text.lines().position(|line| line == "[measurements]").unwrap() + 1;
    let message =
        format!("mine.toml:{line}: these are measurements; `carvallo measure` makes parameters of such a file");
    check_file("mine.toml", &text, &message);
}

#[test]
fn options_of_others_are_hinted_at() {
    check_options(
        &["--speed", "5"],
        "--speed 5: it is the speed of --along; for eigenvalues at speeds write --speeds 5",
    );
    let directory = Directory::of_this_test();
    let output = "error: --output: the result of this command goes to the standard output: write `> FILE` behind it\n";
    for command in [&["analyze", "pista"][..], &["show", "pista"], &["rider", "me.toml"], &["measure", "mine.toml"]] {
        directory.run(&[command, &["--output", "r.toml"]].concat()).fails(2, output);
    }
    let size = ["respond", "--speed", "5", "--input", "Tdelta", "--step", "2"];
    let message = "error: --step 2: its size stands behind an equals sign: --step=2\n";
    directory.run(&size).fails(2, message);
    let message = "error: there is no file pista.toml; `pista` without an ending is the one that ships\n";
    directory.run(&["analyze", "pista.toml"]).fails(2, message);
    for (file, language) in [("l.c", "c"), ("l.h", "c"), ("l.rs", "rust")] {
        let run = directory.run(&["lqr", "--speeds", "5", "--output", file]);
        run.fails(2, &format!("error: --output {file}: for source text write --emit {language}, too\n"));
    }
}

/// Capitals count in names, and what differs in them alone was probably meant.
#[test]
fn capitals_are_told() {
    let directory = Directory::of_this_test();
    directory.write("a.toml", format!("{}\nMb = 85\n", crate::BENCHMARK));
    let run = directory.run(&["analyze", "a.toml"]);
    let note = "note: a.toml: no parameters of Whipple, and not used: `Mb` (did you mean `mB`?)\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), note));
    let keep = ["optimize", "--vary", "c=0:0.1", "--minimize", "weave-speed", "--keep", "Mb <= 3"];
    let message = "error: --keep 'Mb <= 3': `Mb` is no value: `Mb` is not a parameter of Whipple; did you mean `mB`?\n";
    directory.run(&keep).fails(2, message);
}

/// Also with few columns, if there are numbers below.
#[test]
fn tables_of_designs_are_for_sweeps() {
    let directory = Directory::of_this_test();
    let message = "this is a table with a design in each row, which `carvallo sweep --designs` reads";
    for table in ["w,c\n1.0,0.08\n1.1,0.08\n", "w;c;lam\n1.0;0.08;0.3\n", "mB\tc\n80\t0.08\n"] {
        directory.write("many.csv", table);
        directory.run(&["analyze", "many.csv"]).fails(2, &format!("error: many.csv:1: {message}\n"));
    }
}

/// As PowerShell writes it with `>`, and as older editors do.
#[test]
fn texts_in_utf_16_and_latin_1_are_read() {
    let directory = Directory::of_this_test();
    let text = crate::BENCHMARK.replace('\n', "\r\n");
    let expected = directory.write("a.toml", &text).run(&["analyze", "a.toml"]).ok();
    let little = text.encode_utf16().flat_map(u16::to_le_bytes);
    directory.write("a.toml", [0xff, 0xfe].into_iter().chain(little).collect::<Vec<u8>>());
    assert_eq!(directory.run(&["analyze", "a.toml"]).ok(), expected);
    let big = text.encode_utf16().flat_map(u16::to_be_bytes);
    directory.write("a.toml", [0xfe, 0xff].into_iter().chain(big).collect::<Vec<u8>>());
    assert_eq!(directory.run(&["analyze", "a.toml"]).ok(), expected);
    // A degree sign and a plus-minus sign of one byte each.
    let angle = |text: &str| directory.run(&["show", text]).ok();
    directory.write("utf.txt", crate::BENCHMARK.replace("lam = \"pi/10\"", "lam = \"18° ± 1°\""));
    let latin = std::fs::read_to_string(directory.0.join("utf.txt")).unwrap();
    let latin: Vec<u8> = latin.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap_or(b'?')).collect();
    directory.write("latin.txt", latin);
    assert_eq!(angle("latin.txt"), angle("utf.txt"));
}

/// A recording, or text that is no file of parameters, is not told line by line to the end.
#[test]
fn long_files_of_something_else_are_told_in_short() {
    let directory = Directory::of_this_test();
    directory.write("rec.txt", "0.01 0.2\n".repeat(1000));
    let run = directory.run(&["analyze", "rec.txt"]);
    assert!(
        run.stderr.starts_with("error: 1000 problems\nrec.txt") && run.stderr.ends_with("\n… and 950 more\n"),
        "{}",
        run.stderr
    );
    directory.write("line.txt", "x".repeat(100_000));
    let run = directory.run(&["analyze", "line.txt"]);
    assert!(run.code == Some(2) && run.stderr.len() < 1000, "{} bytes", run.stderr.len());
    let names: String = (0..4000).map(|index| format!("x{index} = {index}\n")).collect();
    let message = "error: names.txt: it has 4000 names, and no machine has so many parameters\n";
    directory.write("names.txt", names).run(&["analyze", "names.txt"]).fails(2, message);
}

/// A second design, a form of a command that has one, and a measure by half of its name.
#[test]
fn what_was_meant_is_said() {
    let directory = Directory::of_this_test();
    for (arguments, message) in [
        (
            &["analyze", "pista", "browser"][..],
            "unexpected `browser`: this command takes one design; `carvallo compare` takes several, and lists have commas without spaces",
        ),
        (
            &["show", "--format", "json"],
            "--format: this command writes TOML; `carvallo convert --to paper --format json` writes designs in other forms",
        ),
        (
            &["sweep", "--vary", "c=0:0.1:0.1", "--format", "json"],
            "--format: the format is that of --output, .csv or .parquet",
        ),
        (
            &["optimize", "--vary", "c=0:0.1", "--minimize", "weave"],
            "--minimize weave: `weave` is not a parameter of Whipple; did you mean `weave-speed`?; expected a parameter, or one of \
             stable-range, weave-speed, capsize-speed, divergence-speed, flutter-speed, wobble-speed",
        ),
    ] {
        directory.run(arguments).fails(2, &format!("error: {message}\n"));
    }
}

/// A slip in the name of a parameter that a file must have, in each kind of file, is told with the name that was meant.
#[test]
fn typos_in_files_of_every_kind_have_a_hint() {
    let directory = Directory::of_this_test();
    // The arguments that print a file, its ending, a name in it, and what reads it again.
    let convert = |to: &'static str| ["convert", "benchmark", "--to", to];
    let paper = |form: &'static str| [&convert("paper")[..], &["--format", form]].concat();
    for (print, ending, name, read) in [
        (convert("paper").to_vec(), "toml", "lam", "analyze"),
        (paper("json"), "json", "lam", "analyze"),
        (paper("yaml"), "yaml", "lam", "analyze"),
        (paper("csv"), "csv", "lam", "analyze"),
        (paper("python"), "py", "lam", "analyze"),
        (paper("matlab"), "m", "lam", "analyze"),
        (paper("text"), "txt", "lam", "analyze"),
        (convert("geometry").to_vec(), "toml", "wheelbase", "analyze"),
        (convert("moore").to_vec(), "toml", "d1", "analyze"),
        (convert("pydy").to_vec(), "toml", "htangle", "analyze"),
        (convert("principal").to_vec(), "toml", "kPyy", "analyze"),
        (convert("gyrostats").to_vec(), "toml", "lr", "analyze"),
        (convert("libbicycle").to_vec(), "toml", "ls", "analyze"),
        (convert("jbike6").to_vec(), "m", "wheelbase", "analyze"),
        (vec!["measure", "--example"], "toml", "TtB1", "measure"),
        (vec!["rider", "--example"], "toml", "mass", "rider"),
        (vec!["show", "benchmark"], "toml", "model", "analyze"),
    ] {
        let written = directory.run(&print).stdout;
        let (start, end) = match ending {
            "json" => ("\"", "\":"),
            "yaml" => ("\n  ", ":"),
            _ => ("\n", ""),
        };
        let typo = format!("{name}{}", name.chars().next_back().unwrap());
        let [right, wrong] = [name, typo.as_str()].map(|name| format!("{start}{name}{end}"));
        assert!(written.contains(&right), "{print:?}: {written}");
        let file = format!("typo.{ending}");
        directory.write(&file, written.replacen(&right, &wrong, 1));
        let run = directory.run(&[read, &file]);
        let is_told = run
            .stderr
            .lines()
            .any(|line| line.contains(&format!("`{typo}`")) && line.contains(&format!("did you mean `{name}`")));
        assert!(run.code == Some(2) && is_told, "{print:?}: {}", run.stderr);
    }
    directory.write("group.toml", crate::BENCHMARK.replace("[parameters]", "[parameter]"));
    let run = directory.run(&["analyze", "group.toml"]);
    assert!(run.code == Some(2) && run.stderr.contains("did you mean `parameters`, a group?"), "{}", run.stderr);
}

/// What a command writes as JSON of one design is a file of its parameters; `units` that are no result's are refused.
#[test]
fn results_are_read_as_files_of_parameters() {
    let directory = Directory::of_this_test();
    for command in [
        "simulate --speed 5 --duration 0.01 --units mm,km/h,lbf,lbf*ft --feedback Tdelta=-phi_rate",
        "turns --steer 0.1 --units mm",
        "statespace --speed 5 --units deg,km/h",
        "lqr --inputs Tdelta --speeds 5,6",
        "transfer --speed 5 --inputs Tdelta --outputs phi",
        "respond --speed 5 --step --inputs Tdelta --outputs phi --duration 0.1",
        "controllability --units km/h",
        "analyze --along mB=60:100 --speed 5",
    ] {
        let arguments: Vec<&str> = command.split(' ').chain(["--set", "w=1.1", "--format", "json"]).collect();
        directory.write("result.json", directory.run(&arguments).stdout);
        let run = directory.run(&["show", "result.json"]);
        assert!(run.code == Some(0) && run.stdout.contains("\nw = 1.1 "), "{command}: {}", run.stderr);
    }
    directory.write("mm.toml", crate::BENCHMARK.replace("[parameters]", "units = \"mm\"\n[parameters]"));
    let run = directory.run(&["analyze", "mm.toml"]);
    assert!(run.code == Some(2) && run.stderr.contains("`units` stands outside of [parameters]"), "{}", run.stderr);
}

/// Lists with a space, a range with a hyphen, and what people call a mass.
#[test]
fn slips_of_options_are_told_with_what_was_meant() {
    let directory = Directory::of_this_test();
    let ends = "a list ends with a comma: lists have commas without spaces";
    for (arguments, message) in [
        (&["statespace", "--speed", "5", "--inputs", "Tphi,", "Tdelta"][..], &format!("--inputs Tphi,: {ends}")[..]),
        (&["respond", "--speed", "5", "--step", "--outputs", "phi,", "delta"], &format!("--outputs phi,: {ends}")),
        (
            &["analyze", "--speeds", "0-10"],
            "--speeds 0-10: a speed is -10; it must be >= 0; did you mean a range, as 0:10:0.1?",
        ),
        (
            &["show", "--add", "weight=5, mass=5, at=(0.3, 0, -1)"],
            "--add 'weight=5, mass=5, at=(0.3, 0, -1)': a body has no `weight`; did you mean `mass`?",
        ),
    ] {
        directory.run(arguments).fails(2, &format!("error: {message}\n"));
    }
    // An expression that is none of these, and a list in quotes.
    directory.run(&["analyze", "--speeds", "7-2"]).ok();
    directory.run(&["statespace", "--speed", "5", "--inputs", "Tphi, Tdelta"]).ok();
}

/// Texts without the mark of their encoding, and lines that end as on the first Macintosh, are the same bicycle.
#[test]
fn texts_of_other_systems_are_read() {
    let directory = Directory::of_this_test();
    let read = |file: &str| directory.run(&["convert", file, "--to", "paper", "--format", "json"]).ok();
    directory.write("plain.toml", crate::BENCHMARK);
    let expected = read("plain.toml");
    let halves = |text: &str, order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
    directory.write("little.toml", halves(crate::BENCHMARK, u16::to_le_bytes));
    directory.write("big.toml", halves(crate::BENCHMARK, u16::to_be_bytes));
    directory.write("old.toml", crate::BENCHMARK.replace('\n', "\r"));
    for file in ["little.toml", "big.toml", "old.toml"] {
        assert_eq!(read(file), expected, "{file}");
    }
    directory.write("designs.csv", halves("w,c\n1.1,0.07\n", u16::to_le_bytes));
    let swept = directory.run(&["sweep", "--designs", "designs.csv"]).stdout;
    assert!(swept.lines().nth(1).is_some_and(|line| line.starts_with("1.1,0.07,")), "{swept}");
}

/// Names that a database folded are read alike in files and in tables; one slip in a file is told.
#[test]
fn capitals_are_one_matter_in_files_and_tables() {
    let directory = Directory::of_this_test();
    let plain = directory.run(&["convert", "benchmark", "--to", "paper", "--format", "csv"]).ok();
    let renamed = |rename: fn(&str) -> String| -> String {
        let line = |line: &str| line.split_once(',').map(|(name, rest)| format!("{},{rest}\n", rename(name)));
        let (header, lines) = plain.split_once('\n').unwrap();
        format!("{header}\n{}", lines.lines().filter_map(line).collect::<String>())
    };
    directory.write("plain.csv", &plain);
    directory.write("upper.csv", renamed(str::to_uppercase)).write("lower.csv", renamed(str::to_lowercase));
    let values = |file: &str| -> Vec<String> {
        let text = directory.run(&["convert", file, "--to", "paper", "--format", "json"]).stdout;
        text.lines().filter(|line| line.starts_with("    ")).map(str::to_owned).collect()
    };
    let expected = values("plain.csv");
    assert_eq!((expected.len(), values("upper.csv"), values("lower.csv")), (26, expected.clone(), expected));
    directory.write("slip.csv", plain.replace("\nmF,", "\nMF,"));
    let run = directory.run(&["analyze", "slip.csv"]);
    assert!(run.code == Some(2) && run.stderr.contains("did you mean `mF`?"), "{}", run.stderr);

    let sweep = |header: &str| {
        directory.write("designs.csv", format!("{header}\n1.1,0.06\n"));
        directory.run(&["sweep", "--designs", "designs.csv"])
    };
    assert_eq!(sweep("W,IHXX").stdout, sweep("w,IHxx").stdout);
}

/// What would take a minute to read is refused, with the limit.
#[test]
fn endless_expressions_are_refused() {
    let directory = Directory::of_this_test();
    let terms = |term: &str| vec![term; 400_000].join("+");
    let law = format!("feedback = [\"Tdelta = {}\"]\n[parameters]", terms("1.5*phi"));
    directory.write("law.toml", crate::BENCHMARK.replace("[parameters]", &law));
    let message = "a law of 3200008 bytes: at most 100000 are read\n";
    directory.run(&["analyze", "law.toml"]).fails(2, &format!("error: law.toml:5: {message}"));
    directory.write("value.toml", crate::BENCHMARK.replace("w = 1.02", &format!("w = \"{}\"", terms("0.001"))));
    let run = directory.run(&["analyze", "value.toml"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("an expression of 2399999 bytes: at most 100000 are read"), "{:.300}", run.stderr);
    assert!(run.stderr.len() < 5000, "{} bytes", run.stderr.len());
}
