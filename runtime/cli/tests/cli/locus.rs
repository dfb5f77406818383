//! The root locus along the speed.

use crate::Directory;

#[test]
fn eigenvalues_are_drawn_in_the_complex_plane() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["analyze", "--locus", "l.svg", "--format", "csv"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: l.svg\n"));
    let svg = std::fs::read_to_string(directory.0.join("l.svg")).expect("a picture");
    for text in
        ["Root locus of benchmark: forward speed from 0 to 10 m/s", "imaginary part (1/s)", "castering", "weave"]
    {
        assert!(svg.contains(text), "{text}");
    }
    // All of it is shown, and nothing is left out.
    assert!(!svg.contains("go on to the left") && !svg.contains("NaN"));
    directory.run(&["analyze", "--model", "Motorcycle", "--locus", "m.svg", "--format", "csv"]);
    let svg = std::fs::read_to_string(directory.0.join("m.svg")).expect("a picture");
    assert!(svg.contains("eigenvalues go on to the left, to −326.7 /s") && svg.contains("wobble"));
}

#[test]
fn a_root_locus_needs_a_range_of_speeds() {
    let directory = Directory::of_this_test();
    let message = "error: --locus l.svg: a root locus needs a range of speeds, such as --speeds 0:10:0.1\n";
    directory.run(&["analyze", "--speeds", "5", "--locus", "l.svg"]).fails(2, message);
    let message = "error: --locus l.svg: nothing in the model Pendulum depends on the speed, so there is no root locus along it\n";
    directory.run(&["analyze", "--model", "Pendulum", "--locus", "l.svg"]).fails(2, message);
}

/// A speed stands beside its dot or nowhere: 80 m/s at the top of the wobble, and no 40 among the dots of the weave that touch.
#[test]
fn speeds_stand_clear_of_each_other() {
    let directory = Directory::of_this_test();
    directory.run(&["analyze", "--model", "Motorcycle", "--locus", "m.svg", "--format", "csv"]);
    let svg = std::fs::read_to_string(directory.0.join("m.svg")).expect("a picture");
    let labels = |text: &str| svg.matches(&format!("aria-label=\"{text}\"")).count();
    // The axis has 60 and 70, too.
    assert_eq!((labels("80"), labels("70"), labels("60")), (1, 2, 1));
}
