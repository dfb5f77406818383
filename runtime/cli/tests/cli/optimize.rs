//! The best design within ranges: `carvallo optimize`, held against brute force: `carvallo sweep` over grids of the same ranges.

use std::collections::HashMap;

use serde_json::Value;

use crate::Directory;

fn optimum(arguments: &[&str]) -> Value {
    let run = Directory::of_this_test().run(&[&["optimize", "--format", "json"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// A row of a sweep: the cells that are numbers, by the names of their columns.
type Row = HashMap<String, f64>;

fn sweep(arguments: &[&str]) -> Vec<Row> {
    let directory = Directory::of_this_test();
    let run = directory.run(&[&["sweep", "--output", "grid.csv"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let text = std::fs::read_to_string(directory.0.join("grid.csv")).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells = names.iter().zip(line.split(','));
        cells.filter_map(|(name, cell)| Some(((*name).to_owned(), cell.parse().ok()?))).collect()
    };
    lines.map(row).collect()
}

/// The stable width between 0 and `high` m/s.
fn width(row: &Row, high: f64) -> Option<f64> {
    let ranges = (1..=6).filter_map(|index| {
        let from = row.get(&format!("stable_from_{index}"))?;
        Some(row.get(&format!("stable_to_{index}")).copied().unwrap_or(high).min(high) - from)
    });
    ranges.filter(|width| *width > 0.0).reduce(f64::max)
}

#[test]
fn the_least_weave_speed_is_below_that_of_every_design_of_a_grid() {
    let found = optimum(&["--vary", "lam=10 deg:30 deg", "--vary", "c=0.02:0.12", "--minimize", "weave-speed"]);
    let best = number(&found["goal"]["after"]);
    // At a coarse grid, and at a fine one around the optimum.
    let coarse = sweep(&["--vary", "lam=10 deg:30 deg:0.1 deg", "--vary", "c=0.02:0.12:0.005"]);
    let degrees = number(&found["parameters"]["lam"]).to_degrees();
    let lam = format!("lam={:.3} deg:{:.3} deg:0.002 deg", degrees - 0.1, degrees + 0.1);
    let fine = sweep(&["--vary", &lam, "--vary", "c=0.02:0.021:0.0005"]);
    let least = |rows: &[Row]| rows.iter().filter_map(|row| row.get("weave_1")).copied().fold(f64::INFINITY, f64::min);
    let (coarse, fine) = (least(&coarse), least(&fine));
    assert!(best <= fine && fine <= coarse, "{best}, {fine}, {coarse}");
    assert!(fine - best < 1e-7 && coarse - best < 1e-3, "{best}, {fine}, {coarse}");
    assert_eq!(found["varied"]["c"]["at"], "low");
    assert_eq!(number(&found["varied"]["c"]["after"]), 0.02);
    assert!(found["varied"]["lam"]["at"].is_null());
}

/// Where the upper end of the stable range passes the highest speed that counts, the width has a kink, and the best design lies
/// in it.
#[test]
fn the_widest_stable_range_is_wider_than_that_of_every_design_of_a_grid() {
    let vary = ["--vary", "w=0.9:1.2", "--vary", "c=0:0.15", "--vary", "xH=0.7:1.1"];
    let found = optimum(&[&["pista", "--maximize", "stable-range", "--speeds", "0:10"], &vary[..]].concat());
    let best = number(&found["goal"]["after"]);
    let grid = sweep(&["pista", "--vary", "w=0.9:1.2:0.05", "--vary", "c=0:0.15:0.01", "--vary", "xH=0.7:1.1:0.004"]);
    let widest = grid.iter().filter_map(|row| width(row, 10.0)).fold(0.0, f64::max);
    assert!(best >= widest && best - widest < 0.02, "{best}, {widest}");
}

#[test]
fn what_must_be_kept_is_kept_exactly() {
    let vary = ["--vary", "w=0.6:1.3", "--vary", "lam=10 deg:30 deg", "--vary", "c=0.01:0.1"];
    let keep = ["--keep", "stable_range >= 1.5", "--keep", "rR + rF <= 0.7*w", "--keep", "c >= 1.5 cm"];
    let found = optimum(&[&["pista", "--minimize", "w"], &vary[..], &keep[..]].concat());
    let [w, c, rear, front] = ["w", "c", "rR", "rF"].map(|name| number(&found["parameters"][name]));
    let [from, to] = [0, 1].map(|end| number(&found["stable_ranges"][0][end]));
    assert!(rear + front <= 0.7 * w && c >= 0.015 && to - from >= 1.5, "{found}");
    // One of them leaves no room, or else the wheel base would be less.
    let tight = found["constraints"].as_array().unwrap().iter().filter(|kept| kept["tight"] == true);
    assert!(tight.count() >= 1, "{found}");
    let expected = (rear + front) / 0.7;
    assert!((w - expected).abs() < 1e-6 * expected, "{w} for {expected}");
    // What pista's own zB of -0.477 m violates, which does not vary.
    let arguments = [&["optimize", "pista", "--minimize", "w"], &vary[..], &["--keep", "zB <= -0.5"]].concat();
    let message = "error: pista: no design within these ranges was found that keeps what must be kept: none of those that were \
                   tried keeps `zB <= -0.5`\n";
    Directory::of_this_test().run(&arguments).fails(1, message);
}

#[test]
fn wheels_stay_apart_unasked() {
    let found = optimum(&["--vary", "w=0.5:1.2", "--minimize", "w", "--keep", "rR >= 0"]);
    let wheel_base = number(&found["parameters"]["w"]);
    // 0.3 + 0.35 + 0.02 m
    assert!((0.67..0.670_001).contains(&wheel_base), "{wheel_base}");
    assert_eq!(found["constraints"][0]["tight"], true);
    assert_eq!(found["constraints"][1]["tight"], false);
}

#[test]
fn bodies_stay_rigid_unasked() {
    // IHxx + IHzz = 0.066 kg m² and IHyy = 0.06: IHxx alone can shrink as far as that.
    let found = optimum(&["--vary", "IHxx=0.01:0.1", "--minimize", "IHxx"]);
    let [xx, zz, xz] = ["IHxx", "IHzz", "IHxz"].map(|name| number(&found["parameters"][name]));
    let radius = ((xx - zz) / 2.0).hypot(xz);
    let (small, large, middle) = ((xx + zz) / 2.0 - radius, (xx + zz) / 2.0 + radius, 0.06);
    assert!(small >= 0.0 && middle <= small + large && large <= small + middle, "{xx}");
    assert!((middle - (small + large)).abs() < 1e-6 * middle, "{xx}");
}

/// Only a thousandth of the range has a stable one, which none of the designs that are tried at first is in. It widens up to the
/// end of the range, where `analyze` tells it.
#[test]
fn a_design_that_is_stable_nowhere_is_made_stable_first() {
    let found = optimum(&["--set", "xH=0.5", "--vary", "xH=-60:0.855", "--maximize", "stable-range"]);
    assert!(found["goal"]["before"].is_null());
    assert_eq!(found["varied"]["xH"]["at"], "high");
    let analysis = Directory::of_this_test().run(&["analyze", "--set", "xH=0.855", "--format", "json"]).json();
    let [from, to] = [0, 1].map(|end| number(&analysis["stable_ranges"][0][end]));
    assert_eq!(number(&found["goal"]["after"]), to - from);
    let nowhere = ["optimize", "--set", "xH=0.5", "--vary", "xH=-3:0.5", "--maximize", "stable-range"];
    let run = Directory::of_this_test().run(&nowhere);
    assert_eq!(run.code, Some(1));
    assert!(run.stderr.contains("no design within these ranges was found that has a stable range; "), "{}", run.stderr);
}

#[test]
fn the_same_seed_finds_the_same_design_and_the_file_reads_back() {
    let directory = Directory::of_this_test();
    let arguments = ["optimize", "pista", "--vary", "c=0.01:0.1", "--vary", "xH=0.8:1", "--minimize", "weave-speed"];
    let first = directory.run(&[&arguments[..], &["--format", "json", "--seed", "7"]].concat()).ok();
    let second = directory.run(&[&arguments[..], &["--format", "json", "--seed", "7"]].concat()).ok();
    assert_eq!(first, second);
    let files = ["--seed", "7", "--output", "best.toml", "--plot", "both.svg"];
    let run = directory.run(&[&arguments[..], &files].concat());
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: best.toml\nwrote: both.svg\n"));
    directory.write("best.json", &first);
    let of = |file: &str| directory.run(&["analyze", file, "--format", "json"]).json()["critical_speeds"].clone();
    let found: Value = serde_json::from_str(&first).unwrap();
    assert_eq!(of("best.toml"), found["critical_speeds"]);
    assert_eq!(of("best.json"), found["critical_speeds"]);
}

/// Flutter of the shipped wing: the sheerest rise of its speed is at an end of the range, as `sensitivity` has it.
#[test]
fn other_models_have_their_speeds() {
    let found = optimum(&["--model", "CarTrailer", "caravan", "--vary", "mT=800:1500", "--maximize", "flutter-speed"]);
    assert_eq!(number(&found["parameters"]["mT"]), 800.0, "{found}");
    assert_eq!(found["varied"]["mT"]["at"], "low");
}

/// The same ranges by other names have the same optimum: those of the printed geometry, where the tilt is 90 degrees less the head
/// angle, and what is set is held.
#[test]
fn parameters_may_be_those_of_others() {
    let own = optimum(&["--vary", "lam=10 deg:30 deg", "--vary", "c=0.02:0.12", "--minimize", "weave-speed"]);
    let printed =
        optimum(&["--vary", "head_angle=60 deg:80 deg", "--vary", "trail=2 cm:12 cm", "--minimize", "weave-speed"]);
    let after = |found: &Value| number(&found["goal"]["after"]);
    assert!((after(&own) - after(&printed)).abs() < 1e-10, "{own}, {printed}");
    let [lam, head] = [&own["varied"]["lam"], &printed["varied"]["head_angle"]].map(|varied| number(&varied["after"]));
    assert!((lam + head - std::f64::consts::FRAC_PI_2).abs() < 1e-4, "{lam}, {head}");
    assert_eq!(number(&printed["varied"]["trail"]["after"]), 0.02);
    assert_eq!(printed["varied"]["trail"]["at"], "low");
    assert!((number(&printed["varied"]["head_angle"]["before"]) - 72_f64.to_radians()).abs() < 1e-15);
    let own = optimum(&["--set", "c=6 cm", "--vary", "lam=10 deg:30 deg", "--minimize", "weave-speed"]);
    let printed = optimum(&["--set", "trail=6 cm", "--vary", "head_angle=60 deg:80 deg", "--minimize", "weave-speed"]);
    assert!((after(&own) - after(&printed)).abs() < 1e-10, "{own}, {printed}");
    // A goal and what is kept may be by other names, too.
    let vary = ["--vary", "head_angle=65 deg:80 deg", "--vary", "fork_offset=0:8 cm"];
    let keep = ["--keep", "weave-speed <= 4", "--keep", "c >= 3 cm"];
    let found = optimum(&[&vary[..], &keep[..], &["--maximize", "trail"]].concat());
    let [c, lam] = ["c", "lam"].map(|name| number(&found["parameters"][name]));
    assert!(after(&found) == c && number(&found["critical_speeds"][1]["speed"]) <= 4.0, "{found}");
    let offset = number(&found["varied"]["fork_offset"]["after"]);
    assert!((c - (0.35 * lam.sin() - offset) / lam.cos()).abs() < 1e-15, "{found}");
}

/// Against the grid of the same ranges.
#[test]
fn moores_names_have_their_optimum() {
    let found = optimum(&["pista", "--vary", "d1=0.85:1", "--vary", "d3=0.01:0.06", "--minimize", "weave-speed"]);
    let grid = sweep(&["pista", "--vary", "d1=0.85:1:0.0025", "--vary", "d3=0.01:0.06:0.001"]);
    let best = number(&found["goal"]["after"]);
    let least = grid.iter().filter_map(|row| row.get("weave_1")).copied().fold(f64::INFINITY, f64::min);
    assert!(best <= least && least - best < 1e-3, "{best}, {least}");
}

/// At an end of the only range the stable range is widest, as a fine sweep says; no search may end before it.
#[test]
fn searches_come_to_an_end_of_a_range() {
    let rows = sweep(&["--vary", "w=0.9:1.2:0.005"]);
    let widest = rows.iter().filter_map(|row| width(row, 20.0)).fold(0.0, f64::max);
    for starts in ["1", "8"] {
        let found = optimum(&["--vary", "w=0.9:1.2", "--maximize", "stable-range", "--starts", starts]);
        assert!((number(&found["goal"]["after"]) - widest).abs() < 1e-12, "{}", found["goal"]);
        assert_eq!(found["search"]["agreeing"].to_string(), starts, "{}", found["search"]);
    }
}

/// A chain stay that is too short to reach the axle.
#[test]
fn ranges_without_any_design_are_told() {
    let directory = Directory::of_this_test();
    let set = ["--set", "bb_drop=0.07", "--set", "front_center=0.6", "--vary", "chainstay=0.01:0.06"];
    let run = directory.run(&[&["optimize"], &set[..], &["--minimize", "weave-speed"]].concat());
    assert_eq!(run.code, Some(1), "{}", run.stderr);
    let told = "none of the designs within these ranges that were tried can be built";
    assert!(run.stderr.contains(told), "{}", run.stderr);
}

/// What is set of what varies is where the search begins, by any of its names: the wheel base is w.
#[test]
fn it_begins_at_what_is_set() {
    for vary in ["w=0.9:1.2", "wheelbase=0.9:1.2"] {
        let found = optimum(&["--vary", vary, "--set", "w=1.05", "--minimize", "weave-speed", "--starts", "1"]);
        assert_eq!(number(&found["varied"][vary.split_once("=").unwrap().0]["before"]), 1.05, "{found}");
    }
}

#[test]
fn mistakes_are_told() {
    let directory = Directory::of_this_test();
    let fails = |arguments: &[&str], code: i32, message: &str| {
        directory.run(&[&["optimize"], arguments].concat()).fails(code, message);
    };
    let goal = ["--minimize", "weave-speed"];
    fails(
        &[&["--vary", "w=1.2:0.9"], &goal[..]].concat(),
        2,
        "error: --vary w=1.2:0.9: the range is from 1.2 m to 0.9 m; it must ascend\n",
    );
    // Degrees, that is.
    fails(
        &[&["--vary", "head_angle=60:80"], &goal[..]].concat(),
        2,
        "error: --vary head_angle=60:80: `head_angle` is 60 rad; it must be > 0 and < 3.141592653589793 (for degrees write \
         `60 deg`)\n",
    );
    fails(
        &[&["--vary", "w=0.9"], &goal[..]].concat(),
        2,
        "error: --vary w=0.9: expected NAME=LOW:HIGH, such as w=0.9:1.2\n",
    );
    fails(
        &[&["--vary", "w=0.9:1", "--vary", "w=0.9:1.1"], &goal[..]].concat(),
        2,
        "error: --vary w=0.9:1.1: `w` has a range already\n",
    );
    fails(
        &[&["--vary", "fork_offset=0:0.1", "--vary", "trail=0:0.1"], &goal[..]].concat(),
        2,
        "error: --vary trail=0:0.1: `trail` stands in the place of `fork_offset`, which has a range, too\n",
    );
    fails(
        &[&["--vary", "fork_offset=0:0.1", "--vary", "d1=0.9:1"], &goal[..]].concat(),
        2,
        "error: 2 problems\n\
         --vary fork_offset=0:0.1: `fork_offset` is a name of pydy (the names of PyDy's bicycle) and geometry (the geometry that \
         manufacturers print), and `d1` of others; all must be of one convention\n\
         --vary d1=0.9:1: `d1` is a name of moore (the names of Moore (2012)), and `fork_offset` of others; all must be of one \
         convention\n",
    );
    fails(
        &[&["--vary", "w=0.9:1", "--keep", "xB"], &goal[..]].concat(),
        2,
        "error: --keep 'xB': expected an inequality, such as xB >= 0.2 or rR + rF <= 0.8*w\n",
    );
    fails(
        &[&["--vary", "w=0.9:1", "--keep", "xQ >= 1"], &goal[..]].concat(),
        2,
        "error: --keep 'xQ >= 1': `xQ` is no value: `xQ` is not a parameter of Whipple\n",
    );
    fails(
        &[&["--vary", "w=0.9:1", "--keep", "xB >= 1 kg"], &goal[..]].concat(),
        2,
        "error: --keep 'xB >= 1 kg': `1 kg` is no value: `kg` is no unit for it\n",
    );
    fails(
        &[&["--vary", "c=0:0.1", "--vary", "trail=0:0.1"], &goal[..]].concat(),
        2,
        "error: --vary trail=0:0.1: `trail` is `c`, which has a range already\n",
    );
    fails(
        &[&["--vary", "w=0.9:1", "--output", "best.json"], &goal[..]].concat(),
        2,
        "error: --output best.json: the name must end in .toml\n",
    );
    assert!(!directory.0.join("best.json").exists());
    fails(&["--vary", "c=0:0.1", "--minimize", "mB"], 2, "error: `mB` does not change with `c`\n");
    fails(&["--vary", "w=0.9:1", "--minimize", "trail"], 2, "error: `trail` does not change with `w`\n");
    fails(
        &["--vary", "w=0.9:1", "--maximize", "range"],
        2,
        "error: --maximize range: `range` is not a parameter of Whipple; expected a parameter, or one of stable-range, \
         weave-speed, capsize-speed, divergence-speed, flutter-speed, wobble-speed\n",
    );
}

/// A search that cannot begin at the design begins at the nearest end of the range, and says so.
#[test]
fn a_start_beyond_the_range_is_told() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["optimize", "--vary", "c=100 mm:200 mm", "--minimize", "c", "--starts", "1"]);
    let note = "note: benchmark: `c` is 0.08 m, beyond its range, of which the search begins at 0.1 m\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), note));
}
