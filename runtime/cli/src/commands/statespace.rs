//! `carvallo statespace`: the linearized motion at a speed with inputs and outputs.

use carvallo_control::{Ports, files};
use carvallo_design::Failure;
use carvallo_plot::data;
use clap::Args;

use crate::destination::Destination;
use crate::endings::Endings;
use crate::options::Format;
use crate::output::documents;
use crate::output::typeset::Language;
use crate::ports::PortOptions;
use crate::terminal::{deliver, save};

const HELP: &str = "\
x' = A x + B u and y = C x + D u, with the states x, the inputs u and the outputs y, which are small deviations from
straight running, in SI units.

States are the coordinates, then their rates. Inputs are the torques on angles and the forces on lengths: Tphi, Tdelta.
Outputs are coordinates, their rates and accelerations: phi, phi_rate, phi_acceleration, or in words lean_rate; for bicycles
also the yaw psi and the lateral place y of the rear wheel, which become states where an output asks for them.

Examples:
  carvallo statespace --speed 5                 The benchmark bicycle, with all inputs and states
  carvallo statespace --speed 5 --inputs Tdelta --outputs phi,delta,phi_rate
  carvallo statespace pista --speed '18 km/h' --outputs psi_rate,y_acceleration --format json
  carvallo statespace --speed 5 --output bicycle.npz
                                                For NumPy: control.ss(f[\"A\"], f[\"B\"], f[\"C\"], f[\"D\"])
  carvallo statespace --speed 5 --output bicycle.mat
                                                For MATLAB and Octave: load bicycle.mat; ss(A, B, C, D)
  carvallo statespace --model Motorcycle --speed 20 --inputs Tdelta --outputs phi

The layout of JSON, CSV and files is in docs/control.md, beside the source of this program.

Exit codes: 0 done; 1 there are no equations of motion, or a file cannot be read or written; 2 wrong usage or input.";

/// The state-space form at a speed, with inputs and outputs, also for NumPy and MATLAB
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    ports: PortOptions,
    #[arg(
        long,
        value_enum,
        hide_possible_values = true,
        help = "table, markdown, latex, json or csv [default: table]"
    )]
    format: Option<Format>,
    #[arg(
        long,
        value_name = "FILE",
        help = "Where the result goes; .npz, .mat, .json, .csv, .md, .tex or .txt [default: stdout]"
    )]
    output: Option<Destination>,
}

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Text(Format),
    Npz,
    Mat,
}

const ENDINGS: Endings<Kind> = Endings(&[
    ("npz", Kind::Npz),
    ("mat", Kind::Mat),
    ("json", Kind::Text(Format::Json)),
    ("csv", Kind::Text(Format::Csv)),
    ("md", Kind::Text(Format::Document(Language::Markdown))),
    ("tex", Kind::Text(Format::Document(Language::Latex))),
    ("txt", Kind::Text(Format::Table)),
    ("txt", Kind::Text(Format::Document(Language::Markdown))),
    ("txt", Kind::Text(Format::Document(Language::Latex))),
]);

pub fn run(options: &Options) -> Result<(), Failure> {
    let file = options.output.as_ref();
    let kind = kind(options.format, file)?;
    if let Some(file) = file.filter(|file| options.ports.design.request().reads(file)) {
        return Err(Failure::at(file.place(), "the parameters are read from this file"));
    }
    file.map_or(Ok(()), |file| file.replaces_result())?;
    let shown = options.ports.units.shown();
    let (design, space) = options.ports.load(Ports::states)?;
    let space = space.in_units(&shown);
    let path = file.map(|file| &**file);
    match (kind, path) {
        (Kind::Text(Format::Json), _) => deliver(path, |output| data::state_space::write_json(&design, &space, output)),
        (Kind::Text(Format::Csv), _) => deliver(path, |output| data::state_space::write_csv(&space, output)),
        (Kind::Npz, Some(path)) => save(path, |output| files::write_npz(&space, output)),
        (Kind::Mat, Some(path)) => save(path, |output| files::write_mat(&space, output)),
        (Kind::Text(Format::Document(language)), _) => {
            let text = documents::of_state_space(&design, &space).write(language);
            deliver(path, |output| output.write_all(text.as_bytes()))
        }
        (Kind::Text(Format::Table) | Kind::Npz | Kind::Mat, _) => {
            let text = documents::of_state_space(&design, &space).at_terminal();
            deliver(path, |output| output.write_all(text.as_bytes()))
        }
    }
}

/// What is written: what is asked for, and else what the ending of the file says.
fn kind(format: Option<Format>, file: Option<&Destination>) -> Result<Kind, Failure> {
    let Some(file) = file else { return Ok(Kind::Text(format.unwrap_or(Format::Table))) };
    ENDINGS.kind(file, format.map(Kind::Text)).map_err(|message| {
        let hint = if file.extension().is_none() {
            format!("; an output of the state space is --outputs {}", file.display())
        } else {
            String::new()
        };
        Failure::at(file.place(), format!("{message}{hint}"))
    })
}
