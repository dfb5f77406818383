//! `carvallo transfer`: transfer functions, their frequency responses and margins.

use carvallo_control::Ports;
use carvallo_design::Failure;
use carvallo_plot::analysis::transfer::Transfers;
use carvallo_plot::{data, picture};
use clap::Args;

use crate::frequencies::Given;
use crate::options::{Format, Picture};
use crate::output::documents;
use crate::ports::PortOptions;
use crate::terminal::{print, write};

const HELP: &str = "\
G(s) = k (s - zero) … / (s - pole) … from each input to each output, at one speed. Inputs and outputs are those of
`carvallo statespace`; without --outputs they are the coordinates.

Of several inputs or outputs also what they have together: the transmission zeros of as many outputs as inputs, at which some
direction of inputs is lost, and the singular values, the largest and the smallest gain over all directions.

The phase goes on without jumps from low frequencies. Margins are those of the loop u = -y; where it is stable is told, too.

Examples:
  carvallo transfer --speed 5 --inputs Tdelta --outputs phi
                                                Steer torque to lean of the benchmark bicycle
  carvallo transfer --speed 5 --inputs Tdelta --outputs phi --bode bode.svg --nyquist nyquist.svg
  carvallo transfer --speed 5 --inputs Tdelta,Tphi --outputs phi,delta --sigma sigma.svg
                                                Both torques to lean and steer, together
  carvallo transfer pista --speed 6 --inputs Tdelta --outputs psi_rate,y_acceleration --bode handling.png
  carvallo transfer --speed 5 --inputs Tdelta --frequencies '0.1 Hz:10 Hz' --format csv
                                                The frequency response as a table
  carvallo transfer --model Motorcycle --speed 20 --inputs Tdelta --outputs phi --format json

The layout of JSON and CSV is in docs/control.md, beside the source of this program.

Exit codes: 0 done; 1 there are no equations of motion, or a file cannot be read or written; 2 wrong usage or input.";

/// Transfer functions: poles, zeros, gains, margins, singular values; Bode, Nyquist and sigma plots
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    ports: PortOptions,
    #[arg(
        long,
        value_name = "LOW:HIGH",
        allow_hyphen_values = true,
        help = "The frequencies of responses, in rad/s, or all with Hz behind them; or a list of them [default: all that there is to see]"
    )]
    frequencies: Option<Given>,
    #[arg(
        long,
        value_enum,
        default_value = "table",
        hide_possible_values = true,
        help = "table, markdown, latex or json; or csv, with the frequency response"
    )]
    format: Format,
    /// Draws gain and phase against the frequency; .svg or .png
    #[arg(long, value_name = "FILE")]
    bode: Option<Picture>,
    /// Draws the response in the complex plane; .svg or .png
    #[arg(long, value_name = "FILE")]
    nyquist: Option<Picture>,
    /// Draws the singular values of all transfer functions together against the frequency; .svg or .png
    #[arg(long, value_name = "FILE")]
    sigma: Option<Picture>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    let pictures = [("--bode", &options.bode), ("--nyquist", &options.nyquist), ("--sigma", &options.sigma)];
    for (option, picture) in pictures {
        picture.iter().try_for_each(|picture| picture.check_request(option, &options.ports.design.request()))?;
    }
    let shown = options.ports.units.shown();
    let (design, space) = options.ports.load(Ports::coordinates)?;
    let space = space.in_units(&shown);
    let transfers =
        Transfers::new(&design, &space, options.frequencies.as_ref().map(|Given(frequencies)| frequencies))?;
    if let Some(picture) = &options.bode {
        picture.write(&picture::draw_bode(&transfers))?;
    }
    if let Some(picture) = &options.nyquist {
        picture.write(&picture::draw_nyquist(&transfers))?;
    }
    if let Some(picture) = &options.sigma {
        picture.write(&picture::draw_sigma(&transfers))?;
    }
    match options.format {
        Format::Table => print(&documents::of_transfers(&transfers).at_terminal()),
        Format::Document(language) => print(&documents::of_transfers(&transfers).write(language)),
        Format::Json => write(|output| data::transfer::write_json(&transfers, options.frequencies.is_some(), output)),
        Format::Csv => write(|output| data::transfer::write_csv(&transfers, output)),
    }
}
