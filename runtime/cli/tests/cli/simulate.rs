//! Motions in time.

use serde_json::Value;

use crate::Directory;

/// Runs `carvallo simulate`.
fn simulate(directory: &Directory, arguments: &[&str]) -> crate::Run {
    directory.run(&[&["simulate"], arguments].concat())
}

#[track_caller]
fn assert_near(found: &Value, expected: f64, bound: f64) {
    let found = found.as_f64().expect("a number");
    assert!((found - expected).abs() <= bound * expected.abs().max(1.0), "{found} is not {expected}");
}

/// The benchmark bicycle at 4.6 m/s after a push of 0.5 rad/s, linear: lean, steer, their rates, yaw and y, by the exponential
/// of the printed matrices at 60 digits (mpmath).
const PUSHED: [(f64, [f64; 6]); 3] = [
    (
        1.0,
        [
            -0.05295142942004998,
            -0.04375017636808926,
            -0.24956773931553197,
            -0.37639700887986005,
            0.3019227417451028,
            0.7988782020833841,
        ],
    ),
    (
        2.0,
        [
            0.06227863682512368,
            0.07048234036612427,
            0.013321568143755926,
            0.09278363039827259,
            0.15850496842629055,
            1.5568421872741014,
        ],
    ),
    (
        4.0,
        [
            0.008085626405648172,
            0.018217325677948048,
            -0.11062659748184872,
            -0.12664641099428336,
            0.2324322656445748,
            3.4285774728323264,
        ],
    ),
];

#[test]
fn a_push_is_that_of_sixty_digits() {
    let directory = Directory::of_this_test();
    let pushed = ["--linear", "--speed", "4.6", "--initial", "phi_rate=0.5", "--duration", "4", "--format", "json"];
    let json = simulate(&directory, &pushed).json();
    let rows = json["rows"].as_array().expect("rows");
    assert_eq!((rows.len(), json["equations"].as_str()), (101, Some("linear")));
    for (time, expected) in PUSHED {
        let row = &rows[(time * 25.0) as usize];
        assert_eq!(row["t"], time);
        let (positions, rates) = (&row["positions"], &row["rates"]);
        let found = [
            &positions["phi"],
            &positions["delta"],
            &rates["phi"],
            &rates["delta"],
            &positions["psi"],
            &positions["y"],
        ];
        found.into_iter().zip(expected).for_each(|(found, expected)| assert_near(found, expected, 2e-12));
        assert_near(&positions["x"], 4.6 * time, 1e-14);
        assert_near(&rates["thetaR"], -4.6 / 0.3, 1e-15);
    }
}

/// M^-1 (f - K q) at 4.6 m/s, a lean of 0.1 rad and a steer torque of 2 N m, from the printed matrices.
#[test]
fn no_duration_gives_the_accelerations_of_a_state() {
    let directory = Directory::of_this_test();
    let state = ["--linear", "--speed", "4.6", "--initial", "lean=0.1", "--force", "Tdelta=2 N m", "--duration", "0"];
    let json = simulate(&directory, &[&state[..], &["--format", "json"]].concat()).json();
    let rows = json["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 1);
    assert_near(&rows[0]["accelerations"]["phi"], 0.7007933938542075, 2e-13);
    assert_near(&rows[0]["accelerations"]["delta"], 9.819628048804782, 2e-13);
}

/// A pendulum, `m l² theta'' + c theta' + g m l theta = 0`, let go: exp(-a t) (cos w t + (a/w) sin w t).
#[test]
fn other_models_move_as_well() {
    let directory = Directory::of_this_test();
    let pendulum =
        ["--linear", "--model", "Pendulum", "--initial", "theta=20 deg", "--duration", "3 s", "--step", "0.75"];
    let text = simulate(&directory, &[&pendulum[..], &["--format", "csv"]].concat()).ok();
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert!(text.starts_with("t (s),theta (rad),theta_rate (rad/s),theta_acceleration (rad/s^2)\n"), "{text}");
    let show = directory.run(&["show", "--model", "Pendulum"]).ok();
    let value = |name: &str| -> f64 {
        let line = show.lines().find(|line| line.starts_with(&format!("{name} = "))).expect("a parameter");
        line.split([' ', '#']).nth(2).and_then(|value| value.parse().ok()).expect("a number")
    };
    let a = value("c") / (2.0 * value("m") * value("l").powi(2));
    let w = (value("g") / value("l") - a * a).sqrt();
    for row in rows {
        let t = row[0];
        let expected = 20_f64.to_radians() * (-a * t).exp() * ((w * t).cos() + a / w * (w * t).sin());
        assert!((row[1] - expected).abs() < 1e-13, "{row:?}");
    }
}

/// A mass that nothing holds, by its matrix: q'' = f/m.
#[test]
fn forces_come_from_files() {
    let directory = Directory::of_this_test();
    directory.write("mass.json", r#"{"M": [[2]], "C0": [[0]], "coordinates": [{"name": "q1", "only": "rate"}]}"#);
    directory.write("push.csv", "t (s),force (N)\n# a jump\n0,0\n1,0\n1,6\n3,6\n3,0\n10,0\n");
    let run =
        ["mass.json", "--linear", "--force", "q1=push.csv", "--duration", "10", "--step", "1", "--format", "json"];
    let json = simulate(&directory, &run).json();
    for (time, expected) in [(1, 0.0), (2, 1.5), (3, 6.0), (10, 48.0)] {
        assert_near(&json["rows"][time]["positions"]["q1"], expected, 1e-13);
    }
}

#[test]
fn results_go_to_files() {
    let directory = Directory::of_this_test();
    let ride = ["--linear", "--speed", "5", "--initial", "phi=0.1", "--duration", "2"];
    for (format, file) in [("table", "ride.txt"), ("csv", "ride.csv"), ("json", "ride")] {
        let printed = simulate(&directory, &[&ride[..], &["--format", format]].concat()).ok();
        let written = simulate(&directory, &[&ride[..], &["--format", format, "--output", file]].concat());
        assert_eq!(
            (written.code, written.stdout.as_str(), written.stderr.as_str()),
            (Some(0), "", format!("wrote: {file}\n").as_str())
        );
        assert_eq!(std::fs::read_to_string(directory.0.join(file)).expect("a file"), printed);
    }
}

#[test]
fn all_mistakes_are_told_at_once() {
    let directory = Directory::of_this_test();
    let wrong =
        ["--linear", "--duration", "-1", "--step", "0", "--speed", "fast", "--initial", "ph=1", "--force", "q=1"];
    simulate(&directory, &wrong).fails(
        2,
        "error: 5 problems\n\
         --duration -1: the duration is -1 s; it must be >= 0\n\
         --step 0: the step is 0 s; it must be > 0\n\
         --speed fast: the speed must be a finite number: `fast` is not known\n\
         --initial ph=1: `ph` is no position or rate of Whipple; did you mean `phi`?\n\
         they are phi, delta, psi, x, y, thetaR, thetaF, phi_rate, delta_rate\n\
         --force q=1: `q` is no force on Whipple\n\
         they are Tphi, Tdelta\n",
    );
    simulate(&directory, &["--duration", "1"])
        .fails(2, "error: expected --speed V, which the motion depends on, such as --speed 4.6\n");
    simulate(&directory, &["--linear", "--speed", "5", "--initial", "thetaR_rate=1", "--duration", "1"])
        .fails(2, "error: --initial thetaR_rate=1: the rate of `thetaR` cannot be given: it follows from --speed\n");
}

#[test]
fn force_files_are_read_with_care() {
    let directory = Directory::of_this_test();
    for (text, message) in [
        ("0,1\n2,1\n1,1\n", "force.csv:3: the time 1 s comes behind 2 s; times must ascend"),
        ("0,1\n1,2\n1,3\n1,4\n5,0\n", "force.csv:4: it is the third line at 1 s; a jump has two"),
        ("0,1\n1,\n5,1\n", "force.csv:2: there is a gap; expected a time in s and a force"),
        ("0,1\n1,2,3\n5,1\n", "force.csv:2: the line has 3 fields; expected a time in s and a force"),
        ("0,1\n1,x\n5,1\n", "force.csv:2: `x` must be a finite number: `x` is not known"),
        ("t,T\n", "force.csv: there is no line with a time and a force"),
        ("time (days),force (N m)\n0,1\n5,1\n", "force.csv:1: `days` is no unit for it; it is in s"),
        ("time,force [kg]\n0,1\n5,1\n", "force.csv:1: `kg` is no unit for it; it is in N m"),
        ("1,0\n5,1\n", "force.csv: the first time is 1 s; it must begin at 0 s, where the motion does"),
        ("0,0\n3,1\n", "force.csv: the last time is 3 s; it must reach 5 s, where the motion ends"),
    ] {
        directory.write("force.csv", text);
        let ride = ["--linear", "--speed", "5", "--force", "delta=force.csv", "--duration", "5"];
        simulate(&directory, &ride).fails(2, &format!("error: {message}\n"));
    }
}

/// As PowerShell writes what is redirected to a file, and in Latin-1.
#[test]
fn force_files_are_read_in_other_encodings() {
    let directory = Directory::of_this_test();
    let text = "# für den Lenker\ntime,force [N m]\n0,1\n1,2\n";
    let utf_16 = std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes);
    std::fs::write(directory.0.join("utf16.csv"), utf_16.collect::<Vec<u8>>()).unwrap();
    std::fs::write(directory.0.join("latin.csv"), text.chars().map(|sign| sign as u8).collect::<Vec<u8>>()).unwrap();
    directory.write("utf8.csv", text);
    let ride = |file: &str| {
        let force = format!("delta={file}.csv");
        let ride = ["--linear", "--speed", "5", "--force", &force, "--duration", "1", "--format", "csv"];
        simulate(&directory, &ride).ok()
    };
    let plain = ride("utf8");
    assert_eq!([ride("utf16"), ride("latin")], [plain.clone(), plain]);
}

/// What grows for ever leaves the range of doubles: what there is until then is told, and that it ends.
#[test]
fn what_leaves_the_range_of_doubles_ends_early() {
    let directory = Directory::of_this_test();
    directory.write("fall.json", r#"{"M": [[1]], "Kc": [[-1]]}"#);
    let run = ["fall.json", "--linear", "--initial", "q1=1", "--duration", "1000", "--step", "100", "--format", "csv"];
    let run = simulate(&directory, &run);
    let reason = "the motion then leaves the range of floating-point numbers";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), &*format!("note: the motion ends before 800 s: {reason}\n")));
    assert_eq!(run.stdout.lines().count(), 9);
}

/// Up to 2^53 doubles have every whole number, beyond it every second one.
#[test]
fn what_is_beyond_computing_is_refused_with_its_name() {
    let directory = Directory::of_this_test();
    let run =
        ["--initial", "phi=1e308", "--initial", "delta_rate=-1e200", "--force", "Tphi=-1e308", "--speed", "1e120"];
    let range =
        "it must be at most 1e100 in size, or what is computed of it leaves the range of floating-point numbers";
    let angle = "it must be at most 9007199254740992 in size, beyond which floating-point numbers tell no angle";
    let told = |lean: &str| {
        format!(
            "error: 4 problems\n\
             --initial phi=1e308: the lean is 1e308 rad; {lean}\n\
             --initial delta_rate=-1e200: the rate of steer is -1e200 rad/s; {range}\n\
             --speed 1e120: the speed is 1e120 m/s; {range}\n\
             --force Tphi=-1e308: the force is -1e308 N m; {}\n",
            range.replace("1e100", "1e300")
        )
    };
    simulate(&directory, &[&run[..], &["--duration", "1"]].concat()).fails(2, &told(angle));
    simulate(&directory, &[&run[..], &["--duration", "1", "--linear"]].concat()).fails(2, &told(range));
}

/// (1e100)^2 is in the range of doubles, and the accelerations by it are; their squares are not.
#[test]
fn an_overflow_is_told_as_that() {
    let directory = Directory::of_this_test();
    let run = simulate(&directory, &["--speed", "5", "--initial", "phi_rate=1e100", "--duration", "1"]);
    let told = "note: the motion ends at 0 s: the motion then leaves the range of floating-point numbers; accelerations are up to";
    assert!(run.code == Some(0) && run.stderr.starts_with(told) && !run.stderr.contains("flat"), "{}", run.stderr);
}

/// Of a force of 1e307 N m, which the law has within the range of doubles, the accelerations are none in degrees.
#[test]
fn what_follows_from_a_motion_beyond_the_range_is_told() {
    let directory = Directory::of_this_test();
    let run = ["--speed", "5", "--initial", "phi=0.1", "--duration", "1", "--feedback", "Tdelta=-1e308*phi"];
    let told = "error: forces or accelerations at 0 s leave the range of floating-point numbers\n";
    simulate(&directory, &run).fails(1, told);
}

/// A thousand million seconds are days of computing; the exact solution has no steps.
#[test]
fn what_would_be_integrated_for_days_is_refused() {
    let directory = Directory::of_this_test();
    let run = simulate(&directory, &["--speed", "5", "--duration", "1e9"]);
    assert!(run.code == Some(2) && run.stderr.contains("it must be at most 1000000 s"), "{}", run.stderr);
    simulate(&directory, &["--speed", "5", "--duration", "1e9", "--linear"]).ok();
}

/// The state of Table 1 of Basu-Mandal, Chatterjee & Papadopoulos (2007), and the accelerations and contact forces there, at
/// 80 digits from nine coordinates and six velocity constraints.
#[test]
fn accelerations_and_forces_are_those_of_basu_mandal() {
    let directory = Directory::of_this_test();
    let state = [
        "--speed",
        "2.6738968984467",
        "--initial",
        "phi=0.62066704164769661923132169164",
        "--initial",
        "delta=-0.2311385135743",
        "--initial",
        "phi_rate=-0.6068425835418",
        "--initial",
        "delta_rate=-0.4859824687093",
        "--duration",
        "0",
        "--format",
        "json",
    ];
    let json = simulate(&directory, &state).json();
    assert_eq!(json["equations"], "nonlinear");
    let row = &json["rows"][0];
    for (member, name, expected) in [
        ("positions", "pitch", 0.015885352100443954),
        ("rates", "thetaR", -8.912989661489),
        ("rates", "thetaF", -8.013362058415453),
        ("rates", "psi", -0.7830033527064925),
        ("rates", "pitch", 0.011918552806873832),
        ("accelerations", "psi", -0.8353281706380009),
        ("accelerations", "phi", 7.855528112824301),
        ("accelerations", "pitch", -0.12055438978837053),
        ("accelerations", "delta", 4.6198904039398005),
        ("accelerations", "thetaR", -1.8472554144219437),
        ("accelerations", "thetaF", -2.454807290455227),
    ] {
        assert_near(&row[member][name], expected, 1e-13);
    }
    let forces = [
        ("R", [-0.8268320661887361, 168.70716387615093, -363.68224003958716]),
        ("F", [20.4511484159195, 82.03990066142602, -158.81666855997656]),
    ];
    for (wheel, expected) in forces {
        for (axis, expected) in expected.into_iter().enumerate() {
            assert_near(&row["contact_forces"][wheel][axis], expected, 1e-11);
        }
    }
}

/// The manoeuvre of the IFToMM benchmark "Uncontrolled bicycle", from a simulation of other equations; and the energy, which
/// nothing takes.
#[test]
fn a_bicycle_rides_by_its_nonlinear_equations() {
    let directory = Directory::of_this_test();
    let ride = ["--speed", "4.6", "--initial", "phi_rate=0.5", "--duration", "10", "--step", "0.5", "--format", "json"];
    let json = simulate(&directory, &ride).json();
    let rows = json["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 21);
    for (index, lean, steer, yaw, wheel) in [
        (4, 0.056180808696033015, 0.06309731908372167, 0.19266341653680374, -15.456681927629731),
        (20, 0.001964643254998543, 0.002208916927520156, 0.2368300432429335, -15.408195856620347),
    ] {
        let (positions, rates) = (&rows[index]["positions"], &rows[index]["rates"]);
        let pairs = [
            (&positions["phi"], lean),
            (&positions["delta"], steer),
            (&positions["psi"], yaw),
            (&rates["thetaR"], wheel),
        ];
        pairs.into_iter().for_each(|(found, expected)| assert_near(found, expected, 1e-9));
    }
    let energy = |row: &Value| {
        ["kinetic", "potential"].map(|part| row["energy"][part].as_f64().expect("a number")).iter().sum::<f64>()
    };
    assert!(rows.iter().all(|row| (energy(row) / energy(&rows[0]) - 1.0).abs() < 1e-10));
    // The wheels carry the weight of 94 kg, and no more on the whole.
    let weight: f64 =
        ["R", "F"].map(|wheel| rows[20]["contact_forces"][wheel][2].as_f64().expect("a number")).iter().sum();
    assert!((weight + 94.0 * 9.81).abs() < 0.1, "{weight}");
}

#[test]
fn a_fall_ends_the_run_and_is_told() {
    let directory = Directory::of_this_test();
    let run = simulate(&directory, &["--speed", "0", "--initial", "phi=0.1", "--duration", "10", "--format", "csv"]);
    assert_eq!(run.code, Some(0));
    let last = run.stderr.lines().last().expect("a note");
    let (time, end) =
        last.strip_prefix("note: the motion ends at ").and_then(|rest| rest.split_once(" s: ")).expect("an end");
    assert_eq!(end, "it falls: it leans by 80 degrees");
    let row: Vec<f64> =
        run.stdout.lines().last().expect("a row").split(',').map(|cell| cell.parse().expect("a number")).collect();
    assert!((row[0] - time.parse::<f64>().expect("a time")).abs() < 1e-6);
    assert!((row[4] - 80_f64.to_radians()).abs() < 1e-12, "{}", row[4]);
}

/// As it falls at a slow walk, a steered bicycle is turned back.
#[test]
fn a_stop_is_told() {
    let directory = Directory::of_this_test();
    let run =
        simulate(&directory, &["--speed", "0.3", "--initial", "delta=0.5", "--initial", "phi=0.2", "--duration", "1"]);
    assert!(run.stderr.contains(" s it stops, and turns back\n"), "{}", run.stderr);
}

#[test]
fn what_follows_cannot_be_given() {
    let directory = Directory::of_this_test();
    let given = ["--initial", "thetaR_rate=1", "--initial", "pitch=0.1", "--initial", "psi_rate=1"];
    simulate(&directory, &[&["--speed", "5", "--duration", "1"], &given[..]].concat()).fails(
        2,
        "error: 3 problems\n\
         --initial thetaR_rate=1: the rate of `thetaR` cannot be given: it follows from --speed\n\
         --initial pitch=0.1: the position of `pitch` cannot be given: it follows, since every wheel is on the ground\n\
         --initial psi_rate=1: the rate of `psi` cannot be given: it follows, since wheels roll\n",
    );
}

/// A model without a mechanism has linear equations alone, and is simulated by them.
#[test]
fn models_without_nonlinear_equations_say_so() {
    let directory = Directory::of_this_test();
    let run = ["--model", "Pendulum", "--initial", "theta=0.1", "--duration", "1"];
    let nonlinear = simulate(&directory, &run);
    let note = "note: the model Pendulum has no nonlinear equations; these are the linear ones\n";
    assert_eq!((nonlinear.code, nonlinear.stderr.as_str()), (Some(0), note));
    assert_eq!(nonlinear.stdout, simulate(&directory, &[&run[..], &["--linear"]].concat()).ok());
}

#[test]
fn motions_and_paths_are_drawn() {
    let directory = Directory::of_this_test();
    for (name, arguments) in [
        ("ride.svg", vec!["--speed", "4.6", "--initial", "phi_rate=0.5", "--duration", "5"]),
        ("fall.svg", vec!["--speed", "2", "--initial", "phi_rate=0.5", "--duration", "5"]),
        ("linear.svg", vec!["--linear", "--speed", "4.6", "--initial", "phi_rate=0.5", "--duration", "5"]),
        ("pendulum.svg", vec!["--linear", "--model", "Pendulum", "--initial", "theta=0.1", "--duration", "5"]),
    ] {
        let run = simulate(&directory, &[&arguments[..], &["--plot", name]].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        let svg = std::fs::read_to_string(directory.0.join(name)).expect("a picture");
        assert!(svg.contains("time t (s)") && !svg.contains("NaN"), "{name}");
        assert_eq!(svg.contains("path of the front wheel"), name != "pendulum.svg");
        assert_eq!(svg.contains("the same by the linear equations"), name == "ride.svg" || name == "fall.svg");
    }
    let run = simulate(&directory, &["--speed", "5", "--duration", "0", "--plot", "still.svg"]);
    assert_eq!(
        (run.code, run.stderr.as_str()),
        (Some(2), "error: --plot still.svg: a picture needs a duration above 0\n")
    );
}

/// What begins beyond a fall is told to, and no wheel rolls under a machine that lies flat.
#[test]
fn a_start_beyond_a_fall_is_told() {
    let directory = Directory::of_this_test();
    let begin = |initial: &str| simulate(&directory, &["--speed", "4.6", "--initial", initial, "--duration", "0.05"]);
    let as_if = "and this one is told as if nothing but the wheels touched the ground";
    for (initial, beyond) in [
        ("phi=85deg", "beyond a fall: it leans by 85 degrees; a motion ends at 80"),
        ("phi=-200 deg", "beyond a fall: it leans by 200 degrees; a motion ends at 80"),
        ("delta=190 deg", "with its front turned around: it is steered by 190 degrees; a motion ends at 180"),
    ] {
        let run = begin(initial);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert!(run.stderr.starts_with(&format!("note: it begins {beyond}, {as_if}\n")), "{}", run.stderr);
    }
    assert!(!begin("phi=79.9deg").stderr.contains("begins"));
    begin("phi=90 deg")
        .fails(1, "error: benchmark: it lies flat on the ground at a lean of 90 degrees, where no wheel can roll\n");
}

/// A force in the wrong unit turns the front around at once; one beyond numbers is told to be what ends the motion.
#[test]
fn enormous_forces_are_told() {
    let directory = Directory::of_this_test();
    let pushed = |force: &str| simulate(&directory, &["--speed", "5", "--force", force, "--duration", "1"]);
    let run = pushed("delta=1e12");
    let (_, end) = run.stderr.split_once("note: the motion ends at ").expect("an end");
    assert!(end.ends_with("e-6 s: its front turns around: it is steered by 180 degrees\n"), "{end}");
    let row = run.stdout.lines().last().expect("a row");
    assert!(row.trim_start().split(' ').next().is_some_and(|time| end.starts_with(time)), "{row}");
    let run = pushed("delta=1e300");
    assert!(
        run.stderr.contains("accelerations are up to ") && run.stderr.ends_with(": see the forces\n"),
        "{}",
        run.stderr
    );
}

/// The linear equations of the pendulum on wheels do not depend on the speed, but the nonlinear ones roll at it: at rest in
/// balance nothing else happens, and x = v t.
#[test]
fn what_rolls_has_a_speed() {
    let directory = Directory::of_this_test();
    let roll = ["--model", "WheeledPendulum", "--speed", "3", "--duration", "2", "--format", "json"];
    let run = simulate(&directory, &roll);
    assert_eq!(run.stderr, "");
    let json = run.json();
    for row in json["rows"].as_array().expect("rows") {
        assert_near(&row["positions"]["x"], 3.0 * row["t"].as_f64().expect("a time"), 1e-11);
        assert_near(&row["rates"]["thetaL"], -3.0 / 0.04, 1e-12);
    }
    // Its table has no speed of a rear wheel, since it has none.
    let table = simulate(&directory, &roll[..6]).ok();
    assert!(!table.contains("v (m/s)") && table.contains("thetaR'"), "{table}");
    let note = "note: nothing in the model WheeledPendulum depends on the speed: --speed is ignored; what moves forward is x, \
                whose rate is --initial x_rate=…\n";
    assert_eq!(simulate(&directory, &[&roll[..], &["--linear"]].concat()).stderr, note);
}

/// One torque as programs of all kinds write it: with other separators, decimal commas, quotes, and units of the columns.
#[test]
fn force_files_are_read_in_many_forms() {
    let directory = Directory::of_this_test();
    let ride = |text: &str| {
        directory.write("force.csv", text);
        let given = ["--speed", "5", "--force", "delta=force.csv", "--duration", "1", "--format", "csv"];
        let run = simulate(&directory, &given);
        assert_eq!(run.stderr, "", "{text}");
        run.stdout
    };
    let plain = ride("0,0\n0.5,0.25\n1,0\n");
    for text in [
        "Zeit;Moment\n0;0\n0,5;0,25\n1;0\n",
        "0\t0\n0,5\t0,25\n1\t0\n",
        "0 0\n0.5 0.25\n1 0\n",
        "0,0,\n0.5,0.25,\n1,0,\n",
        "\"t\",\"T\"\n\"0\",\"0\"\n\"0.5\",\"0.25\"\n\"1\",\"0\"\n",
        "time (ms),torque (Nm)\r\n0,0\r\n500,0.25\r\n1000,0\r\n",
        "Time [min], torque\n0, 0\n0.5 s, 0.25 N m\n1 s, 0\n",
    ] {
        assert_eq!(ride(text), plain, "{text}");
    }
}

/// What only nonlinear equations know, as the torque of a motor, is drawn without the linear motion.
#[test]
fn pictures_do_without_linear_motions_that_there_are_not() {
    let directory = Directory::of_this_test();
    let ride = ["--model", "WheeledPendulum", "--initial", "thetaL=0.1", "--duration", "0.2", "--plot", "ride.svg"];
    let run = simulate(&directory, &ride);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stderr.contains("note: the picture has no linear motion, which knows no --initial thetaL=0.1\n"));
    let svg = std::fs::read_to_string(directory.0.join("ride.svg")).expect("a picture");
    assert!(!svg.contains("the same by the linear equations"));
}

/// theta'' = -k sin(theta) - d theta' of a pendulum at rest at 0.1 rad, by its linear equations: -9.81*1.988/1.976072*0.1 rad/s^2. Of the
/// benchmark bicycle the table has what JSON has, in degrees.
#[test]
fn a_state_has_its_accelerations_in_the_table() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["simulate", "--model", "Pendulum", "--initial", "theta=0.1", "--duration", "0"]);
    let expected = -(9.81 * 1.988 / 1.976072_f64 * 0.1).to_degrees();
    let last: Vec<&str> = run.stdout.lines().last().unwrap().split_whitespace().collect();
    assert!(run.stdout.contains("theta'' (°/s²)"), "{}", run.stdout);
    assert_eq!(last, ["0", "5.7296", "0.0000", format!("{expected:.4}").as_str()]);
    let bicycle = ["simulate", "--speed", "5", "--initial", "phi=0.1", "--duration", "0"];
    let table = directory.run(&bicycle).ok();
    let json: serde_json::Value =
        serde_json::from_str(&directory.run(&[&bicycle[..], &["--format", "json"]].concat()).stdout).unwrap();
    for (name, factor) in [("phi", 180.0 / std::f64::consts::PI), ("x", 1.0)] {
        let value = json["rows"][0]["accelerations"][name].as_f64().unwrap();
        assert!(table.contains(&format!("{:.4}", factor * value)), "{name}: {value}\n{table}");
    }
    assert!(!directory.run(&["simulate", "--speed", "5", "--duration", "1"]).ok().contains("''"));
}
