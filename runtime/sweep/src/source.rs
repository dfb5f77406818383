//! Where the designs of a sweep come from, and the way to them.

use carvallo_design::conventions::Varying;
use carvallo_design::{Design, Failure};
use rayon::prelude::*;

use super::generate::Generator;
use super::read::{File, Named, Records};
use super::table::{Designs, Heading};

/// The designs that one core computes before it looks for more: small enough for its cache.
const CHUNK: usize = 512;

/// Where the designs come from.
pub enum Source {
    Generated(Generator),
    File(File),
}

impl Source {
    /// The columns of the designs, and for each its parameter, if it is one.
    pub fn headings(&self, design: &Design) -> (Vec<Heading>, Vec<Option<Varying>>) {
        let parameter = |varying: Varying| (Heading::number(varying.info.name, varying.info.unit), Some(varying));
        match self {
            Self::Generated(generator) => generator.parameters(design.info()).into_iter().map(parameter).unzip(),
            Self::File(file) => {
                let heading = |Named { name, parameter: own, .. }: &Named| match own {
                    Some(own) => parameter(own.clone()),
                    None => (Heading::text(name.clone()), None),
                };
                file.columns.iter().map(heading).unzip()
            }
        }
    }
}

/// The designs, one batch after the other.
pub enum Batches<'a> {
    Generated(&'a Generator),
    /// Those of a file come in its order.
    File(&'a File, Box<Records>),
}

impl<'a> Batches<'a> {
    /// # Errors
    /// If a file cannot be read.
    pub fn new(source: &'a Source) -> Result<Self, Failure> {
        Ok(match source {
            Source::Generated(generator) => Self::Generated(generator),
            Source::File(file) => Self::File(file, Box::new(file.records()?)),
        })
    }

    /// How many designs there are, where that is known.
    pub fn total(&self) -> Option<u64> {
        match self {
            Self::Generated(generator) => generator.total(),
            Self::File(..) => None,
        }
    }

    /// At most so many designs from one on, in chunks.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub fn next(&mut self, first: u64, most: usize) -> Result<Vec<Designs>, Failure> {
        match self {
            Self::Generated(generator) => {
                let left = generator.total().unwrap_or(0).saturating_sub(first).min(most as u64) as usize;
                let chunks: Vec<usize> = (0..left).step_by(CHUNK).collect();
                let designs = |&start: &usize| generator.designs(first + start as u64, CHUNK.min(left - start));
                Ok(chunks.par_iter().map(designs).collect())
            }
            Self::File(file, records) => {
                let chunks = (0..most).step_by(CHUNK);
                chunks.map(|start| file.designs(records, CHUNK.min(most - start))).collect()
            }
        }
    }
}
