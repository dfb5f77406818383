//! Matrices in scripts of MATLAB and Python, in YAML, and as text in JSON.

use crate::Directory;

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

/// q1'' + q1' = 0 and q2'' + q2' = 0.
#[test]
fn matrices_that_scripts_make_are_read() {
    let directory = Directory::new("matrices-made");
    directory.write("a.m", "M = eye(2);\nC_0 = eye(2); Kc = zeros(2, 2);\ncoordinates = ['x' 'y']\n");
    let json = directory.run(&["analyze", "a.m", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(json["matrices"]["M"], serde_json::json!([[1.0, 0.0], [0.0, 1.0]]));
    assert_eq!(json["matrices"]["Kc"], serde_json::json!([[0.0, 0.0], [0.0, 0.0]]));
    let values = json["eigenvalues"][0]["values"].as_array().unwrap();
    let real: Vec<f64> = values.iter().map(|value| value["re"].as_f64().unwrap()).collect();
    assert_eq!(real, [-1.0, -1.0, 0.0, 0.0]);
    directory.write("a.m", "M = eye(2);\nKc = zeros(3);\n");
    let message = "error: a.m:2: `Kc` has 3 rows; expected 2 rows of 2 numbers, as `M` has\n";
    directory.run(&["analyze", "a.m"]).fails(2, message);
}

/// A list of rows is no parameter, whatever the case of its name; one of numbers may be.
#[test]
fn names_of_matrices_may_be_in_lower_case() {
    let directory = Directory::new("matrices-lower-case");
    let names = ["M", "C1", "C_1", "K0", "K_0", "K2", "K_2"];
    for (file, text) in SCRIPTS {
        // With the number m in the place of its name: beside a matrix it would be a second one.
        let text = text.replace("m = 80.81722\n", "").replace("[[m,", "[[80.81722,");
        let lower = names.iter().fold(text, |text, name| {
            let assigned = [format!("{name} ="), format!("{name}:"), format!("\"{name}\"")];
            assigned.iter().fold(text, |text, name| text.replace(name, &name.to_lowercase()))
        });
        let run = directory.write(file, &lower).run(&["analyze", file, "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&run.stdout).expect(&run.stderr);
        let range = &json["stable_ranges"][0];
        assert!((range[0].as_f64().unwrap() - 4.29238253634111).abs() < 1e-13, "{file}: {range}");
        assert!(run.stderr.contains("`m` is taken for `M`, as it has rows"), "{}", run.stderr);
    }
    directory.write("a.json", r#"{"M": [[1]], "m": [[2]]}"#);
    let message = "error: a.json:1: `m` is `M`, which is given twice; first at a.json:1\n";
    directory.run(&["analyze", "a.json"]).fails(2, message);
    directory.write("a.json", r#"{"M": [[1]], "m": 2, "Kc": [["m"]]}"#);
    let json = directory.run(&["analyze", "a.json", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json.stdout).expect(&json.stderr);
    assert_eq!(json["matrices"]["Kc"], serde_json::json!([[2.0]]));
    directory.write("a.json", r#"{"m": [1, 2], "M": [[1]]}"#);
    let message = "error: a.json:1: `m` is no matrix; expected `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1`, `K2`";
    let run = directory.run(&["analyze", "a.json"]);
    assert!(run.stderr.starts_with(message), "{}", run.stderr);
}
