//! Forces that follow from the motion, by laws of the command line.

use serde_json::{Value, json};

use crate::Directory;

/// Steer into the fall, up to a speed: what the model BalanceAssist has in its equations.
const LAW: &str = "Tdelta = 10*(4.7 - v)*phi_rate";

fn numbers(value: &Value, found: &mut Vec<f64>) {
    match value {
        Value::Number(number) => found.push(number.as_f64().unwrap()),
        Value::Array(values) => values.iter().for_each(|value| numbers(value, found)),
        Value::Object(members) => members.values().for_each(|value| numbers(value, found)),
        _ => {}
    }
}

#[track_caller]
fn assert_same(one: &Value, other: &Value, error: f64) {
    let [mut first, mut second] = [Vec::new(), Vec::new()];
    numbers(one, &mut first);
    numbers(other, &mut second);
    assert_eq!(first.len(), second.len());
    assert!(first.len() > 1, "{first:?}");
    let largest = first.iter().fold(1.0, |largest: f64, number| largest.max(number.abs()));
    for (one, other) in first.iter().zip(&second) {
        assert!((one - other).abs() <= error * largest, "{one} and {other}");
    }
}

/// Recomputed with 40 digits (`tests/data/published_speeds.tsv`, `BalanceAssist`), and the capsize speed of the bicycle alone
/// (`tests/data/critical_speeds.tsv`), which feedback of a rate leaves.
#[test]
fn critical_speeds_of_a_closed_loop_are_those_of_the_model_that_has_it() {
    let directory = Directory::of_this_test();
    let closed = directory.run(&["analyze", "--feedback", LAW, "--format", "json"]).json();
    let deciding = |event: &&Value| event["kind"] != "double_root";
    let speeds: Vec<f64> = closed["critical_speeds"]
        .as_array()
        .unwrap()
        .iter()
        .filter(deciding)
        .map(|event| event["speed"].as_f64().unwrap())
        .collect();
    let expected = [1.0948652805741492, 4.912_570_360_527_988, 6.024_262_015_388_359];
    assert_eq!(speeds.len(), 3);
    for (speed, expected) in speeds.iter().zip(expected) {
        assert!((speed - expected).abs() < 2e-15 * expected, "{speed}, expected {expected}");
    }
    let model = directory.run(&["analyze", "--model", "BalanceAssist", "--format", "json"]).json();
    for member in ["matrices", "critical_speeds", "stable_ranges", "eigenvalues"] {
        assert_same(&closed[member], &model[member], 1e-13);
    }
    assert_eq!(closed["feedback"], json!([LAW]));
    // What is printed is such a file.
    directory.write("closed.json", closed.to_string());
    assert_eq!(directory.run(&["analyze", "closed.json", "--format", "json"]).json(), closed);
}

/// One law, as people write it.
#[test]
fn laws_are_read_in_units_and_in_other_words() {
    let directory = Directory::of_this_test();
    let matrices = |law: &str| {
        let json = directory.run(&["analyze", "--speeds", "4", "--format", "json", "--feedback", law]).json();
        json["matrices"].clone()
    };
    let expected = matrices(LAW);
    for law in [
        "delta = -10*(v - 4.7)*phi'",
        "steer = 47*lean_rate - 10*v*lean_rate",
        "tdelta = 10 kg*m*(4.7 m/s - v)*rate(phi)",
        "Tdelta = 10 [N s^2]*(4.7 m/s - v)*phi_rate",
        "Tdelta = -(10)*v*phidot - -47 N*m*s*phi_rate + phi - phi",
        "Tdelta = (47*v^2 - 10*v³)*phi_rate/v^2",
    ] {
        assert_same(&matrices(law), &expected, 2e-15);
    }
    // All powers, in their matrices, on the other side of the equation.
    let law = "Tphi = 3/v*delta_rate + 4*phi - 5*v*delta + 6*v**2*phi + 7 N*m/deg*delta";
    let all = matrices(law);
    let radians = -7.0 * 180.0 / std::f64::consts::PI;
    assert_eq!(all["C-1"], json!([[0.0, -3.0], [0.0, 0.0]]));
    assert_eq!(all["Kc"][0][0], json!(-4.0));
    assert!((all["Kc"][0][1].as_f64().unwrap() - radians).abs() < 1e-13);
    assert_eq!(all["K1"], json!([[0.0, 5.0], [0.0, 0.0]]));
    assert_eq!(all["K2"][0][0], json!(-6.0));
}

#[test]
fn mistakes_in_laws_are_told_together() {
    let directory = Directory::of_this_test();
    let names = "\nthey are phi, phi_rate, delta, delta_rate, v; for example 'Tdelta = -10*phi_rate'";
    let example = "; for example 'Tdelta = -10*phi_rate'";
    for (law, message) in [
        ("Tdelta", "expected FORCE = LAW, such as 'Tdelta = -10*phi_rate'".to_owned()),
        ("Tdelt = phi", "`Tdelt` is no force on Whipple; did you mean `Tdelta`?\nthey are Tphi, Tdelta".to_owned()),
        (
            "Tdelta = ph_rate",
            format!("`ph_rate` is neither a position nor a rate of Whipple; did you mean `phi_rate`?{names}"),
        ),
        (
            "Tdelta = 2*mB*phi",
            format!("`mB` is a parameter of Whipple; expected its value: gains are numbers{example}"),
        ),
        (
            "Tdelta = 2*phi*v^3",
            "`phi` is multiplied by v^3; the equations of motion have no such term: a position has 1, v and v^2"
                .to_owned(),
        ),
        (
            "Tdelta = phi_rate*v^2",
            "`phi_rate` is multiplied by v^2; the equations of motion have no such term: a rate has 1/v, 1 and v"
                .to_owned(),
        ),
        (
            "Tdelta = 10 N*s*phi_rate",
            "the unit of what multiplies `phi_rate` makes no force in N m; expected N m s".to_owned(),
        ),
        (
            "Tdelta = 10 N*m*s*v*phi_rate",
            "the unit of what multiplies `phi_rate` and v makes no force in N m; expected N s^2".to_owned(),
        ),
        ("Tdelta = (4.7 kg - v)*phi_rate", format!("quantities of different units are added{example}")),
        (
            "Tdelta = phi*delta",
            format!(
                "it is not linear: expected a sum of positions and rates, each times numbers and powers of `v`{example}"
            ),
        ),
        ("Tdelta = 10 phi", format!("expected a sign such as `*` before `phi`{example}")),
        ("Tdelta = phi/((((v + 1)^8)^8)^8)^8", format!("the powers of `v` are too high{example}")),
        ("Tdelta = ((((((v^8)^8)^8)^8)^8)^8)^8*phi", format!("the powers of `v` are too high{example}")),
        (
            "Tdelta = 10 N⋅m·s⋅ phi_rat",
            format!("`phi_rat` is neither a position nor a rate of Whipple; did you mean `phi_rate`?{names}"),
        ),
        ("Tdelta = phi/0", "what multiplies `phi` is inf; it must be finite".to_owned()),
        (
            "Tdelta = phi^2",
            format!(
                "it is not linear: no power of a position or rate, and no negative one of a sum, is fed back{example}"
            ),
        ),
        ("Tdelta = sqrt(phi)", format!("it is not linear: the argument of `sqrt` is not a number{example}")),
        (
            "Tdelta = sqrt(v - 6)*phi_rate",
            format!(
                "`sqrt` is of the speed, of which the equations of motion have whole powers alone: expected such as `v^2`{example}"
            ),
        ),
        ("Tdelta = 10*(phi", format!("a closing parenthesis is missing{example}")),
    ] {
        let message = format!("error: --feedback '{law}': {message}\n");
        directory.run(&["analyze", "--feedback", law]).fails(2, &message);
    }
    let twice = ["analyze", "--set", "mB=-1", "--feedback", "Tdelta = phi", "--feedback", "steer = phi_rate"];
    directory.run(&twice).fails(
        2,
        "error: 2 problems\n--feedback 'steer = phi_rate': there is a law for the force `Tdelta` already, at --feedback 'Tdelta = \
         phi'; expected one sum\n--set mB=-1: `mB` is -1 kg; it must be >= 0\n",
    );
    let rate = ["analyze", "--model", "Wheelset", "--feedback", "Tqqq = 1"];
    assert_eq!(directory.run(&rate).code, Some(2));
}

/// Files have laws, too, and the command line replaces them force by force.
#[test]
fn a_file_has_laws() {
    let directory = Directory::of_this_test();
    let shown = directory.run(&["show", "--feedback", LAW]).ok();
    assert!(shown.contains(&format!("\nfeedback = [\"{LAW}\"]\n")), "{shown}");
    directory.write("mine.toml", &shown);
    let analyze = |arguments: &[&str]| {
        directory.run(&[&["analyze", "--format", "json", "--speeds", "3"], arguments].concat()).json()
    };
    let mut from_file = analyze(&["mine.toml"]);
    let from_option = analyze(&["--feedback", LAW]);
    assert_eq!(from_file, from_option);
    from_file = analyze(&["mine.toml", "--feedback", "delta = -phi", "--feedback", "phi = -delta_rate"]);
    assert_eq!(from_file["feedback"], json!(["delta = -phi", "phi = -delta_rate"]));
    directory.write("mine.toml", shown.replace("[\"Tdelta", "[\"Tdelt"));
    let line = shown.lines().position(|line| line.starts_with("feedback")).unwrap() + 1;
    let message = format!(
        "error: mine.toml:{line}: `Tdelt` is no force on Whipple; did you mean `Tdelta`?\nthey are Tphi, Tdelta\n"
    );
    directory.run(&["analyze", "mine.toml"]).fails(2, &message);
}

/// The commands that the loop is closed in, held against the model that has it in its equations.
#[test]
fn every_command_takes_the_closed_loop() {
    let directory = Directory::of_this_test();
    let both = |arguments: &[&str]| {
        let model = directory.run(&[arguments, &["--model", "BalanceAssist"]].concat());
        [directory.run(&[arguments, &["--feedback", LAW]].concat()), model].map(|run| {
            assert_eq!(run.code, Some(0), "{}", run.stderr);
            run.stdout
        })
    };
    let json = |texts: [String; 2]| texts.map(|text| serde_json::from_str::<Value>(&text).unwrap());
    let [closed, model] = json(both(&[
        "simulate",
        "--linear",
        "--speed",
        "3",
        "--initial",
        "phi_rate=0.5",
        "--duration",
        "2",
        "--format",
        "json",
    ]));
    // The path of the wheels is told of the bicycle alone.
    let last = |motion: &Value| motion["rows"].as_array().unwrap().last().unwrap()["positions"].clone();
    for name in ["phi", "delta"] {
        let [one, other] = [&closed, &model].map(|motion| last(motion)[name].as_f64().unwrap());
        assert!((one - other).abs() < 1e-12 * other.abs(), "{one}, {other}");
    }
    let [closed, model] = json(both(&["analyze", "--along", "mB=60:120", "--speed", "1.2", "--format", "json"]));
    assert_same(&closed["critical_values"], &model["critical_values"], 1e-12);
    let [closed, model] = json(both(&["sensitivity", "--format", "json"]));
    let by_mass = |found: &Value| {
        found["critical_speeds"]
            .as_array()
            .unwrap()
            .iter()
            .map(|speed| speed["derivatives"]["mB"].clone())
            .collect::<Value>()
    };
    assert_same(&by_mass(&closed), &by_mass(&model), 1e-10);
    let [closed, model] = both(&["sweep", "--vary", "w=1:1.1:0.05"]);
    let weave = |table: &str| -> Vec<Vec<String>> {
        let mut lines = table.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<String>>());
        let heading = lines.next().unwrap();
        let columns: Vec<usize> = (0..heading.len()).filter(|&index| heading[index].starts_with("weave")).collect();
        lines.map(|line| columns.iter().map(|&column| line[column].clone()).collect()).collect()
    };
    let [closed, model] = [closed, model].map(|table| weave(&table));
    assert_eq!(closed.len(), 3);
    for (one, other) in closed.iter().flatten().zip(model.iter().flatten()).filter(|(one, _)| !one.is_empty()) {
        let [one, other] = [one, other].map(|cell| cell.parse::<f64>().unwrap());
        assert!((one - other).abs() < 1e-13 * other, "{one}, {other}");
    }
}

/// By nonlinear equations, too: 1.8 mrad of lean and steer differ from those of the linear ones by what is cubic in them. What the law
/// makes is told beside the motion, with the speed of the moment.
#[test]
fn nonlinear_motions_and_turns_are_of_the_closed_loop() {
    let directory = Directory::of_this_test();
    let simulate = |options: &[&str]| {
        let given = ["simulate", "--feedback", LAW, "--speed", "3", "--initial", "phi_rate=0.01", "--duration", "2"];
        directory.run(&[&given, options].concat())
    };
    let [nonlinear, linear] = [simulate(&["--format", "json"]), simulate(&["--format", "json", "--linear"])];
    assert_eq!(nonlinear.stderr, "");
    let [nonlinear, linear] = [nonlinear.json(), linear.json()];
    assert_eq!([&nonlinear["equations"], &linear["equations"]], [&json!("nonlinear"), &json!("linear")]);
    let mut largest = 0.0_f64;
    let rows = |motion: &Value| motion["rows"].as_array().unwrap().clone();
    for (one, other) in rows(&nonlinear).iter().zip(rows(&linear)) {
        let value = |row: &Value, member: &str, name: &str| row[member][name].as_f64().unwrap();
        for name in ["phi", "delta"] {
            assert!((value(one, "positions", name) - value(&other, "positions", name)).abs() < 1e-6, "{one} {other}");
            largest = largest.max(value(one, "positions", name).abs());
        }
        let speed = -0.3 * value(one, "rates", "thetaR");
        let expected = 10.0 * (4.7 - speed) * value(one, "rates", "phi");
        assert!((value(one, "feedback_forces", "Tdelta") - expected).abs() < 1e-14, "{one}");
        let expected = 17.0 * value(&other, "rates", "phi");
        assert!((value(&other, "feedback_forces", "Tdelta") - expected).abs() < 1e-14, "{other}");
    }
    assert!(largest > 5e-3, "{largest}");
    let csv = simulate(&["--format", "csv"]).ok();
    assert!(csv.lines().next().unwrap().contains(",potential_energy (J),Tdelta (N*m),force_R_x (N),"), "{csv}");
    assert!(simulate(&[]).ok().contains("steer delta (°)  Tdelta (N m)\n"));
    // A circle of the closed loop is one in which the motion stays.
    let law = "Tdelta = -2*delta";
    let turns = directory.run(&["turns", "--feedback", law, "--steer", "5 deg", "--format", "json"]).json();
    let turn = &turns["families"][0]["turns"][0];
    let of = |member: &str, name: &str| turn[member][name].as_f64().unwrap();
    let given = [format!("phi={}", of("positions", "phi")), format!("delta={}", of("positions", "delta"))];
    let speed = format!("{}", -0.3 * of("rates", "thetaR"));
    let still = ["simulate", "--feedback", law, "--speed", &speed, "--duration", "0", "--format", "json"];
    let motion = directory.run(&[&still[..], &["--initial", &given[0], "--initial", &given[1]]].concat()).json();
    for name in ["phi", "delta", "thetaR"] {
        let acceleration = motion["rows"][0]["accelerations"][name].as_f64().unwrap();
        assert!(acceleration.abs() < 1e-9, "{name}: {acceleration}");
    }
    // What the nonlinear equations have no force for is told.
    let run = directory.run(&[
        "simulate",
        "--model",
        "WheeledPendulum",
        "--feedback",
        "Ttheta = -theta",
        "--duration",
        "0.1",
    ]);
    let without =
        "the nonlinear equations of WheeledPendulum have no force `Ttheta`, which is fed back; they have TL, TR";
    assert_eq!((run.code, run.stderr), (Some(0), format!("note: {without}; these are the linear ones\n")));
    directory
        .run(&["turns", "--model", "WheeledPendulum", "--feedback", "Ttheta = -theta"])
        .fails(1, &format!("error: WheeledPendulum robot with feedback: {without}\n"));
}

/// An inverted pendulum of matrices, `q'' - q = f`, with `f = -5*q - 2*q_rate`: `s^2 + 2 s + 4` has -1 ± √3 i.
#[test]
fn given_matrices_are_closed_as_well() {
    let directory = Directory::of_this_test();
    directory.write("matrices.json", r#"{"M": [[1]], "Kc": [[-1]]}"#);
    let json =
        directory.run(&["analyze", "matrices.json", "--feedback", "q1 = -5*q1 - 2*q1_rate", "--format", "json"]).json();
    let values = &json["eigenvalues"][0]["values"];
    let found = |index: usize, part: &str| values[index][part].as_f64().unwrap();
    assert!((found(0, "re") + 1.0).abs() < 1e-15 && (found(0, "im").abs() - f64::sqrt(3.0)).abs() < 1e-15, "{values}");
    directory.write("closed.json", json.to_string());
    assert_eq!(directory.run(&["analyze", "closed.json", "--format", "json"]).json(), json);
    let shown = directory.run(&["show", "closed.json"]).ok();
    assert!(shown.contains("feedback = ") && shown.contains("Kc = [\n    [-1.0],") && !shown.contains("C0"), "{shown}");
}

/// The hinges of a double pendulum have torques by names of its mechanism, the linear equations by those of its coordinates: both know
/// all of them. The motions differ by what is of third order in 1e-4 rad.
#[test]
fn forces_have_one_name_in_linear_and_nonlinear_equations() {
    let directory = Directory::of_this_test();
    let pushed =
        ["simulate", "--model", "DoublePendulum", "--initial", "theta1=1e-4", "--duration", "0.3", "--format", "json"];
    let last = |more: &[&str]| {
        let motion = directory.run(&[&pushed, more].concat()).json();
        motion["rows"].as_array().unwrap().last().unwrap()["positions"]["theta2"].as_f64().unwrap()
    };
    for option in ["--force", "--feedback"] {
        let value = if option == "--force" { "=1e-3" } else { "=-8*theta1" };
        let expected = last(&[option, &format!("T1{value}")]);
        assert!(expected.abs() > 1e-5, "{expected}");
        for name in ["T1", "Ttheta1", "theta1", "torque at the lower hinge"] {
            for equations in [&[][..], &["--linear"]] {
                let found = last(&[&[option, &format!("{name}{value}")], equations].concat());
                assert!((found - expected).abs() < 1e-6 * expected.abs(), "{option} {name} {equations:?}: {found}");
            }
        }
    }
}

/// By virtual work a motor pushes the ground: with the radius r and half the track b it is a force `-1/r` forward and a torque `-b/r` or
/// `b/r` in yaw, and none in pitch, against which the body moves by itself. What holds the machine up does so in the nonlinear
/// equations, too, which have motors alone.
#[test]
fn motors_on_wheels_are_forces_on_all_that_they_move() {
    let directory = Directory::of_this_test();
    let robot = ["--model", "WheeledPendulum"];
    let (r, b) = (0.04, 0.07);
    let law = "0.3*theta_rate + 3*theta";
    let [left, right] = ["TL", "TR"].map(|motor| format!("{motor} = {law} + 0.05*x_rate"));
    let by_motors = ["--feedback", left.as_str(), "--feedback", right.as_str()];
    let by_hand = format!("Fx = {}*({law} + 0.05*x_rate)", -2.0 / r);
    let analyze = |laws: &[&str]| directory.run(&[&["analyze", "--format", "json"], &robot[..], laws].concat()).json();
    let (motors, hand) = (analyze(&by_motors), analyze(&["--feedback", &by_hand]));
    for member in ["matrices", "eigenvalues"] {
        assert_same(&motors[member], &hand[member], 1e-14);
    }
    let inputs = |names: &str| {
        directory.run(&[&["statespace", "--format", "json", "--inputs", names], &robot[..]].concat()).json()["B"]
            .clone()
    };
    let (motors, coordinates) = (inputs("TL,TR"), inputs("Fx,Tpsi"));
    for (motors, own) in motors.as_array().unwrap().iter().zip(coordinates.as_array().unwrap()) {
        let [forward, yaw] = [0, 1].map(|place| own[place].as_f64().unwrap());
        let expected = json!([(-forward - b * yaw) / r, (-forward + b * yaw) / r]);
        assert_same(&json!([motors, 1e4]), &json!([expected, 1e4]), 1e-15);
    }
    let pitch = |more: &[&str]| {
        let ride = ["simulate", "--initial", "theta=1e-5", "--duration", "0.3", "--format", "json"];
        let motion = directory.run(&[&ride, &robot[..], more].concat()).json();
        motion["rows"].as_array().unwrap().last().unwrap()["positions"]["theta"].as_f64().unwrap()
    };
    // In the nonlinear equations x is where the wheel touches the ground, below which the body does not pitch.
    let held = ["TL", "TR"].map(|motor| format!("{motor} = {law}"));
    let by_motors = ["--feedback", held[0].as_str(), "--feedback", held[1].as_str()];
    for more in [&by_motors[..], &["--force", "TL=1e-6", "--force", "TR=1e-6"]] {
        let (nonlinear, linear) = (pitch(more), pitch(&[more, &["--linear"]].concat()));
        assert!((nonlinear - linear).abs() < 1e-7 * linear.abs(), "{nonlinear} and {linear}");
    }
    let sensitivity = [&["sensitivity"], &robot[..], &by_motors].concat();
    directory.run(&sensitivity).fails(
        1,
        "error: WheeledPendulum robot with feedback: there are no derivatives with feedback of `TL`, which acts on no coordinate: how \
         `TL` moves them changes with parameters; expected forces on the coordinates\n",
    );
}

/// Gains as a table of `lqr` has them in ounces and degrees are read again: with them the loop has the eigenvalues that it tells. Where
/// pounds make no torque as masses, they are forces.
#[test]
fn gains_of_a_table_are_read_in_its_units() {
    let directory = Directory::of_this_test();
    let table =
        directory.run(&["lqr", "--speeds", "5", "--inputs", "Tdelta", "--units", "oz*in,deg", "--format", "csv"]).ok();
    let [header, row] = [0, 1].map(|line| table.lines().nth(line).unwrap().split(',').collect::<Vec<_>>());
    let terms = header.iter().zip(&row).filter_map(|(name, value)| {
        let (motion, unit) = name.strip_prefix("Tdelta by ")?.strip_suffix(')')?.split_once(" (")?;
        Some(format!("{value} {unit}*{motion}"))
    });
    let law = format!("Tdelta = -({})", terms.collect::<Vec<_>>().join(" + "));
    assert!(law.contains("oz*in*s/deg*phi_rate"), "{law}");
    let closed = directory.run(&["analyze", "--speeds", "5", "--feedback", &law, "--format", "json"]).json();
    let mut found: Vec<f64> = Vec::new();
    numbers(&closed["eigenvalues"][0]["values"], &mut found);
    let told = header.iter().zip(&row).filter(|(name, _)| name.starts_with("eigenvalue"));
    let told: Vec<f64> = told.map(|(_, value)| value.parse().unwrap()).collect();
    assert_eq!(told.len(), 8);
    for value in told {
        assert!(found.iter().any(|own| (own - value).abs() < 1e-9), "{value}: {found:?}");
    }
    let analyze = |law| directory.run(&["analyze", "--feedback", law, "--format", "json"]).json();
    // A unit in parentheses divides; a motion in them does not, which is not linear.
    for (written, same) in [
        ("Tdelta = -7.37 lbf*ft/(rad/s)*phi_rate", "Tdelta = -7.37 lbf*ft*s/rad*phi_rate"),
        ("Tdelta = -(10 N*m/( deg / s )) * phi_rate", "Tdelta = -10 N*m*s/deg*phi_rate"),
        ("Tdelta = -10 N*m/(v)*phi_rate", "Tdelta = -10 N*m/v*phi_rate"),
    ] {
        let critical = |law: &str| {
            let run = directory.run(&["analyze", "--feedback", law, "--format", "json"]);
            (run.code, (run.code == Some(0)).then(|| run.json()["critical_speeds"].clone()))
        };
        assert_eq!(critical(written), critical(same), "{written}");
    }
    let refused = directory.run(&["analyze", "--feedback", "Tdelta = -10 N*m/(phi)*phi_rate"]);
    assert!(
        refused.code == Some(2) && refused.stderr.contains("expected a number or a power of `v`"),
        "{}",
        refused.stderr
    );
    let [mass, force] = ["Tdelta = 10 lb*in*s*phi_rate", "Tdelta = 10 lbf*in*s*phi_rate"].map(analyze);
    assert_eq!(mass["critical_speeds"], force["critical_speeds"]);
}
