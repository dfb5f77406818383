//! What a sweep does: the request, judged as a whole.

use super::args::Request;
use super::columns::Heading;
use super::definition::definition;
use super::evaluate::{self, Task};
use super::generate::Generator;
use super::judge::{Judged, judge};
use super::layout::Layout;
use super::read::File;
use super::write::Format;
use crate::failure::{Failure, Place, Problem};
use crate::input::Design;

/// More designs than this are taken for a slip in a step.
const MAX_DESIGNS: u64 = 1_000_000_000_000;

/// The designs between two points at which a sweep can go on: of a small sweep few, of a large one more.
const BATCH: (u64, u64) = (4096, 65_536);

/// Everything that determines the result.
pub struct Plan {
    pub task: Task,
    pub source: Source,
    /// The columns of the result: those of the designs, those of the results, and that of the errors.
    pub headings: Vec<Heading>,
    pub format: Format,
    /// The number of designs that are computed and written at once.
    pub batch: usize,
    /// Differs for sweeps with different results.
    pub definition: u64,
}

/// Where the designs come from.
pub enum Source {
    Generated(Generator),
    File(File),
}

impl Plan {
    /// # Errors
    /// Everything that is wrong with the request.
    pub fn new(design: &Design, request: &Request) -> Result<Self, Failure> {
        let info = design.info();
        let Judged { vary, random, speeds, format, file } = judge(request, info)?;
        let source = match file {
            Some((path, format)) => {
                let file = File::open(&path, format, info)?;
                once(request, &file)?;
                Source::File(file)
            }
            None => {
                let samples = request.samples.unwrap_or(1);
                Source::Generated(Generator { vary, random, samples, seed: request.seed.unwrap_or_default() })
            }
        };
        let batch = match &source {
            Source::File(_) => BATCH.0,
            Source::Generated(generator) => match generator.total().filter(|total| *total <= MAX_DESIGNS) {
                Some(total) => (total / 64).clamp(BATCH.0, BATCH.1),
                None => {
                    let options = "--vary, --random and --samples";
                    return Err(Failure::usage(format!(
                        "{options} make too many designs; there must be at most {MAX_DESIGNS}"
                    )));
                }
            },
        };
        let evaluate = evaluate::of(design.model)
            .ok_or_else(|| Failure::usage(format!("the model {} cannot be swept", info.name)))?;
        let (mut headings, positions) = source.headings(design);
        let task = Task { base: design.values(), positions, layout: Layout::new(info, speeds), evaluate };
        headings.extend(task.layout.headings());
        headings.push(Heading::text("error"));
        let definition = definition(design, &source, &headings, format)?;
        Ok(Self { task, source, headings, format, batch: batch as usize, definition })
    }
}

/// Whether each parameter has its value from one place.
fn once(request: &Request, file: &File) -> Result<(), Failure> {
    let is_twice = |name: &str| file.columns.iter().any(|(column, _)| column == name);
    let twice = request.base.overrides.iter().filter(|(_, name, _)| is_twice(name));
    let problem = |(option, name, _): &(String, String, String)| {
        let message = format!("`{name}` is given twice; also by a column of {}", file.path.display());
        Problem { place: Place::Option(option.clone()), message }
    };
    let problems: Vec<Problem> = twice.map(problem).collect();
    if problems.is_empty() { Ok(()) } else { Err(Failure::Input(problems)) }
}

impl Source {
    /// The columns of the designs, and for each the position of its parameter, if it is one.
    fn headings(&self, design: &Design) -> (Vec<Heading>, Vec<Option<usize>>) {
        let parameter = |position: usize| {
            let parameter = &design.info().parameters[position];
            Heading::number(parameter.name, parameter.unit)
        };
        match self {
            Self::Generated(generator) => generator.positions().map(|at| (parameter(at), Some(at))).unzip(),
            Self::File(file) => {
                let heading = |(name, position): &(String, Option<usize>)| match position {
                    Some(position) => (parameter(*position), Some(*position)),
                    None => (Heading::text(name.clone()), None),
                };
                file.columns.iter().map(heading).unzip()
            }
        }
    }
}
