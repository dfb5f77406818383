//! Motions in time: what is asked for, and from what it is computed.

mod force;
mod initial;
mod linear;
mod motion;
mod options;
mod times;

use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::Path;

pub use self::motion::{Motion, Quantity, Row};
pub use self::options::Options;

use self::linear::Linear;
use crate::design::Design;
use crate::failure::{Failure, Place, Problem};
use crate::input::is_same_file;
use crate::options::Format;
use crate::output;
use crate::quantity::{self, Mistake, Reason};
use crate::speeds::CONTEXT as SPEED;
use crate::terminal::{WARNING, note, print, write, wrote};

/// Rows of a table for people, and of what is read by programs or drawn.
const COARSE: u32 = 20;
const FINE: u32 = 100;

/// Computes a motion, and tells it.
///
/// # Errors
/// Everything that is wrong with the request; that there is no motion; or that a file cannot be read or written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let default_rows = if options.format == Format::Table { COARSE } else { FINE };
    let times = times::times(&options.duration, options.step.as_deref(), default_rows);
    let speed = options.speed.as_deref().map(speed).transpose();
    let mut problems = files(options);
    problems.extend(times.as_ref().err().into_iter().flatten().cloned());
    problems.extend(speed.as_ref().err().cloned());
    let design = match options.design.load() {
        Err(Failure::Input(found)) => return Err(Failure::Input([problems, found].concat())),
        design => design?,
    };
    let linear = Linear::new(&design);
    let (Ok(times), Ok(speed), true) = (times, speed, problems.is_empty()) else {
        problems.extend(linear.read(&design, options, 0.0).err().into_iter().flatten());
        return Err(Failure::Input(problems));
    };
    let given = linear.read(&design, options, times[times.len() - 1]).map_err(Failure::Input)?;
    let speed = required_speed(&design, speed)?;
    if !options.linear {
        let text = format!("the model {} has no nonlinear equations; these are the linear ones", design.info().name);
        note(WARNING, "note", &text);
    }
    let motion = linear.run(design, given, speed, &times)?;
    tell(&motion, options)?;
    if let Some(end) = &motion.end {
        note(WARNING, "note", end);
    }
    Ok(())
}

fn tell(motion: &Motion, options: &Options) -> Result<(), Failure> {
    let Some(path) = &options.output else {
        return match options.format {
            Format::Table => print(&output::motion::render_table(motion)),
            Format::Json => write(|output| output::motion::write_json(motion, output)),
            Format::Csv => write(|output| output::motion::write_csv(motion, output)),
        };
    };
    let fail = |error: std::io::Error| Failure::Run(format!("cannot write {}: {error}", path.display()));
    let mut file = BufWriter::new(File::create(path).map_err(fail)?);
    let written = match options.format {
        Format::Table => {
            file.write_all(anstream::adapter::strip_str(&output::motion::render_table(motion)).to_string().as_bytes())
        }
        Format::Json => output::motion::write_json(motion, &mut file),
        Format::Csv => output::motion::write_csv(motion, &mut file),
    };
    written.and_then(|()| file.flush()).map_err(fail)?;
    wrote(path);
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
    if let Some(path) = &options.output {
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

/// The speed of what depends on it.
fn required_speed(design: &Design, given: Option<f64>) -> Result<f64, Failure> {
    match (given, design.model.depends_on_speed()) {
        (Some(speed), true) => Ok(speed),
        (None, true) => Err(Failure::usage("expected --speed V, which the motion depends on, such as --speed 4.6")),
        (None, false) => Ok(0.0),
        (Some(_), false) => {
            let text = format!("nothing in the model {} depends on the speed: --speed is ignored", design.info().name);
            note(WARNING, "note", &text);
            Ok(0.0)
        }
    }
}
