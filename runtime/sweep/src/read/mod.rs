//! Designs from a file: a row each.

mod chunk;
mod csv;
mod lines;
mod parquet;
mod rows;

use std::path::{Path, PathBuf};

use carvallo::ModelInfo;
use carvallo_design::parameter::find;
use carvallo_design::{Failure, Place, Problem};

pub use self::rows::Named;

use self::rows::Rows;
use super::table::{Designs, Format};

/// Columns that are no parameters; they are copied to the result.
const COPIED: [&str; 5] = ["name", "id", "index", "bike", "bicycle"];

/// A file of designs, of which the columns are known.
pub struct File {
    pub path: PathBuf,
    format: Format,
    info: &'static ModelInfo,
    pub columns: Vec<Named>,
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
        // Files are read more than once, and reading others may never end.
        if std::fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
            return Err(Failure::at(Place::Option(format!("--designs {label}")), "expected a regular file"));
        }
        let names = match format {
            Format::Csv => csv::names(path)?,
            Format::Parquet => parquet::names(path)?,
        };
        let mut problems = Vec::new();
        let mut problem = |message| problems.push(Problem { place: Place::File(label.clone()), message });
        let mut columns: Vec<Named> = Vec::new();
        for (at, name) in names.into_iter().enumerate() {
            // Tables of pandas begin with an index that has no name.
            let name = if at == 0 && name.is_empty() { "index".to_owned() } else { name };
            if columns.iter().any(|other| other.name == name) {
                problem(format!("there are two columns `{name}`"));
            }
            let position = match find(&name, info) {
                Ok(position) => Some(position),
                Err(_) if COPIED.contains(&name.as_str()) => None,
                Err(_) if name.is_empty() => {
                    problem(format!("column {} has no name", at + 1));
                    None
                }
                Err(message) => {
                    problem(format!("column {message}"));
                    None
                }
            };
            let other = columns.iter().find(|other| position.is_some() && other.position == position);
            if let Some(other) = other.filter(|other| other.name != name) {
                problem(format!("columns `{}` and `{name}` are the same parameter", other.name));
            }
            columns.push(Named { name, position });
        }
        if columns.iter().all(|column| column.position.is_none()) && problems.is_empty() {
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
        let file = Self { path: path.to_owned(), format, info, columns, has_both_signs };
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
        let mut rows = Rows::new(&self.columns, self.info, most);
        match records {
            Records::Csv(records) => records.read(&mut rows, most)?,
            Records::Parquet(records) => records.read(&mut rows, most)?,
        }
        Ok(rows.designs)
    }
}
