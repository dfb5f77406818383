//! How the program behaves among others: exit codes, pipes, colours, files.

use std::io::Read as _;
use std::process::Stdio;

use crate::{Directory, finished};

#[test]
fn a_reader_that_closes_the_pipe_is_no_failure() {
    let directory = Directory::new("pipe");
    let mut command = directory.command(&["analyze", "--format", "csv", "--speeds", "0:100:0.005"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut first = [0; 11];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    assert_eq!(&first, b"speed (m/s)");
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}

#[test]
fn colours_can_be_forced_and_refused() {
    let directory = Directory::new("colours");
    let forced = directory.command(&["analyze"]).env("CLICOLOR_FORCE", "1").output().unwrap().stdout;
    assert!(forced.contains(&0x1b));
    let refused = directory.command(&["analyze"]).env("NO_COLOR", "1").output().unwrap().stdout;
    assert!(!refused.contains(&0x1b));
}

#[test]
fn help_has_examples_and_the_exit_codes() {
    let directory = Directory::new("help");
    let help = directory.run(&["--help"]).ok();
    assert!(help.contains("carvallo analyze pista --plot pista.svg"), "{help}");
    let lines: Vec<&str> = help.lines().collect();
    assert_eq!(lines[2..5], ["Usage: carvallo [COMMAND]", "", "Stability:"]);
    assert!(
        help.contains("\n\nMotion:\n  simulate         The motion from an initial state, under forces\n"),
        "{help}"
    );
    assert!(
        help.contains("\n\nOptions:\n  -h, --help     Print help\n  -V, --version  Print version\n\nExamples:\n"),
        "{help}"
    );
    for command in ["analyze", "sensitivity", "show", "sweep"] {
        let help = directory.run(&[command, "--help"]).ok();
        assert!(help.contains(&format!("Usage: carvallo {command} [OPTIONS] [DESIGN|FILE]\n")), "{help}");
        assert!(help.contains("Exit codes: 0"), "{help}");
    }
    assert_eq!(directory.run(&["--version"]).ok(), format!("carvallo {}\n", env!("CARGO_PKG_VERSION")));
    let help = directory.run(&["analyze", "--help"]).ok();
    assert!(help.contains("\"stable_ranges\": [[FROM, TO|null]]"), "{help}");
}

#[test]
fn analyze_writes_no_file_unasked() {
    let directory = Directory::new("no-litter");
    directory.run(&["analyze"]).ok();
    directory.run(&["show", "benchmark"]).ok();
    directory.run(&[]).ok();
    assert_eq!(std::fs::read_dir(&directory.0).unwrap().count(), 0);
}

/// Without arguments: the benchmark, and a picture where cargo keeps what it builds.
#[test]
fn a_first_look_needs_no_arguments() {
    let directory = Directory::new("first-look");
    let text = directory.run(&[]).ok();
    let table = directory.run(&["analyze"]).ok();
    assert!(text.starts_with(&table), "{text}");
    assert!(text.contains("━ stable"), "{text}");
    let path = text.lines().find_map(|line| line.strip_prefix("Picture: ")).unwrap();
    assert!(std::fs::read_to_string(path).unwrap().starts_with("<svg "), "{path}");
}

/// Not from the repository by cargo, but as an installed program is run.
#[test]
fn a_first_look_elsewhere_writes_nothing() {
    let directory = Directory::new("first-look-elsewhere");
    // A program beside the mark of a build directory, which may be that of another project.
    std::fs::create_dir(directory.0.join("debug")).unwrap();
    directory.write("CACHEDIR.TAG", "");
    let program = directory.0.join("debug/carvallo");
    std::fs::copy(env!("CARGO_BIN_EXE_carvallo"), &program).unwrap();
    let run_in = |folder: &std::path::Path, package: Option<&str>| {
        let mut command = std::process::Command::new(&program);
        command.current_dir(folder).stdin(Stdio::null()).env_remove("CARGO_PKG_NAME");
        finished(command.envs(package.map(|package| ("CARGO_PKG_NAME", package))).output().unwrap()).ok()
    };
    let run = |package| run_in(&directory.0, package);
    for package in [None, Some("another")] {
        let text = run(package);
        assert!(
            text.ends_with("\nPicture: carvallo analyze --plot benchmark.svg\nMore:    carvallo --help\n"),
            "{text}"
        );
        assert!(!directory.0.join("carvallo").exists());
    }
    assert!(run(Some(env!("CARGO_PKG_NAME"))).ends_with("\nMore:    cargo run --release -- --help\n"));
    assert!(directory.0.join("carvallo/benchmark.svg").exists());
    // By cargo from another folder, where its command would not do without the place of the workspace.
    let text = run_in(&directory.0.join("debug"), Some(env!("CARGO_PKG_NAME")));
    assert!(text.ends_with("/debug/carvallo --help\n") && !text.contains("cargo run"), "{text}");
}

/// A bicycle without any inertia about the lean axis has no equations of motion to solve.
#[test]
fn a_singular_mass_matrix_is_a_failure_of_the_analysis() {
    let directory = Directory::new("singular");
    let zero = [
        "mR", "IRxx", "IRyy", "mB", "IBxx", "IByy", "IBzz", "IBxz", "IHxx", "IHyy", "IHzz", "IHxz", "mF", "IFxx",
        "IFyy", "xH", "zH",
    ];
    let settings: Vec<String> = zero.iter().map(|name| format!("{name}=0")).collect();
    let mut arguments = vec!["analyze"];
    for setting in &settings {
        arguments.extend(["--set", setting]);
    }
    let run = directory.run(&arguments);
    assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""));
    assert!(run.stderr.starts_with("error: benchmark: "), "{}", run.stderr);
    assert!(run.stderr.contains("mass matrix"), "{}", run.stderr);
}

#[test]
fn files_that_cannot_be_read_or_written_are_failures() {
    let directory = Directory::new("io");
    directory.run(&["analyze", "."]).fails(2, "error: there is no file .: it is a folder\n");
    let run = directory.run(&["analyze", "--plot", "missing/plot.svg"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""));
    assert!(run.stderr.starts_with("error: cannot write missing/plot.svg: "), "{}", run.stderr);
}

/// A name that is no file is a mistake of the command line, 2, whether it is nothing or a folder; that one cannot be written is
/// none, 1. So it is in every command.
#[test]
fn exit_codes_of_files_are_the_same_everywhere() {
    let directory = Directory::of_this_test();
    std::fs::create_dir(directory.0.join("folder.csv")).unwrap();
    let reading: [&[&str]; 20] = [
        &["analyze", "FILE"],
        &["show", "FILE"],
        &["convert", "FILE", "--to", "moore"],
        &["sensitivity", "FILE"],
        &["statespace", "FILE", "--speed", "5"],
        &["transfer", "FILE", "--speed", "5"],
        &["respond", "FILE", "--speed", "5", "--step", "--input", "Tdelta"],
        &["controllability", "FILE"],
        &["lqr", "FILE", "--speeds", "5"],
        &["turns", "FILE"],
        &["simulate", "FILE", "--speed", "5", "--duration", "1"],
        &["simulate", "--speed", "5", "--duration", "1", "--force", "delta=FILE"],
        &["optimize", "FILE", "--vary", "c=0:0.1", "--minimize", "weave-speed"],
        &["sweep", "FILE", "--vary", "c=0:0.1:0.1"],
        &["compare", "benchmark", "FILE"],
        &["check", "FILE"],
        &["check", "FILE", "--bicycle", "FILE"],
        &["measure", "FILE"],
        &["rider", "FILE"],
        &["analyze", "--add", "FILE"],
    ];
    let run = |arguments: &[&str], file: &str| {
        let arguments: Vec<String> = arguments.iter().map(|argument| argument.replace("FILE", file)).collect();
        directory.run(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
    };
    for arguments in reading {
        for (file, code, message) in [("missing.csv", 2, "file"), ("folder.csv", 2, "folder")] {
            let found = run(arguments, file);
            assert_eq!(found.code, Some(code), "{arguments:?} {file}: {}", found.stderr);
            assert!(found.stderr.contains(message), "{arguments:?} {file}: {}", found.stderr);
        }
    }
    // A recording is named in a file, at a line of which it is missing.
    let example = directory.run(&["measure", "--example"]).ok();
    let line = example.lines().find(|line| line.trim_start().starts_with("TtR1")).unwrap();
    for (file, code, message) in [
        ("missing.csv", 2, "`TtR1`: there is no file missing.csv"),
        ("folder.csv", 2, "`TtR1`: there is no file folder.csv: it is a folder"),
    ] {
        directory.write("measured.toml", example.replace(line, &format!("TtR1 = '{file}'")));
        let found = directory.run(&["measure", "measured.toml"]);
        assert!(found.code == Some(code) && found.stderr.contains(message), "{file}: {}", found.stderr);
    }
    run(&["sweep", "--designs", "FILE"], "missing.csv").fails(2, "error: there is no file missing.csv\n");
    let writing: [&[&str]; 23] = [
        &["analyze", "--plot", "none/a.svg"],
        &["transfer", "--speed", "5", "--bode", "none/a.png"],
        &["statespace", "--speed", "5", "--output", "none/a.npz"],
        &["simulate", "--speed", "5", "--duration", "1", "--output", "none/a.csv"],
        &["lqr", "--speeds", "5", "--output", "none/a.csv"],
        &["convert", "--to", "moore", "--output", "none/a.toml"],
        &["turns", "--output", "none/a.csv"],
        &["sweep", "--vary", "c=0:0.1:0.1", "--output", "none/a.csv"],
        &["sweep", "--vary", "c=0:0.1:0.1", "--vary", "w=1:1.1:0.1", "--map", "none/a.svg"],
        &["analyze", "--along", "w=0.9:1.2", "--speed", "5", "--plot", "none/a.svg"],
        &["analyze", "--speeds", "5", "--phasors", "none/a.svg"],
        &["analyze", "--locus", "none/a.svg"],
        &["transfer", "--speed", "5", "--nyquist", "none/a.png"],
        &["transfer", "--speed", "5", "--sigma", "none/a.png"],
        &["compare", "pista", "browser", "--plot", "none/a.svg"],
        &["compare", "pista", "browser", "--side-view", "none/a.svg"],
        &["compare", "pista", "browser", "--contributions", "none/a.svg"],
        &["optimize", "--vary", "w=0.9:1.2", "--minimize", "weave-speed", "--output", "none/a.toml"],
        &["sensitivity", "--plot", "none/a.svg"],
        &["simulate", "--speed", "5", "--duration", "1", "--plot", "none/a.svg"],
        &["respond", "--speed", "5", "--plot", "none/a.svg"],
        &["controllability", "--plot", "none/a.svg"],
        &["show", "--plot", "none/a.svg"],
    ];
    for arguments in writing {
        // Before anything is computed, for not even the feedback is read.
        let mut arguments = arguments.to_vec();
        if !["sweep", "compare"].contains(&arguments[0]) {
            arguments.extend(["--feedback", "nonsense"]);
        }
        let found = directory.run(&arguments);
        assert_eq!((found.code, found.stdout.as_str()), (Some(1), ""), "{arguments:?}: {}", found.stderr);
        let message = "error: cannot write none/a.";
        assert!(
            found.stderr.starts_with(message) && !found.stderr.contains("nonsense"),
            "{arguments:?}: {}",
            found.stderr
        );
    }
    // Nothing is left of a trial.
    directory.run(&["analyze", "--plot", "a.svg", "--feedback", "nonsense"]);
    assert!(!directory.0.join("a.svg").exists());
}

/// Options that other commands have, and words that are options, point to these commands; what is near a name points to that.
#[test]
fn what_there_is_not_points_to_what_there_is() {
    let directory = Directory::of_this_test();
    for (arguments, message) in [
        (&["bode", "--speed", "5"][..], "there is no command `bode`; --bode is an option of `transfer`"),
        (&["sensitivity", "--along", "w=1:2"], "--along: this command has no such option; it is one of `analyze`"),
        (&["show", "--bode", "x.svg"], "--bode: this command has no such option; it is one of `transfer`"),
        (
            &["turns", "--outputs", "phi"],
            "--outputs: this command has no such option; it is one of `statespace`, `transfer`, `respond` and `controllability`",
        ),
        (&["show", "--keep", "w > 1"], "--keep: this command has no such option; it is one of `optimize`"),
    ] {
        directory.run(arguments).fails(2, &format!("error: {message}\n"));
    }
    for (arguments, near) in [(&["analize"][..], "'analyze'"), (&["optimize", "--minimise", "x"], "'--minimize'")] {
        let run = directory.run(arguments);
        assert!(run.code == Some(2) && run.stderr.contains(near), "{}", run.stderr);
    }
}

/// What one picture shows would be lost under the other.
#[test]
fn two_results_do_not_go_to_one_file() {
    let directory = Directory::of_this_test();
    let compare = ["compare", "benchmark", "pista", "--plot", "a.svg", "--contributions"];
    let run = |file: &'static str| directory.run(&[&compare[..], &[file]].concat());
    run("a.svg").fails(2, "error: two results go to a.svg: give each a file of its own\n");
    // By another path to where nothing is yet.
    run("./a.svg").fails(2, "error: two results go to ./a.svg: give each a file of its own\n");
    assert_eq!(run("b.svg").code, Some(0));
    // Now that it is there, by another path.
    run("./a.svg").fails(2, "error: two results go to ./a.svg: give each a file of its own\n");
}

/// A result takes the place of a result, in each of its forms, and of nothing that somebody wrote.
#[test]
fn results_replace_results_alone() {
    let directory = Directory::of_this_test();
    let commands = [
        (&["statespace", "--speed", "5"][..], &["tex", "md", "txt", "csv", "json"][..]),
        (&["lqr", "--inputs", "Tdelta", "--speeds", "5,6"], &["md", "csv", "json"]),
        (&["simulate", "--speed", "5", "--duration", "0.01", "--linear"], &["txt", "csv", "json"]),
        (&["turns", "--steer", "0.1"], &["csv"]),
    ];
    let theirs = "\\documentclass{report}\nA matrix\nof, say, four rows: motion by a rider.\n";
    for (command, endings) in commands {
        for ending in endings {
            let file = format!("thesis.{ending}");
            directory.write(&file, theirs);
            let run = || directory.run(&[command, &["--output", &file]].concat());
            let message = "this file is there, and is no result of this program: give another name, or remove it\n";
            run().fails(2, &format!("error: --output {file}: {message}"));
            assert_eq!(std::fs::read_to_string(directory.0.join(&file)).unwrap(), theirs);
            std::fs::remove_file(directory.0.join(&file)).unwrap();
            for _ in 0..2 {
                let run = run();
                assert_eq!(run.code, Some(0), "{command:?} {file}: {}", run.stderr);
            }
        }
    }
    for _ in 0..2 {
        let run = directory.run(&["statespace", "--speed", "5", "--output", "a.npz"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
    }
}

/// A picture replaces a picture, and nothing else: not numbers that its name is a link to.
#[cfg(unix)]
#[test]
fn pictures_replace_pictures_alone() {
    let directory = Directory::of_this_test();
    let steer = "t,delta\n0,1\n1,2\n";
    directory.write("steer.csv", steer);
    std::os::unix::fs::symlink("steer.csv", directory.0.join("steer.png")).unwrap();
    let force = ["simulate", "--speed", "5", "--duration", "0.1", "--force", "delta=steer.csv", "--plot", "steer.png"];
    let message = "this file is there, and is no picture: give another name, or remove it\n";
    directory.run(&force).fails(2, &format!("error: --plot steer.png: {message}"));
    assert_eq!(std::fs::read_to_string(directory.0.join("steer.csv")).unwrap(), steer);
    let compare = ["compare", "benchmark", "pista", "--side-view", "notes.svg"];
    directory.write("notes.svg", "none yet\n");
    directory.run(&compare).fails(2, &format!("error: --side-view notes.svg: {message}"));
    let sweep = ["sweep", "--vary", "c=0.05:0.1:0.05", "--vary", "w=1:1.1:0.1", "--map", "notes.svg"];
    directory.run(&sweep).fails(2, &format!("error: --map notes.svg: {message}"));
    std::fs::remove_file(directory.0.join("notes.svg")).unwrap();
    for _ in 0..2 {
        let run = directory.run(&compare);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
    }
}

/// Two names of one file are one file.
#[cfg(unix)]
#[test]
fn what_is_read_is_not_written_through_another_name() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", crate::BENCHMARK);
    directory.write("rack.toml", "mass = 5\nat = [0.1, 0, -0.9]\n");
    for (from, to) in [("mine.toml", "linked.toml"), ("mine.toml", "linked.csv"), ("rack.toml", "rack.svg")] {
        std::fs::hard_link(directory.0.join(from), directory.0.join(to)).unwrap();
    }
    let read = "the parameters are read from this file";
    for (arguments, option) in [
        (&["convert", "mine.toml", "--to", "moore", "--output", "linked.toml"][..], "--output linked.toml"),
        (&["statespace", "mine.toml", "--speed", "5", "--output", "linked.csv"], "--output linked.csv"),
        (&["show", "--add", "rack.toml", "--plot", "rack.svg"], "--plot rack.svg"),
        (
            &["optimize", "mine.toml", "--vary", "c=0:0.1", "--minimize", "c", "--output", "linked.toml"],
            "--output linked.toml",
        ),
    ] {
        directory.run(arguments).fails(2, &format!("error: {option}: {read}\n"));
    }
}
