//! Designs beside each other: `carvallo compare`.

use serde_json::Value;

use crate::Directory;

/// Contributions to the differences of pista from the benchmark, of the weave and the capsize speed in m/s, as
/// `tests/references/contributions.py` computes them with 40 digits.
const CONTRIBUTIONS: [(&str, f64, f64); 23] = [
    ("w", 0.0653052871937495, 0.226963591992093),
    ("c", -0.101601254807518, -0.503718263326512),
    ("lam", -0.22719236617034, -0.222307697482672),
    ("rR", -0.00385160548366253, -0.0489377030190702),
    ("mR", -0.0266026206981386, 0.0105040550356629),
    ("IRxx", 0.00134261376187143, 0.0),
    ("IRyy", -0.0352054659555379, -0.228612516770214),
    ("xB", -0.0406442595601245, 0.496924501638521),
    ("zB", -0.205581248025818, 0.326002642349677),
    ("mB", -3.01594392603725, -2.97862019203859),
    ("IBxx", 2.07304969934355, 0.0),
    ("IBzz", 0.0815798612708469, 0.0),
    ("IBxz", -0.484703701527716, 0.0),
    ("xH", 0.0200107778471774, 0.0516654714753132),
    ("zH", 0.0555318629874449, 0.0698548839162508),
    ("mH", -0.10495575263362, -0.457836111579921),
    ("IHxx", 0.0523790230521698, 0.0),
    ("IHzz", 0.164294584375809, 0.0),
    ("IHxz", 0.0221246874895689, 0.0),
    ("rF", -0.0862649501242803, -0.180612846760072),
    ("mF", 0.102621274166358, -0.359805155516523),
    ("IFxx", -0.544220711828889, 0.0),
    ("IFyy", 1.6204639200693, 3.23952226430997),
];

fn compare(arguments: &[&str]) -> Value {
    let run = Directory::of_this_test().run(&[&["compare", "--format", "json"], arguments].concat());
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    serde_json::from_str(&run.stdout).unwrap()
}

/// How the critical speeds of the second design come from those of the first.
fn ways(comparison: &Value) -> &Vec<Value> {
    comparison["differences"][0]["critical_speeds"].as_array().unwrap()
}

#[test]
fn contributions_are_those_of_a_computation_with_forty_digits() {
    let comparison = compare(&["benchmark", "pista"]);
    let [weave, capsize] = &ways(&comparison)[..] else { panic!("two critical speeds: {comparison}") };
    for (parameter, of_weave, of_capsize) in CONTRIBUTIONS {
        for (found, expected) in [(weave, of_weave), (capsize, of_capsize)] {
            let found = found["contributions"][parameter].as_f64().unwrap();
            assert!((found - expected).abs() < 1e-12, "{parameter}: {found} for {expected}");
        }
    }
}

/// Between shipped bicycles, and of models of other sizes: the sum is the difference of what `analyze` finds.
#[test]
fn contributions_sum_to_the_difference() {
    let cases: [&[&str]; 5] = [
        &["browser", "browser-jason"],
        &["fisher", "crescendo"],
        &["silver", "rigid:lam=20 deg,c=5 cm"],
        &["--model", "Motorcycle", "standard", "standard:sigma=0.2,Rf=0.32"],
        &["--model", "CarTrailer", "caravan", "loaded_behind"],
    ];
    for arguments in cases {
        let comparison = compare(arguments);
        let mut count = 0;
        for way in ways(&comparison).iter().filter(|way| way["contributions"].is_object()) {
            let speed = |end: &str| way[end].as_f64().unwrap();
            let of = |design: usize| comparison["designs"][design]["critical_speeds"].as_array().unwrap();
            let is_there = |design: usize, end: &str| of(design).iter().any(|critical| critical["speed"] == way[end]);
            assert!(is_there(0, "from") && is_there(1, "to"), "{arguments:?}: {way}");
            let terms = way["contributions"].as_object().unwrap().values();
            let sum: f64 = terms.map(|term| term.as_f64().unwrap()).sum();
            let difference = speed("to") - speed("from");
            assert!((sum - difference).abs() < 1e-11 * speed("from"), "{arguments:?}: {sum} for {difference}");
            count += 1;
        }
        assert!(count > 0, "{arguments:?}: {comparison}");
    }
}

/// Where det K0 is zero the capsize speed is; where K0_11 K2_22 = K0_21 K2_12 it is infinite: both places by mpmath's roots of
/// the formulas in `tests/references/contributions.py`.
#[test]
fn critical_speeds_vanish_where_formulas_say() {
    let lost = |design: &str| {
        let comparison = compare(&["benchmark", design]);
        let way = ways(&comparison).iter().find(|way| way["kind"] == "capsize").unwrap().clone();
        assert!(way["to"].is_null() && way["contributions"].is_null(), "{way}");
        (way["vanishes"]["place"].as_f64().unwrap(), way["vanishes"]["reason"].as_str().unwrap().to_owned())
    };
    let (place, reason) = lost("benchmark:c=-0.2");
    assert!((place - 0.397961580322403).abs() < 1e-8 && reason == "it is at rest", "{place}: {reason}");
    let (place, reason) = lost("benchmark:mF=0.01,IFyy=0.001");
    assert!((place - 0.952285269077033).abs() < 1e-5 && reason == "it is beyond all bounds", "{place}: {reason}");
}

#[test]
fn tables_say_what_differs() {
    let text = Directory::of_this_test().run(&["compare", "benchmark", "benchmark:lam=20 deg,c=5cm"]).ok();
    for line in [
        "benchmark, benchmark:lam=20 deg,c=5cm",
        "  c m 0.08 0.05",
        "  the same in all: w, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IByy, IBzz, IBxz, xH, zH, mH, IHxx, IHyy, IHzz, IHxz, rF, mF, IFxx, IFyy",
    ] {
        let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert!(text.lines().any(|found| words(found) == words(line)), "{line}\n{text}");
    }
    let all = Directory::of_this_test().run(&["compare", "--all", "benchmark", "benchmark"]).ok();
    assert!(all.contains("IHyy") && all.contains("there is no difference to explain"), "{all}");
    let other = Directory::of_this_test().run(&["compare", "benchmark", "pista", "--set", "g=1"]).ok();
    assert!(other.contains("the same in all: g"), "{other}");
}

/// Nothing leads from the parameters of one model to those of another; the rest is compared.
#[test]
fn designs_of_different_models_are_compared_without_a_path() {
    let directory = Directory::of_this_test();
    let sprung = directory.run(&["show", "--model", "WhippleSprung"]).ok();
    directory.write("sprung.toml", sprung);
    let text = directory.run(&["compare", "benchmark", "sprung.toml"]).ok();
    assert!(text.contains("the models are Whipple and WhippleSprung, so that no parameters lead"), "{text}");
    assert!(text.contains("not in all: "), "{text}");
}

#[test]
fn csv_has_a_row_for_each_contribution() {
    let csv = Directory::of_this_test().run(&["compare", "benchmark", "benchmark:c=0.07", "--format", "csv"]).ok();
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 3, "{csv}");
    let capsize = &lines[2];
    assert_eq!(capsize[2..3], ["capsize"]);
    let number = |column: usize| capsize[column].parse::<f64>().unwrap();
    assert!((number(9) - (number(4) - number(3))).abs() < 1e-12, "{csv}");
}

#[test]
fn pictures_show_all_designs() {
    let directory = Directory::of_this_test();
    let files = ["both.svg", "views.svg", "difference.svg"];
    let arguments =
        ["compare", "benchmark", "pista", "--plot", files[0], "--side-view", files[1], "--contributions", files[2]];
    assert_eq!(directory.run(&arguments).code, Some(0));
    let [both, views, difference] = files.map(|file| std::fs::read_to_string(directory.0.join(file)).unwrap());
    for (svg, texts) in [
        (both, ["Eigenvalues of benchmark, pista", "stable 4.29 to 6.02 m/s", "stable 3.67 to 5.47 m/s"]),
        (
            views,
            ["benchmark, pista: side views to one scale", "pista: wheel base 0.989 m", "benchmark: wheel base 1.020 m"],
        ),
        (
            difference,
            [
                "What makes the difference of pista from benchmark",
                "85 to 4.49 kg",
                "weave speed, from 4.2924 to 3.6743 m/s",
            ],
        ),
    ] {
        for text in texts {
            assert!(svg.contains(text), "{text} is missing");
        }
    }
}

/// The lines of the legends, three pixels wide; a design is a shipped one with another wheel base.
#[test]
fn many_designs_have_lines_of_their_own() {
    let directory = Directory::of_this_test();
    let designs: Vec<String> = (0..17).map(|k| format!("pista:w=1.{k:02}")).collect();
    let mut arguments = vec!["compare", "--plot", "all.svg", "--side-view", "views.svg"];
    arguments.extend(designs.iter().map(String::as_str));
    let run = directory.run(&arguments);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    for file in ["all.svg", "views.svg"] {
        let svg = std::fs::read_to_string(directory.0.join(file)).unwrap();
        let part = |line: &str, name: &str| {
            let value = line.split_once(&format!(" {name}=\"")).and_then(|(_, rest)| rest.split_once('"'));
            value.map(|(value, _)| value.to_owned())
        };
        let lines = svg.lines().filter(|line| line.contains(" stroke-width=\"3\""));
        let mut lines: Vec<_> = lines.map(|line| (part(line, "stroke"), part(line, "stroke-dasharray"))).collect();
        assert_eq!(lines.len(), designs.len(), "{file}");
        lines.sort();
        lines.dedup();
        assert_eq!(lines.len(), designs.len(), "{file}: {lines:?}");
    }
}

#[test]
fn mistakes_are_told() {
    let directory = Directory::of_this_test();
    directory.run(&["compare", "pista"]).fails(2, "error: there is one design to compare: expected two or more\n");
    directory.run(&["compare", "pista", "pista:q=1"]).fails(2, "error: pista:q=1: `q` is not a parameter of Whipple\n");
    directory
        .run(&["compare", "pista", "benchmark:w=1,c"])
        .fails(2, "error: benchmark:w=1,c: `c` is no setting: expected NAME=VALUE\n");
    directory
        .run(&["compare", "--model", "Motorcycle", "standard", "standard:Rf=0.31", "--side-view", "v.svg"])
        .fails(2, "error: --side-view v.svg: there is a side view of bicycles alone, and not all of these are\n");
}

/// There and back through another convention a parameter differs by rounding alone.
#[test]
fn rounding_is_no_difference() {
    let directory = Directory::of_this_test();
    for convention in ["moore", "geometry", "pydy", "principal"] {
        let there = directory.run(&["convert", "browser", "--to", convention]).stdout;
        directory.write("there.toml", there);
        let run = directory.run(&["compare", "browser", "there.toml"]);
        assert!(
            run.stdout.contains("\nParameters that differ\n  those that all have are the same\n"),
            "{}",
            run.stdout
        );
        assert!(run.stdout.contains("there is no difference to explain"), "{}", run.stdout);
    }
    let run = directory.run(&["compare", "browser", "browser:w=1.1210000001"]);
    assert!(run.stdout.contains("  w           m"), "{}", run.stdout);
}

/// The fifth design has dashes, and of a pair one curve, or the dashes of one real part would fill the gaps of the other; and real
/// parts have the limits that are asked for.
#[test]
fn a_pair_of_real_parts_is_drawn_once() {
    let directory = Directory::of_this_test();
    let designs = ["benchmark", "pista", "fisher", "silver", "crescendo"];
    let limits = ["--plot", "a.svg", "--xlim", "6:8", "--ylim=-4:1"];
    assert_eq!(directory.run(&[&["compare"], &designs[..], &limits].concat()).code, Some(0));
    let picture = std::fs::read_to_string(directory.0.join("a.svg")).unwrap();
    // Between 6 and 8 m/s: castering out of sight, capsize and weave, and the frequency of weave; and the line of the legend.
    assert_eq!(picture.matches("stroke-dasharray").count(), 4);
    for limit in ["−4.0", "1.0"] {
        assert!(picture.contains(&format!("aria-label=\"{limit}\"")), "{limit}");
    }
}

/// What is odd about a design is told by what it is called among the others.
#[test]
fn warnings_name_the_design_that_they_are_of() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["compare", "pista", "pista:IBxx=20"]);
    let warnings: Vec<&str> = run.stderr.lines().filter(|line| line.starts_with("warning: ")).collect();
    assert!(run.code == Some(0) && !warnings.is_empty(), "{}", run.stderr);
    assert!(warnings.iter().all(|line| line.starts_with("warning: pista:IBxx=20: ")), "{}", run.stderr);
}
