//! `carvallo respond`: responses to steps, impulses and initial states.

use carvallo_control::{Ports, StateSpace};
use carvallo_design::{Design, Failure, Place};
use carvallo_plot::analysis::excitation::Excitation;
use carvallo_plot::analysis::response::Responses;
use carvallo_plot::{data, picture};
use clap::Args;

use crate::options::{Format, Picture};
use crate::output::documents;
use crate::ports::PortOptions;
use crate::simulate::times::times;
use crate::terminal::{WARNING, note, print, write};

/// Rows of a table for people, and of what is read by programs or drawn.
const COARSE: u32 = 20;
const FINE: u32 = 200;
const DRAWN: u32 = 800;

const HELP: &str = "\
The linearized motion at one speed, solved exactly by the matrix exponential. Inputs and outputs are those of
`carvallo statespace`; without --outputs they are the coordinates. For forces that change in time, and for the nonlinear
equations, see `carvallo simulate`.

Examples:
  carvallo respond --speed 5 --input Tdelta --step --plot step.svg
                                                What a steady torque of 1 N m does
  carvallo respond --speed 5 --input Tdelta --impulse=0.5 --outputs phi,delta,psi --duration 3
  carvallo respond --speed 5 --initial phi_rate=0.5 --outputs phi,delta --duration 5 --plot r.svg
  carvallo respond pista --speed 6 --input Tdelta --step='2 N m' --outputs psi_rate --format csv

The layout of JSON and CSV is in docs/control.md, beside the source of this program.

Exit codes: 0 done, also where the response ended early, which is told; 1 there is none, or a file cannot be read or written;
2 wrong usage or input.";

/// Responses to a step, an impulse or an initial state
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    ports: PortOptions,
    #[arg(
        long,
        value_name = "SIZE",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "1",
        conflicts_with_all = ["impulse", "initial"],
        help = "The input is so large from time zero on [default: 1]"
    )]
    step: Option<String>,
    #[arg(
        long,
        value_name = "SIZE",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "1",
        conflicts_with = "initial",
        help = "An impulse of the input, by its integral over time [default: 1]"
    )]
    impulse: Option<String>,
    /// A state at time zero; may be given several times
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    initial: Vec<String>,
    /// How long, in s
    #[arg(long, value_name = "T", default_value = "5", allow_hyphen_values = true)]
    duration: String,
    /// table, markdown, latex, json or csv
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
    /// Draws the outputs against time; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    sizes_are_attached(options)?;
    if let Some(picture) = &options.plot {
        picture.check(&options.ports.design)?;
    }
    let rows = if options.format.is_read() { COARSE } else { FINE };
    let moments = times(&options.duration, None, rows).map_err(Failure::Input)?;
    let shown = options.ports.units.shown();
    let (design, space) = options.ports.load(Ports::coordinates)?;
    let excitation = excitation(options, &design, &space)?.in_units(&space, &shown);
    let space = space.in_units(&shown);
    let responses = Responses::new(&design, &space, excitation.clone(), &moments)?;
    if let Some(picture) = &options.plot {
        if moments.len() == 1 {
            return Err(picture.problem("a picture needs a duration above 0"));
        }
        let end = responses.response.times.last().copied().unwrap_or(0.0);
        let fine: Vec<f64> = (0..=DRAWN).map(|row| end * f64::from(row) / f64::from(DRAWN)).collect();
        picture.write(&picture::draw_response(&Responses::new(&design, &space, excitation, &fine)?))?;
    }
    match options.format {
        Format::Table => print(&documents::of_responses(&responses).at_terminal()),
        Format::Document(language) => print(&documents::of_responses(&responses).write(language)),
        Format::Json => write(|output| data::response::write_json(&responses, output)),
        Format::Csv => write(|output| data::response::write_csv(&responses, output)),
    }?;
    let doubts = Excitation::doubts(&options.initial, &design);
    responses.end.iter().chain(&doubts).for_each(|text| note(WARNING, "note", text));
    Ok(())
}

/// That no size stands where the design does: `--step 2`.
fn sizes_are_attached(options: &Options) -> Result<(), Failure> {
    let request = options.ports.design.request();
    let number = request.parameters.filter(|name| name.parse::<f64>().is_ok());
    let given = |size: &Option<String>| size.as_deref() == Some("1");
    let option = [("--step", &options.step), ("--impulse", &options.impulse)].into_iter().find(|(_, size)| given(size));
    match (option, number) {
        (Some((option, _)), Some(number)) => {
            let message = format!("its size stands behind an equals sign: {option}={number}");
            Err(Failure::at(Place::Option(format!("{option} {number}")), message))
        }
        _ => Ok(()),
    }
}

/// What is asked for.
fn excitation(options: &Options, design: &Design, space: &StateSpace) -> Result<Excitation, Failure> {
    match (&options.step, &options.impulse) {
        (Some(size), _) => Excitation::step(size, space),
        (None, Some(size)) => Excitation::impulse(size, space),
        (None, None) if options.initial.is_empty() => {
            Err(Failure::usage("expected --step, --impulse or --initial NAME=VALUE, such as --initial phi_rate=0.5"))
        }
        (None, None) => Excitation::initial(&options.initial, design, space),
    }
}
