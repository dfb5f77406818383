//! Where the results go.

use std::io::{ErrorKind, Write as _};

use carvallo_design::Failure;
use rayon::prelude::*;

mod journal;
mod store;

use self::store::Store;
use super::plan::Plan;
use super::request::Request;
use super::table::{Column, Designs, Format, Results, joined, parquet_message};
use super::write::{csv, parquet};

/// Where the results go, and how many designs without results went there.
pub struct Destination {
    kind: Kind,
    errors: u64,
}

enum Kind {
    Stdout,
    File(Store),
    /// A file that is complete already.
    Complete,
    /// Only a map was asked for.
    Nowhere,
}

impl Destination {
    /// # Errors
    /// If it may not or cannot be written.
    pub fn open(request: &Request, plan: &Plan) -> Result<Self, Failure> {
        let kind = match &request.output {
            Some(path) => Store::open(path, plan, request.restart)?.map_or(Kind::Complete, Kind::File),
            None if request.map.is_some() => Kind::Nowhere,
            None => Kind::Stdout,
        };
        let errors = if let Kind::File(store) = &kind { store.progress().errors } else { 0 };
        let mut destination = Self { kind, errors };
        let is_empty = match &destination.kind {
            Kind::File(store) => store.progress().bytes == 0,
            _ => true,
        };
        if plan.format == Format::Csv && is_empty {
            destination.put(&[csv::header(&plan.headings)], 0, 0)?;
        }
        Ok(destination)
    }

    /// How many designs are written.
    pub fn designs(&self) -> u64 {
        match &self.kind {
            Kind::File(store) => store.progress().designs,
            Kind::Complete => u64::MAX,
            Kind::Stdout | Kind::Nowhere => 0,
        }
    }

    /// Whether it is the standard output.
    pub fn is_stdout(&self) -> bool {
        matches!(self.kind, Kind::Stdout)
    }

    /// Writes a batch; whether there is still a reader.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&mut self, plan: &Plan, designs: Vec<Designs>, results: Vec<Results>) -> Result<bool, Failure> {
        let errors = results.iter().map(|results| results.errors.iter().flatten().count()).sum();
        let rows: usize = designs.iter().map(|designs| designs.rows).sum();
        self.errors += errors as u64;
        if matches!(self.kind, Kind::Nowhere | Kind::Complete) {
            return Ok(true);
        }
        let sizes: Vec<usize> = designs.iter().map(|designs| designs.rows).collect();
        let shown = |columns: Vec<Column>| {
            columns.into_iter().zip(&plan.shown).map(|(column, unit)| column.shown(unit.as_ref())).collect()
        };
        let tables: Vec<Vec<Column>> = designs.into_iter().zip(results).map(|(d, r)| shown(joined(d, r))).collect();
        let bytes: Vec<Vec<u8>> =
            match plan.format {
                Format::Csv => tables.par_iter().zip(&sizes).map(|(table, rows)| csv::rows(table, *rows)).collect(),
                Format::Parquet => {
                    let part = parquet::part(&plan.headings, &tables);
                    vec![part.map_err(|error| {
                        Failure::Run(format!("cannot write the results: {}", parquet_message(error)))
                    })?]
                }
            };
        self.put(&bytes, rows, errors)
    }

    fn put(&mut self, bytes: &[Vec<u8>], designs: usize, errors: usize) -> Result<bool, Failure> {
        match &mut self.kind {
            Kind::File(store) => store.add(bytes, designs, errors).map(|()| true),
            Kind::Stdout => match bytes.iter().try_for_each(|bytes| std::io::stdout().lock().write_all(bytes)) {
                Ok(()) => Ok(true),
                // A reader that has seen enough is no failure.
                Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
                Err(error) => Err(Failure::Run(format!("cannot write the output: {error}"))),
            },
            Kind::Complete | Kind::Nowhere => Ok(true),
        }
    }

    /// Completes the file; the number of designs without results.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(self, plan: &Plan) -> Result<u64, Failure> {
        match self.kind {
            Kind::File(store) => store.finish(plan.format, &plan.headings)?,
            Kind::Stdout => match std::io::stdout().lock().flush() {
                Err(error) if error.kind() != ErrorKind::BrokenPipe => {
                    return Err(Failure::Run(format!("cannot write the output: {error}")));
                }
                _ => {}
            },
            Kind::Complete | Kind::Nowhere => {}
        }
        Ok(self.errors)
    }
}
