//! Designs from a file: a row each.

mod chunk;
mod csv;
mod heading;
mod lines;
mod parquet;
mod rows;

use std::path::{Path, PathBuf};

use carvallo::ModelInfo;
use carvallo_design::conventions::{Naming, Varying};
use carvallo_design::input::is_folder;
use carvallo_design::quantity::scale;
use carvallo_design::{Failure, Place, Problem};

pub use self::rows::Named;

use self::heading::Heading;
use self::rows::{Rows, Unit};
use super::plan::ERROR;
use super::table::{Designs, Format};

/// Columns that are no parameters; they are copied to the result.
const COPIED: [&str; 5] = ["name", "id", "index", "bike", "bicycle"];

/// The names of the columns of a table.
///
/// # Errors
/// If it cannot be read.
pub fn names(path: &Path, format: Format) -> Result<Vec<String>, Failure> {
    match format {
        Format::Csv => csv::names(path),
        Format::Parquet => parquet::names(path),
    }
}

/// A file of designs, of which the columns are known.
pub struct File {
    pub path: PathBuf,
    format: Format,
    /// What the names of its columns mean.
    pub naming: Naming,
    pub columns: Vec<Named>,
    /// What is to be known of them.
    pub notes: Vec<String>,
    /// Whether decimals in its texts stand behind points and behind commas.
    has_both_signs: bool,
}

/// The rows of a file, one after the other.
pub enum Records {
    Csv(csv::Records),
    Parquet(parquet::Records),
}

impl File {
    /// # Errors
    /// If the file cannot be read, and everything that is wrong with its columns.
    pub fn open(path: &Path, format: Format, info: &'static ModelInfo) -> Result<Self, Failure> {
        let label = path.display().to_string();
        if !path.exists() {
            return Err(Failure::usage(format!("there is no file {label}")));
        }
        if path.is_dir() {
            return Err(Failure::usage(is_folder(&label)));
        }
        // Files are read more than once, and reading others may never end.
        if std::fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
            return Err(Failure::Run(format!("cannot read {label}: expected a regular file")));
        }
        let names = names(path, format)?;
        if is_result(&names) {
            let message =
                "it is the result of a sweep; expected a table of designs, whose columns are parameters alone";
            return Err(Failure::at(Place::File(label), message));
        }
        let mut problems = Vec::new();
        let mut problem = |message| problems.push(Problem { place: Place::File(label.clone()), message });
        let mut columns: Vec<Named> = Vec::new();
        let mut notes = Vec::new();
        // Tables of pandas begin with an index that has no name.
        let unnamed = |(at, name): (usize, String)| if at == 0 && name.is_empty() { "index".to_owned() } else { name };
        let names: Vec<String> = names.into_iter().enumerate().map(unnamed).collect();
        let mut headings: Vec<Heading> = names.iter().map(|name| Heading::parse(name, info)).collect();
        let is_copied = |name: &str| COPIED.iter().any(|copied| name.eq_ignore_ascii_case(copied));
        let own = headings.iter_mut().filter(|heading| !is_copied(&heading.name) && !heading.name.is_empty());
        let naming = heading::naming(info, own.collect());
        for (at, (name, heading)) in names.into_iter().zip(headings).enumerate() {
            if columns.iter().any(|other| other.name == name) {
                problem(format!("there are two columns `{name}`"));
            }
            let parameter = match naming.column(&heading.name) {
                Ok(parameter) => Some(parameter),
                Err(_) if is_copied(&name) => None,
                Err(_) if name.is_empty() => {
                    problem(format!("column {} has no name", at + 1));
                    None
                }
                Err(_) if let Some(reason) = naming.ignored(&heading.name) => {
                    notes.push(format!("{label}: `{name}` is copied and changes nothing: {reason}"));
                    None
                }
                Err(message) => {
                    problem(format!("column {message}"));
                    None
                }
            };
            let is_same =
                |other: &&Named| parameter.as_ref().zip(other.parameter.as_ref()).is_some_and(|(a, b)| a.is(b));
            let other = columns.iter().find(is_same);
            if let Some(other) = other.filter(|other| other.name != name) {
                problem(format!("columns `{}` and `{name}` are the same parameter", other.name));
            }
            let unit = heading.unit.zip(parameter.as_ref()).map(|(written, parameter)| {
                let scale = scale(&written, parameter.info.unit);
                (written, scale, parameter.info)
            });
            let unit = match unit {
                Some((written, None, info)) => {
                    let unit = with_unit_of(info.unit);
                    problem(format!("column `{name}` has the unit `{written}`; `{}` is {unit}", info.name));
                    None
                }
                Some((written, Some(scale), _)) => Some(Unit { written, scale }),
                None => None,
            };
            columns.push(Named { name, parameter, unit });
        }
        if columns.iter().all(|column| column.parameter.is_none()) && problems.is_empty() {
            problems
                .push(Problem { place: Place::File(label.clone()), message: "no column is a parameter".to_owned() });
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        let has_both_signs = match format {
            Format::Csv => csv::check(path, &columns)?,
            Format::Parquet => parquet::check(path, &columns).map(|()| false)?,
        };
        let parameters = || columns.iter().filter_map(|column| column.parameter.as_ref());
        let second = |other: &Varying| parameters().find_map(|counts| naming.second(counts, other));
        notes.extend(parameters().filter_map(second).map(|text| format!("{label}: {text}")));
        let file = Self { path: path.to_owned(), format, naming, columns, notes, has_both_signs };
        if file.designs(&mut file.records()?, 1)?.rows == 0 {
            let message = "there is no design: no row follows the names of the columns";
            return Err(Failure::at(Place::File(label), message));
        }
        Ok(file)
    }

    /// # Errors
    /// If the file cannot be read.
    pub fn records(&self) -> Result<Records, Failure> {
        Ok(match self.format {
            Format::Csv => Records::Csv(csv::Records::open(&self.path, self.has_both_signs)?),
            Format::Parquet => Records::Parquet(parquet::Records::open(&self.path)?),
        })
    }

    /// The next designs, at most so many.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn designs(&self, records: &mut Records, most: usize) -> Result<Designs, Failure> {
        let mut rows = Rows::new(&self.columns, &self.naming, most);
        match records {
            Records::Csv(records) => records.read(&mut rows, most)?,
            Records::Parquet(records) => records.read(&mut rows, most)?,
        }
        Ok(rows.designs)
    }
}

/// Whether columns are those of a result: the last one says why a design has none, and one before it how often something
/// happens, or a verdict.
fn is_result(names: &[String]) -> bool {
    let is_of_results = |name: &String| name == "stable_count" || name.starts_with("verdict_at_");
    names.last().is_some_and(|name| name == ERROR) && names.iter().any(is_of_results)
}

/// `in m`, or what has no unit is.
fn with_unit_of(unit: &str) -> String {
    match carvallo_design::number::unit(unit) {
        unit if unit.is_empty() => "a pure number".to_owned(),
        unit => format!("in {unit}"),
    }
}
