//! Motions in time: what is asked for, and from what it is computed.

mod extremes;
mod options;
mod progress;
pub mod times;

use std::ops::ControlFlow;
use std::path::Path;

use carvallo_design::input::{is_folder, is_same_file};
use carvallo_design::quantity::{self, Mistake, Reason};
use carvallo_design::speeds::CONTEXT as SPEED;
use carvallo_design::units::Units;
use carvallo_design::{Design, Failure, Place, Problem};
use carvallo_plot::analysis::simulation::{Given, Linear, Motion, Nonlinear, Solver, read};
use carvallo_plot::{data, picture};

pub use self::options::Options;

use self::progress::Progress;
use crate::options::Format;
use crate::output::{self, documents};
use crate::terminal::{WARNING, deliver, note};

/// Rows of a table for people, and of what is read by programs or drawn.
const COARSE: u32 = 20;
const FINE: u32 = 100;
/// Of a picture.
const DRAWN: u32 = 600;

/// Computes a motion, and tells it.
///
/// # Errors
/// Everything that is wrong with the request; that there is no motion; or that a file cannot be read or written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let format = options.delivery.format()?;
    let default_rows = if format.is_read() { COARSE } else { FINE };
    readable(&options.force)?;
    options.delivery.replaces_result()?;
    let times = times::times(&options.duration, options.step.as_deref(), default_rows);
    let speed = options.speed.as_deref().map(speed).transpose();
    let mut problems = files(options);
    problems.extend(times.as_ref().err().into_iter().flatten().cloned());
    problems.extend(speed.as_ref().err().cloned());
    let design = match options.design.load() {
        Err(Failure::Input(found)) => return Err(Failure::Input([problems, found].concat())),
        design => design?,
    };
    let asked = Asked { design: &design, options, format, is_nonlinear: false, times, speed, problems };
    if options.linear {
        return asked.simulate(&Linear::new(&design));
    }
    let mut done = None;
    let machine = design.with_machine(&mut |machine| {
        let (problems, times, speed) = (asked.problems.clone(), asked.times.clone(), asked.speed.clone());
        let asked = Asked { is_nonlinear: true, problems, times, speed, ..asked };
        done = Some(asked.simulate(&Nonlinear::new(machine)));
    });
    if let Err(without) = machine {
        note(WARNING, "note", &format!("{}; these are the linear ones", design.explain(&without)));
    }
    done.unwrap_or_else(|| asked.simulate(&Linear::new(&design)))
}

/// What was asked for, with what is wrong with it.
struct Asked<'a> {
    design: &'a Design,
    options: &'a Options,
    format: Format,
    is_nonlinear: bool,
    times: Result<Vec<f64>, Vec<Problem>>,
    speed: Result<Option<f64>, Problem>,
    problems: Vec<Problem>,
}

impl Asked<'_> {
    /// Solves the equations of motion, and tells the motion.
    fn simulate(self, solver: &dyn Solver) -> Result<(), Failure> {
        let Self { design, options, format, is_nonlinear, times, speed, mut problems } = self;
        let (Ok(times), Ok(speed), true) = (times, speed, problems.is_empty()) else {
            problems.extend(read(solver, design, &options.initial, &options.force, 0.0).err().into_iter().flatten());
            return Err(Failure::Input(problems));
        };
        let end = times[times.len() - 1];
        let given = read(solver, design, &options.initial, &options.force, end).map_err(Failure::Input)?;
        let mut problems = extremes::problems(solver, &given, speed, &times, is_nonlinear);
        if is_nonlinear {
            problems.extend(times::integrable(&options.duration, end).err());
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        if let Some(picture) = options.plot.as_ref().filter(|_| end == 0.0) {
            return Err(picture.problem("a picture needs a duration above 0"));
        }
        let speed = required_speed(solver, design, speed)?;
        let units = options.units.units();
        let motion = solved(solver, design, &given, speed, &times)?;
        tell(&motion, &units, format, options.delivery.path())?;
        motion.notes.iter().chain(&motion.end).for_each(|text| note(WARNING, "note", text));
        if let Some(picture) = &options.plot {
            // No further than it goes.
            let end = motion.rows.last().map_or(end, |row| row.t);
            let fine: Vec<f64> = (0..=DRAWN).map(|row| end * f64::from(row) / f64::from(DRAWN)).collect();
            let drawn = solved(solver, design, &given, speed, &fine)?;
            let linear = if drawn.is_linear { None } else { beside(&drawn, options, speed, &fine)? };
            picture.write(&picture::draw_motion(&drawn, linear.as_ref(), &units))?;
        }
        Ok(())
    }
}

/// The motion, with a bar for who waits.
fn solved<'a>(
    solver: &dyn Solver,
    design: &'a Design,
    given: &Given,
    speed: f64,
    times: &[f64],
) -> Result<Motion<'a>, Failure> {
    let progress = Progress::new(times[times.len() - 1]);
    let motion = solver.run(design, given, speed, times, &|time| {
        progress.reach(time);
        ControlFlow::Continue(())
    })?;
    progress.finish();
    extremes::within_range(motion)
}

/// The linear motion that is drawn beside a nonlinear one, if it knows all that is given.
fn beside<'a>(
    motion: &Motion<'a>,
    options: &Options,
    speed: f64,
    times: &[f64],
) -> Result<Option<Motion<'a>>, Failure> {
    let linear = Linear::new(motion.design);
    match read(&linear, motion.design, &options.initial, &options.force, times[times.len() - 1]) {
        Ok(given) => linear.run(motion.design, &given, speed, times, &|_| ControlFlow::Continue(())).map(Some),
        Err(problems) => {
            let unknown: Vec<String> = problems.into_iter().map(|problem| problem.place.to_string()).collect();
            let text = format!("the picture has no linear motion, which knows no {}", unknown.join(", "));
            note(WARNING, "note", &text);
            Ok(None)
        }
    }
}

fn tell(motion: &Motion, units: &Units, format: Format, path: Option<&Path>) -> Result<(), Failure> {
    deliver(path, |output| match format {
        Format::Table => output.write_all(output::motion::render_table(motion, units).as_bytes()),
        Format::Document(language) => output.write_all(documents::of_motion(motion, units).write(language).as_bytes()),
        Format::Json => data::motion::write_json(motion, units, output),
        Format::Csv => data::motion::write_csv_in(motion, units, output),
    })
}

/// That files of forces which are there can be read.
fn readable(forces: &[String]) -> Result<(), Failure> {
    let files = forces.iter().filter_map(|force| Some(force.split_once('=')?.1.trim()));
    for file in files.filter(|file| Path::new(file).exists()) {
        if Path::new(file).is_dir() {
            return Err(Failure::usage(is_folder(file)));
        }
        std::fs::read(file).map_err(|error| Failure::Run(format!("cannot read {file}: {error}")))?;
    }
    Ok(())
}

/// Files that would replace each other, or what is read.
fn files(options: &Options) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut problem = |option: String, message: &str| {
        problems.push(Problem { place: Place::Option(option), message: message.to_owned() });
    };
    if let Some(picture) = &options.plot
        && let Err(Failure::Input(found)) = picture.check(&options.design)
    {
        found.into_iter().for_each(|found| problem(found.place.file().to_owned(), &found.message));
    }
    if let Some(path) = options.delivery.path() {
        let option = format!("--output {}", path.display());
        if options.design.request().reads(path) {
            problem(option.clone(), "the parameters are read from this file");
        }
        let read = options.force.iter().filter_map(|force| force.split_once('='));
        if read.into_iter().any(|(_, file)| is_same_file(Path::new(file.trim()), path)) {
            problem(option, "a force is read from this file");
        }
    }
    problems
}

fn speed(text: &str) -> Result<f64, Problem> {
    quantity::number(text.trim(), SPEED).map_err(|Mistake { reason, .. }| {
        let message = match reason {
            Reason::Unit(unit) => format!("`{unit}` is no unit for a speed: it is in m/s, or for example in km/h"),
            Reason::Other(reason) => format!("the speed must be a finite number: {reason}"),
        };
        Problem { place: Place::Option(format!("--speed {text}")), message }
    })
}

/// The speed of what has one.
fn required_speed(solver: &dyn Solver, design: &Design, given: Option<f64>) -> Result<f64, Failure> {
    match (given, solver.takes_speed(design)) {
        (Some(speed), true) => Ok(speed),
        (None, true) if design.model.depends_on_speed() => {
            Err(Failure::usage("expected --speed V, which the motion depends on, such as --speed 4.6"))
        }
        (None, _) => Ok(0.0),
        (Some(_), false) => {
            let model = design.info().name;
            let coordinate = design.info().coordinates.iter().find(|coordinate| coordinate.name == "x");
            let hint = coordinate.map_or("", |_| "; what moves forward is x, whose rate is --initial x_rate=…");
            note(
                WARNING,
                "note",
                &format!("nothing in the model {model} depends on the speed: --speed is ignored{hint}"),
            );
            Ok(0.0)
        }
    }
}
