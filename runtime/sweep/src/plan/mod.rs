//! What a sweep does: the request, validated as a whole.

mod fingerprint;
mod slips;
mod validate;

pub(crate) use self::validate::validate;

use carvallo_design::conventions::{Varied, Varying};
use carvallo_design::{Design, DisplayUnit, Failure, Place, Problem};

use self::fingerprint::fingerprint;
use self::validate::Validated;
use super::evaluate::Task;
use super::generate::{Generator, Together};
use super::read::File;
use super::request::Request;
use super::source::Source;
use super::table::{Format, Heading, Layout, shown_in};

/// More designs than this are taken for a slip in a step.
const MAX_DESIGNS: u64 = 1_000_000_000_000;

/// The designs between two points at which a sweep can go on: of a small sweep few, of a large one more.
const BATCH: (u64, u64) = (4096, 65_536);

/// The last column of the result.
pub(crate) const ERROR: &str = "error";

/// Everything that determines the result of a sweep.
pub struct Plan {
    pub(crate) task: Task,
    pub(crate) source: Source,
    /// The columns of the result: those of the designs, those of the results, and that of the errors.
    pub(crate) headings: Vec<Heading>,
    /// For each what its numbers are written in, where that is another unit.
    pub(crate) shown: Vec<Option<DisplayUnit>>,
    pub(crate) format: Format,
    /// The number of designs that are computed and written at once.
    pub(crate) batch: usize,
    /// Differs for sweeps with different results.
    pub(crate) fingerprint: u64,
    warnings: Vec<String>,
}

impl Plan {
    /// What its parameters seem to be in that is not their unit, of each column once.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// What is to be known of what varies, and of the columns of a file.
    pub fn notes(&self) -> Vec<String> {
        let of_file = match &self.source {
            Source::File(file) => file.notes.clone(),
            Source::Generated(_) => Vec::new(),
        };
        of_file.into_iter().chain(self.task.varied.note()).collect()
    }

    /// What is asked for of a design.
    ///
    /// # Errors
    /// Everything that is wrong with the request.
    pub fn new(design: &Design, request: &Request) -> Result<Self, Failure> {
        let info = design.info();
        let Validated { mut naming, vary, random, is_measured, speeds, format, file } =
            validate(request, design.model)?;
        let source = match file {
            Some((path, format)) => {
                let file = File::open(&path, format, info)?;
                once(request, &file)?;
                naming = file.naming.clone();
                Source::File(file)
            }
            None => {
                let varied = vary.iter().map(|axis| &axis.parameter);
                let others: Vec<&Varying> = varied.chain(random.iter().map(|random| &random.parameter)).collect();
                if let (true, Some(convention)) = (is_measured, naming.convention()) {
                    let message = format!(
                        "what was measured are parameters of the paper, which would replace what follows from {}: \
                         beside it only the paper's can vary",
                        convention.title
                    );
                    return Err(Failure::at(Place::Option("--random measured".to_owned()), message));
                }
                let together = is_measured.then(|| Together::new(design, &others)).transpose()?;
                let (samples, seed) = (request.samples.unwrap_or(1), request.seed.unwrap_or_default());
                Source::Generated(Generator { vary, random, together, samples, seed })
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
        let (mut headings, parameters) = source.headings(design);
        let layout = Layout::new(design.model, speeds);
        let parameters: Vec<Option<&Varying>> = parameters.iter().map(Option::as_ref).collect();
        let fail = |message: String| Failure::usage(format!("{}: {message}", design.title()));
        let varied = Varied::new(design, &naming, &parameters).map_err(fail)?;
        match &source {
            Source::Generated(_) => {
                if let Some(message) = varied.conflict().or_else(|| varied.fixed()) {
                    return Err(Failure::usage(message));
                }
            }
            // Rows may well have both of what follows from each other, if they agree.
            Source::File(file) => {
                if let Some(message) = varied.contradiction() {
                    return Err(Failure::at(Place::File(file.path.display().to_string()), message));
                }
            }
        }
        let warnings = slips::warnings(design, &source, &parameters, &varied)?;
        let task = Task { model: design.model, base: design.values(), varied, layout };
        headings.extend(task.layout.headings());
        headings.push(Heading::text(ERROR));
        let shown = headings.iter_mut().map(|heading| shown_in(heading, &request.units)).collect();
        let fingerprint = fingerprint(design, &source, &headings, format)?;
        Ok(Self { task, source, headings, shown, format, batch: batch as usize, fingerprint, warnings })
    }
}

/// Whether each parameter has its value from one place.
fn once(request: &Request, file: &File) -> Result<(), Failure> {
    let is_twice = |name: &str| {
        let own = file.naming.find(name).ok();
        let is_own = |other: &Varying| own.as_ref().is_some_and(|own| own.is(other));
        file.columns.iter().any(|column| column.name == name || column.parameter.as_ref().is_some_and(is_own))
    };
    let base = &request.base;
    let twice = base.overrides.iter().filter(|(_, name, _)| is_twice(name));
    let problem = |(option, name, _): &(String, String, String)| {
        let message = format!("`{name}` is given twice; also by a column of {}", file.path.display());
        Problem { place: Place::Option(option.clone()), message }
    };
    let problems: Vec<Problem> = twice.map(problem).collect();
    if problems.is_empty() { Ok(()) } else { Err(Failure::Input(problems)) }
}
