//! Files in the shapes that people of the field have, each with the right value. Numbers that are not those of a shipped
//! bicycle were computed apart from this program, at 25 digits.

use crate::{BENCHMARK, Directory, Run};

/// The benchmark as `name = value` lines.
fn benchmark() -> String {
    BENCHMARK
        .lines()
        .skip_while(|line| *line != "[parameters]")
        .skip(1)
        .map(|line| line.replace('"', "") + "\n")
        .collect()
}

/// The parameters of a robot bicycle, under plain names.
const ROBOT: [(&str, &str); 26] = [
    ("w", "1.32"),
    ("c", "0.082"),
    ("lam", "radians(27)"),
    ("g", "9.81"),
    ("rR", "0.25"),
    ("mR", "1"),
    ("IRxx", "0.1405/2"),
    ("IRyy", "0.28/2"),
    ("xB", "0.3"),
    ("zB", "-0.58"),
    ("mB", "78-5.7"),
    ("IBxx", "9.2"),
    ("IBxz", "2.4"),
    ("IByy", "11"),
    ("IBzz", "2.8"),
    ("xH", "1.2"),
    ("zH", "-0.6"),
    ("mH", "5.7"),
    ("IHxx", "0.05892"),
    ("IHxz", "-0.00756"),
    ("IHyy", "0.06"),
    ("IHzz", "0.00708"),
    ("rF", "0.25"),
    ("mF", "1"),
    ("IFxx", "0.1405/2"),
    ("IFyy", "0.28/2"),
];

/// A bicycle without the moments of inertia that no matrix depends on, in the form of a script.
const SCRIPT: &str = "\
% units: SI
c = 0.0448; % [m]
w = 0.96468; % [m]
lambda = pi/10; % [rad]
m_R = 3.405; m_B = 17.71;
m_H = 1.61;
m_F = m_R;
x_B = 0.4521963;
x_H = 0.865528645;
r_R = 0.254;
r_F = 0.254;
z_B = -0.371334;
z_H = -0.32045;
I_Rxx = 0.0603;
I_Bxx = 1.01;
I_Hxx = 0.01;
I_Fxx = 0.0603;
I_Bxz = 0;
I_Hxz = 0;
I_Ryy = 2*I_Rxx;
I_Fyy = 2*I_Fxx;
I_Bzz = 0.57;
I_Hzz = 0.01;
";

fn analyze(test: &str, file: &str, text: &str) -> (Run, serde_json::Value) {
    let directory = Directory::new(&format!("shapes-{test}"));
    directory.write(file, text);
    let run = directory.run(&["analyze", file, "--format", "json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let json = serde_json::from_str(&run.stdout).unwrap();
    (run, json)
}

/// What is said of a file, and the one stable range that it has.
#[track_caller]
fn check(test: &str, file: &str, text: &str, notes: &str, range: [Option<f64>; 2]) {
    let (run, json) = analyze(test, file, text);
    assert_eq!(run.stderr, notes);
    let ranges = json["stable_ranges"].as_array().unwrap();
    assert_eq!(ranges.len(), 1);
    for (bound, found) in range.iter().zip(ranges[0].as_array().unwrap()) {
        let is_same = match (bound, found.as_f64()) {
            (Some(bound), Some(found)) => (bound - found).abs() < 1e-9,
            (bound, found) => bound.is_none() && found.is_none(),
        };
        assert!(is_same, "{bound:?} is not {found}");
    }
}

const BENCHMARK_RANGE: [Option<f64>; 2] = [Some(4.292_382_536_3), Some(6.024_262_015_4)];
const ROBOT_RANGE: [Option<f64>; 2] = [Some(5.515_377_327_4), Some(8.087_202_066_2)];
const SCRIPT_RANGE: [Option<f64>; 2] = [Some(2.676_161_230_3), Some(4.299_312_495_7)];

#[test]
fn measurements_with_their_deviations() {
    let text = benchmark();
    for (test, line) in [("sign", "c = 0.08+-0.001"), ("spaces", "c = 0.08 + - 0.001"), ("digits", "c = 0.080(1)")] {
        check(test, "bike.txt", &text.replace("c = 0.08", line), "", BENCHMARK_RANGE);
    }
    let (_, json) = analyze("list", "bike.txt", &text.replace("w = 1.02", "w = 1.02+/-0.01, 1.03+/-0.01"));
    assert_eq!(json["parameters"]["w"].as_f64(), Some(1.025));
    let shown = |text: &str| {
        let directory = Directory::new("shapes-shown");
        directory.write("bike.txt", text).run(&["show", "bike.txt"]).ok()
    };
    // 0.01/sqrt(2)
    let list = shown(&text.replace("w = 1.02", "w = 1.02+/-0.01, 1.03+/-0.01"));
    assert!(list.contains("\nw = { value = 1.025, std = 0.00707106781186547"), "{list}");
    let digits = shown(&text.replace("w = 1.02", "w = 1.020(3)"));
    assert!(digits.contains("\nw = { value = 1.020, std = 3e-3 }"), "{digits}");
}

#[test]
fn attributes_of_python() {
    let plain: String = ROBOT.iter().map(|(name, value)| format!("{name} = {value} # [m]\n")).collect();
    check("plain", "robot.txt", &plain.replace("radians", "math.radians"), "", ROBOT_RANGE);
    let long = |name: &str| match name {
        "lam" => "lamda".to_owned(),
        name if name.len() > 1 => format!("{}_{}", &name[..1], &name[1..]),
        name => name.to_owned(),
    };
    let attributes: String = ROBOT.iter().map(|(name, value)| format!("{} = {value} # [m]\n", long(name))).collect();
    let attributes = format!("import math\n{attributes}I_Bzx = I_Bxz\nI_Hzx = I_Hxz\n");
    check("attributes", "robot.py", &attributes, "", ROBOT_RANGE);
    let owned: String = ROBOT.iter().map(|(name, value)| format!("self.{} = {value}\n", long(name))).collect();
    let owned = format!("class Robot:\n    def __init__(self):\n{}", owned.replace("radians", "np.radians"));
    check("owned", "robot.py", &owned, "", ROBOT_RANGE);
    let helped = attributes.replace("m_B = 78-5.7", "total = 78\nm_B = total - m_H");
    check("helped", "robot", &helped, "", ROBOT_RANGE);
    let directory = Directory::new("shapes-circle");
    let circle = attributes.replace("m_B = 78-5.7", "total = m_B\nm_B = total - m_H");
    let run = directory.write("robot.py", circle).run(&["analyze", "robot.py"]);
    let expected = "expected a number, or an expression such as `pi/10`";
    run.fails(2, &format!("error: robot.py:13: `mB` is `total - m_H`; {expected}: `total` refers to itself\n"));
}

#[test]
fn scripts_of_matlab_and_what_no_matrix_depends_on() {
    let [unused, gravity] = [
        "`IByy`, `IHyy` are not given; no matrix depends on them",
        "`g` is not given: it is 9.81 N/kg unless --gravity says otherwise",
    ];
    for (test, file) in [("script", "bike.m"), ("script-by-content", "bike.txt")] {
        check(test, file, SCRIPT, &format!("note: {file}: {unused}\nnote: {file}: {gravity}\n"), SCRIPT_RANGE);
    }
    check("no-pitch", "a.m", &format!("{SCRIPT}g = 9.81;"), &format!("note: a.m: {unused}\n"), SCRIPT_RANGE);
    check("gravity", "a.m", &format!("{SCRIPT}gravity = 9.81;"), &format!("note: a.m: {unused}\n"), SCRIPT_RANGE);
    check("zero-pitch", "a.m", &format!("{SCRIPT}g = 9.81;\nIByy = 0;\nIHyy = 0;"), "", SCRIPT_RANGE);
}

#[test]
fn names_beyond_those_of_the_model() {
    let text = benchmark();
    let note = "note: bike.txt: no parameters of Whipple, and not used: `IGxx`, `mG`\n";
    check("extra", "bike.txt", &format!("{text}IGxx = 0.05+/-0.001\nmG = 3.35"), note, BENCHMARK_RANGE);
    let directory = Directory::new("shapes-near-miss");
    let missing = format!("{}d1 = 0.96\n", text.replace("IByy", "IBy"));
    let run = directory.write("bike.txt", missing).run(&["analyze", "bike.txt"]);
    run.fails(2, "error: bike.txt:16: `IBy` is not a parameter of Whipple; did you mean `IByy`?\n");
}

/// Of the benchmark the wheel base is 1.02 m, the head angle 72°, the trail 0.08 m, and the fork offset rF sin λ - c cos λ =
/// 0.0320714 m.
#[test]
fn what_is_said_twice_must_be_the_same() {
    let text = benchmark();
    for line in ["wheelbase = 1.02", "wheelbase = 1020 mm", "head_angle = 72 deg", "trail = 0.080", "rake = 32.1 mm"] {
        let name = line.split(' ').next().unwrap();
        let note = format!("note: bike.txt: `{name}` says what the parameters of Whipple say, too\n");
        check("said-twice", "bike.txt", &format!("{text}{line}\n"), &note, BENCHMARK_RANGE);
    }
    let directory = Directory::new("shapes-said-twice");
    for (line, message) in [
        ("wheelbase = 1.1", "`wheelbase` is 1.1 m, but 1.02 m follows from `w`; leave one of them out"),
        ("trail = 6 cm", "`trail` is 0.06 m, but 0.08 m follows from `c`; leave one of them out"),
        (
            "head_angle = 72",
            "`head_angle` is 72 rad; it must be > 0 and < 3.141592653589793 (for degrees write `72 deg`)",
        ),
    ] {
        let run = directory.write("bike.txt", format!("{text}{line}\n")).run(&["analyze", "bike.txt"]);
        run.fails(2, &format!("error: bike.txt:{}: {message}\n", text.lines().count() + 1));
    }
    let run = directory.write("bike.txt", format!("{text}rake = 45 mm\n")).run(&["analyze", "bike.txt"]);
    let message = "`rake` is 0.045 m, but 0.0320714 m follows from `c`, `lam`, `rF`; leave one of them out";
    run.fails(2, &format!("error: bike.txt:{}: {message}\n", text.lines().count() + 1));
    // What others refer to is no second one; and settings by such names still change the design.
    let refers = text.replace("w = 1.02", "w = wheelbase") + "wheelbase = 1.02\n";
    assert!(refers.contains("w = wheelbase"));
    check("refers", "bike.txt", &refers, "", BENCHMARK_RANGE);
    let twice = format!("{text}head_angle = 72 deg\n");
    let run = directory.write("bike.txt", twice).run(&["show", "bike.txt", "--set", "head_angle=70 deg"]);
    assert!(run.code == Some(0) && run.stdout.contains("lam = 0.349065850398"), "{}{}", run.stdout, run.stderr);
}

#[test]
fn what_a_model_takes_for_granted_is_checked() {
    let text = benchmark();
    for (line, warning) in [
        (
            "IRzz = 0.5",
            "`IRzz` is 0.5 kg m², but `IRxx` is 0.0603 kg m²: wheels are axisymmetric, and `IRzz` is not used",
        ),
        ("yB = 0.05", "`yB` is 0.05, but the bicycle is laterally symmetric, and `yB` is not used"),
        ("kphi = -3", "`kphi` is -3, but the bicycle has no control, and `kphi` is not used"),
    ] {
        let warning = format!("warning: bike.txt: {warning}\n");
        check("granted", "bike.txt", &format!("{text}{line}\n"), &warning, BENCHMARK_RANGE);
    }
    let directory = Directory::new("shapes-granted-mistakes");
    let lines = text.lines().count();
    for (line, message) in [
        ("yB = banana", "`yB` is `banana`; expected a number, or an expression such as `pi/10`: `banana` is not known"),
        ("I_Bzx = 2.5", "`I_Bzx` is 2.5 kg m², but `IBxz` is 2.4 kg m²; inertia tensors are symmetric"),
        ("I_Bxz = 2.4", "`I_Bxz` is given twice; first as `IBxz` at bike.txt:18"),
    ] {
        let run = directory.write("bike.txt", format!("{text}{line}\n")).run(&["analyze", "bike.txt"]);
        run.fails(2, &format!("error: bike.txt:{}: {message}\n", lines + 1));
    }
}

/// Two point masses on skates: by hand, with wheels of any radius.
#[test]
fn wheels_of_no_radius() {
    let mut text =
        "w = 1\nc = 0\nlam = 0.0872664626\ng = 9.81\nxB = 1.2\nzB = -0.4\nmB = 10\nxH = 1.02\nzH = -0.2\nmH = 1\n"
            .to_owned();
    let zeros = "rR mR IRxx IRyy IBxx IByy IBzz IBxz IHxx IHyy IHzz IHxz rF mF IFxx IFyy";
    zeros.split(' ').for_each(|name| text.push_str(&format!("{name} = 0\n")));
    let note = "note: skate.txt: `rR`, `rF` are 0; any radius gives the same equations of motion, and 0.1 m is taken\n";
    check("skate", "skate.txt", &text, note, [Some(2.841_008_323_4), None]);
    let directory = Directory::new("shapes-skate");
    let heavy = text.replace("mR = 0", "mR = 1").replace("IRyy = 0", "IRyy = 0.1");
    let run = directory.write("skate.txt", heavy).run(&["analyze", "skate.txt"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("skate.txt:11: `rR` is 0 m; it must be > 0\n"), "{}", run.stderr);
}

/// The benchmark as Python prints and people edit it.
#[test]
fn dictionaries() {
    let members: String = benchmark()
        .lines()
        .filter_map(|line| line.split_once(" = "))
        .map(|(name, value)| format!("'{name}': '{value}',\n"))
        .collect();
    let text = format!("{{\n{members}'yB': 0.0, 'v': 1.0,\n'kphi': 0.0, 'kdelta': +0.0,\n}}\n");
    let line = members.lines().count() + 2;
    let notes = format!(
        "note: bike.json:{line}: `yB` is ignored: the bicycle is laterally symmetric\n\
         note: bike.json:{line}: `v` is ignored: the speeds come from --speeds\n\
         note: bike.json:{}: `kphi`, `kdelta` are ignored: the bicycle has no control\n",
        line + 1
    );
    check("dictionary", "bike.json", &text, &notes, BENCHMARK_RANGE);
}

#[test]
fn a_head_angle_in_the_place_of_the_tilt_is_a_warning() {
    let run = Directory::new("shapes-tilt").run(&["show", "--set", "lam=70 deg", "benchmark"]);
    let warning = "warning: benchmark: `lam` is 70.0 deg: it is the tilt of the steer axis, 90 deg minus the head angle, \
                   which would be 20.0 deg\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), warning));
}

/// The benchmark by its matrices, from Meijaard et al. (2007), equations (3.5) to (3.8), with all digits.
const MATRICES: &str = r#"
    "M": [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]],
    "C1": [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]],
    "K0": [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]],
    "K2": [[0, 76.59734589573222], [0, 2.65431523794604]]"#;

#[test]
fn matrices_themselves() {
    let range = |text: &str, file: &str, notes: &str| check("matrices", file, text, notes, BENCHMARK_RANGE);
    range(&format!("{{{MATRICES}, \"g\": 9.81}}"), "matrices.json", "");
    let gravity = "note: matrices.json: `g` is not given: it is 9.81 N/kg unless --gravity says otherwise\n";
    range(&format!("{{\"name\": \"mine\", \"matrices\": {{{MATRICES}}}}}"), "matrices.json", gravity);
    let toml: String = MATRICES.replace("]],", "]]\n").replace("\":", "\" =");
    range(&format!("{toml}\ng = 9.81\n"), "matrices.toml", "");

    let directory = Directory::new("shapes-matrices-all");
    directory.write("matrices.json", format!("{{{MATRICES}, \"C_0\": [[0, 0], [0, 1]], \"g\": 9.81}}"));
    let json = directory.run(&["analyze", "matrices.json", "--format", "json"]).json();
    assert_eq!(json["matrices"]["C0"][1][1].as_f64(), Some(1.0));
    directory.write("shown.toml", directory.run(&["show", "matrices.json"]).ok());
    let mut again = directory.run(&["analyze", "shown.toml", "--format", "json"]).json();
    again["name"] = json["name"].clone();
    assert_eq!(again, json);
    let text = "{\"M\": [[1, 0], [0, \"one\"]], \"K0\": [[1, 0], [0, 1]]}";
    let run = directory.write("matrices.json", text).run(&["analyze", "matrices.json"]);
    let expected = "expected a number, or an expression such as `pi/10`";
    run.fails(2, &format!("error: matrices.json:1: `M_22` is `one`; {expected}: `one` is not known\n"));
}

/// Without spring and damper the wider model is that of the bicycles.
#[test]
fn bicycles_for_a_wider_model() {
    let directory = Directory::new("shapes-wider");
    let note = "note: pista: `k`, `d` are not given: they are 0, with which WhippleSprung is the model Whipple\n";
    let run = directory.run(&["analyze", "pista", "--model", "WhippleSprung", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), note));
    let ranges = |text: &str| {
        let json: serde_json::Value = serde_json::from_str(text).unwrap();
        let bound = |at: usize| json["stable_ranges"][0][at].as_f64().unwrap();
        [bound(0), bound(1)]
    };
    let own = ranges(&directory.run(&["analyze", "pista", "--format", "json"]).stdout);
    assert!(own.iter().zip(ranges(&run.stdout)).all(|(own, wide)| (own - wide).abs() < 1e-9));
    let damped = directory.run(&["analyze", "pista", "--model", "WhippleSprung", "--set", "d=1", "--set", "k=0"]).ok();
    assert!(damped.contains("WhippleSprung pista"), "{damped}");
    // A file for this model must have what it says.
    let text = BENCHMARK.replace("[parameters]", "model = \"WhippleSprung\"\n[parameters]\nd = 1");
    let run = directory.write("bike.toml", text).run(&["analyze", "bike.toml"]);
    run.fails(2, "error: bike.toml: missing: `k` (of 28 parameters)\n");
    let run = directory.run(&["analyze", "pista", "--model", "WhippleLeaning"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.starts_with("error: pista: missing: "), "{}", run.stderr);
}
