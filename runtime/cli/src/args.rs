//! The command line: what can be asked for, and its help.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, Styles, styling::AnsiColor};
use clap::{Arg, ArgAction, ArgMatches, value_parser};

use crate::failure::{Failure, Place, Problem};
use crate::input::Request;
use crate::speeds;
use crate::sweep;

/// What to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Without any argument: the benchmark bicycle, as a first look.
    Demo,
    Analyze {
        request: Request,
        /// In m/s; `None` for those that suit the output.
        speeds: Option<Vec<f64>>,
        format: Format,
        plot: Option<PathBuf>,
    },
    Bicycles,
    Models,
    /// What the critical speeds depend on most.
    Sensitivity {
        request: Request,
        format: Format,
        plot: Option<PathBuf>,
    },
    Show {
        request: Request,
        plot: Option<PathBuf>,
    },
    Sweep(Box<sweep::Request>),
}

/// How an analysis is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Table,
    Json,
    Csv,
}

const ABOUT: &str = "Stability of bicycles and of other models: matrices, eigenvalues and critical speeds.";

const EXAMPLES: &str = "\
Examples:
  carvallo                                     A first look at the benchmark bicycle
  carvallo analyze pista --plot pista.svg      A measured bicycle, with its picture
  carvallo analyze --set mB=90 --set 'lam=20 deg'
                                               The benchmark bicycle, changed
  carvallo analyze my-bike.toml --format csv --speeds 0:8:0.05
  carvallo sensitivity pista --plot pista.svg  Which parameters its critical speeds depend on most
  carvallo show benchmark > my-bike.toml       A file to start from: edit it and analyze it
  carvallo show browser --plot browser.svg     Parameters, and a side view to scale
  carvallo sweep --vary w=0.9:1.2:0.01 --vary 'lam=10 deg:30 deg:1 deg' --map map.svg --output designs.csv
                                               Many designs, with a map of their stability
  carvallo analyze --model Pendulum            Another model that ships, with its first parameter set";

const ANALYZE_HELP: &str = "\
DESIGN is a name that `carvallo bicycles` lists, or with --model a parameter set that `carvallo models` lists; the path
of a file; or - for the standard input. A file that says `model = \"NAME\"` chooses its model by itself.
Files: TOML as `carvallo show` writes it; YAML `name: value` and text `name = value+/-deviation` as
BicycleParameters writes them; JSON, also as --format json writes it. Values may be expressions:
pi/10, atan(1/3), 18 deg.

JSON for the Whipple model, in SI units, every number reading back to the same double:
  {\"model\", \"bicycle\", \"parameters\": {NAME: VALUE}, \"matrices\": {\"M\", \"C1\", \"K0\", \"K2\"},
   \"critical_speeds\": [{\"kind\": \"weave\"|\"capsize\"|\"double_root\", \"speed\", \"eigenvalue\": {\"re\", \"im\"},
     \"change\": \"stabilizes\"|\"destabilizes\"|\"merges\"|\"splits\"|\"touches\"}],
   \"stable_ranges\": [[FROM, TO|null]],
   \"eigenvalues\": [{\"speed\", \"values\": [{\"re\", \"im\", \"mode\": \"castering\"|\"capsize\"|\"weave\"}]}]}
Other models have \"name\" in the place of \"bicycle\", and those of \"M\", \"C0\", \"C1\", \"Kc\", \"K0\", \"K2\" that they have.
Critical speeds and stable ranges are null for other than two coordinates. Unless the coordinates are lean and steer,
eigenvalues have no \"mode\" and are sorted, and beside them stands \"verdict\": \"stable\"|\"marginal\"|\"unstable\"; where
nothing depends on the speed there is one row, with the speed null.

Exit codes: 0 done; 1 the analysis has no answer, or a file cannot be read or written; 2 wrong usage or input.";

const SENSITIVITY_HELP: &str = "\
Ranks the parameters by how much 1 % of each changes the weave and capsize speeds (m/s), with the derivatives beside it
(m/s per unit of the parameter). They are exact derivatives, not differences. 1 % is of the value, with its sign: 1 % more
of zB = -0.9 m is -0.009 m, which is higher up. A parameter that is 0 is changed by 1 % of the median size of the others in
its unit, or of a radian, and marked *.

Standard deviations of parameters, where the file has them, propagate to first order to every critical speed and matrix
entry, with the shares of the variance that come from each parameter.

DESIGN and MODEL are as for `carvallo analyze`, of models with two coordinates. JSON and CSV have all critical speeds,
those of double roots too; their layout is in docs/sensitivity.md.

Examples:
  carvallo sensitivity                          The benchmark bicycle
  carvallo sensitivity browser --plot browser.png
                                                A measured bicycle, with deviations in the table, and a
                                                bar chart of the effects of 1 %
  carvallo sensitivity --set c=0                Without trail
  carvallo sensitivity my-bike.toml --format csv

Exit codes: 0 done; 1 there is no answer, or a file cannot be read or written; 2 wrong usage or input.";

fn command() -> clap::Command {
    let design = Arg::new("design").value_name("DESIGN|FILE");
    let design = design.help("A shipped bicycle or parameter set, or a file; - reads stdin");
    let model = Arg::new("model")
        .long("model")
        .value_name("MODEL")
        .help("A model that `carvallo models` lists [default: the file's, or Whipple]");
    let gravity = Arg::new("gravity")
        .long("gravity")
        .value_name("G")
        .allow_negative_numbers(true)
        .help("Gravitational field strength in N/kg, the same as --set g=G");
    let set = Arg::new("set")
        .long("set")
        .value_name("NAME=VALUE")
        .action(ArgAction::Append)
        .help("Replaces a parameter; may be given several times");
    let plot = Arg::new("plot").long("plot").value_name("FILE").value_parser(value_parser!(PathBuf));
    let format = Arg::new("format")
        .long("format")
        .value_name("FORMAT")
        .value_parser(PossibleValuesParser::new(["table", "json", "csv"]))
        .default_value("table")
        .hide_possible_values(true)
        .help("table, json or csv");
    let styles = Styles::styled()
        .header(AnsiColor::Green.on_default().bold())
        .usage(AnsiColor::Green.on_default().bold())
        .literal(AnsiColor::Cyan.on_default().bold())
        .placeholder(AnsiColor::Cyan.on_default());
    let sweep = sweep::command([design.clone(), model.clone(), gravity.clone(), set.clone()]);
    let analyze = clap::Command::new("analyze")
        .about("Matrices, critical speeds, and eigenvalues against speed")
        .after_help(ANALYZE_HELP)
        .arg(design.clone())
        .arg(model.clone())
        .arg(
            Arg::new("speeds")
                .long("speeds")
                .value_name("SPEEDS")
                .allow_hyphen_values(true)
                .help("In m/s: LOW:HIGH:STEP, a list, or one [default: 0:10:1 in a table, else 0:10:0.1]"),
        )
        .arg(gravity.clone())
        .arg(set.clone())
        .arg(format.clone())
        .arg(plot.clone().help("Draws the eigenvalues against speed; .svg or .png"));
    let sensitivity = clap::Command::new("sensitivity")
        .about("Which parameters the weave and capsize speeds depend on most")
        .after_help(SENSITIVITY_HELP)
        .arg(design.clone())
        .arg(model.clone())
        .arg(gravity.clone())
        .arg(set.clone())
        .arg(format)
        .arg(plot.clone().help("Draws the effects as a bar chart; .svg or .png"));
    let show = clap::Command::new("show")
        .about("The parameters as a file, with units and warnings")
        .arg(design.required_unless_present("model"))
        .arg(model)
        .arg(gravity)
        .arg(set)
        .arg(plot.help("Draws a side view to scale; .svg or .png"));
    clap::Command::new("carvallo")
        .about(ABOUT)
        .version(env!("CARGO_PKG_VERSION"))
        .styles(styles)
        .after_help(EXAMPLES)
        .disable_help_subcommand(true)
        .subcommand(analyze)
        .subcommand(sensitivity)
        .subcommand(clap::Command::new("bicycles").about("The shipped bicycles, with their critical speeds"))
        .subcommand(clap::Command::new("models").about("The shipped models, with their coordinates and parameter sets"))
        .subcommand(show)
        .subcommand(sweep)
}

/// Reads the command line. Prints help, and ends the process for it and for wrong usage.
///
/// # Errors
/// What clap does not judge: speeds, `NAME=VALUE`, and the ending of a picture.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, Failure> {
    let matches = command().get_matches_from(arguments);
    match matches.subcommand() {
        None => Ok(Command::Demo),
        Some(("analyze", matches)) => {
            let text = matches.get_one::<String>("speeds");
            let speeds = text.map(|text| {
                speeds::parse(text).map_err(|message| {
                    Failure::Input(vec![Problem { place: Place::Option(format!("--speeds {text}")), message }])
                })
            });
            let format = format(matches);
            let (request, speeds) = (request(matches)?, speeds.transpose()?);
            let plot = plot(matches, &request)?;
            if let (Some(path), Some([first, others @ ..])) = (&plot, speeds.as_deref())
                && others.iter().all(|speed| speed == first)
            {
                let message = "a picture needs a range of speeds, such as --speeds 0:10:0.1";
                return Err(plot_problem(path, message));
            }
            Ok(Command::Analyze { request, speeds, format, plot })
        }
        Some(("sensitivity", matches)) => {
            let request = request(matches)?;
            let plot = plot(matches, &request)?;
            Ok(Command::Sensitivity { request, format: format(matches), plot })
        }
        Some(("show", matches)) => {
            let request = request(matches)?;
            Ok(Command::Show { plot: plot(matches, &request)?, request })
        }
        Some(("sweep", matches)) => Ok(Command::Sweep(Box::new(sweep::request(matches, request(matches)?)))),
        Some(("models", _)) => Ok(Command::Models),
        Some(_) => Ok(Command::Bicycles),
    }
}

fn format(matches: &ArgMatches) -> Format {
    match matches.get_one::<String>("format").map(String::as_str) {
        Some("json") => Format::Json,
        Some("csv") => Format::Csv,
        _ => Format::Table,
    }
}

fn request(matches: &ArgMatches) -> Result<Request, Failure> {
    let mut overrides = Vec::new();
    for setting in matches.get_many::<String>("set").into_iter().flatten() {
        let option = format!("--set {setting}");
        match setting.split_once('=') {
            Some((name, value)) if !name.trim().is_empty() => {
                overrides.push((option, name.trim().to_owned(), value.to_owned()))
            }
            _ => {
                let message = "expected NAME=VALUE, such as mB=90".to_owned();
                return Err(Failure::Input(vec![Problem { place: Place::Option(option), message }]));
            }
        }
    }
    if let Some(gravity) = matches.get_one::<String>("gravity") {
        overrides.push((format!("--gravity {gravity}"), "g".to_owned(), gravity.clone()));
    }
    let [model, parameters] = ["model", "design"].map(|argument| matches.get_one::<String>(argument).cloned());
    Ok(Request { model, parameters, overrides })
}

/// The picture is refused before anything is computed if its ending names no format, or if it would replace what is read.
fn plot(matches: &ArgMatches, request: &Request) -> Result<Option<PathBuf>, Failure> {
    let Some(path) = matches.get_one::<PathBuf>("plot") else { return Ok(None) };
    let is_known =
        path.extension().is_some_and(|ending| ["svg", "png"].iter().any(|known| ending.eq_ignore_ascii_case(known)));
    if !is_known {
        return Err(plot_problem(path, "the name must end in .svg or .png"));
    }
    if request.reads(path) {
        return Err(plot_problem(path, "the parameters are read from this file"));
    }
    Ok(Some(path.clone()))
}

fn plot_problem(path: &Path, message: &str) -> Failure {
    let place = Place::Option(format!("--plot {}", path.display()));
    Failure::Input(vec![Problem { place, message: message.to_owned() }])
}
