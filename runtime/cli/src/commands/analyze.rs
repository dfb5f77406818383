//! `carvallo analyze`: everything about one design along speed.

use carvallo::ModeValue;
use carvallo_design::number::shortest;
use carvallo_design::{Failure, Place};
use carvallo_plot::analysis::Analysis;
use carvallo_plot::analysis::along::{Along, AlongAnalysis};
use carvallo_plot::analysis::reach;
use carvallo_plot::data;
use carvallo_plot::picture::{Limits, MOST_SPEEDS, draw_along, draw_eigenvalues, draw_locus, draw_phasors};
use clap::Args;

use crate::limits::{EigenvalueLimits, SpeedLimits};
use crate::options::{DesignOptions, Format, Picture, Speed, Speeds, UnitOptions};
use crate::output::{self, documents};
use crate::terminal::{WARNING, note, print, write};

const HELP: &str = "\
Examples:
  carvallo analyze                              The benchmark bicycle, from 0 to 10 m/s
  carvallo analyze pista --speeds 0:30:5        A measured bicycle at other speeds
  carvallo analyze --set 'w=102 cm' --set c=0   The benchmark bicycle, changed
  carvallo analyze my-bike.toml --plot my-bike.png
  carvallo analyze --along mB=60:120 --speed 5  Against the mass of the rider and frame, at 5 m/s
  carvallo analyze --feedback 'Tdelta = 10*(4.7 - v)*phi_rate'
                                                With a motor that steers into the fall, up to 4.7 m/s
  carvallo analyze matrices.json                Matrices M, C1, K0, … of 1 to 12 coordinates
  carvallo analyze --speeds 5 --eigenvectors    The shapes of the modes: sizes and phases of lean and steer
  carvallo analyze --speeds 5 --phasors modes.svg
                                                The same as arrows on a dial for each mode

DESIGN is a name that `carvallo bicycles` lists, or with --model a parameter set that `carvallo models` lists; the path
of a file; or - for the standard input. A file that says `model = \"NAME\"` chooses its model by itself.
Files: TOML as `carvallo show` writes it; YAML `name: value` and text `name = value+/-deviation` as
BicycleParameters writes them, also as scripts of Python and MATLAB; JSON, also as --format json writes it, or with
matrices instead of parameters. Values may be expressions, in other units, and have standard deviations: pi/10,
atan(1/3), 18 deg, 102 cm, 1.02+/-0.01, 1.020(3).
Pages beside the source of this program: docs/files.md has every form, docs/modes.md says what castering, capsize,
weave, wobble, divergence and flutter are.

JSON for the Whipple model, in SI units, every number reading back to the same double:
  {\"model\", \"bicycle\", \"parameters\": {NAME: VALUE}, \"matrices\": {\"M\", \"C1\", \"K0\", \"K2\"},
   \"critical_speeds\": [{\"kind\": \"weave\"|\"capsize\"|\"double_root\", \"speed\", \"eigenvalue\": {\"re\", \"im\"},
     \"change\": \"stabilizes\"|\"destabilizes\"|\"merges\"|\"splits\"|\"touches\",
     \"verdicts\": [BELOW, ABOVE]}],
   \"stable_ranges\": [[FROM, TO|null]], \"undecided_ranges\": [[FROM, TO]],
   \"eigenvalues\": [{\"speed\", \"values\": [{\"re\", \"im\", \"mode\": \"castering\"|\"capsize\"|\"weave\"
     |\"real\"|\"oscillatory\"}]}]}
Other models have \"name\" in the place of \"bicycle\", and those of \"M\", \"C-1\", \"C0\", \"C1\", \"Kc\", \"K0\", \"K1\", \"K2\" that they have.
Unless lean and steer are among the coordinates, kinds are \"flutter\", \"divergence\" and \"double_root\"; with others beside
them there is \"wobble\", too. Eigenvalues are followed one by one, in the same order at all speeds; their modes are those
kinds, \"real\" or \"oscillatory\", and beside them stands \"verdict\": \"stable\"|\"marginal\"|\"unstable\". Where nothing depends
on the speed there is one row, with the speed null. With --eigenvectors each has \"right\" and \"left\": docs/json.md.
With --along there are \"critical_values\" in the place of \"critical_speeds\": docs/json.md.

Exit codes: 0 done; 1 the analysis has no answer, or a file cannot be read or written; 2 wrong usage or input.";

/// Matrices, critical speeds, and eigenvalues against speed
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    #[arg(
        long,
        value_name = "SPEEDS",
        allow_hyphen_values = true,
        help = "In m/s: LOW:HIGH:STEP, a list, or one [default: 0 to 10, or as far as there are critical speeds]"
    )]
    speeds: Option<Speeds>,
    /// Everything against a parameter instead, over a range of it and at --speed
    #[arg(long, value_name = "NAME=LOW:HIGH", allow_hyphen_values = true, conflicts_with_all = ["speeds", "xlim"])]
    along: Option<Along>,
    /// The speed of --along, in m/s
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<Speed>,
    /// table, markdown, latex, json or csv
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
    #[command(flatten)]
    units: UnitOptions,
    /// The shapes of the modes at each speed, too, in a table or as JSON
    #[arg(long)]
    eigenvectors: bool,
    /// Draws the eigenvalues against speed; .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<Picture>,
    /// Draws the shapes of the modes as phasors, at each of --speeds; .svg or .png
    #[arg(long, value_name = "FILE", conflicts_with = "along")]
    phasors: Option<Picture>,
    /// Draws the root locus: eigenvalues in the complex plane while the speed grows; .svg or .png
    #[arg(long, value_name = "FILE", conflicts_with = "along")]
    locus: Option<Picture>,
    /// The speeds that --plot shows, in m/s [default: those of --speeds]
    #[arg(long, value_name = "LOW:HIGH", requires = "plot")]
    xlim: Option<SpeedLimits>,
    /// The eigenvalues that --plot shows, in 1/s; but for bicycles their real parts [default: what is slow or critical]
    #[arg(long, value_name = "LOW:HIGH", requires = "plot", allow_hyphen_values = true)]
    ylim: Option<EigenvalueLimits>,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    if options.eigenvectors && options.format == Format::Csv {
        let place = Place::Option("--eigenvectors".to_owned());
        return Err(Failure::at(place, "CSV has no columns for them; they are in a table and in --format json"));
    }
    if let Some(along) = &options.along {
        return run_along(options, along);
    }
    if let Some(Speed(speed)) = options.speed {
        let speed = shortest(speed);
        let message = format!("it is the speed of --along; for eigenvalues at speeds write --speeds {speed}");
        return Err(Failure::at(Place::Option(format!("--speed {speed}")), message));
    }
    if let Some(picture) = &options.plot {
        picture.check(&options.design)?;
        if options.xlim.is_none()
            && options.speeds.as_ref().is_some_and(|Speeds(speeds)| speeds.iter().all(|speed| *speed == speeds[0]))
        {
            return Err(picture.problem("a picture needs a range of speeds, such as --speeds 0:10:0.1"));
        }
    }
    if let Some(picture) = &options.locus {
        picture.check_request("--locus", &options.design.request())?;
    }
    if let Some(picture) = &options.phasors {
        check_phasors(picture, options)?;
    }
    let mut analysis = Analysis::new(options.design.load()?)?;
    analysis.unit = options.units.of_speeds();
    let model = analysis.design.model;
    if !model.depends_on_speed() {
        let nothing = format!("nothing in the model {} depends on the speed", model.info.name);
        if let Some(picture) = &options.plot {
            return Err(picture.problem(format!("{nothing}, so there is no graph against it")));
        }
        if let Some(picture) = &options.locus {
            return Err(picture.problem_of("--locus", format!("{nothing}, so there is no root locus along it")));
        }
        if options.speeds.is_some() {
            note(WARNING, "note", &format!("{nothing}: --speeds is ignored"));
        }
    }
    if let (Some(picture), true, None) = (&options.phasors, model.depends_on_speed(), &options.speeds) {
        return Err(picture
            .problem_of("--phasors", "expected --speeds with the speeds that it is drawn at, such as --speeds 4.5"));
    }
    let given = options.speeds.as_ref();
    let speeds_or = |is_coarse: bool| match given {
        Some(Speeds(speeds)) => speeds.clone(),
        None => {
            let unit = &analysis.unit;
            reach::speeds(unit.value(analysis.reach), is_coarse).into_iter().map(|speed| unit.back(speed)).collect()
        }
    };
    let speeds = speeds_or(options.format.is_read());
    tell_of_rest(&analysis, &speeds)?;
    let rows = analysis.rows(&speeds)?;
    let at_row = |(speed, values): (f64, &[ModeValue])| analysis.shapes(speed, values);
    let are_needed = options.eigenvectors || options.phasors.is_some();
    let shapes = are_needed.then(|| rows.values().into_iter().map(at_row).collect::<Result<Vec<_>, _>>());
    let shapes = shapes.transpose()?;
    if let Some(picture) = &options.locus {
        let (low, high) = extremes(&speeds_or(false));
        if low == high {
            let message = "a root locus needs a range of speeds, such as --speeds 0:10:0.1";
            return Err(picture.problem_of("--locus", message));
        }
        picture.write(&draw_locus(&analysis, (low, high))?)?;
    }
    if let (Some(picture), Some(shapes)) = (&options.phasors, &shapes) {
        picture.write(&draw_phasors(&analysis, &rows, shapes))?;
    }
    let shapes = shapes.as_deref().filter(|_| options.eigenvectors);
    if let Some(picture) = &options.plot {
        let x = options.xlim.map_or_else(|| extremes(&speeds_or(false)), |SpeedLimits(low, high)| (low, high));
        let y = options.ylim.map(|EigenvalueLimits(low, high)| (low, high));
        picture.write(&draw_eigenvalues(&analysis, Limits { x, y })?)?;
    }
    match options.format {
        Format::Table => print(&output::render_table(&analysis, &rows, shapes)),
        Format::Document(language) => print(&documents::of_analysis(&analysis, &rows, shapes).write(language)),
        Format::Json => write(|output| data::analysis::write_json(&analysis, &rows, shapes, output)),
        Format::Csv => write(|output| data::analysis::write_csv(&analysis, &rows, output)),
    }
}

/// Whether phasors can be drawn as they are asked for.
fn check_phasors(picture: &Picture, options: &Options) -> Result<(), Failure> {
    picture.check_request("--phasors", &options.design.request())?;
    match &options.speeds {
        Some(Speeds(speeds)) if speeds.len() > MOST_SPEEDS => {
            let message = format!("there are {} speeds; the picture has room for {MOST_SPEEDS}", speeds.len());
            Err(picture.problem_of("--phasors", message))
        }
        _ => Ok(()),
    }
}

fn run_along(options: &Options, along: &Along) -> Result<(), Failure> {
    if options.eigenvectors {
        return Err(Failure::at(Place::Option("--eigenvectors".to_owned()), "there are none with --along"));
    }
    let units = options.units.units();
    if let Some(picture) = &options.plot {
        picture.check(&options.design)?;
    }
    let mut analysis = AlongAnalysis::new(options.design.load()?, along, options.speed.map(|Speed(speed)| speed))?;
    (analysis.unit, analysis.speed_unit) = (units.of(analysis.parameter.unit), units.of("m/s"));
    let [low, high] = analysis.range;
    if let Some(text) = analysis.path.warning(if high >= -low { high } else { low }) {
        note(WARNING, "warning", &text);
    }
    if let Some(kept) = analysis.path.note() {
        note(WARNING, "note", &format!("{}: {kept}", analysis.design.name));
    }
    if options.speed.is_some() && analysis.speed.is_none() {
        let name = analysis.design.info().name;
        note(WARNING, "note", &format!("nothing in the model {name} depends on the speed: --speed is ignored"));
    }
    if let Some(picture) = &options.plot {
        let y = options.ylim.map(|EigenvalueLimits(low, high)| (low, high));
        picture.write(&draw_along(&analysis, y)?)?;
    }
    let rows = analysis.rows(if options.format.is_read() { 11 } else { 101 })?;
    match options.format {
        Format::Table => print(&output::render_along(&analysis, &rows)),
        Format::Document(language) => print(&documents::of_along(&analysis, &rows).write(language)),
        Format::Json => write(|output| data::along::write_json(&analysis, &rows, output)),
        Format::Csv => write(|output| data::along::write_csv(&analysis, &rows, output)),
    }
}

/// Where there are no equations of motion at rest, that is told; where nothing else is asked for, it is a failure.
fn tell_of_rest(analysis: &Analysis, speeds: &[f64]) -> Result<(), Failure> {
    let Some(reason) = analysis.design.equations.without_rest().filter(|_| speeds.contains(&0.0)) else {
        return Ok(());
    };
    let nothing = format!("{}: at 0 m/s there are no equations of motion, since {reason}", analysis.design.title());
    if speeds.iter().all(|speed| *speed == 0.0) {
        return Err(Failure::Run(nothing));
    }
    note(WARNING, "note", &format!("{nothing}: left out"));
    Ok(())
}

/// The lowest and the highest of the speeds.
fn extremes(speeds: &[f64]) -> (f64, f64) {
    let low = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    (low, speeds.iter().copied().fold(0.0, f64::max))
}
