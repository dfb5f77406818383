//! Everything that can be wrong with a request, told at once.

use std::path::{Path, PathBuf};

use carvallo::MatrixName;
use carvallo_design::conventions::{Naming, Varying};
use carvallo_design::input::{given_twice, is_same_file};
use carvallo_design::number::shortest;
use carvallo_design::{Capacity, Failure, Place, Problem, Shipped, speeds};
use carvallo_plot::picture::{MOST_CELLS, may_be_replaced};

use crate::generate::{Axis, MEASURED, Random};
use crate::request::Request;
use crate::table::Format;

/// More speeds than this would make tables that nobody reads.
const MAX_SPEEDS: usize = 100;

/// What was asked for, with everything in it that can be validated without reading a file.
pub struct Validated {
    pub naming: Naming,
    pub vary: Vec<Axis>,
    pub random: Vec<Random>,
    /// Whether all others are drawn as they were measured.
    pub is_measured: bool,
    pub speeds: Vec<f64>,
    pub format: Format,
    pub file: Option<(PathBuf, Format)>,
}

/// # Errors
/// Everything that is wrong with the request for a model.
pub fn validate(request: &Request, model: &Shipped) -> Result<Validated, Failure> {
    let info = model.info;
    let mut problems = Problems::default();
    let options = request.vary.iter().chain(request.random.iter().filter(|text| !is_measured(text)));
    let naming = Naming::new(info, options.map(|text| name_of(text)));
    let (vary, random) = problems.parameters(request, &naming);
    let format = request.output.as_deref().map_or(Format::Csv, |path| problems.table("--output", path));
    let file = request.designs.clone().map(|path| {
        let format = problems.table("--designs", &path);
        (path, format)
    });
    problems.paths(request);
    let speeds = request.eigenvalues.as_ref().map(|text| problems.speeds(text)).unwrap_or_default();
    if let (true, Some(text)) = (info.matrices.contains(&MatrixName::Cm1), &request.eigenvalues)
        && speeds.contains(&0.0)
    {
        let message = format!("at 0 m/s {} has no eigenvalues, since C-1 is divided by the speed", info.name);
        problems.option("--eigenvalues", text, message);
    }
    if Capacity::of(model).is_none() && request.eigenvalues.is_none() {
        let nothing = format!("nothing in the model {} depends on the speed", info.name);
        problems.add(Place::Nowhere, format!("{nothing}: give --eigenvalues SPEEDS"));
    }
    if let Some(path) = &request.map {
        problems.map(path, request, &vary);
    }
    if problems.all.is_empty() {
        let is_measured = request.random.iter().any(|text| is_measured(text));
        Ok(Validated { naming, vary, random, is_measured, speeds, format, file })
    } else {
        Err(Failure::Input(problems.all))
    }
}

/// What stands before the equals sign.
fn name_of(text: &str) -> &str {
    text.split('=').next().unwrap_or_default().trim()
}

fn is_measured(text: &str) -> bool {
    text.trim() == MEASURED
}

/// Collects what is wrong.
#[derive(Default)]
struct Problems {
    all: Vec<Problem>,
}

impl Problems {
    fn add(&mut self, place: Place, message: impl Into<String>) {
        self.all.push(Problem { place, message: message.into() });
    }

    fn option(&mut self, option: &str, value: &str, message: impl Into<String>) {
        self.add(Place::Option(format!("{option} {value}")), message);
    }

    /// What varies and what is drawn.
    fn parameters(&mut self, request: &Request, naming: &Naming) -> (Vec<Axis>, Vec<Random>) {
        let vary = self.each("--vary", &request.vary, |text| Axis::parse(text, naming));
        let alone: Vec<String> = request.random.iter().filter(|text| !is_measured(text)).cloned().collect();
        let random = self.each("--random", &alone, |text| Random::parse(text, naming));
        let varied = request.vary.iter().map(|text| ("--vary", text));
        let base = &request.base;
        let settings = base.overrides.iter().map(|(option, name, _)| (option.clone(), name.as_str()));
        let mut given: Vec<(String, &str)> = settings.collect();
        let meaning = |name: &str| naming.find(name).ok();
        for (option, text) in varied.chain(request.random.iter().map(|text| ("--random", text))) {
            let name = name_of(text);
            let own: Option<Varying> = meaning(name);
            // What is set and what varies may well stand in each other's place: then the latter is kept no more.
            let is_same = |first: &str, other: &str| match (&own, meaning(other)) {
                _ if other == name => true,
                (Some(own), Some(other)) if first.starts_with("--set") => own.is(&other),
                (Some(own), Some(other)) => own.is_in_place_of(&other, naming),
                _ => false,
            };
            if let Some((first, other)) = given.iter().find(|(first, other)| is_same(first, other)) {
                let message = match own.as_ref().zip(meaning(other)).is_none_or(|(own, other)| own.is(&other)) {
                    true => given_twice(name, other, first),
                    false => format!("`{name}` stands in the place of `{other}`, which varies, too, at {first}"),
                };
                self.option(option, text, message);
            }
            given.push((format!("{option} {text}"), name));
        }
        match (request.samples, request.random.is_empty()) {
            (None, false) => self.add(Place::Nowhere, "--random needs --samples COUNT"),
            (Some(_), true) => self.add(Place::Nowhere, "--samples needs --random NAME=VALUES"),
            (Some(0), false) => self.option("--samples", "0", "expected at least 1"),
            _ => {}
        }
        if request.seed.is_some() && request.random.is_empty() {
            self.add(Place::Nowhere, "--seed needs --random NAME=VALUES");
        }
        if request.vary.is_empty() && request.random.is_empty() && request.designs.is_none() {
            self.add(Place::Nowhere, "nothing varies: expected --vary, --random or --designs");
        }
        (vary, random)
    }

    fn each<V>(&mut self, option: &str, texts: &[String], parse: impl Fn(&str) -> Result<V, String>) -> Vec<V> {
        let mut values = Vec::new();
        for text in texts {
            match parse(text) {
                Ok(value) => values.push(value),
                Err(message) => self.option(option, text, message),
            }
        }
        values
    }

    /// The format of a table by the ending of its name.
    fn table(&mut self, option: &str, path: &Path) -> Format {
        Format::of(path).unwrap_or_else(|| {
            self.option(option, &path.display().to_string(), "the name must end in .csv or .parquet");
            Format::Csv
        })
    }

    /// Whether the results would replace what is read, or a map what is no picture.
    fn paths(&mut self, request: &Request) {
        for (option, path) in [("--output", &request.output), ("--map", &request.map)] {
            let Some(path) = path else { continue };
            let shown = path.display().to_string();
            if request.designs.as_ref().is_some_and(|designs| is_same_file(designs, path)) {
                self.option(option, &shown, "the designs are read from this file");
            } else if request.base.reads(path) {
                self.option(option, &shown, "the parameters are read from this file");
            } else if option == "--map" && !may_be_replaced(path) {
                self.option(option, &shown, "this file is there, and is no picture: give another name, or remove it");
            }
        }
    }

    /// The speeds of eigenvalues.
    fn speeds(&mut self, text: &str) -> Vec<f64> {
        let speeds = speeds::parse(text).and_then(|speeds| {
            if speeds.len() > MAX_SPEEDS {
                return Err(format!("there are {} speeds; there must be at most {MAX_SPEEDS}", speeds.len()));
            }
            match speeds.iter().enumerate().find(|(index, speed)| speeds[..*index].contains(speed)) {
                Some((_, speed)) => Err(format!("the speed {} is given twice", shortest(*speed))),
                None => Ok(speeds),
            }
        });
        speeds.unwrap_or_else(|message| {
            self.option("--eigenvalues", text, message);
            Vec::new()
        })
    }

    /// Whether there is a map to draw.
    fn map(&mut self, path: &Path, request: &Request, vary: &[Axis]) {
        let path = path.display().to_string();
        if ![".svg", ".png"].iter().any(|ending| path.to_lowercase().ends_with(ending)) {
            self.option("--map", &path, "the name must end in .svg or .png");
        }
        if request.vary.len() != 2 || !request.random.is_empty() {
            self.option("--map", &path, "a map needs two parameters that vary by --vary, and no others");
        } else if let [x, y] = vary {
            if [x, y].iter().any(|axis| axis.values.iter().all(|value| *value == axis.values[0])) {
                self.option("--map", &path, "a map needs at least two values of each parameter");
            } else if x.values.len() * y.values.len() > MOST_CELLS {
                self.option("--map", &path, format!("a map shows at most {MOST_CELLS} designs"));
            }
        }
    }
}
