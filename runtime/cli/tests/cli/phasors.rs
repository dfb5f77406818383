//! Eigenvectors as arrows on dials.

use crate::Directory;
use crate::pictures::texts;

fn phasors(directory: &Directory, arguments: &[&str]) -> String {
    let run = directory.run(&[&["analyze", "--phasors", "modes.svg"], arguments].concat());
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: modes.svg\n"));
    let svg = std::fs::read_to_string(directory.0.join("modes.svg")).expect("a picture");
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    svg
}

/// Weave of the benchmark at 5 m/s by numpy, of the matrices that Meijaard et al. (2007) print: lean is 0.770503 of the steer, and
/// leads it by 10.003 degrees.
#[test]
fn each_mode_has_a_dial_with_sizes_and_phases() {
    let directory = Directory::of_this_test();
    let svg = phasors(&directory, &["--speeds", "5"]);
    let found = texts(&svg);
    let expected = [
        "Eigenvectors of benchmark at 5 m/s",
        "castering",
        "−14.0784 1/s",
        "capsize",
        "weave",
        "(−0.7753 ± 4.4649 i) 1/s",
        "phi  0.7705 at 10°",
        "delta  1.0000",
    ];
    for expected in expected {
        assert!(found.iter().any(|text| text == expected), "{expected}: {found:?}");
    }
    assert_eq!(found.iter().filter(|text| *text == "90°").count(), 3);
    // The same in every run.
    assert_eq!(phasors(&directory, &["--speeds", "5"]), svg);
}

#[test]
fn several_speeds_stand_below_each_other_and_all_models_have_dials() {
    let directory = Directory::of_this_test();
    let found = texts(&phasors(&directory, &["--speeds", "2,8", "--units", "km/h"]));
    assert!(["7.2 km/h", "28.8 km/h"].iter().all(|speed| found.iter().any(|text| text == speed)), "{found:?}");
    // Of two rods, one standing on the other, nothing depends on the speed. Of a motorcycle on tyres some rates are states.
    let found = texts(&phasors(&directory, &["--model", "DoublePendulum"]));
    assert!(found.iter().any(|text| text == "Eigenvectors of DoublePendulum rods"), "{found:?}");
    let found = texts(&phasors(&directory, &["--model", "Motorcycle", "--speeds", "20"]));
    assert_eq!(found.iter().filter(|text| text.starts_with("psi’  ")).count(), 6);
}

#[test]
fn what_has_no_room_is_refused() {
    let directory = Directory::of_this_test();
    let with = |arguments: &[&str]| directory.run(&[&["analyze", "--phasors", "modes.svg"], arguments].concat());
    with(&[]).fails(
        2,
        "error: --phasors modes.svg: expected --speeds with the speeds that it is drawn at, such as --speeds 4.5\n",
    );
    let message = "error: --phasors modes.svg: there are 21 speeds; the picture has room for 12\n";
    with(&["--speeds", "0:10:0.5"]).fails(2, message);
}
