//! What cannot be swept, and what is said of it.

use crate::Directory;

#[track_caller]
fn check(arguments: &[&str], message: &str) {
    let directory = Directory::of_this_test();
    directory.run(&[&["sweep"], arguments].concat()).fails(2, &format!("error: {message}\n"));
}

#[test]
fn everything_wrong_is_told_at_once() {
    let message = "\
6 problems
--set mb=90: `mb` is not a parameter of Whipple; did you mean `mB`?
--vary ww=1,2: `ww` is not a parameter of Whipple; did you mean `w`?
--vary mB=1,x: a value of `mB` is `x`; expected a number, or an expression such as `pi/10`: `x` is not known
--random c=1: expected NAME=LOW..HIGH, NAME=MEAN+-DEVIATION or measured, such as c=0.02..0.12 or mB=85+-5
--output table.txt: the name must end in .csv or .parquet
--eigenvalues 1,1: the speed 1 is given twice";
    let arguments = ["--vary", "ww=1,2", "--vary", "mB=1,x", "--random", "c=1", "--samples", "3"];
    check(&[&arguments[..], &["--set", "mb=90", "--eigenvalues", "1,1", "--output", "table.txt"]].concat(), message);
}

#[test]
fn sweeps_that_make_no_sense() {
    check(&[], "nothing varies: expected --vary, --random or --designs");
    check(&["--random", "w=1..2"], "--random needs --samples COUNT");
    check(&["--vary", "w=1,2", "--samples", "3"], "--samples needs --random NAME=VALUES");
    check(&["--vary", "w=1,2", "--seed", "3"], "--seed needs --random NAME=VALUES");
    check(
        &["--vary", "w=-1e308:1e308:3 points"],
        "--vary w=-1e308:1e308:3 points: the range from -1e308 m to 1e308 m is too wide for double precision",
    );
    for (option, value) in [("--samples", "1e3"), ("--seed", "abc"), ("--seed", "-1")] {
        let run = Directory::of_this_test().run(&["sweep", "--random", "w=1..2", option, value]);
        assert_eq!(run.code, Some(2));
        assert!(run.stderr.contains(&format!("invalid value '{value}' for '{option}")), "{}", run.stderr);
        assert!(run.stderr.contains("expected a whole number"), "{}", run.stderr);
    }
    check(&["--random", "w=1..2", "--samples", "0"], "--samples 0: expected at least 1");
    check(
        &["--vary", "w=1:1.2:5"],
        "--vary w=1:1.2:5: the step is 5 m, longer than the range; a number of values is `5 points`",
    );
    check(&["--vary", "w=1,2", "--vary", "w=3"], "--vary w=3: `w` is given twice; first at --vary w=1,2");
    check(&["--vary", "g=1,2", "--gravity", "3"], "--vary g=1,2: `g` is given twice; first at --gravity 3");
    let message = "nothing in the model Pendulum depends on the speed: give --eigenvalues SPEEDS";
    check(&["--model", "Pendulum", "--vary", "l=1,2"], message);
    let huge = ["--vary", "w=1:2:1000000 points", "--vary", "c=1:2:1000000 points", "--vary", "mB=1,2"];
    check(&huge, "--vary, --random and --samples make too many designs; there must be at most 1000000000000");
    check(
        &["--vary", "w=1,2", "--eigenvalues", "0:10:0.05"],
        "--eigenvalues 0:10:0.05: there are 201 speeds; there must be at most 100",
    );
}

#[test]
fn maps_that_make_no_sense() {
    check(
        &["--vary", "w=1,2", "--map", "map.svg"],
        "--map map.svg: a map needs two parameters that vary by --vary, and no others",
    );
    let two = ["--vary", "w=1,2", "--vary", "c=1,1", "--map"];
    check(&[&two[..], &["map.svg"]].concat(), "--map map.svg: a map needs at least two values of each parameter");
    let two = ["--vary", "w=1,2", "--vary", "c=1,2", "--map"];
    check(&[&two[..], &["map.pdf"]].concat(), "--map map.pdf: the name must end in .svg or .png");
}

#[test]
fn files_of_designs_that_cannot_be_used() {
    let directory = Directory::new("sweep-bad-files");
    let check = |text: &str, message: &str| {
        directory.write("bikes.csv", text);
        directory.run(&["sweep", "--designs", "bikes.csv"]).fails(2, &format!("error: {message}\n"));
    };
    let message = "2 problems\nbikes.csv: column `lamm` is not a parameter of Whipple; did you mean `lam`?\nbikes.csv: \
                   there are two columns `w`";
    check("w,lamm,w\n1,2,3\n", message);
    check("name,id\na,b\n", "bikes.csv: no column is a parameter");
    check("", "bikes.csv: no column is a parameter");
    for (text, line) in [("w,name\n1.0,\"abc\n1.1,b\n1.2,c\n", 2), ("# a\nw\n1\n\"1.0\n", 4), ("w,\"n\nm\"\n1,2\n", 1)]
    {
        let message = "a quote opens here that is not closed in this line; fields have no line breaks";
        check(text, &format!("bikes.csv:{line}: {message}"));
    }
    check("w\n1\n\"1.0", "bikes.csv:3: a quote opens here that is not closed");
    check(&format!("w\n{}\n", "1".repeat(2_000_000)), "bikes.csv:2: the line is longer than 1 MiB");
    for header in ["w", "w,name\n\n"] {
        check(header, "bikes.csv: there is no design: no row follows the names of the columns");
    }
    directory.write("bikes.csv", "w,mB\n1,2\n");
    let message = "error: --set w=2: `w` is given twice; also by a column of bikes.csv\n";
    directory.run(&["sweep", "--designs", "bikes.csv", "--set", "w=2"]).fails(2, message);
    std::fs::create_dir(directory.0.join("folder.csv")).unwrap();
    let message = "error: there is no file folder.csv: it is a folder\n";
    directory.run(&["sweep", "--designs", "folder.csv"]).fails(2, message);
    directory.run(&["sweep", "--vary", "w=0.9:1.1:0.1", "--output", "result.csv"]);
    directory.run(&["sweep", "--vary", "w=1:1.1:0.1", "--eigenvalues", "5", "--units", "km/h", "--output", "at.csv"]);
    for file in ["result.csv", "at.csv"] {
        let message = "it is the result of a sweep; expected a table of designs, whose columns are parameters alone";
        directory.run(&["sweep", "--designs", file]).fails(2, &format!("error: {file}: {message}\n"));
    }
    directory
        .run(&["sweep", "--designs", "bikes.txt"])
        .fails(2, "error: --designs bikes.txt: the name must end in .csv or .parquet\n");
    for missing in ["missing.csv", "missing.parquet"] {
        directory.run(&["sweep", "--designs", missing]).fails(2, &format!("error: there is no file {missing}\n"));
    }
    directory.write("broken.parquet", "PAR1 this is none");
    let run = directory.run(&["sweep", "--designs", "broken.parquet"]);
    assert_eq!(
        (run.code, run.stderr.starts_with("error: cannot read broken.parquet: ")),
        (Some(1), true),
        "{}",
        run.stderr
    );
    directory.write("bikes.csv", "w\n1\n");
    let message = "error: --output bikes.csv: the designs are read from this file\n";
    directory.run(&["sweep", "--designs", "bikes.csv", "--output", "bikes.csv", "--restart"]).fails(2, message);
}

#[test]
fn help_has_examples_and_the_exit_codes() {
    let help = Directory::new("sweep-help").run(&["sweep", "--help"]).ok();
    for expected in [
        "carvallo sweep --vary mB=60:100:1 > mass.csv",
        "Exit codes: 0 done",
        "stable_from_1",
        "--restart",
        "100 speeds",
    ] {
        assert!(help.contains(expected), "{help}");
    }
}

#[test]
fn results_that_cannot_be_written_are_failures() {
    let directory = Directory::new("sweep-unwritable");
    let run = directory.run(&["sweep", "--vary", "w=1,2", "--output", "missing/table.csv"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""));
    assert!(run.stderr.starts_with("error: cannot write missing/table.csv"), "{}", run.stderr);
    // Before anything is computed, and nothing is left behind.
    let two = ["sweep", "--vary", "w=1,2", "--vary", "c=1,2", "--map"];
    let run = directory.run(&[&two[..], &["missing/map.png"]].concat());
    assert_eq!(run.code, Some(1));
    assert!(run.stderr.starts_with("error: cannot write missing/map.png"), "{}", run.stderr);
    std::fs::create_dir(directory.0.join("folder.csv")).unwrap();
    let message = "error: --output folder.csv: it is a directory\n";
    directory.run(&["sweep", "--vary", "w=1,2", "--output", "folder.csv", "--restart"]).fails(2, message);
    assert_eq!(std::fs::read_dir(&directory.0).unwrap().count(), 1);
}

#[test]
fn what_is_read_is_not_replaced() {
    let directory = Directory::new("sweep-base");
    let parameters = directory.run(&["show", "benchmark"]).ok();
    directory.write("b.csv", &parameters);
    directory.write("b.svg", &parameters);
    let replaced = |option: &str| format!("error: {option}: the parameters are read from this file\n");
    let sweep = ["sweep", "--vary", "w=1,1.1", "--vary", "c=0,0.1"];
    let run = directory.run(&[&sweep[..], &["b.csv", "--output", "./b.csv", "--restart"]].concat());
    run.fails(2, &replaced("--output ./b.csv"));
    directory.run(&[&sweep[..], &["b.svg", "--map", "b.svg"]].concat()).fails(2, &replaced("--map b.svg"));
    for command in ["analyze", "sensitivity", "show"] {
        directory.run(&[command, "b.svg", "--plot", "b.svg"]).fails(2, &replaced("--plot b.svg"));
    }
    assert_eq!(std::fs::read_to_string(directory.0.join("b.svg")).unwrap(), parameters);
}
