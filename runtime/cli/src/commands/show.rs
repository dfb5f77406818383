//! `carvallo show`: the parameters of one design.

use carvallo_design::Failure;
use carvallo_plot::picture;
use clap::Args;

use crate::options::{DesignOptions, Picture, UnitOptions};
use crate::output;
use crate::terminal::{WARNING, note, print};

const HELP: &str = "\
What is printed can be edited, and read by `carvallo analyze` and the others. DESIGN and MODEL are as for
`carvallo analyze`; without them it is the benchmark bicycle.

Exit codes: 0 done; 1 there is no picture, or a file cannot be read or written; 2 wrong usage or input.";

/// The parameters as a file, with units and warnings
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    #[command(flatten)]
    units: UnitOptions,
    /// Draws a side view to scale; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    if let Some(picture) = &options.plot {
        picture.check(&options.design)?;
    }
    let units = options.units.units();
    let design = options.design.load()?;
    if let Some(picture) = &options.plot {
        let no_view = || Failure::Run(format!("the model {} has no side view", design.info().name));
        let (scene, left_out) = picture::draw_side_view(&design, &units).ok_or_else(no_view)?;
        if !left_out.is_empty() {
            note(WARNING, "note", &format!("the side view has no place for {}", left_out.join(", ")));
        }
        picture.write(&scene)?;
    }
    print(&output::render_parameters(&design, &units))
}
