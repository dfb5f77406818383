//! `carvallo controllability`: which modes inputs excite and outputs show, along the speed.

use carvallo_control::Ports;
use carvallo_design::Failure;
use carvallo_plot::analysis::controllability::{Controllability, drawn};
use carvallo_plot::analysis::{Analysis, reach};
use carvallo_plot::{data, picture};
use clap::Args;

use crate::options::{DesignOptions, Format, Picture, Speeds, UnitOptions};
use crate::output::documents;
use crate::ports::PortNames;
use crate::terminal::{print, write};

const HELP: &str = "\
Of each mode, how much of it an input excites and an output shows: the cosines of the angles between its left eigenvector
and the column of B, and between its right eigenvector and the row of C, from 0, where the mode is out of reach or out of
sight, to 1. Inputs and outputs are those of `carvallo statespace`; without --outputs they are the coordinates.

The speeds at which a mode that does not oscillate is lost to an input or an output are told to all digits, up to the largest
of --speeds. An oscillation is lost at no single speed but by chance; where one hardly is, its cosine shows.

Examples:
  carvallo controllability                      The benchmark bicycle along the speed
  carvallo controllability --inputs Tdelta --outputs phi_rate --plot c.svg
  carvallo controllability pista --speeds 5 --inputs Tdelta
  carvallo controllability --speeds 0.1:8:0.1 --format csv

The layout of JSON and CSV is in docs/control.md, beside the source of this program.

Exit codes: 0 done; 1 there is no answer, or a file cannot be read or written; 2 wrong usage or input.";

/// Which modes inputs excite and outputs show, along the speed
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    #[command(flatten)]
    names: PortNames,
    #[command(flatten)]
    units: UnitOptions,
    #[arg(
        long,
        alias = "speed",
        value_name = "SPEEDS",
        allow_hyphen_values = true,
        help = "In m/s: LOW:HIGH:STEP, a list, or one [default: 0 to 10, or as far as there are critical speeds]"
    )]
    speeds: Option<Speeds>,
    /// table, markdown, latex, json or csv
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
    /// Draws the cosines against the speed; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    if let Some(picture) = &options.plot {
        picture.check(&options.design)?;
    }
    let design = options.design.load()?;
    let (inputs, outputs) = options.names.ports(&design, Ports::coordinates)?;
    let mut analysis = Analysis::new(design)?;
    analysis.unit = options.units.of_speeds();
    let speeds = match &options.speeds {
        Some(Speeds(speeds)) => speeds.clone(),
        None => reach::speeds(analysis.reach, options.format.is_read()),
    };
    let (least, most) = speeds.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(*v), high.max(*v)));
    let controllability = Controllability::new(analysis, inputs, outputs);
    let rows = controllability.rows(&speeds)?;
    let lost = controllability.lost(most)?;
    if let Some(picture) = &options.plot {
        let model = controllability.analysis.design.model;
        if !model.depends_on_speed() {
            let nothing = format!("nothing in the model {} depends on the speed", model.info.name);
            return Err(picture.problem(format!("{nothing}, so there is no graph against it")));
        }
        if least == most {
            return Err(picture.problem("a picture needs a range of speeds, such as --speeds 0:10:0.1"));
        }
        let drawn = controllability.rows(&drawn(least, most, &lost))?;
        picture.write(&picture::draw_controllability(&controllability, &drawn))?;
    }
    match options.format {
        Format::Table => print(&documents::of_controllability(&controllability, &lost, most, &rows).at_terminal()),
        Format::Document(language) => {
            print(&documents::of_controllability(&controllability, &lost, most, &rows).write(language))
        }
        Format::Json => write(|output| data::controllability::write_json(&controllability, &lost, &rows, output)),
        Format::Csv => write(|output| data::controllability::write_csv(&controllability, &rows, output)),
    }
}
