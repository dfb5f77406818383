//! Files that give matrices in the place of parameters.

use serde_json::Value;

use crate::{Directory, Run};

/// A chain of masses of 1 kg between walls, with springs of 1 N/m between neighbours, and dampers of as many tenths.
fn chain(count: usize) -> String {
    let matrix = |entry: &dyn Fn(usize, usize) -> f64| {
        (0..count).map(|row| (0..count).map(|column| entry(row, column)).collect()).collect::<Vec<Vec<f64>>>()
    };
    let stiffness = |row: usize, column: usize| match row.abs_diff(column) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    };
    let m = matrix(&|row, column| if row == column { 1.0 } else { 0.0 });
    let c1 = matrix(&|row, column| 0.1 * stiffness(row, column));
    format!("{{\"M\": {m:?}, \"C1\": {c1:?}, \"Kc\": {:?}}}", matrix(&stiffness))
}

fn part(value: &Value, part: &str) -> f64 {
    value[part].as_f64().unwrap()
}

/// The stiffness of mode k is 2 - 2 cos(k pi / (N + 1)), and with the damping of a tenth of it at 1 m/s its eigenvalues
/// solve s^2 + stiffness s / 10 + stiffness = 0.
#[test]
fn any_number_of_coordinates_up_to_twelve() {
    let directory = Directory::new("matrices-any");
    for count in 1..=12 {
        directory.write("chain.json", chain(count));
        let arguments = ["analyze", "chain.json", "--format", "json", "--speeds", "1"];
        let json = directory.run(&arguments).json();
        let values = json["eigenvalues"][0]["values"].as_array().unwrap();
        assert_eq!(values.len(), 2 * count);
        for mode in 1..=count {
            let angle = mode as f64 * std::f64::consts::PI / (count as f64 + 1.0);
            let stiffness = 2.0 - 2.0 * angle.cos();
            let (re, im) = (-stiffness / 20.0, (stiffness - stiffness * stiffness / 400.0).sqrt());
            let near = |value: &&Value| (part(value, "re") - re).abs() + (part(value, "im").abs() - im).abs() < 1e-12;
            assert_eq!(values.iter().filter(near).count(), 2, "{count}: {re} {im}");
        }
        directory.write("result.json", directory.run(&arguments).ok());
        let mut again = directory.run(&["analyze", "result.json", "--format", "json", "--speeds", "1"]).json();
        again["name"] = json["name"].clone();
        assert_eq!(again, json);
        directory.write("shown.toml", directory.run(&["show", "chain.json"]).ok());
        let mut again = directory.run(&["analyze", "shown.toml", "--format", "json", "--speeds", "1"]).json();
        again["name"] = json["name"].clone();
        assert_eq!(again, json);
    }
    directory.write("chain.json", chain(13));
    let message = "error: chain.json:1: there are 13 coordinates; there may be at most 12\n";
    directory.run(&["analyze", "chain.json"]).fails(2, message);
}

/// A towed wheel whose tyre has a relaxation length: y' is a state and y is not, of the force F only the value is one.
///
/// With m = 2 kg, the stiffness 6 N/m and the relaxation length 0.5 m, m y'' = F and 0.5 F' + v F = -6 y', so that
/// s = 0 is left out and 2 s (0.5 s + v) + 6 = 0.
const RELAXATION: &str = r#"
M = [[2, 0], [0, 0]]
C0 = [[0, 0], [6, 0.5]]
Kc = [[0, -1], [0, 0]]
K1 = [[0, 0], [0, 1]]
"#;

#[test]
fn coordinates_of_which_only_one_is_a_state() {
    let directory = Directory::new("matrices-states");
    let lists = [
        "coordinates = [{ name = \"y\", only = \"rate\" }, { name = \"F\", only = \"position\" }]\n",
        "coordinates = { y = \"rate\", F = \"position\" }\n",
        "coordinates = { y = { only = \"rate\" }, F = { only = \"position\" } }\n",
        "coordinates = { names = [\"y\", \"F\"], only = { y = \"rate\", F = \"position\" } }\n",
    ];
    for coordinates in lists {
        directory.write("tyre.toml", format!("{coordinates}{RELAXATION}"));
        let text = directory.run(&["analyze", "tyre.toml", "--speeds", "1,4"]).ok();
        assert!(
            text.contains("with q = (y, F)\n  of y only the rate is a state\n  of F only the position is a state\n")
        );
        let json = directory.run(&["analyze", "tyre.toml", "--speeds", "1,4", "--format", "json"]).json();
        // s^2 + 2 v s + 6 = 0.
        let [oscillating, creeping] = [0, 1].map(|row| json["eigenvalues"][row]["values"].as_array().unwrap().clone());
        assert_eq!((oscillating.len(), creeping.len()), (2, 2));
        assert!((part(&oscillating[1], "re") + 1.0).abs() < 1e-14);
        assert!((part(&oscillating[1], "im") - 5_f64.sqrt()).abs() < 1e-14);
        assert!((part(&creeping[1], "re") + 4.0 - 10_f64.sqrt()).abs() < 1e-14);
    }
    let header = directory.run(&["analyze", "tyre.toml", "--speeds", "1", "--format", "csv"]).ok();
    assert_eq!(header.lines().next().map(|line| line.split(',').count()), Some(6));
}

/// y'' + (1/v + 1) y' + 4 y = 0 is at 2 m/s s^2 + 1.5 s + 4 = 0.
#[test]
fn what_is_divided_by_the_speed_has_nothing_at_rest() {
    let directory = Directory::new("matrices-rest");
    directory.write("slip.json", r#"{"M": [[1]], "C-1": [[1]], "C0": 1, "Kc": [4]}"#);
    let nothing = "Matrices slip.json: at 0 m/s there are no equations of motion, since C-1 is divided by the speed";
    let Run { code, stdout, stderr } = directory.run(&["analyze", "slip.json", "--speeds", "0,2", "--format", "csv"]);
    assert_eq!((code, stderr), (Some(0), format!("note: {nothing}: left out\n")));
    let rows: Vec<&str> = stdout.lines().skip(1).collect();
    let [row] = rows[..] else { panic!("{stdout}") };
    assert!(row.starts_with("2.0,-0.75,-1.8540496217739157,-0.75,1.8540496217739157,"), "{row}");
    directory.run(&["analyze", "slip.json", "--speeds", "0"]).fails(1, &format!("error: {nothing}\n"));
    let sweep = directory.run(&["sweep", "slip.json", "--vary", "Kc_11=1:3:1", "--eigenvalues", "0,2"]);
    let message = "error: --eigenvalues 0,2: at 0 m/s Matrices has no eigenvalues, since C-1 is divided by the speed\n";
    sweep.fails(2, message);
}

/// v F' + F = 0 has the eigenvalue -1/v.
#[test]
fn what_moves_with_the_speed_alone_has_nothing_at_rest() {
    let directory = Directory::new("matrices-rest-first-order");
    directory.write("slip.json", r#"{"M": [[0]], "C1": [[1]], "Kc": [[1]], "coordinates": {"F": "position"}}"#);
    let Run { code, stdout, stderr } = directory.run(&["analyze", "slip.json", "--speeds", "0,2", "--format", "csv"]);
    let nothing = "note: Matrices slip.json: at 0 m/s there are no equations of motion, since the rate of a coordinate of \
                   first order is multiplied by the speed alone: left out\n";
    assert_eq!((code, stderr.as_str()), (Some(0), nothing));
    assert_eq!(stdout.lines().nth(1), Some("2.0,-0.5,0.0,stable"));
}

#[test]
fn names_of_matrices_are_read_as_people_write_them() {
    let directory = Directory::new("matrices-names");
    let plain = |name: &str| match name {
        "C" | "D" => {
            format!("note: a.json:1: `{name}` is taken for `C0`, which depends on neither gravity nor speed\n")
        }
        "K" => "note: a.json:1: `K` is taken for `Kc`, which depends on neither gravity nor speed\n".to_owned(),
        _ => String::new(),
    };
    for (matrix, names) in [
        ("C-1", &["C-1", "C_-1", "Cm1", "Cminus1", "C_{-1}", "C₋₁"][..]),
        ("C0", &["C0", "C_0", "C₀", "C", "D"]),
        ("C1", &["C1", "C_1", "C₁"]),
        ("Kc", &["Kc", "K_c", "K"]),
        ("K0", &["K0", "K_0"]),
        ("K1", &["K1"]),
        ("K2", &["K2", "K_2", "K₂"]),
    ] {
        for name in names {
            directory
                .write("a.json", format!("{{\"M\": [[1, 0], [0, 1]], \"{name}\": [[1, 2], [3, 4]], \"g\": 9.81}}"));
            let run = directory.run(&["analyze", "a.json", "--speeds", "1", "--format", "json"]);
            let notes: Vec<&str> = run.stderr.lines().filter(|line| line.contains("taken for")).collect();
            assert_eq!(notes.join("\n"), plain(name).trim_end(), "{name}");
            let json: Value = serde_json::from_str(&run.stdout).unwrap();
            assert_eq!(json["matrices"][matrix], serde_json::json!([[1.0, 2.0], [3.0, 4.0]]), "{name}");
        }
    }
}

#[test]
fn mistakes_are_told_at_their_place() {
    let directory = Directory::new("matrices-mistakes");
    let rows = "expected a list of rows, such as [[1, 0], [0, 1]]";
    let known = "expected `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1`, `K2`, `g`, `coordinates`, `name`, `kind`, `source`";
    let both = r#""M": [[1, 0], [0, 1]], "Kc": [[1, 0], [0, 1]]"#;
    let number = "expected a number, or an expression such as `pi/10`";
    for (text, message) in [
        ("\"M\": [1, 2]".to_owned(), format!("1: `M` is one list of 2; {rows}")),
        ("\"M\": []".to_owned(), format!("1: `M` is empty; {rows}")),
        (
            "\"M\": [[1, 2]]".to_owned(),
            "1: row 1 of `M` has 2 numbers; expected 1, as many as there are rows".to_owned(),
        ),
        (
            "\"M\": [[1, 2],\n [3]]".to_owned(),
            "2: row 2 of `M` has 1 number; expected 2, as many as there are rows".to_owned(),
        ),
        (
            "\"M\": [[1, 0], [0, 1]],\n\"K0\": [[1]]".to_owned(),
            "2: `K0` has 1 row; expected 2 rows of 2 numbers, as `M` has".to_owned(),
        ),
        ("\"K0\": [[1]]".to_owned(), "1: `M` is not given; expected 1 row of 1 number".to_owned()),
        ("\"M\": [[1,\n NaN], [0, 1]]".to_owned(), "2: `M_12` is `NaN`; expected a finite number".to_owned()),
        ("\"M\": [[1, 0],\n [null, 1]]".to_owned(), format!("2: `M_21` is null; {number}")),
        (format!("{both}, \"Q\": 4"), format!("1: `Q` is not known beside matrices; {known}")),
        (
            format!("{both}, \"gravty\": 4"),
            format!("1: `gravty` is not known beside matrices; {known}; did you mean `gravity`?"),
        ),
        (
            format!("{both},\n \"K\": [[1, 0], [0, 1]]"),
            "2: `K` is `Kc`, which is given twice; first at a.json:1".to_owned(),
        ),
        (
            format!("{both}, \"coordinates\": [\"a\"]"),
            "1: `coordinates` has 1 name; expected 2, one for each row of `M`".to_owned(),
        ),
        (format!("{both}, \"coordinates\": [\"a\", \"a\"]"), "1: two of the `coordinates` are called `a`".to_owned()),
        (
            format!("{both}, \"coordinates\": {{\"a\": \"rate\", \"b\": \"speed\"}}"),
            "1: what is `only` a state is `speed`; expected \"rate\", \"position\" or \"both\"".to_owned(),
        ),
    ] {
        directory.write("a.json", format!("{{{text}}}"));
        directory.run(&["analyze", "a.json"]).fails(2, &format!("error: a.json:{message}\n"));
    }
}

#[test]
fn what_cannot_be_inverted_is_told_by_its_coordinate() {
    let directory = Directory::new("matrices-singular");
    let singular = "`M` is singular, and it must be invertible:";
    for (m, coordinates, message) in [
        (
            "[[1, 2, 3], [2, 4, 5], [1, 2, 9]]",
            "[\"x\", \"phi\", \"delta\"]",
            "its column of `phi` depends on those before it",
        ),
        ("[[1, 2, 3], [0, 0, 0], [1, 2, 9]]", "[\"x\", \"phi\", \"delta\"]", "its row of `phi` is zero"),
        (
            "[[1, 2, 0], [2, 1, 0], [1, 2, 0]]",
            "[\"x\", \"phi\", \"F\"]",
            "its column of `F` is zero; where only the position of `F` is a state, `coordinates` says so by \
             `only = \"position\"`",
        ),
    ] {
        directory.write("a.toml", format!("coordinates = {coordinates}\nM = {m}\n"));
        directory.run(&["analyze", "a.toml"]).fails(2, &format!("error: a.toml: {singular} {message}\n"));
    }
    let states = "coordinates = { y = \"rate\", F = \"position\" }\nM = [[1, 0], [0, 0]]\nKc = [[0, 1], [0, 1]]\n";
    for (other, message) in [
        (
            "",
            "of `F` only the position is a state, but no damping matrix has its rate: its column of `C-1`, `C0` or `C1` \
             must not be zero",
        ),
        (
            "C0 = [[0, 0], [0, 1]]\nK2 = [[0, 0], [3, 0]]",
            "`K2_21` is 3, but of `y` only the rate is a state: its column of every stiffness matrix must be zero",
        ),
    ] {
        directory.write("a.toml", format!("{states}{other}"));
        directory.run(&["analyze", "a.toml"]).fails(2, &format!("error: a.toml: {message}\n"));
    }
    directory.write("a.toml", "coordinates = { F = \"position\" }\nM = [[1]]\nC0 = [[1]]\n");
    let message = "`M_11` is 1, but of `F` only the position is a state: its column of `M` must be zero";
    directory.run(&["analyze", "a.toml"]).fails(2, &format!("error: a.toml: {message}\n"));
}

#[test]
fn matrices_and_models_do_not_mix() {
    let directory = Directory::new("matrices-mix");
    directory.write("a.json", chain(2));
    let message = "error: a.json: the parameters are for the model `Matrices`, but --model is Pendulum\n";
    directory.run(&["analyze", "a.json", "--model", "Pendulum"]).fails(2, message);
    let plain = directory.run(&["analyze", "a.json"]).ok();
    assert_eq!(directory.run(&["analyze", "a.json", "--model", "matrices"]).ok(), plain);
    directory.write("b.json", chain(2).replacen('{', "{\"model\": \"Pendulum\", ", 1));
    let message = "error: b.json: there are matrices in the place of parameters of the model `Pendulum`\n";
    directory.run(&["analyze", "b.json"]).fails(2, message);
    directory.write("c.toml", "w = 1\n");
    let message = "error: c.toml: there are no matrices; expected `M` and others, in JSON or TOML\n";
    directory.run(&["analyze", "c.toml", "--model", "Matrices"]).fails(2, message);
}

/// A mass without a spring goes on wherever it is: 0 is an eigenvalue, unless only its rate is asked for.
#[test]
fn positions_on_which_nothing_depends_are_told() {
    let directory = Directory::new("matrices-free");
    directory.write("free.toml", "M = [[1]]\nC1 = [[1]]\n");
    let Run { code, stderr, stdout } = directory.run(&["analyze", "free.toml", "--speeds", "2"]);
    let note = "note: free.toml: no force depends on the position of `q1`, so that 0 is an eigenvalue at every speed; \
                `only = \"rate\"` in `coordinates` leaves it out\n";
    assert_eq!((code, stderr.as_str()), (Some(0), note));
    assert!(stdout.contains("marginal"), "{stdout}");
    directory.write("free.toml", "coordinates = { q1 = \"rate\" }\nM = [[1]]\nC1 = [[1]]\n");
    let json = directory.run(&["analyze", "free.toml", "--speeds", "2", "--format", "json"]).json();
    assert_eq!(json["eigenvalues"][0]["verdict"], "stable");
    assert_eq!(json["eigenvalues"][0]["values"], serde_json::json!([{"re": -2.0, "im": 0.0}]));
}

/// The benchmark of Meijaard et al. (2007), equations (3.5) to (3.8), as scripts have it.
const SCRIPTS: [(&str, &str); 4] = [
    (
        "bike.m",
        "% The benchmark\nclear; clc\ng = 9.81; % [N/kg]\n\
         M = [80.81722, 2.31941332208709;  % lean\n     2.31941332208709, 0.29784188199686];\n\
         C_1 = [0 33.86641391492494; -0.85035641456978 1.68540397397560]; K_0 = [-80.95 -2.59951685249872\n\
         -2.59951685249872 -0.80329488458618];\n\
         K_2 = [0 76.59734589573222; ...\n   0 2.65431523794604];\n",
    ),
    (
        "bike.py",
        "import numpy as np\nm = 80.81722\ng = 9.81\n\
         self.M = np.array([[m, 2.31941332208709],\n    [2.31941332208709, 0.29784188199686]])\n\
         C1 = np.array([[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]])\n\
         K0 = numpy.array([\n  [-80.95, -2.59951685249872],  # lean\n  [-2.59951685249872, -0.80329488458618],\n], dtype=float)\n\
         K2 = [[0, 76.59734589573222], [0, 2.65431523794604]]\n",
    ),
    (
        "bike.yml",
        "M: [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]]\n\
         C1: [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]]\n\
         K0: [[-80.95, -2.59951685249872],\n  [-2.59951685249872, -0.80329488458618]]\n\
         K2: [[0, 76.59734589573222], [0, 2.65431523794604]]\ng: 9.81\n",
    ),
    (
        "bike.json",
        "{\"M\": \"[[80.81722 2.31941332208709]\\n [2.31941332208709 0.29784188199686]]\",\n\
         \"C1\": \"[0 33.86641391492494; -0.85035641456978 1.68540397397560]\", \"g\": 9.81,\n\
         \"K0\": \"[-80.95, -2.59951685249872; -2.59951685249872, -0.80329488458618]\",\n\
         \"K2\": [[0, 76.59734589573222], [0, 2.65431523794604]]}\n",
    ),
];

/// The critical speeds are those of the paper: weave 4.29238253634111 m/s, capsize 6.02426201538837 m/s.
#[test]
fn matrices_in_scripts_are_read() {
    let directory = Directory::new("matrices-scripts");
    for (file, text) in SCRIPTS {
        directory.write(file, text);
        let json = directory.run(&["analyze", file, "--format", "json"]).json();
        let range = &json["stable_ranges"][0];
        assert!((range[0].as_f64().unwrap() - 4.29238253634111).abs() < 1e-13, "{file}: {range}");
        assert!((range[1].as_f64().unwrap() - 6.02426201538837).abs() < 1e-13, "{file}: {range}");
        let piped = directory.run_with_input(&["analyze", "-"], text).ok();
        assert!(piped.contains("self-stable from 4.292382536341129 to 6.024262015388421 m/s"), "{file}: {piped}");
    }
}

#[test]
fn mistakes_in_scripts_are_told_in_their_line() {
    let directory = Directory::new("matrices-scripts-mistakes");
    let rows = "expected a list of rows, such as [[1, 0], [0, 1]] or [1 0; 0 1]";
    for (text, message) in [
        ("M = [1 2;\n 3];\n", "2: row 2 of `M` has 1 number; expected 2, as many as there are rows".to_owned()),
        ("M = [1 2; 3 4\n", format!("1: `M` cannot be read; {rows}")),
        ("\nM = [1 2; 3 4]*9.81;\n", format!("2: `M` cannot be read; {rows}")),
        (
            "M = [1 2;\n x 4];\n",
            "2: `M_21` is `x`; expected a number, or an expression such as `pi/10`: `x` is not known".to_owned(),
        ),
    ] {
        directory.write("a.m", text).run(&["analyze", "a.m"]).fails(2, &format!("error: a.m:{message}\n"));
    }
}

/// Three masses that are not coupled: s^2 + (v - 1) s + 4, s^2 + 3 s + 9 - v^2 and s^2 + 5 s + 6.
const UNCOUPLED: &str = r#"{"M": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "C0": [[-1, 0, 0], [0, 3, 0], [0, 0, 5]],
  "C1": [[1, 0, 0], [0, 0, 0], [0, 0, 0]], "Kc": [[4, 0, 0], [0, 9, 0], [0, 0, 6]],
  "K2": [[0, 0, 0], [0, -1, 0], [0, 0, 0]]}"#;

/// The first is stable from 1 m/s, where its eigenvalues are 2 i and -2 i, and the second up to 3 m/s.
#[test]
fn critical_speeds_of_three_coordinates_are_those_of_each() {
    let directory = Directory::new("matrices-critical");
    directory.write("three.json", UNCOUPLED);
    let text = directory.run(&["analyze", "three.json", "--speeds", "2"]).ok();
    let found: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("Critical")).take(4).collect();
    let expected = [
        "Critical speeds (m/s)",
        "  flutter      1                   becomes stable, at λ = ±2.0000 i",
        "  divergence   3                   becomes unstable, at λ = 0",
        "  self-stable from 1 to 3 m/s",
    ];
    assert_eq!(found, expected);
    let json = directory.run(&["analyze", "three.json", "--speeds", "2", "--format", "json"]).json();
    let kinds = [0, 1].map(|index| json["critical_speeds"][index]["kind"].as_str().unwrap());
    assert_eq!((kinds, &json["stable_ranges"]), (["flutter", "divergence"], &serde_json::json!([[1.0, 3.0]])));
    assert_eq!(json["undecided_ranges"], serde_json::json!([]));
    let sweep = ["sweep", "three.json", "--vary", "C0_11=-1,-2,1", "--eigenvalues", "2"];
    let run = directory.run(&sweep);
    let rows: Vec<Vec<&str>> = run.stdout.lines().map(|line| line.split(',').collect()).collect();
    let cell = |row: usize, name: &str| rows[row][rows[0].iter().position(|found| *found == name).unwrap()];
    let cells = |name: &str| [1, 2, 3].map(|row| cell(row, name));
    assert_eq!(cells("flutter_count"), ["1", "1", "0"]);
    assert_eq!(cells("flutter_1"), ["1.0", "2.0", ""]);
    assert_eq!(cells("divergence_1"), ["3.0", "3.0", "3.0"]);
    assert_eq!(cells("stable_from_1"), ["1.0", "2.0", "0.0"]);
    assert_eq!(cells("stable_to_1"), ["3.0", "3.0", "3.0"]);
    assert_eq!(cells("undecided_count"), ["0", "0", "0"]);
    assert_eq!(cells("verdict_at_2"), ["stable", "marginal", "stable"]);
    assert_eq!(cells("error"), ["", "", ""]);
}

/// With lean and steer for coordinates the modes have names; what is critical has those of the field.
#[test]
fn coordinates_of_a_bicycle_give_its_words() {
    let directory = Directory::new("matrices-words");
    let text = |coordinates: &str| {
        let text = format!("{coordinates}{}", SCRIPTS[1].1);
        directory.write("bike.py", text).run(&["analyze", "bike.py"]).ok()
    };
    let plain = text("");
    assert!(plain.contains("flutter      4.292382536341129 ") && !plain.contains("castering"), "{plain}");
    let named = text("coordinates = ['lean', 'steer']\n");
    assert!(named.contains("weave        4.292382536341129 ") && named.contains("castering"), "{named}");
}

/// As printed by Sharp (1971), Tables 1 to 3, in columns for the speeds in ft/s: capsize, weave and wobble.
const SHARP: [[f64; 8]; 6] = [
    [10.0, 20.0, 30.0, 50.0, 70.0, 100.0, 130.0, 160.0],
    [-3.56, -2.83, -0.13, 0.08, 0.08, 0.07, 0.05, 0.04],
    [2.01, -0.18, -3.36, -6.59, -3.97, -1.82, -1.13, -0.96],
    [1.63, 2.09, 4.56, 11.4, 16.8, 19.2, 20.4, 21.2],
    [-5.2, -5.91, -6.42, -6.52, -5.7, -3.94, -2.24, -0.82],
    [55.7, 55.8, 55.5, 54.6, 54.0, 54.3, 55.6, 57.5],
];

/// Six coordinates, two of which are rates and two of first order: all 24 eigenvalues to the last printed digit, and critical
/// speeds from equations that were derived apart from these, at 25 digits, of which 17 stand here.
#[test]
fn the_motorcycle_of_sharp() {
    let directory = Directory::new("matrices-sharp");
    directory.write("motorcycle.toml", include_str!("../../docs/motorcycle.toml"));
    let speeds = SHARP[0].map(|speed| format!("{speed}*0.3048")).join(",");
    let json = directory.run(&["analyze", "motorcycle.toml", "--format", "json", "--speeds", &speeds]).json();
    let mut compared = 0;
    for (column, row) in json["eigenvalues"].as_array().unwrap().iter().enumerate() {
        let values = row["values"].as_array().unwrap();
        assert_eq!(values.len(), 8);
        let is_printed = |value: &Value, re: f64, im: f64| {
            let half = |printed: f64| 0.5 * if printed.abs() < 10.0 { 0.01 } else { 0.1 } + 1e-9;
            let [found_re, found_im] = [part(value, "re"), part(value, "im").abs()];
            // Frequencies below 10 have two decimals, those above one, and one real part of 5.2 has one.
            let re_half = if re == -5.2 || re == -5.7 { 0.05 } else { half(re) };
            (found_re - re).abs() <= re_half && (found_im - im).abs() <= if im == 0.0 { 0.0 } else { half(im) }
        };
        for (re, im) in [(1, None), (2, Some(3)), (4, Some(5))] {
            let (re, im) = (SHARP[re][column], im.map_or(0.0, |im: usize| SHARP[im][column]));
            assert!(values.iter().any(|value| is_printed(value, re, im)), "{re} {im}: {row}");
            compared += 1;
        }
    }
    assert_eq!(compared, 24);
    let critical = json["critical_speeds"].as_array().unwrap();
    let expected = [
        ("weave", 19.440006372816047, 2.0855133306714594),
        ("capsize", 35.210269211458693, 0.0),
        ("weave", 181.68476172001148, 59.281250592044735),
    ];
    assert_eq!(critical.len(), expected.len());
    for (found, (kind, speed, frequency)) in critical.iter().zip(expected) {
        assert_eq!(found["kind"], kind);
        assert!((part(found, "speed") / (0.3048 * speed) - 1.0).abs() < 1e-12, "{found}");
        assert!((part(&found["eigenvalue"], "im") - frequency).abs() <= 1e-11 * frequency, "{found}");
    }
    directory.write("shown.toml", directory.run(&["show", "motorcycle.toml"]).ok());
    let again = directory.run(&["analyze", "shown.toml", "--format", "json", "--speeds", &speeds]);
    assert_eq!(again.code, Some(0), "{}", again.stderr);
}
