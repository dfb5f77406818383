//! Names and units of others: in options, and in the headings of tables.

use super::{Table, sweep, table};
use crate::{Directory, Run};

/// Of the benchmark, of Meijaard et al. (2007), Table 2.
const WEAVE: f64 = 4.292_382_536_341_11;
const CAPSIZE: f64 = 6.024_262_015_388_37;

/// The benchmark in Moore's names, as Moore (2012) and the tests of SymPy have it.
const MOORE: [(&str, f64); 26] = [
    ("rf", 0.35),
    ("rr", 0.3),
    ("d1", 0.953_457_069_612_184_9),
    ("d3", 0.032_071_426_727_619_29),
    ("d2", 0.267_644_508_447_688_7),
    ("l1", 0.470_727_151_513_514_5),
    ("l2", -0.477_928_811_464_607_97),
    ("l4", -0.369_951_820_028_297_4),
    ("l3", -0.005_970_833_924_186_85),
    ("mc", 85.0),
    ("md", 2.0),
    ("me", 4.0),
    ("mf", 3.0),
    ("id11", 0.0603),
    ("id22", 0.12),
    ("if11", 0.1405),
    ("if22", 0.28),
    ("ic11", 7.178_169_776_497_895),
    ("ic22", 11.0),
    ("ic31", 3.822_553_593_835_787_3),
    ("ic33", 4.821_830_223_502_103),
    ("ie11", 0.058_413_377_001_529_72),
    ("ie22", 0.06),
    ("ie31", 0.009_119_225_261_946_298),
    ("ie33", 0.007_586_622_998_470_264),
    ("g", 9.81),
];

#[track_caller]
fn noted(run: Run, note: &str) -> Table {
    assert!(run.stderr.starts_with(&format!("note: {note}\n")), "{}", run.stderr);
    table(run)
}

#[track_caller]
fn is_benchmark(table: &Table, row: usize) {
    for (column, expected) in [("weave_1", WEAVE), ("capsize_1", CAPSIZE)] {
        let found = table.number(row, column).unwrap_or_else(|| panic!("{}", table.text(row, "error")));
        assert!((found - expected).abs() < 2e-13, "{column}: {found}");
    }
}

/// c = (rF sin λ - f)/cos λ, with everything else of the benchmark.
#[test]
fn an_offset_varies_with_the_rest_of_the_geometry() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["sweep", "--vary", "fork_offset=0:60 mm:20 mm"]);
    let offsets = noted(
        run,
        "`fork_offset` varies in the geometry that manufacturers print: `wheelbase`, `head_angle`, \
         `rear_wheel_diameter`, `front_wheel_diameter` and all else of it stay as they are, and `c` follows",
    );
    assert_eq!(offsets.column("fork_offset"), [0.0, 0.02, 0.04, 0.06]);
    let lam = std::f64::consts::PI / 10.0;
    let trails = offsets.column("fork_offset").into_iter().map(|offset| (0.35 * lam.sin() - offset) / lam.cos());
    let trails: Vec<String> = trails.map(|trail| trail.to_string()).collect();
    let expected = sweep(&["--vary", &format!("c={}", trails.join(", "))]);
    for column in ["weave_1", "capsize_1"] {
        for (found, expected) in offsets.column(column).iter().zip(expected.column(column)) {
            assert!((found - expected).abs() < 1e-13, "{column}: {found}, expected {expected}");
        }
    }
}

/// With the fork offset, or with the trail, if that varies, too; wheels by what is printed on them.
#[test]
fn angles_and_wheels_vary_as_they_are_printed() {
    let both = sweep(&["--vary", "head_angle=70 deg, 72 deg", "--vary", "trail=0.08,0.06", "--vary", "mB=85,90"]);
    assert_eq!(both.header[..3], ["head_angle", "trail", "mB"]);
    is_benchmark(&both, 4);
    let plain = sweep(&["--vary", "lam=20 deg, 18 deg", "--vary", "c=0.08,0.06", "--vary", "mB=85,90"]);
    for (found, expected) in both.column("weave_1").iter().zip(plain.column("weave_1")) {
        assert!((found - expected).abs() < 1e-12, "{found}, expected {expected}");
    }
    // ISO 5775: 622 mm and twice 28 mm.
    let sizes = sweep(&["--vary", "wheel=28-622,700x38C"]);
    assert_eq!(sizes.column("wheel_diameter"), [0.678, 0.698]);
}

/// What is set stays, and what follows from it follows: the trail beside another head angle, by whichever name it was set; and of
/// the file, what it has.
#[test]
fn what_is_set_is_held() {
    let directory = Directory::new("what-is-set");
    let expected = sweep(&["--vary", "lam=20 deg, 18 deg", "--set", "c=60 mm"]).column("weave_1");
    let printed = directory.run(&["convert", "benchmark", "--to", "geometry"]).ok();
    let offset = printed.lines().find(|line| line.starts_with("fork_offset")).unwrap();
    directory.write("trail.toml", printed.replace(offset, "trail = '60 mm'"));
    for arguments in [&["--set", "trail=60 mm"][..], &["--set", "c=60 mm"], &["trail.toml"]] {
        let run = directory.run(&[&["sweep", "--vary", "head_angle=70 deg, 72 deg"], arguments].concat());
        let note = "note: `head_angle` varies in the geometry that manufacturers print: `wheelbase`, \
                    `rear_wheel_diameter`, `front_wheel_diameter`, `trail` and all else of it stay as they are, and `lam` \
                    follows\n";
        assert!(run.stderr.contains(note), "{arguments:?}: {}", run.stderr);
        for (found, expected) in table(run).column("weave_1").iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-12, "{arguments:?}: {found}, expected {expected}");
        }
    }
    for (arguments, told) in [
        (["--vary", "d1=0.9, 1", "--set", "mB=90"], "those of the paper follow\n"),
        (["--vary", "d3=0.03, 0.04", "--set", "wheel=28-622"], "those of the paper follow\n"),
    ] {
        let run = directory.run(&[&["sweep"], &arguments[..]].concat());
        assert!(run.code == Some(0) && run.stderr.contains(told), "{arguments:?}: {}", run.stderr);
    }
    let both = ["sweep", "--vary", "d1=0.9, 1", "--vary", "w=1, 1.1"];
    directory.run(&both).fails(2, "error: `w` follows from `d1`, which varies, too; both cannot be held\n");
}

/// By definition the wheel base is w, the trail c, the head angle 90° - λ, and the fork offset rF sin λ - c cos λ; Moore's d1 is
/// (w + c) cos λ - rR sin λ.
#[test]
fn what_is_set_cannot_change() {
    let directory = Directory::new("what-is-set-cannot-change");
    let refused = |arguments: &[&str], set: &str, by: &str| {
        let message = format!(": `{set}` is set, but changes with {by}; leave one of them out\n");
        let run = directory.run(arguments);
        assert!(run.code == Some(2) && run.stderr.ends_with(&message), "{arguments:?}: {}", run.stderr);
    };
    for (set, value, vary, values) in [
        ("wheelbase", "1.1", "w", "1.0:1.1"),
        ("head_angle", "70 deg", "lam", "0.2:0.3"),
        ("trail", "5 cm", "c", "0.05:0.08"),
        ("fork_offset", "45 mm", "c", "0.05:0.08"),
        ("fork_offset", "45 mm", "lam", "0.2:0.3"),
        ("wheel", "28-622", "rF", "0.3:0.4"),
        ("trail", "60 mm", "fork_offset", "0.04:0.05"),
        ("d1", "0.9", "c", "0.05:0.08"),
        ("w", "1.1", "d1", "0.9:1"),
    ] {
        let (setting, range) = (format!("{set}={value}"), format!("{vary}={values}"));
        let by = format!("`{vary}`, which varies");
        let (of_random, grid) = (range.replace(':', ".."), format!("{range}:2 points"));
        refused(&["sweep", "--set", &setting, "--vary", &grid], set, &by);
        refused(&["sweep", "--set", &setting, "--random", &of_random, "--samples", "2"], set, &by);
        refused(&["optimize", "--set", &setting, "--vary", &range, "--minimize", "weave-speed"], set, &by);
        refused(&["analyze", "--set", &setting, "--along", &range, "--speed", "5"], set, &by);
        let [low, high] = values.split_once(':').unwrap().into();
        directory.write("designs.csv", format!("{vary}\n{low}\n{high}\n"));
        refused(&["sweep", "--set", &setting, "--designs", "designs.csv"], set, &by);
    }
    let settings = ["--set", "chainstay=0.43", "--set", "front_center=0.6", "--set", "bb_drop=0.07"];
    refused(&[&["sweep", "--vary", "w=1, 1.1"], &settings[..]].concat(), "chainstay", "`w`, which varies");
    // Neither the wheel base nor the trail depends on the tilt.
    sweep(&["--set", "wheelbase=1.1", "--set", "trail=5 cm", "--vary", "lam=0.2, 0.3"]);
    // A search starts from what is set.
    let run = directory.run(&["optimize", "--set", "w=1.1", "--vary", "w=1:1.2", "--minimize", "weave-speed"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

/// The wheel base by way of the bottom bracket: the legs of two right triangles.
#[test]
fn chainstays_vary_with_the_rest_of_the_frame() {
    let directory = Directory::new("chainstays");
    let (drop, stays) = (0.07_f64, [0.4_f64, 0.45]);
    let w = |front: f64| stays.map(|stay| (stay * stay - drop * drop).sqrt() + front).map(|w| w.to_string()).join(", ");
    // The axle in front is 0.35 m - 0.3 m higher.
    let front = (0.6_f64.powi(2) - (drop + 0.05).powi(2)).sqrt();
    let vary = ["--vary", "chainstay=400 mm, 450 mm"];
    let found = sweep(&[&vary[..], &["--set", "front_center=600 mm", "--set", "bb_drop=70 mm"]].concat());
    let expected = sweep(&["--vary", &format!("w={}", w(front))]);
    for (found, expected) in found.column("weave_1").iter().zip(expected.column("weave_1")) {
        assert!((found - expected).abs() < 1e-12, "{found}, expected {expected}");
    }
    // What is printed beside the wheel base tells how far the front axle is.
    let printed = directory.run(&["convert", "benchmark", "--to", "geometry"]).ok();
    let more = printed.replace("[parameters]\n", "[parameters]\nchainstay = '430 mm'\nbb_drop = '70 mm'\n");
    directory.write("printed.toml", more);
    let expected = sweep(&["--vary", &format!("w={}", w(1.02 - (0.43_f64.powi(2) - drop * drop).sqrt()))]);
    let expected = expected.column("weave_1");
    let run = directory.run(&[&["sweep", "printed.toml"], &vary[..]].concat());
    assert!(
        run.stderr.contains("`front_center`, `bb_drop` and all else of it stay as they are, and `w` follows"),
        "{}",
        run.stderr
    );
    let varied = table(run).column("weave_1");
    let set = directory.run(&["analyze", "printed.toml", "--set", "chainstay=450 mm", "--format", "json"]).stdout;
    let set: serde_json::Value = serde_json::from_str(&set).unwrap();
    let set = set["critical_speeds"].as_array().unwrap().iter().find(|event| event["kind"] == "weave").unwrap();
    for (found, expected) in
        [(varied[0], expected[0]), (varied[1], expected[1]), (set["speed"].as_f64().unwrap(), expected[1])]
    {
        assert!((found - expected).abs() < 1e-12, "{found}, expected {expected}");
    }
    let run = directory.run(&[&["sweep"], &vary[..], &["--set", "front_center=0.6"]].concat());
    let message = "error: benchmark: `bb_drop` must be known beside `chainstay`: give what is missing by --set\n";
    assert!(run.code == Some(2) && run.stderr.ends_with(message), "{}", run.stderr);
    let run = directory.run(&["analyze", "--set", "front_center=0.6", "--speeds", "5"]);
    let note = "`front_center` is set, and `wheelbase` follows from it only with `chainstay`, `bb_drop`\n";
    assert!(run.code == Some(0) && run.stderr.contains(note), "{}", run.stderr);
}

/// One wheel of two that are printed as one size.
#[test]
fn a_wheel_varies_alone() {
    let directory = Directory::new("one-wheel");
    let printed = directory.run(&["convert", "benchmark", "--to", "geometry"]).ok();
    let lines = printed.lines().filter(|line| !line.starts_with("front_wheel"));
    let lines = lines.map(|line| if line.starts_with("rear_wheel") { "wheel = '28-622'" } else { line });
    directory.write("wheels.toml", lines.collect::<Vec<_>>().join("\n"));
    let run = directory.run(&["sweep", "wheels.toml", "--vary", "front_wheel=28-622, 40-622", "--output", "found.csv"]);
    assert!(run.stderr.contains("`rear_wheel_diameter` and all else of it"), "{}", run.stderr);
    let set = directory.run(&["convert", "wheels.toml", "--set", "front_wheel=40-622", "--to", "paper"]).stdout;
    assert!(set.contains("rR = 0.339 ") && set.contains("rF = 0.351 "), "{set}");
    let found = std::fs::read_to_string(directory.0.join("found.csv")).unwrap();
    directory.write("set.toml", set);
    let expected = directory.run(&["analyze", "set.toml", "--format", "json"]).json();
    let weave = found.lines().nth(2).unwrap().split(',').nth(2).unwrap().parse::<f64>().unwrap();
    let events = expected["critical_speeds"].as_array().unwrap();
    assert!(events.iter().any(|event| (event["speed"].as_f64().unwrap() - weave).abs() < 1e-12), "{weave}: {events:?}");
}

/// What is drawn for a parameter depends on nothing that varies beside it, also in another convention.
#[test]
fn samples_are_the_same_beside_other_names() {
    let samples = ["--samples", "5", "--random", "mB=85+-5"];
    let alone = sweep(&samples).column("mB");
    let beside = sweep(&[&samples[..], &["--random", "fork_offset=30 mm..50 mm"]].concat());
    assert_eq!(beside.column("mB"), alone);
    let offsets = beside.column("fork_offset");
    assert!(offsets.iter().all(|offset| (0.03..0.05).contains(offset)), "{offsets:?}");
}

/// A whole set needs nothing of the design: of Moore's names, in SI units or others.
#[test]
fn tables_may_be_in_the_names_of_others() {
    let directory = Directory::of_this_test();
    let names = MOORE.map(|(name, _)| name).join(",") + ",id33,v,bike\n";
    let values = MOORE.map(|(_, value)| value.to_string()).join(",");
    directory.write("moore.csv", format!("{names}{values},0.0603,5,one\n{values},0.07,5,other\n"));
    let set = directory.run(&["sweep", "pista", "--designs", "moore.csv", "--set", "w=2"]);
    set.fails(2, "error: pista: `w` is set, but changes with 26 parameters, which vary; leave one of them out\n");
    let run = directory.run(&["sweep", "pista", "--designs", "moore.csv"]);
    assert!(run.stderr.contains("`v` is copied and changes nothing"), "{}", run.stderr);
    assert!(
        run.stderr.contains("vary as all of the names of Moore (2012); those of the paper follow"),
        "{}",
        run.stderr
    );
    let found = table(run);
    is_benchmark(&found, 0);
    assert_eq!(found.text(0, "bike"), "one");
    assert_eq!(
        found.text(1, "error"),
        "`id33` is 0.07 kg m²; it must be that of `id11`, 0.0603 kg m²: wheels are axisymmetric"
    );
}

/// Names with units, as spreadsheets have them.
#[test]
fn headings_may_have_units() {
    let directory = Directory::of_this_test();
    let offset = 1e3 * (0.35 * (18_f64).to_radians().sin() - 0.08 * (18_f64).to_radians().cos());
    directory.write(
        "printed.csv",
        format!(
            "Name;Head angle (deg);fork_offset [mm];wheelbase / mm;mB_kg;rear wheel diameter_mm;front_wheel_diameter;Stack\n\
             a;72;{offset};1020;85;600;0,7;560\nb;72 deg;{offset} mm;1,02 m;85;0,6 m;700 mm;\nc;180-100;{offset};1020;85;600;0,7;\n"
        ),
    );
    let run = directory.run(&["sweep", "--designs", "printed.csv"]);
    let found = table(run);
    assert_eq!(found.header[..4], ["Name", "head_angle", "fork_offset", "wheelbase"]);
    is_benchmark(&found, 0);
    is_benchmark(&found, 1);
    assert!((found.number(2, "head_angle").unwrap() - 80_f64.to_radians()).abs() < 1e-15);
    // As databases fold names.
    directory.write("folded.csv", "w,c,lam_deg,rr,rf,mb\n1020 mm,80 mm,18,0.3,0.35,85\n");
    is_benchmark(&table(directory.run(&["sweep", "--designs", "folded.csv"])), 0);
    for (heading, message) in [
        ("w [kg]", "column `w [kg]` has the unit `kg`; `w` is in m"),
        ("nothing_m", "column `nothing_m` is not a parameter of Whipple"),
        ("d1,d2,fork_offset", "column `fork_offset` is a name of"),
        ("w,w_mm", "columns `w` and `w_mm` are the same parameter"),
        ("wheelbase,w", "columns `wheelbase` and `w` are the same parameter"),
        ("c,head_angle,trail", "columns `c` and `trail` are the same parameter"),
        ("head_angle [deg],lam", "error: wrong.csv: both `head_angle` and `lam` are given; one follows from the other"),
        ("rear_wheel_diameter,rR", "error: wrong.csv: the rear wheel is given twice"),
    ] {
        directory.write("wrong.csv", format!("{heading}\n1,1,1\n"));
        let run = directory.run(&["sweep", "--designs", "wrong.csv"]);
        assert!(run.code == Some(2) && run.stderr.contains(message), "{heading}: {}", run.stderr);
    }
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let directory = Directory::of_this_test();
    let fails = |arguments: &[&str], message: &str| {
        directory.run(&[&["sweep"], arguments].concat()).fails(2, &format!("error: {message}\n"));
    };
    fails(
        &["--vary", "fork_ofset=0,1"],
        "--vary fork_ofset=0,1: `fork_ofset` is not a parameter of Whipple; did you mean `fork_offset`?",
    );
    fails(
        &["--vary", "lam=0.3,0.4", "--vary", "head_angle=1.2,1.3"],
        "--vary head_angle=1.2,1.3: `head_angle` stands in the place of `lam`, which varies, too, at --vary lam=0.3,0.4",
    );
    fails(
        &["--vary", "fork_offset=0.04,0.05", "--vary", "rake=0.03,0.04"],
        "--vary rake=0.03,0.04: `rake` is given twice; first as `fork_offset` at --vary fork_offset=0.04,0.05",
    );
    fails(
        &["--vary", "fork_offset=0.03,0.04", "--random", "measured", "--samples", "3"],
        "--random measured: what was measured are parameters of the paper, which would replace what follows from the \
         geometry that manufacturers print: beside it only the paper's can vary",
    );
    // With everything else held there is one head angle; 0.1 % less of 72 degrees is 71.928.
    let message = "`htangle` cannot vary by itself in the names of PyDy's bicycle: `htangle` is 71.9280 deg, but 72.0000 deg with \
                   framelength, forklength and forkoffset";
    fails(&["--vary", "htangle=1.2,1.3"], message);
    let optimize = ["optimize", "--vary", "htangle=1.2:1.3", "--minimize", "weave-speed"];
    directory.run(&optimize).fails(2, &format!("error: {message}\n"));
    let run = directory.run(&["sweep", "--vary", "head_angle=1,4"]);
    assert_eq!(table(run).text(1, "error"), "`head_angle` is 4 rad; it must be > 0 and < 3.141592653589793");
}
