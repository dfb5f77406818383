//! What each subcommand does.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anstyle::Style;
use carvallo_models::BICYCLES;

use crate::analysis::Analysis;
use crate::args::{self, Command, Format};
use crate::design::Design;
use crate::failure::Failure;
use crate::input::{self, DEFAULT_BICYCLE, Request};
use crate::sensitivity::Changes;
use crate::terminal::{ERROR, WARNING, note, print};
use crate::{model, output, plot, speeds, sweep};

/// The speeds of tables, and of everything that is read by programs or drawn.
const COARSE: &str = "0:10:1";
const FINE: &str = "0:10:0.1";

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    match args::parse(std::env::args_os()).and_then(run) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            note(ERROR, "error", &failure.to_string());
            failure.exit_code()
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Demo => demo(),
        Command::Analyze { request, speeds, format, plot } => analyze(&request, speeds, format, plot.as_deref()),
        Command::Bicycles => bicycles(),
        Command::Models => print(&output::models(model::MODELS)),
        Command::Sensitivity { request, format, plot } => sensitivity(&request, format, plot.as_deref()),
        Command::Show { request, plot } => show(&request, plot.as_deref()),
        Command::Sweep(request) => sweep::run(load(&request.base), &request),
    }
}

/// The benchmark bicycle and its picture, and how to go on.
fn demo() -> Result<(), Failure> {
    let analysis = Analysis::new(load(&Request::default())?)?;
    let rows = analysis.rows(&default_speeds(COARSE)?)?;
    let mut text = output::table(&analysis, &rows);
    text.push('\n');
    text.push_str(&output::sketch(&analysis, 10.0)?);
    let path = picture_directory().map(|directory| directory.join(format!("{DEFAULT_BICYCLE}.svg")));
    // Nobody asked for the picture, so that what keeps it from being written is no failure.
    match path.filter(|path| save_eigenvalues(&analysis, &[0.0, 10.0], path).is_ok()) {
        Some(path) => {
            let here = std::env::current_dir().unwrap_or_default();
            let path = path.strip_prefix(here).unwrap_or(&path);
            text.push_str(&format!("\nPicture: {}\nMore:    cargo run --release -- --help\n", path.display()));
        }
        None => text.push_str("\nPicture: carvallo analyze --plot benchmark.svg\nMore:    carvallo --help\n"),
    }
    print(&text)
}

/// Where cargo keeps what it builds, if the program runs from there. Elsewhere nothing is written unasked.
fn picture_directory() -> Option<PathBuf> {
    let executable = std::env::current_exe().ok()?;
    let target = executable.parent()?.parent()?;
    let directory = target.join("carvallo");
    (target.join("CACHEDIR.TAG").exists() && std::fs::create_dir_all(&directory).is_ok()).then_some(directory)
}

fn analyze(request: &Request, speeds: Option<Vec<f64>>, format: Format, plot: Option<&Path>) -> Result<(), Failure> {
    let analysis = Analysis::new(load(request)?)?;
    let model = analysis.design.model;
    if !model.depends_on_speed() {
        let nothing = format!("nothing in the model {} depends on the speed", model.info.name);
        if let Some(path) = plot {
            let path = path.display();
            return Err(Failure::usage(format!("--plot {path}: {nothing}, so there is no graph against it")));
        }
        if speeds.is_some() {
            note(WARNING, "note", &format!("{nothing}: --speeds is ignored"));
        }
    }
    let speeds_or = |default| speeds.clone().map_or_else(|| default_speeds(default), Ok);
    let rows = analysis.rows(&speeds_or(if format == Format::Table { COARSE } else { FINE })?)?;
    let text = match format {
        Format::Table => output::table(&analysis, &rows),
        Format::Json => output::json(&analysis, &rows),
        Format::Csv => output::csv(&analysis, &rows),
    };
    if let Some(path) = plot {
        save_eigenvalues(&analysis, &speeds_or(FINE)?, path)?;
        note(Style::new(), "wrote", &path.display().to_string());
    }
    print(&text)
}

fn sensitivity(request: &Request, format: Format, plot: Option<&Path>) -> Result<(), Failure> {
    let changes = Changes::new(load(request)?)?;
    if let Some(path) = plot {
        let nothing = || {
            let title = changes.design.title();
            Failure::Run(format!("{title} has neither a weave nor a capsize speed, so there is no chart to draw"))
        };
        plot::save(&plot::tornado(&changes).ok_or_else(nothing)?, path)?;
        note(Style::new(), "wrote", &path.display().to_string());
    }
    print(&match format {
        Format::Table => output::sensitivity::table(&changes),
        Format::Json => output::sensitivity::json(&changes),
        Format::Csv => output::sensitivity::csv(&changes),
    })
}

fn bicycles() -> Result<(), Failure> {
    let analyses = BICYCLES.iter().map(|bicycle| {
        let request = Request { parameters: Some(bicycle.name.to_owned()), ..Request::default() };
        input::load(&request).and_then(Analysis::new)
    });
    print(&output::list(&analyses.collect::<Result<Vec<_>, _>>()?))
}

fn show(request: &Request, plot: Option<&Path>) -> Result<(), Failure> {
    let design = load(request)?;
    if let Some(path) = plot {
        let no_view = || Failure::Run(format!("the model {} has no side view", design.info().name));
        plot::save(&plot::side_view(&design).ok_or_else(no_view)?, path)?;
        note(Style::new(), "wrote", &path.display().to_string());
    }
    print(&output::parameters(&design))
}

fn default_speeds(text: &str) -> Result<Vec<f64>, Failure> {
    speeds::parse(text).map_err(Failure::usage)
}

/// Loads a design, and tells what deserves to be known about its parameters.
fn load(request: &Request) -> Result<Design, Failure> {
    let design = input::load(request)?;
    for text in &design.notes {
        note(WARNING, "note", text);
    }
    for text in input::warnings(design.info(), &design.values()) {
        note(WARNING, "warning", &format!("{}: {text}", design.name));
    }
    Ok(design)
}

fn save_eigenvalues(analysis: &Analysis, speeds: &[f64], path: &Path) -> Result<(), Failure> {
    let low = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    let high = speeds.iter().copied().fold(0.0, f64::max);
    plot::save(&plot::eigenvalues(analysis, (low, high))?, path)
}
