//! `carvallo sensitivity`: what the critical speeds of one design depend on.

use carvallo_design::Failure;
use carvallo_plot::analysis::sensitivity::Changes;
use carvallo_plot::{data, picture};
use clap::Args;

use crate::options::{DesignOptions, Format, Picture, UnitOptions};
use crate::output::{self, documents};
use crate::terminal::{WARNING, note, print, write};

const HELP: &str = "\
Ranks the parameters by how much 1 % of each changes the weave and capsize speeds (m/s), with the derivatives beside it
(m/s per unit of the parameter). They are exact derivatives, not differences. 1 % is of the value, with its sign: 1 % more
of zB = -0.9 m is -0.009 m, which is higher up. A parameter that is 0 is changed by 1 % of the median size of the others in
its unit, or of a radian, and marked *.

Standard deviations of parameters, where the file has them, propagate to first order to every critical speed and matrix
entry, with the shares of the variance that come from each parameter.

DESIGN and MODEL are as for `carvallo analyze`. Of other models than bicycles and motorcycles flutter and divergence speeds
are ranked, and double roots at which stability changes. Of a file with matrices each entry is a parameter. JSON and CSV
have all critical speeds; their layout is in docs/sensitivity.md, beside the source of this program.

Examples:
  carvallo sensitivity                          The benchmark bicycle
  carvallo sensitivity browser --plot browser.png
                                                A measured bicycle, with deviations in the table, and a
                                                bar chart of the effects of 1 %
  carvallo sensitivity --set c=0                Without trail
  carvallo sensitivity --units km/h,mm,deg      In other units
  carvallo sensitivity my-bike.toml --format csv
  carvallo sensitivity --model CarTrailer       When a caravan snakes

Exit codes: 0 done; 1 there is no answer, or a file cannot be read or written; 2 wrong usage or input.";

/// Which parameters the weave and capsize speeds depend on most
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    #[command(flatten)]
    units: UnitOptions,
    /// table, markdown, latex, json or csv
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
    /// Draws the effects as a bar chart; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    if let Some(picture) = &options.plot {
        picture.check(&options.design)?;
    }
    let units = options.units.units();
    let shown = Box::new(move |declared: &str| units.of(declared));
    let changes = Changes { shown, ..Changes::new(options.design.load()?)? };
    if !changes.design.model.depends_on_speed() {
        let model = changes.design.info().name;
        note(
            WARNING,
            "note",
            &format!(
                "nothing in the model {model} depends on the speed, so that there are no critical speeds to rank by; what a \
                 parameter does to the eigenvalues is in `carvallo analyze --model {model} --along NAME=LOW:HIGH`"
            ),
        );
    }
    if let Some(picture) = &options.plot {
        let nothing = || {
            let title = changes.design.title();
            Failure::Run(format!("{title} has neither a weave nor a capsize speed, so there is no chart to draw"))
        };
        picture.write(&picture::draw_tornado(&changes).ok_or_else(nothing)?)?;
    }
    match options.format {
        Format::Table => print(&output::sensitivity::render_table(&changes)),
        Format::Document(language) => print(&documents::of_sensitivity(&changes).write(language)),
        Format::Json => write(|output| data::sensitivity::write_json(&changes, output)),
        Format::Csv => write(|output| data::sensitivity::write_csv(&changes, output)),
    }
}
