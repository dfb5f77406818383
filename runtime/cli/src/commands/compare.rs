//! `carvallo compare`: several designs, what differs, and which parameters make the difference.

use std::collections::HashSet;
use std::path::Path;

use carvallo_design::Failure;
use carvallo_design::input::{self, Request};
use carvallo_design::units::Units;
use carvallo_plot::analysis::Analysis;
use carvallo_plot::analysis::compare::{Compared, Comparison};
use carvallo_plot::{data, picture};
use clap::Args;

use crate::limits::{EigenvalueLimits, SpeedLimits};
use crate::options::{Format, Picture, Setting, UnitOptions, tell};
use crate::output::documents;
use crate::terminal::{print, write};

const HELP: &str = "\
The first design is what the others are held against. Behind a name or a file may stand settings of it alone, after a colon and
separated by commas: pista:lam=20deg,c=5cm. --set, --gravity and --model are for all.

Of each critical speed that both designs have, the difference is shared out among the parameters that differ: the exact
derivatives are integrated along the straight path from the parameters of one to those of the other, so that the
contributions sum to the difference. Of a critical speed that only one of them has, it is told where on the way it appears
or vanishes, and how. The parameters of different models have no path between them; their critical speeds are compared.

Examples:
  carvallo compare benchmark pista browser      Three bicycles: critical speeds, and what differs
  carvallo compare pista pista:c=0.04           One, changed
  carvallo compare browser browser-jason --format latex
                                                What a rider changes, as tables for a paper
  carvallo compare pista browser --plot both.svg --side-view views.svg --contributions difference.svg
                                                With pictures of both, and of what makes the difference
  carvallo compare mine.toml pista --format json

The layout of JSON and CSV is in docs/compare.md, beside the source of this program.

Exit codes: 0 done; 1 there is no answer, or a file cannot be read or written; 2 wrong usage or input.";

/// Several designs: what differs, and which parameters make the difference
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    /// Shipped bicycles or parameter sets, or files; each with settings behind a colon, if any
    #[arg(value_name = "DESIGN|FILE", required = true)]
    designs: Vec<String>,
    #[arg(long, value_name = "MODEL", help = "A model that `carvallo models` lists [default: the files', or Whipple]")]
    model: Option<String>,
    /// Gravitational field strength in N/kg, the same as --set g=G
    #[arg(long, value_name = "G", allow_negative_numbers = true)]
    gravity: Option<String>,
    /// Replaces a parameter of all designs; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<Setting>,
    /// A law of feedback that closes a loop of all designs, such as 'Tdelta = -10*phi_rate'; may be given several times
    #[arg(long, value_name = "LAW")]
    feedback: Vec<String>,
    /// A body that is joined to a frame of all designs: a file, or 'mass=75 kg, at=(0.3, 0, -1.1)'; may be given several times
    #[arg(long, value_name = "BODY")]
    add: Vec<String>,
    /// All parameters, and not only those that differ
    #[arg(long)]
    all: bool,
    #[command(flatten)]
    pictures: Pictures,
    #[command(flatten)]
    units: UnitOptions,
    /// table, markdown, latex, json or csv
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
}

/// Pictures of several designs.
#[derive(Args, Debug)]
pub struct Pictures {
    /// Draws the eigenvalues of all against the speed; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
    /// The speeds that --plot shows, in m/s [default: as far as there is something to see]
    #[arg(long, value_name = "LOW:HIGH", requires = "plot")]
    xlim: Option<SpeedLimits>,
    /// The real parts that --plot shows, in 1/s [default: most of what there is to see]
    #[arg(long, value_name = "LOW:HIGH", requires = "plot", allow_hyphen_values = true)]
    ylim: Option<EigenvalueLimits>,
    /// Draws the side views of all to one scale; .svg or .png
    #[arg(long, value_name = "FILE")]
    side_view: Option<Picture>,
    /// Draws what each parameter contributes to the differences of the last design from the first; .svg or .png
    #[arg(long, value_name = "FILE")]
    contributions: Option<Picture>,
}

impl Pictures {
    /// # Errors
    /// If a picture would replace the file that parameters are read from.
    pub fn check(&self, request: &Request) -> Result<(), Failure> {
        let all = [("--plot", &self.plot), ("--side-view", &self.side_view), ("--contributions", &self.contributions)];
        let mut given = all.into_iter().filter_map(|(option, picture)| Some((option, picture.as_ref()?)));
        given.try_for_each(|(option, picture)| picture.check_request(option, request))
    }

    /// # Errors
    /// If one cannot be drawn, or a file cannot be written.
    pub fn draw(&self, comparison: &Comparison, units: &Units) -> Result<(), Failure> {
        if let Some(file) = &self.plot {
            let x = self.xlim.map(|SpeedLimits(low, high)| (low, high));
            let y = self.ylim.map(|EigenvalueLimits(low, high)| (low, high));
            file.write(&picture::draw_overlay(comparison, x, y, units)?)?;
        }
        if let Some(file) = &self.side_view {
            let none =
                || file.problem_of("--side-view", "there is a side view of bicycles alone, and not all of these are");
            file.write(&picture::draw_side_views(comparison, units).ok_or_else(none)?)?;
        }
        if let Some(file) = &self.contributions {
            let (first, last) = (&comparison.designs[0], &comparison.designs[comparison.designs.len() - 1]);
            let difference = &comparison.differences[comparison.differences.len() - 1];
            let none = || {
                file.problem_of("--contributions", "there is no critical speed of both with a difference to share out")
            };
            file.write(&picture::draw_contributions(first, last, difference, units).ok_or_else(none)?)?;
        }
        Ok(())
    }
}

pub fn run(options: &Options) -> Result<(), Failure> {
    let units = options.units.units();
    let requests = options.designs.iter().map(|argument| request(argument, options)).collect::<Result<Vec<_>, _>>()?;
    requests.iter().try_for_each(|request| options.pictures.check(request))?;
    let designs = requests.iter().map(input::load).collect::<Result<Vec<_>, _>>()?;
    let mut labels: Vec<String> = designs.iter().map(|design| design.title()).collect();
    let different: HashSet<&String> = labels.iter().collect();
    // Names that are the same tell nothing; then what was asked for does.
    if different.len() < labels.len() || requests.iter().any(|request| !request.overrides.is_empty()) {
        labels = options.designs.clone();
    }
    designs.iter().zip(&labels).for_each(|(design, label)| tell(design, label));
    let compared =
        labels.into_iter().zip(designs).map(|(label, design)| Ok(Compared { label, analysis: Analysis::new(design)? }));
    let comparison = Comparison::new(compared.collect::<Result<_, Failure>>()?)?;
    options.pictures.draw(&comparison, &units)?;
    match options.format {
        Format::Table => print(&documents::of_comparison(&comparison, options.all, &units).at_terminal()),
        Format::Document(language) => {
            print(&documents::of_comparison(&comparison, options.all, &units).write(language))
        }
        Format::Json => write(|output| data::compare::write_json(&comparison, &units, output)),
        Format::Csv => write(|output| data::compare::write_csv(&comparison, &units, output)),
    }
}

/// `NAME`, or `NAME:SETTING,SETTING`; what is the name of a file as a whole is one.
fn request(argument: &str, options: &Options) -> Result<Request, Failure> {
    let parts =
        argument.rsplit_once(':').filter(|(_, settings)| settings.contains('=') && !Path::new(argument).exists());
    let (name, settings) = parts.unwrap_or((argument, ""));
    let own = settings.split(',').filter(|setting| !setting.trim().is_empty());
    let own = own.map(|setting| {
        let Setting { name, value, .. } = setting
            .parse()
            .map_err(|_| Failure::usage(format!("{argument}: `{setting}` is no setting: expected NAME=VALUE")))?;
        Ok((argument.to_owned(), name, value))
    });
    let common = options
        .set
        .iter()
        .map(|Setting { written, name, value }| Ok((format!("--set {written}"), name.clone(), value.clone())));
    let gravity = options.gravity.iter().map(|value| Ok((format!("--gravity {value}"), "g".to_owned(), value.clone())));
    Ok(Request {
        model: options.model.clone(),
        parameters: (!name.is_empty()).then(|| name.to_owned()),
        overrides: common.chain(gravity).chain(own).collect::<Result<_, Failure>>()?,
        feedback: options.feedback.iter().map(|law| (format!("--feedback '{law}'"), law.clone())).collect(),
        bodies: options.add.iter().map(|body| (format!("--add '{body}'"), body.clone())).collect(),
    })
}
