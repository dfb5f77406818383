//! The command line of a sweep.

use std::path::PathBuf;

use carvallo_design::Failure;
use carvallo_sweep::Request;
use clap::Args;

use crate::destination::Destination;
use crate::options::{DesignOptions, UnitOptions};

const HELP: &str = "\
Designs:
  --vary w=0.9:1.2:0.01              from, to and step; both ends belong to it
  --vary 'lam=10 deg:30 deg:41 points'
                                     from, to and the number of points
  --vary mB=60,75,90                 a list; values may be expressions, as everywhere
                                     Several --vary make every combination; the first one varies slowest
  --random 'c=0.02..0.12' --samples 1000
                                     uniform between two values
  --random 'mB=85+-5' --samples 1000 normal, by its mean and standard deviation; also +/- and ±
  --random measured --samples 1000   all parameters of DESIGN that have standard deviations, with their correlations
                                     Beside --vary, each combination gets the same samples
  --vary 'fork_offset=30 mm:50 mm:1 mm'
                                     names of other conventions (see `carvallo convert --help`) keep everything else in
                                     it, here head angle, wheel base and wheels; a note says what is kept. What --set sets
                                     is held, as the trail in `--vary 'head_angle=68 deg:74 deg:1 deg' --set 'trail=60 mm'`
  --designs bikes.csv                a row for each design; columns are named like parameters, of any
                                     convention, and may have a unit, as `w [mm]` or `w_mm`; `name`, `id`, `index`
                                     and `bike` are copied. Parameters without a column are those of DESIGN. In CSV, lines before the
                                     header that begin with # are comments; Parquet may be compressed with Snappy, gzip
                                     or LZ4, or not at all
At most 1,000,000 values for each --vary, 10^12 designs, 100 speeds of --eigenvalues, and 1,000,000 designs in a map.

Columns of the result, in SI units (speeds in m/s, eigenvalues in 1/s), or with --units in others, as `weave_1 (km/h)`:
  the parameters that vary, or all columns of the file
  weave_count, weave_1, weave_2, …   critical speeds, ascending; in the same way capsize_… and double_root_…
  stable_count, stable_from_1, stable_to_1, …
                                     stable ranges; one without end has a stable_from and an empty stable_to
  verdict_at_V, eigenvalue_1_re_at_V, eigenvalue_1_im_at_V, …
                                     with --eigenvalues, for each speed V, sorted by their real parts
  error                              why a design has no results; everything else in its row is then empty
Unless lean and steer are among the coordinates, flutter_… stands in the place of weave_… and divergence_… in that of
capsize_…; of motorcycles weave_… has wobble, too. For other than two coordinates, and with C-1 or K1, there are at most 12
of each, and undecided_count says in how many ranges a critical speed may be missing. Models that do not depend on the speed
have none, and need --eigenvalues.

A sweep that was interrupted goes on where it stopped when the same command runs again: until it is finished,
FILE.partial and FILE.journal stand beside FILE. All cores are used (RAYON_NUM_THREADS=1 for one of them); the result
has the same bytes with any number of them.

Examples:
  carvallo sweep --vary mB=60:100:1 > mass.csv
  carvallo sweep pista --vary c=0.02:0.12:0.001 --vary 'lam=10 deg:30 deg:0.2 deg' --map map.png --output map.parquet
  carvallo sweep --random 'mB=85+-5' --random 'zB=-0.95..-0.85' --samples 100000 --seed 1 --output random.csv
  carvallo sweep --designs bikes.csv --eigenvalues 3,5,7 --output results.parquet

Exit codes: 0 done, also where single designs have an error (their number is told); 1 a file cannot be read or written;
2 wrong usage or input.";

/// Critical speeds, stable ranges and eigenvalues of many designs, to CSV or Parquet
#[derive(Args, Clone, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    /// The design that gives all parameters that do not vary.
    #[command(flatten)]
    pub base: DesignOptions,
    /// Varies a parameter: LOW:HIGH:STEP, LOW:HIGH:N points, or a list
    #[arg(long, value_name = "NAME=VALUES", allow_hyphen_values = true)]
    pub vary: Vec<String>,
    /// Draws a parameter, LOW..HIGH or MEAN+-DEVIATION; or `measured`: all that have deviations
    #[arg(long, value_name = "NAME=VALUES", allow_hyphen_values = true)]
    pub random: Vec<String>,
    /// How many designs to draw
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true, value_parser = whole)]
    pub samples: Option<u64>,
    #[arg(
        long,
        value_name = "SEED",
        allow_hyphen_values = true,
        value_parser = whole,
        help = "Another seed draws other designs [default: 0]"
    )]
    pub seed: Option<u64>,
    /// Reads the designs; .csv or .parquet
    #[arg(long, value_name = "FILE", conflicts_with_all = ["vary", "random"])]
    pub designs: Option<PathBuf>,
    /// Also the eigenvalues at these speeds in m/s: LOW:HIGH:STEP, a list, or one
    #[arg(long, value_name = "SPEEDS", allow_hyphen_values = true)]
    pub eigenvalues: Option<String>,
    #[command(flatten)]
    pub units: UnitOptions,
    #[arg(long, value_name = "FILE", help = "Where the results go; .csv or .parquet [default: CSV to stdout]")]
    pub output: Option<PathBuf>,
    /// Begins anew, and replaces FILE, where there is a finished or interrupted sweep
    #[arg(long, requires = "output")]
    pub restart: bool,
    /// Draws the stable ranges over two varied parameters; .svg or .png
    #[arg(long, value_name = "FILE")]
    pub map: Option<Destination>,
}

impl Options {
    /// What is asked for.
    ///
    /// # Errors
    /// What is no unit.
    pub fn request(&self) -> Result<Request, Failure> {
        let Self { base, vary, random, samples, seed, designs, eigenvalues, units, output, restart, map } =
            self.clone();
        let (base, units) = (base.request(), units.units());
        let map = map.map(|Destination(path)| path);
        Ok(Request { base, vary, random, samples, seed, designs, eigenvalues, units, output, restart, map })
    }
}

fn whole(text: &str) -> Result<u64, &'static str> {
    text.parse().map_err(|_| "expected a whole number")
}
