//! `carvallo lqr`: gains of a linear quadratic regulator, scheduled along speeds.

use carvallo_control::{Code, Ports, Schedule, Weights};
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure, Place};
use carvallo_plot::data;
use clap::{Args, ValueEnum};

use crate::delivery::Delivery;
use crate::options::{DesignOptions, Format, Speeds, UnitOptions};
use crate::output::documents;
use crate::ports;
use crate::terminal::{WARNING, deliver, note};

const HELP: &str = "\
The gains K of u = -K x that keep the integral of the weighted squares of outputs and inputs as small as it can be, at each
speed: the linear quadratic regulator. Inputs u and states x are those of `carvallo statespace`.

--weight NAME=VALUE is that of the square of a position or rate (phi, delta_rate, in words lean), or of an input by the name of
its force (Tdelta), each in SI units. Without one for an output, every state has the weight 1; with one, the others have none. An
input that is not named has 1. A weight on the yaw psi or the lateral place y of a bicycle makes it go straight, or stay on its
line.

--sensitivity tells what 1 % of each parameter changes about each gain, by the exact derivatives, which are in the JSON.

--emit writes a module of Rust without the standard library, or C99: the gains as a table, interpolated linearly along the speed,
and those at its ends beyond. A note says between which speeds the interpolated gains do not hold the machine.

Examples:
  carvallo lqr --inputs Tdelta --speeds 1:8:0.5 Steered at each of these speeds
  carvallo lqr --inputs Tdelta --speeds 1:8:0.5 --weight phi=10 --weight delta_rate=0.1 --weight Tdelta=0.5
  carvallo lqr --inputs Tdelta --speeds 2:10:1 --weight y=1 --format json
                                                To stay on a line
  carvallo lqr --inputs Tdelta --speeds 4 --sensitivity
                                                What each parameter changes about the gains
  carvallo lqr --inputs Tdelta --speeds 1:8:0.5 --emit c --output regulator.c
  carvallo lqr --model DoublePendulum --inputs Ttheta1

The layout of JSON and CSV is in docs/control.md, beside the source of this program.

Exit codes: 0 done; 1 no gains stabilize it, or a file cannot be read or written; 2 wrong usage or input.";

/// The gains of a linear quadratic regulator along the speed, also as Rust and C
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    #[command(flatten)]
    units: UnitOptions,
    #[arg(
        long,
        value_name = "NAMES",
        alias = "input",
        value_delimiter = ',',
        help = "Forces and torques that it sets, such as Tdelta [default: all]"
    )]
    inputs: Vec<String>,
    #[arg(
        long,
        value_name = "SPEEDS",
        alias = "speed",
        allow_hyphen_values = true,
        help = "In m/s: LOW:HIGH:STEP, a list, or one"
    )]
    speeds: Option<Speeds>,
    /// Of an output or an input; may be given several times [default: 1 for each state and each input]
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    weight: Vec<String>,
    #[command(flatten)]
    delivery: Delivery,
    /// Source text with the gains in the place of a table: rust or c
    #[arg(long, value_name = "LANGUAGE", hide_possible_values = true, conflicts_with = "format")]
    emit: Option<Language>,
    /// Tells also what each parameter changes about the gains; with table, markdown, latex or json
    #[arg(long, conflicts_with = "emit")]
    sensitivity: bool,
}

/// A language of source text.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Language {
    Rust,
    C,
}

impl Language {
    /// That a file which is named has an ending of the language.
    fn ends(self, delivery: &Delivery) -> Result<(), Failure> {
        let (endings, words) = match self {
            Self::Rust => (&["rs"][..], ".rs"),
            Self::C => (&["c", "h"][..], ".c or .h"),
        };
        let Some(path) = delivery.path() else { return Ok(()) };
        match path.extension().and_then(|ending| ending.to_str()) {
            Some(ending) if endings.iter().any(|own| ending.eq_ignore_ascii_case(own)) => Ok(()),
            _ => Err(delivery.problem(&format!("the name of this source text must end in {words}"))),
        }
    }
}

pub fn run(options: &Options) -> Result<(), Failure> {
    let path = options.delivery.path();
    if path.is_some_and(|path| options.design.request().reads(path)) {
        return Err(options.delivery.problem("the parameters are read from this file"));
    }
    let format = match options.emit {
        Some(language) => {
            language.ends(&options.delivery)?;
            options.delivery.replaces_source()?;
            Ok(Format::Table)
        }
        None => {
            options.delivery.replaces_result()?;
            table(&options.delivery)
        }
    }?;
    let shown = options.units.shown();
    if options.emit.is_some() && !options.units.units().is_si() {
        return Err(Failure::at(Place::Option("--units".to_owned()), "with --emit all is in units of the SI"));
    }
    let design = options.design.load()?;
    let ports = Ports::of(&design);
    let inputs = ports::inputs(&ports, &options.inputs)?;
    let weights = Weights::read(&options.weight, &ports, &inputs)?;
    let schedule = Schedule::new(&design, &speeds(options, &design)?, &weights)?;
    let unit = shown("m/s");
    for [from, to] in &schedule.unstable {
        let ([from, to], unit) = ([*from, *to].map(|speed| shortest(unit.value(speed))), unit.unit());
        let text = format!(
            "between {from} and {to} {unit} the interpolated gains do not hold it: more speeds are needed there"
        );
        note(WARNING, "note", &text);
    }
    if options.sensitivity && format == Format::Csv {
        let place = Place::Option("--sensitivity".to_owned());
        return Err(Failure::at(place, "CSV has no place for it; table, markdown, latex and json have"));
    }
    let mut sensitivities = options.sensitivity.then(|| schedule.sensitivities(&design, &weights)).transpose()?;
    for (regulator, by_parameter) in schedule.regulators.iter().zip(sensitivities.iter_mut().flatten()) {
        by_parameter.iter_mut().for_each(|gains| *gains = regulator.gains_in_units(gains, &shown));
    }
    let (sensitivities, schedule) = (sensitivities.as_deref(), schedule.in_units(&shown));
    let text = match (options.emit, format) {
        (Some(Language::Rust), _) => schedule.code(Code::Rust, &design, &weights),
        (Some(Language::C), _) => schedule.code(Code::C, &design, &weights),
        (None, Format::Json) => {
            return deliver(path, |output| {
                data::schedule::write_json(&design, &schedule, &weights, sensitivities, output)
            });
        }
        (None, Format::Csv) => return deliver(path, |output| data::schedule::write_csv(&schedule, output)),
        (None, Format::Document(language)) => documents::of_schedule(&design, &schedule, sensitivities).write(language),
        (None, Format::Table) => documents::of_schedule(&design, &schedule, sensitivities).at_terminal(),
    };
    deliver(path, |output| output.write_all(text.as_bytes()))
}

/// The format of what is no source text.
fn table(delivery: &Delivery) -> Result<Format, Failure> {
    let ending = delivery.path().and_then(|path| path.extension()?.to_str()).unwrap_or_default();
    match [("rust", "rs"), ("c", "c"), ("c", "h")].iter().find(|(_, own)| ending.eq_ignore_ascii_case(own)) {
        Some((language, _)) => Err(delivery.problem(&format!("for source text write --emit {language}, too"))),
        None => delivery.format(),
    }
}

/// The speeds of what has one.
fn speeds(options: &Options, design: &Design) -> Result<Vec<f64>, Failure> {
    match (&options.speeds, design.model.depends_on_speed()) {
        (Some(Speeds(speeds)), true) => Ok(speeds.clone()),
        (None, true) => {
            Err(Failure::usage("expected --speeds, which the equations of motion depend on, such as --speeds 1:8:0.5"))
        }
        (None, false) => Ok(vec![0.0]),
        (Some(_), false) => {
            let model = design.info().name;
            note(WARNING, "note", &format!("nothing in the model {model} depends on the speed: --speeds is ignored"));
            Ok(vec![0.0])
        }
    }
}
