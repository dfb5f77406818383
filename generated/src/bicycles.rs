//! Parameter sets of the Whipple bicycle: the two published benchmarks, and bicycles that were measured.

/// A bicycle that ships with this crate.
///
/// It is kept as text so that its digits stay as they were published; the command line reads it like any other file.
/// A value is a number, an expression in quotes (`"pi/10"`), or `{ value = …, std = … }` with the standard deviation
/// of its measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bicycle {
    /// The name it is chosen by.
    pub name: &'static str,
    /// The TOML file: `name`, `kind`, `source`, and a table `parameters`.
    pub toml: &'static str,
}

macro_rules! bicycles {
    ($($name:literal)*) => {
        &[$(Bicycle { name: $name, toml: include_str!(concat!("../bicycles/", $name, ".toml")) }),*]
    };
}

/// The bicycles that ship with this crate: the benchmarks, then real bicycles without a rider, then with one.
pub static BICYCLES: &[Bicycle] = bicycles![
    "benchmark"
    "benchmark-2005"
    "balanceassistv1"
    "browser"
    "browserins"
    "crescendo"
    "fisher"
    "pista"
    "rigid"
    "silver"
    "yellow"
    "yellowrev"
    "browser-jason"
    "pista-rider"
];
