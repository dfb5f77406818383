//! `carvallo optimize`: the best design within ranges of its parameters.

use std::cell::OnceCell;
use std::io::IsTerminal as _;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use carvallo_design::number::fixed;
use carvallo_design::{Design, Failure, Place, file};
use carvallo_optimize::{Goal, Measure, Problem, Progress, Range, Settings, optimize};
use carvallo_plot::analysis::Analysis;
use carvallo_plot::analysis::compare::{Compared, Comparison};
use carvallo_plot::data;
use clap::{ArgGroup, Args};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::compare::Pictures;
use crate::destination::Destination;
use crate::limits::SpeedLimits;
use crate::options::{DesignOptions, Format, UnitOptions};
use crate::output::documents;
use crate::terminal::{WARNING, deliver, note, print, write};

const HELP: &str = "\
A MEASURE is stable-range, the width of the widest range of speeds at which it is stable; weave-speed, above which weave is
stable; capsize-speed or divergence-speed, the lowest at which it becomes unstable without an oscillation; flutter-speed or
wobble-speed, the lowest at which it does by one; or the name of a parameter.

--keep takes inequalities between expressions in parameters, and in stable_range, weave_speed, capsize_speed and flutter_speed:
'xB >= 0.2', 'rR + rF <= 0.7*w', 'weave_speed <= 4'. Beside a parameter or a speed alone, a number may have a unit:
'w <= 110 cm'. Without being asked, wheels of bicycles stay 2 cm apart, and bodies whose inertias vary stay rigid bodies:
no principal moment of inertia exceeds the sum of the others.

Names may be those of other conventions, as in `carvallo sweep --vary`: 'head_angle=68 deg:75 deg', trail, d1, … Then everything
else of that convention is held, as it was set or given, and a note says what is kept and what follows.

The search begins at the design, with what --set sets of what may change, and is by sequential quadratic programming from
several designs, of which all others come from a generator with a seed: the same command finds the same design. The derivatives
of speeds are exact. Where no design that was tried has what is measured, it is first searched for one that is stable. The result
lies within its ranges and keeps every inequality exactly; where it lies at an end of a range, that is told.

Examples:
  carvallo optimize --vary 'lam=10 deg:30 deg' --vary c=0.02:0.12 --minimize weave-speed
                                                The head angle and trail with which the benchmark weaves least
  carvallo optimize pista --vary w=0.9:1.2 --vary c=0:0.15 --vary xH=0.7:1.1 --maximize stable-range --speeds 0:10
  carvallo optimize browser --vary w=0.95:1.3 --vary 'lam=10 deg:30 deg' --minimize w --keep 'stable_range >= 1'
                                                The shortest one that is stable over 1 m/s
  carvallo optimize pista --vary c=0:0.1 --minimize weave-speed --output better.toml --plot both.svg

The layout of JSON and CSV is in docs/optimize.md, beside the source of this program.

Exit codes: 0 done; 1 there is no such design, or a file cannot be read or written; 2 wrong usage or input.";

/// The best design within ranges of its parameters
#[derive(Args, Debug)]
#[command(after_help = HELP, group(ArgGroup::new("goal").required(true).args(["maximize", "minimize"])))]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    /// A parameter that may change, and between which values; may be given several times
    #[arg(long, value_name = "NAME=LOW:HIGH", allow_hyphen_values = true, required = true)]
    vary: Vec<String>,
    /// The measure that is to be as large as can be
    #[arg(long, value_name = "MEASURE")]
    maximize: Option<String>,
    /// The measure that is to be as small as can be
    #[arg(long, value_name = "MEASURE")]
    minimize: Option<String>,
    /// What must be kept; may be given several times
    #[arg(long, value_name = "INEQUALITY", allow_hyphen_values = true)]
    keep: Vec<String>,
    /// The speeds that count for stable-range, in m/s [default: 0:20]
    #[arg(long, value_name = "LOW:HIGH")]
    speeds: Option<SpeedLimits>,
    /// From how many designs the search begins
    #[arg(long, value_name = "COUNT", default_value_t = Settings::default().starts)]
    starts: u32,
    /// Of the generator of these designs
    #[arg(long, value_name = "SEED", default_value_t = Settings::default().seed)]
    seed: u64,
    /// Writes the best design as a file of parameters, which can be read again
    #[arg(long, value_name = "FILE.toml")]
    output: Option<Destination>,
    #[command(flatten)]
    pictures: Pictures,
    #[command(flatten)]
    units: UnitOptions,
    /// table, markdown, latex, json or csv
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    check_files(options)?;
    let units = options.units.units();
    let design = options.design.load()?;
    let problem = problem(options, &design)?;
    for text in problem.warnings() {
        note(WARNING, "warning", &text);
    }
    for text in problem.note().into_iter().chain(problem.outside()) {
        note(WARNING, "note", &format!("{}: {text}", design.name));
    }
    let bar = Bar::new();
    let optimum = optimize(&problem, &|progress| {
        bar.tell(progress);
        ControlFlow::Continue(())
    });
    bar.finish();
    let optimum = optimum?;
    let best = optimum.design(&problem)?;
    if let Some(path) = &options.output {
        let text = file::write_in(&best, &|declared| units.of(declared), &str::to_owned);
        deliver(Some(path), |output| output.write_all(text.as_bytes()))?;
    }
    let before = Compared { label: design.title(), analysis: Analysis::new(optimum.given(&problem)?)? };
    let after = Compared { label: best.title(), analysis: Analysis::new(best)? };
    let comparison = Comparison::new(vec![before, after])?;
    options.pictures.draw(&comparison, &units)?;
    let document = || documents::of_optimum(&problem, &optimum, &comparison, &units);
    match options.format {
        Format::Table => print(&document().at_terminal()),
        Format::Document(language) => print(&document().write(language)),
        Format::Json => write(|output| {
            data::optimum::write_json(&problem, &optimum, &comparison.designs[1].analysis, &units, output)
        }),
        Format::Csv => write(|output| data::optimum::write_csv(&problem, &optimum, &units, output)),
    }
}

fn problem<'a>(options: &Options, design: &'a Design) -> Result<Problem<'a>, Failure> {
    let info = design.info();
    let ranges = Range::parse(&options.vary, info)?;
    let goal = [("--maximize", &options.maximize, true), ("--minimize", &options.minimize, false)];
    let Some((option, name, maximize)) =
        goal.into_iter().find_map(|(option, name, maximize)| Some((option, name.as_ref()?, maximize)))
    else {
        return Err(Failure::usage("there is no goal: expected --maximize or --minimize"));
    };
    let place = || Place::Option(format!("{option} {name}"));
    let measure = Measure::called(name, info).map_err(|message| Failure::at(place(), message))?;
    let speeds = options.speeds.map_or(Settings::default().speeds, |SpeedLimits(low, high)| [low, high]);
    let settings = Settings { speeds, starts: options.starts, seed: options.seed };
    Problem::new(design, ranges, Goal { measure, maximize }, &options.keep)?.with(settings)
}

/// Nothing must be written where the parameters are read from, nor twice to one file.
fn check_files(options: &Options) -> Result<(), Failure> {
    let request = options.design.request();
    options.pictures.check(&request)?;
    let Some(path) = &options.output else { return Ok(()) };
    if request.reads(path) {
        return Err(Failure::at(path.place(), "the parameters are read from this file"));
    }
    if !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
        return Err(Failure::at(path.place(), "the name must end in .toml"));
    }
    path.replaces_parameters()
}

/// How far it is, on the standard error if that is a terminal; what is done soon needs no bar.
struct Bar {
    started: Instant,
    bar: OnceCell<ProgressBar>,
}

const SHORT: Duration = Duration::from_millis(500);

impl Bar {
    fn new() -> Self {
        Self { started: Instant::now(), bar: OnceCell::new() }
    }

    fn tell(&self, Progress { done, starts, best }: Progress) {
        if self.started.elapsed() < SHORT || !std::io::stderr().is_terminal() {
            return;
        }
        let bar = self.bar.get_or_init(|| {
            let bar = ProgressBar::with_draw_target(Some(u64::from(starts)), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{wide_bar} {msg}, {pos} of {len} searches");
            style.map_or(bar.clone(), |style| bar.with_style(style))
        });
        let best = best.map_or("none yet".to_owned(), |best| format!("best {}", fixed(best, 6)));
        bar.set_message(best);
        bar.set_position(u64::from(done));
    }

    fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}
