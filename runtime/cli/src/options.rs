//! Options that several subcommands share, each with a type of its own.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use carvallo_design::input::{self, Request};
use carvallo_design::units::Units;
use carvallo_design::{Design, DisplayUnit, Failure, Place, Problem, speeds};
use carvallo_plot::picture::{Scene, may_be_replaced};
use clap::builder::{PathBufValueParser, PossibleValue, TypedValueParser as _, ValueParser, ValueParserFactory};
use clap::{ArgMatches, Args, ValueEnum};

use crate::output::typeset::Language;
use crate::picture;
use crate::terminal::{WARNING, note, wrote};

/// Which design is meant.
#[derive(Args, Clone, Debug, Default)]
pub struct DesignOptions {
    /// A shipped bicycle or parameter set, or a file; - reads stdin
    #[arg(value_name = "DESIGN|FILE")]
    design: Option<String>,
    #[arg(long, value_name = "MODEL", help = "A model that `carvallo models` lists [default: the file's, or Whipple]")]
    model: Option<String>,
    /// Gravitational field strength in N/kg, the same as --set g=G
    #[arg(long, value_name = "G", allow_negative_numbers = true)]
    gravity: Option<String>,
    /// Replaces a parameter; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<Setting>,
    /// A force that follows from the motion, such as 'Tdelta = -10*phi_rate + 3*v*phi'; may be given several times
    #[arg(long, value_name = "FORCE=LAW", allow_hyphen_values = true)]
    feedback: Vec<String>,
    /// Joins a body to a frame: a file, or 'mass=5 kg, at=(0.3, 0, -0.9), to=rear'; may be given several times
    #[arg(long, value_name = "BODY")]
    add: Vec<String>,
}

impl DesignOptions {
    /// Where the parameters come from.
    pub fn request(&self) -> Request {
        let settings = self.set.iter().map(Setting::replacement);
        let gravity = self.gravity.iter().map(|value| (format!("--gravity {value}"), "g".to_owned(), value.clone()));
        Request {
            model: self.model.clone(),
            parameters: self.design.clone(),
            overrides: settings.chain(gravity).collect(),
            feedback: self.feedback.iter().map(|law| (format!("--feedback '{law}'"), law.clone())).collect(),
            bodies: self.add.iter().map(|body| (format!("--add '{body}'"), body.clone())).collect(),
        }
    }

    /// Loads the design, and tells what deserves to be known about its parameters.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn load(&self) -> Result<Design, Failure> {
        load(&self.request())
    }
}

/// Loads a design, and tells what deserves to be known about its parameters.
///
/// # Errors
/// Everything that is wrong with it.
pub fn load(request: &Request) -> Result<Design, Failure> {
    let design = input::load(request)?;
    tell(&design, &design.name);
    Ok(design)
}

/// Tells what deserves to be known about the parameters of a design, by what it is called.
pub fn tell(design: &Design, name: &str) {
    for text in &design.notes {
        note(WARNING, "note", text);
    }
    for text in &design.warnings {
        note(WARNING, "warning", &format!("{name}: {text}"));
    }
}

/// In which units results are shown.
#[derive(Args, Clone, Debug, Default)]
pub struct UnitOptions {
    /// Units in the place of those of the SI, such as mm,deg,km/h,lb; imperial is in,lb,deg,mph,lb*in,lb*in^2,ft/s^2
    #[arg(long, value_name = "UNITS", value_parser = units)]
    units: Option<Units>,
}

fn units(text: &str) -> Result<Units, Problem> {
    Units::parse(text).map_err(|failure| match failure {
        Failure::Input(mut problems) if problems.len() == 1 => problems.remove(0),
        failure => problem(failure.to_string()),
    })
}

impl UnitOptions {
    /// What is asked for.
    pub fn units(&self) -> Units {
        self.units.clone().unwrap_or_default()
    }

    /// What quantities are shown in, by the units that they are declared in.
    pub fn shown(&self) -> impl Fn(&str) -> DisplayUnit + use<> {
        let units = self.units();
        move |declared: &str| units.of(declared)
    }

    /// What speeds are shown in.
    pub fn of_speeds(&self) -> DisplayUnit {
        self.units().of("m/s")
    }
}

/// Tells which units were asked for while nothing was shown in them.
pub fn tell_unused(matches: &ArgMatches) {
    let Some((_, matches)) = matches.subcommand() else { return };
    let units = matches.try_get_one::<Units>("units").ok().flatten();
    let unused: Vec<String> = units.iter().flat_map(|units| units.unused()).map(|unit| format!("`{unit}`")).collect();
    if !unused.is_empty() {
        note(WARNING, "note", &format!("--units: nothing here is in {}", unused.join(", ")));
    }
}

/// `NAME=VALUE`; what they mean depends on the model.
#[derive(Clone, Debug)]
pub struct Setting {
    /// As it was given.
    pub written: String,
    pub name: String,
    pub value: String,
}

impl Setting {
    /// The option as it was given, the name and the value.
    pub fn replacement(&self) -> (String, String, String) {
        (format!("--set {}", self.written), self.name.clone(), self.value.clone())
    }
}

impl FromStr for Setting {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        match text.split_once('=') {
            Some((name, value)) if !name.trim().is_empty() => {
                Ok(Self { written: text.to_owned(), name: name.trim().to_owned(), value: value.to_owned() })
            }
            _ => Err(problem("expected NAME=VALUE, such as mB=90")),
        }
    }
}

/// Speeds in m/s.
#[derive(Clone, Debug)]
pub struct Speeds(pub Vec<f64>);

impl FromStr for Speeds {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        speeds::parse(text).map(Self).map_err(|message| problem(message + &range_meant(text)))
    }
}

/// What was probably meant by `0-10`, as the end of a sentence.
fn range_meant(text: &str) -> String {
    let is_number = |text: &str| text.trim().parse::<f64>().is_ok_and(|number| number >= 0.0);
    match text.split_once('-') {
        Some((low, high)) if is_number(low) && is_number(high) => {
            format!("; did you mean a range, as {}:{}:0.1?", low.trim(), high.trim())
        }
        _ => String::new(),
    }
}

/// One speed in m/s.
#[derive(Clone, Copy, Debug)]
pub struct Speed(pub f64);

impl FromStr for Speed {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self, Problem> {
        speeds::number(text, "the speed").map(Self).map_err(problem)
    }
}

/// How results are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// At a terminal.
    Table,
    /// As tables for a document.
    Document(Language),
    Json,
    Csv,
}

impl Format {
    /// Whether it is for people, who want fewer rows than programs do.
    pub fn is_read(self) -> bool {
        matches!(self, Self::Table | Self::Document(_))
    }
}

/// How lists are printed that are for people alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListFormat {
    /// At a terminal.
    Table,
    /// As a table for a document.
    Document(Language),
}

impl ValueEnum for ListFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Table, Self::Document(Language::Markdown), Self::Document(Language::Latex)]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Table => PossibleValue::new("table"),
            Self::Document(language) => named(*language),
        })
    }
}

fn named(language: Language) -> PossibleValue {
    match language {
        Language::Markdown => PossibleValue::new("markdown").alias("md"),
        Language::Latex => PossibleValue::new("latex").alias("tex"),
    }
}

impl ValueEnum for Format {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Table, Self::Document(Language::Markdown), Self::Document(Language::Latex), Self::Json, Self::Csv]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Table => PossibleValue::new("table"),
            Self::Document(language) => named(*language),
            Self::Json => PossibleValue::new("json"),
            Self::Csv => PossibleValue::new("csv"),
        })
    }
}

/// The file of a picture; its ending names a format.
#[derive(Clone, Debug)]
pub struct Picture(PathBuf);

impl Picture {
    fn new(path: PathBuf) -> Result<Self, Problem> {
        let is = |known: &str| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(known));
        if is("svg") || is("png") { Ok(Self(path)) } else { Err(problem("the name must end in .svg or .png")) }
    }

    /// Where it goes.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// # Errors
    /// If the picture would replace the file that the parameters are read from, or what is no picture.
    pub fn check(&self, design: &DesignOptions) -> Result<(), Failure> {
        self.check_request("--plot", &design.request())
    }

    /// The same for a picture of another option than `--plot`.
    ///
    /// # Errors
    /// If it would replace the file that the parameters are read from, or what is no picture.
    pub fn check_request(&self, option: &str, request: &Request) -> Result<(), Failure> {
        if request.reads(&self.0) {
            return Err(self.problem_of(option, "the parameters are read from this file"));
        }
        if may_be_replaced(&self.0) {
            return Ok(());
        }
        Err(self.problem_of(option, "this file is there, and is no picture: give another name, or remove it"))
    }

    /// That it cannot be drawn as it was asked for.
    pub fn problem(&self, message: impl Into<String>) -> Failure {
        self.problem_of("--plot", message)
    }

    /// The same for a picture of another option than `--plot`.
    pub fn problem_of(&self, option: &str, message: impl Into<String>) -> Failure {
        Failure::at(Place::Option(format!("{option} {}", self.0.display())), message)
    }

    /// Writes a drawing, and tells so.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, scene: &Scene) -> Result<(), Failure> {
        picture::save(scene, &self.0)?;
        wrote(&self.0);
        Ok(())
    }
}

impl ValueParserFactory for Picture {
    type Parser = ValueParser;

    fn value_parser() -> ValueParser {
        PathBufValueParser::new().try_map(Self::new).into()
    }
}

/// What is wrong with the value of an option. Which option it is, is known where the command line is read.
pub fn problem(message: impl Into<String>) -> Problem {
    Problem { place: Place::Nowhere, message: message.into() }
}
