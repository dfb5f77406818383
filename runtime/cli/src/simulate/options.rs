//! The command line of a simulation.

use clap::Args;

use crate::delivery::Delivery;
use crate::options::{DesignOptions, Picture, UnitOptions};

const HELP: &str = "\
A bicycle moves by the nonlinear equations of its four bodies; so do other models that have such equations, and with --linear,
or if a model has no others, the linear ones at the speed are solved exactly.

Names of positions: the coordinates of the model, and of bicycles x, y (where the rear wheel touches the ground, forward
and to the right), psi (yaw), phi (lean), pitch, delta (steer), thetaR and thetaF (angles of the wheels about axes to the
right, so that they decrease as it rolls forward). Their rates are NAME_rate; torques on lean and steer are phi and delta.
Angles are in rad, unless a unit stands behind them; x, y and z (down) are along axes of the ground. The speed is that of the
rear wheel, -rR thetaR_rate.

What --initial leaves out is zero; what follows from the rest, such as the pitch and the rates of wheels that roll, cannot be
given. Forces are constant, or a file with a time in s and a force in each line, linear between them; two lines at one time
are a jump.

A fall (a lean of 80 degrees, or a front wheel that turns around) ends the run; that, a stop, and a wheel that would lift off
are told.

Examples:
  carvallo simulate --speed 4.6 --initial phi_rate=0.5 --duration 10
                                                The benchmark bicycle, pushed
  carvallo simulate pista --speed '18 km/h' --initial 'phi=5 deg' --duration 5 --plot ride.svg
                                                A measured one, with its picture
  carvallo simulate --speed 5 --force delta=torque.csv --duration 8 --step 0.01 --output ride.csv
                                                Steered by a torque
  carvallo simulate --speed 3 --initial phi_rate=0.5 --duration 4 --feedback 'Tdelta = 10*(4.7 - v)*phi_rate'
                                                With a motor that steers into the fall; v is the speed at the moment
  carvallo simulate --speed 5 --initial phi=0.1 --duration 0 --format json
                                                The accelerations at a state
  carvallo simulate --model Pendulum --initial 'theta=20 deg' --duration 2
                                                Another model

The layout of JSON and CSV is in docs/simulate.md, beside the source of this program.

Exit codes: 0 done, also where the motion ended early, which is told; 1 there is no motion, or a file cannot be read or
written; 2 wrong usage or input.";

/// The motion from an initial state, under forces
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    pub design: DesignOptions,
    #[command(flatten)]
    pub units: UnitOptions,
    /// Forward speed in m/s
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub speed: Option<String>,
    /// A position or rate at the beginning; may be given several times
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub initial: Vec<String>,
    /// A force or torque, constant or from a file; may be given several times
    #[arg(long, value_name = "NAME=VALUE|FILE.csv", allow_hyphen_values = true)]
    pub force: Vec<String>,
    /// How long, in s; 0 for the accelerations at a state
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub duration: String,
    #[arg(
        long,
        value_name = "DT",
        allow_hyphen_values = true,
        help = "The time between rows in s [default: a hundredth of T, in a table a twentieth]"
    )]
    pub step: Option<String>,
    /// Solves the linear equations, not the nonlinear ones
    #[arg(long)]
    pub linear: bool,
    #[command(flatten)]
    pub delivery: Delivery,
    /// Draws the motion against time, and the paths of wheels; .svg or .png
    #[arg(long, value_name = "FILE")]
    pub plot: Option<Picture>,
}
