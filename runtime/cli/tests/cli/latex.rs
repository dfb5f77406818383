//! What is written for LaTeX goes through LaTeX.

use std::process::Command;

use crate::Directory;

/// Whether LaTeX is there, with what tables and equations need; said aloud if it is not.
fn has_latex() -> bool {
    let has = |program: &str, argument: &str| {
        Command::new(program).arg(argument).output().is_ok_and(|output| output.status.success())
    };
    let is_there = has("pdflatex", "--version") && has("kpsewhich", "booktabs.sty") && has("kpsewhich", "amsmath.sty");
    if !is_there {
        eprintln!(
            "SKIPPED: no LaTeX with booktabs and amsmath (texlive-latex-recommended of Debian): tables were not typeset"
        );
    }
    is_there
}

/// Puts pieces into one document and typesets it.
#[track_caller]
fn typeset(directory: &Directory, pieces: &[String]) {
    let body = pieces.join("\n\\clearpage\n");
    let packages = "\\usepackage{booktabs}\n\\usepackage{amsmath}\n";
    let text = format!("\\documentclass{{article}}\n{packages}\\begin{{document}}\n{body}\n\\end{{document}}\n");
    directory.write("all.tex", text);
    let mut latex = Command::new("pdflatex");
    latex.args(["-halt-on-error", "-interaction=nonstopmode", "all.tex"]).current_dir(&directory.0);
    let log = String::from_utf8_lossy(&latex.output().unwrap().stdout).into_owned();
    let mistakes: Vec<&str> = log.lines().filter(|line| line.starts_with(['!', 'l'])).collect();
    assert!(directory.0.join("all.pdf").exists(), "{mistakes:#?}");
    assert!(!log.contains("Missing character"), "{log}");
}

#[test]
fn tables_of_every_command_are_typeset() {
    if !has_latex() {
        return;
    }
    let directory = Directory::new("latex-tables");
    let commands = [
        "bicycles",
        "models",
        "analyze",
        "analyze pista --speeds 2,5 --eigenvectors --units km/h",
        "analyze --along fork_offset=0:0.06 --speed 5",
        "compare pista browser --all",
        "compare benchmark benchmark:w=1.1,mB=50 --units imperial",
        "optimize --vary w=0.9:1.2 --vary c=0.02:0.12 --minimize weave-speed --keep c<=0.1 --starts 1",
        "sensitivity pista",
        "simulate --speed 4.6 --duration 2 --initial phi_rate=0.5",
        "turns --steer 0.1",
        "statespace --speed 5 --inputs Tdelta",
        "transfer --speed 5 --inputs Tdelta --outputs phi",
        "respond --speed 5 --input Tdelta --step",
        "controllability --speeds 3,5",
        "lqr --inputs Tdelta --speeds 1:8:1",
    ];
    let piece = |command: &&str| {
        let arguments: Vec<&str> = command.split(' ').chain(["--format", "latex"]).collect();
        let run = directory.run(&arguments);
        assert_eq!(run.code, Some(0), "{command}: {}", run.stderr);
        run.stdout
    };
    typeset(&directory, &commands.iter().map(piece).collect::<Vec<String>>());
}

/// With the names and symbols that models have.
#[test]
fn models_are_typeset() {
    if !has_latex() {
        return;
    }
    let directory = Directory::new("latex-models");
    let list = directory.run(&["models", "--format", "markdown"]).ok();
    let names: Vec<&str> = carvallo_design::MODELS.iter().map(|model| model.info.name).collect();
    assert!(names.iter().all(|name| list.contains(name)), "{list}");
    let pieces = names.iter().flat_map(|name| {
        let tables = directory.run(&["analyze", "--model", name, "--format", "latex"]);
        assert_eq!(tables.code, Some(0), "{name}: {}", tables.stderr);
        [tables.stdout, directory.run(&["equations", name, "--format", "latex"]).ok()]
    });
    typeset(&directory, &pieces.collect::<Vec<String>>());
}
