//! `carvallo turns`: the circles that a bicycle runs in by itself.

use carvallo_design::quantity::{self, Context, Mistake, Reason, check_units, no_names};
use carvallo_design::{Failure, Place};
use carvallo_plot::analysis::simulation::{Quantity, doubt};
use carvallo_plot::analysis::turns::Families;
use carvallo_plot::{data, picture};
use clap::Args;

use crate::delivery::Delivery;
use crate::options::{DesignOptions, Format, Picture, UnitOptions};
use crate::output::{self, documents};
use crate::terminal::{WARNING, deliver, note};

const HELP: &str = "\
Where straight running loses its stability to capsize, a curve of circles begins: hands free, at a lean and a steer that are
in balance, at one speed each. It is followed to its end by the nonlinear equations of motion, and so are the curves that begin
elsewhere, some of them with the front wheel turned around. Circles to the left are the mirror images of those to the right.

A turn is stable if every small deviation dies away, but for one to a neighbouring circle. Growth is the largest real part of
the eigenvalues near it, in 1/s: how fast the worst deviation grows, or how slowly it dies away.

Examples:
  carvallo turns                                The benchmark bicycle
  carvallo turns --steer '5 deg, 10 deg'        Its circles at these steers
  carvallo turns pista --plot turns.svg         A measured one, with its picture
  carvallo turns --set c=0.06 --format json     The benchmark bicycle, changed

The layout of JSON and CSV is in docs/simulate.md, beside the source of this program.

Exit codes: 0 done; 1 there are no turns, or a file cannot be read or written; 2 wrong usage or input.";

/// The circles that it runs in hands free, and whether they are stable
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    #[command(flatten)]
    units: UnitOptions,
    #[arg(
        long,
        value_name = "ANGLES",
        allow_hyphen_values = true,
        help = "Only the turns at these steers: a list, in rad or as `5 deg` [default: along the curve]"
    )]
    steer: Option<String>,
    #[command(flatten)]
    delivery: Delivery,
    /// Draws lean, steer and radius against the speed; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    if let Some(picture) = &options.plot {
        picture.check(&options.design)?;
    }
    let format = options.delivery.format()?;
    if options.delivery.path().is_some_and(|path| options.design.request().reads(path)) {
        return Err(options.delivery.problem("the parameters are read from this file"));
    }
    options.delivery.replaces_result()?;
    let steers = options.steer.as_deref().map(steers).transpose()?;
    let steer = Quantity::new("steer", "steer", "rad");
    let doubts = options.steer.iter().flat_map(|text| text.split(',')).filter_map(|text| doubt(text, &steer));
    doubts.for_each(|text| note(WARNING, "note", &text));
    let (units, shown) = (options.units.units(), options.units.shown());
    let design = options.design.load()?;
    let families = Families::new(&design, steers.as_deref())?;
    if let Some(picture) = &options.plot {
        let all = if steers.is_some() { Some(Families::new(&design, None)?) } else { None };
        picture.write(&picture::draw_turns(all.as_ref().unwrap_or(&families), &units))?;
    }
    if steers.iter().flatten().any(|steer| *steer == 0.0) {
        note(
            WARNING,
            "note",
            "with no steer it runs straight, at any speed; circles begin at the capsize speed, and `carvallo analyze` tells at \
             which speeds straight running is stable",
        );
    }
    deliver(options.delivery.path(), |output| match format {
        Format::Table => output.write_all(output::turns::render_table(&families, steers.is_some(), &units).as_bytes()),
        Format::Document(language) => {
            output.write_all(documents::of_turns(&families, steers.is_some(), &units).write(language).as_bytes())
        }
        Format::Json => data::turns::write_json(&families, &shown, output),
        Format::Csv => data::turns::write_csv(&families, &shown, output),
    })
}

/// A list of angles, in rad.
fn steers(text: &str) -> Result<Vec<f64>, Failure> {
    let context = Context { unit: "rad", names: &no_names };
    let fail = |message: String| Failure::at(Place::Option(format!("--steer {text}")), message);
    let list: Vec<&str> = text.split(',').map(str::trim).collect();
    check_units(&list, context).map_err(fail)?;
    let number = |text: &&str| {
        quantity::number(text, context).map_err(|Mistake { reason, .. }| {
            fail(match reason {
                Reason::Unit(unit) => {
                    format!("`{text}`: `{unit}` is no unit for an angle: it is in rad, or in degrees as `5 deg`")
                }
                Reason::Other(reason) => format!("`{text}` must be a finite number: {reason}"),
            })
        })
    };
    list.iter().map(number).collect()
}
