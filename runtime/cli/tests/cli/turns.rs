//! Steady turns.

use serde_json::Value;

use crate::Directory;

/// Two circles of the benchmark bicycle, at 25 digits from other equations (`tests/data/steady_turns.tsv` of the workspace):
/// steer in degrees, lean, speed, yaw rate, rear wheel rate, and the largest real part.
const CIRCLES: [(f64, [f64; 5]); 2] = [
    (5.0, [0.2758296945538076, 5.773782597691651, 0.4894767466690726, -19.245941992305504, 0.14339864799498742]),
    (20.0, [0.3759656131188581, 3.49206134869491, 1.270909520372591, -11.6402044956497, 1.6947265140955892]),
];

#[test]
fn circles_at_given_steers_are_those_of_other_equations() {
    let directory = Directory::of_this_test();
    let json = directory.run(&["turns", "--steer", "5 deg, 20 deg", "--format", "json"]).json();
    let family = &json["families"][0];
    assert_eq!(
        (json["bicycle"].as_str(), family["end"].as_str()),
        (Some("benchmark"), Some("at rest, in an equilibrium"))
    );
    let turns = family["turns"].as_array().expect("turns");
    assert_eq!(turns.len(), 2);
    for (turn, (steer, [lean, speed, yaw_rate, wheel, growth])) in turns.iter().zip(CIRCLES) {
        let number = |value: &Value| value.as_f64().expect("a number");
        let real_parts = turn["eigenvalues"].as_array().expect("eigenvalues").iter().map(|value| number(&value["re"]));
        for (found, expected, bound) in [
            (number(&turn["positions"]["delta"]), steer.to_radians(), 1e-15),
            (number(&turn["positions"]["phi"]), lean, 1e-11),
            (number(&turn["speed"]), speed, 1e-11),
            (number(&turn["rates"]["psi"]), yaw_rate, 1e-11),
            (number(&turn["rates"]["thetaR"]), wheel, 1e-10),
            (number(&turn["radius"]), speed / yaw_rate, 1e-11),
            (real_parts.fold(f64::NEG_INFINITY, f64::max), growth, 1e-8),
        ] {
            assert!((found - expected).abs() <= bound, "{steer}: {found} is not {expected}");
        }
        assert_eq!(turn["verdict"], "unstable");
    }
}

#[test]
fn the_curve_goes_from_the_capsize_speed_to_rest() {
    let directory = Directory::of_this_test();
    let text = directory.run(&["turns"]).ok();
    assert!(text.contains("from the capsize speed of 6.02426201538835"), "{text}");
    let (first, others) = text.split_once("end of the curve: at rest, in an equilibrium\n").expect("an end");
    assert!(first.contains("straight") && others.matches("that begin at no capsize speed").count() == 2, "{text}");
    let csv = directory.run(&["turns", "--format", "csv"]).ok();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let (rows, others): (Vec<_>, Vec<_>) = rows.into_iter().partition(|row| !row[0].is_empty());
    assert!(others.iter().any(|row| row[row.len() - 1] == "stable"));
    assert_eq!(rows[0][..5], ["capsize_speed (m/s)", "speed (m/s)", "radius (m)", "phi (rad)", "delta (rad)"]);
    // Straight running has no radius.
    assert_eq!((rows[1][2], rows[1][rows[1].len() - 1]), ("", "marginal"));
    let last: f64 = rows[rows.len() - 1][4].parse().expect("a steer");
    assert!((last - 1.339_739_91).abs() < 1e-8, "{last}");
}

/// Deviations grow by exp(0.58 t) there, which is not much of rounding in 2 s.
#[test]
fn a_simulation_that_begins_in_a_circle_stays_there() {
    let directory = Directory::of_this_test();
    let json = directory.run(&["turns", "--steer", "10 deg", "--format", "json"]).json();
    let turn = &json["families"][0]["turns"][0];
    let [lean, steer, speed] =
        [&turn["positions"]["phi"], &turn["positions"]["delta"], &turn["speed"]].map(Value::to_string);
    let (lean, steer) = (format!("phi={lean}"), format!("delta={steer}"));
    let ride =
        ["simulate", "--speed", &speed, "--initial", &lean, "--initial", &steer, "--duration", "2", "--format", "json"];
    let json = directory.run(&ride).json();
    for row in json["rows"].as_array().expect("rows") {
        for (name, bound) in [("phi", 1e-9), ("delta", 1e-9)] {
            let found = row["positions"][name].as_f64().expect("a number");
            let expected = turn["positions"][name].as_f64().expect("a number");
            assert!((found - expected).abs() < bound, "{name} {found} is not {expected}");
        }
    }
}

#[test]
fn turns_are_drawn_and_mistakes_told() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["turns", "--plot", "turns.svg", "--output", "turns.txt"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: turns.svg\nwrote: turns.txt\n"));
    let svg = std::fs::read_to_string(directory.0.join("turns.svg")).expect("a picture");
    assert!(svg.contains("radius (m)") && svg.contains("steer delta") && !svg.contains("NaN"));
    // All of its turns are unstable, and so are the lines beside the names; the radius ends below infinity.
    assert!(svg.contains("radius, up to 8 m: it goes on to straight running"));
    directory.run(&["turns", "--steer", "5 kg"]).fails(
        2,
        "error: --steer 5 kg: `5 kg`: `kg` is no unit for an angle: it is in rad, or in degrees as `5 deg`\n",
    );
    directory
        .run(&["turns", "--model", "Pendulum"])
        .fails(1, "error: Pendulum seconds: there is no capsize speed, at which steady turns begin\n");
}

/// Without steer a bicycle runs straight: at the beginning of the curve, and at any other speed too.
#[test]
fn no_steer_is_straight_running() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["turns", "--steer", "0"]);
    assert_eq!(run.code, Some(0));
    assert!(run.stdout.contains("6.0243    straight        0.0000"), "{}", run.stdout);
    assert!(run.stderr.starts_with("note: with no steer it runs straight, at any speed; "), "{}", run.stderr);
    let csv = directory.run(&["turns", "--steer", "5 deg, 0", "--format", "csv"]);
    // Behind the header one at each, and at 5 degrees one of another curve.
    assert_eq!(csv.stdout.lines().count(), 4);
}

/// With a torque that follows the lean the circles go on through pivoting about the rear wheel, where there is a yaw rate and no speed: one
/// curve, with that of each steer once, and in few steps. At rest it ends where the front wheel stands as without the law, which is zero
/// without a lean.
#[test]
fn a_curve_of_a_closed_loop_goes_through_a_pivot_once() {
    let directory = Directory::of_this_test();
    let json = directory.run(&["turns", "--feedback", "Tdelta=10*phi", "--format", "json"]).json();
    let [family] = &json["families"].as_array().expect("families")[..] else { panic!("{json}") };
    let turns = family["turns"].as_array().expect("turns");
    let of = |turn: &serde_json::Value, member: &str, name: &str| turn[member][name].as_f64().expect("a number");
    let speeds: Vec<f64> = turns.iter().map(|turn| -0.3 * of(turn, "rates", "thetaR")).collect();
    assert!(speeds.windows(2).any(|pair| pair[0] * pair[1] < 0.0) && turns.len() < 500, "{}", turns.len());
    let steer = of(&turns[turns.len() - 1], "positions", "delta");
    assert!((steer - 1.339_739_91).abs() < 1e-8, "{steer}");
}
