//! Designs of one model, a column for each parameter, and what is computed of them: arrays in the shape of the designs, then
//! in that of the speeds.

use std::ops::Range;

use carvallo::Complex;
use carvallo_design::{Equations, Shipped};
use carvallo_plot::analysis::columns::{Heading, Kind, Layout};
use numpy::{Element, PyArray1, PyArrayDyn, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::at_speeds;
use crate::columns::{Column, Held, Values, gather};
use crate::critical::{self, Critical};
use crate::parts::{Threads, in_parts, threads};
use crate::sheet::Sheet;
use crate::speeds::Speeds;

/// Designs of one model.
#[pyclass(frozen, module = "carvallo._carvallo")]
#[derive(Debug)]
pub struct Designs {
    pub(crate) model: &'static Shipped,
    pub(crate) columns: Vec<Column>,
    /// Empty for one design.
    pub(crate) shape: Vec<usize>,
}

/// Numbers of an array.
pub type Array<'py, T> = Bound<'py, PyArrayDyn<T>>;

impl Designs {
    /// # Errors
    /// If there are not as many columns as parameters, or as many values as the shape has.
    pub fn new(
        model: &'static Shipped,
        columns: Vec<Column>,
        count: Option<usize>,
        shape: Vec<usize>,
    ) -> PyResult<Self> {
        let (expected, found) = (model.info.parameters.len(), columns.len());
        if expected != found {
            let name = model.info.name;
            return Err(PyValueError::new_err(format!("{name} has {expected} parameters; {found} are given")));
        }
        let expected: usize = shape.iter().product();
        match count {
            Some(found) if found != expected => {
                Err(PyValueError::new_err(format!("there are {expected} designs, and columns of {found} values")))
            }
            _ => Ok(Self { model, columns, shape }),
        }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.shape.iter().product()
    }

    /// Which of the designs it is that something is wrong with, before a message.
    fn label(&self, index: usize) -> String {
        let mut place = Vec::new();
        let mut rest = index;
        for length in self.shape.iter().rev() {
            place.push((rest % length).to_string());
            rest /= length;
        }
        place.reverse();
        if place.is_empty() { String::new() } else { format!("design {}: ", place.join(", ")) }
    }

    /// Collects what `fill` adds for each design at the speeds, or, if they are paired, at the speed of its own. Gives the
    /// arrays and the shape of their speeds.
    fn at<T: Element + Copy + Send + Sync, const ARRAYS: usize>(
        &self,
        py: Python<'_>,
        Speeds { values, shape }: Speeds,
        Options { paired, threads, cost }: Options,
        fill: impl Fn(&dyn Equations, f64, &[f64], &mut [Vec<T>; ARRAYS]) -> Result<(), String> + Sync,
    ) -> PyResult<([Vec<T>; ARRAYS], Vec<usize>)> {
        if !paired {
            let cost = cost * values.len();
            let fill = |equations: &dyn Equations, gravity: f64, _: usize, arrays: &mut [Vec<T>; ARRAYS]| {
                fill(equations, gravity, &values, arrays)
            };
            return Ok((self.collect(py, threads, cost, fill)?, shape));
        }
        if shape != self.shape {
            let (designs, speeds) = (&self.shape, shape);
            let message = format!("paired speeds have the shape of the designs: {designs:?}; theirs is {speeds:?}");
            return Err(PyValueError::new_err(message));
        }
        let fill = |equations: &dyn Equations, gravity: f64, index: usize, arrays: &mut [Vec<T>; ARRAYS]| {
            fill(equations, gravity, &values[index..=index], arrays)
        };
        Ok((self.collect(py, threads, cost, fill)?, Vec::new()))
    }

    /// Collects what `fill` adds for each design to lists of numbers, one list for each array that there is to be.
    pub(crate) fn collect<T: Element + Copy + Send + Sync, const ARRAYS: usize>(
        &self,
        py: Python<'_>,
        asked: Option<Threads>,
        cost: usize,
        fill: impl Fn(&dyn Equations, f64, usize, &mut [Vec<T>; ARRAYS]) -> Result<(), String> + Sync,
    ) -> PyResult<[Vec<T>; ARRAYS]> {
        let held = Held::new(py, &self.columns)?;
        let columns = held.values()?;
        let work = |range: Range<usize>| {
            let mut arrays = [const { Vec::new() }; ARRAYS];
            let mut row = Vec::with_capacity(columns.len());
            for index in range {
                let mut fill = |equations: &dyn Equations, gravity: f64| fill(equations, gravity, index, &mut arrays);
                let visited = self.visit(&columns, index, &mut row, &mut fill);
                visited.map_err(|message| format!("{}{message}", self.label(index)))?;
            }
            Ok(arrays)
        };
        let mut parts = in_parts(py, self.count(), (PART / cost.max(1)).max(1), threads(asked), work)?;
        if parts.len() == 1 {
            return Ok(parts.swap_remove(0));
        }
        let mut whole = [const { Vec::new() }; ARRAYS];
        for (index, array) in whole.iter_mut().enumerate() {
            array.reserve_exact(parts.iter().map(|part| part[index].len()).sum());
            parts.iter().for_each(|part| array.extend_from_slice(&part[index]));
        }
        Ok(whole)
    }

    /// The stability of all designs as columns.
    fn fill(&self, py: Python<'_>, layout: &Layout, asked: Option<Threads>) -> PyResult<Sheet> {
        let held = Held::new(py, &self.columns)?;
        let columns = held.values()?;
        let mut sheet = Sheet::new(layout, self.count());
        // Other than known polynomials are found first, which takes milliseconds.
        let size = if self.model.has_known_polynomials() { PART } else { PART / 64 };
        let parts = sheet.parts(size);
        let work = |range: Range<usize>| {
            // Of no designs there is no part.
            let Some(part) = parts.get(range.start / size) else { return Ok(()) };
            let mut part = part.lock().map_err(|_| "a thread has failed".to_owned())?;
            let mut row = Vec::with_capacity(columns.len());
            part.fill(layout, range, |index, look| self.visit(&columns, index, &mut row, look));
            Ok(())
        };
        in_parts(py, self.count(), size, threads(asked), work)?;
        drop(parts);
        Ok(sheet)
    }

    /// Looks at the equations of motion of one design.
    pub(crate) fn visit(
        &self,
        columns: &[Values],
        index: usize,
        row: &mut Vec<f64>,
        look: &mut dyn FnMut(&dyn Equations, f64) -> Result<(), String>,
    ) -> Result<(), String> {
        gather(columns, index, row);
        let gravity = self.model.info.gravity.map_or(0.0, |position| row[position]);
        self.model.visit(row, &mut |equations| look(equations, gravity))
    }

    /// An array in the shape of the designs, then in those that follow.
    fn array<'py, T: Element>(&self, py: Python<'py>, numbers: Vec<T>, inner: &[&[usize]]) -> PyResult<Array<'py, T>> {
        let shape: Vec<usize> =
            std::iter::once(self.shape.as_slice()).chain(inner.iter().copied()).flatten().copied().collect();
        PyArray1::from_vec(py, numbers).reshape(shape)
    }

    fn states(&self) -> usize {
        self.model.eigenvalues()
    }

    fn coordinates(&self) -> usize {
        self.model.info.coordinates.len()
    }
}

/// How what there is at speeds is computed.
#[derive(Clone, Copy)]
struct Options {
    /// Each design at a speed of its own.
    paired: bool,
    /// As many as there are cores, unless it is said.
    threads: Option<Threads>,
    /// How long one speed takes, in some fractions of a microsecond.
    cost: usize,
}

/// Designs in a part, where one takes some microseconds.
const PART: usize = 2048;

#[pymethods]
impl Designs {
    #[getter]
    fn shape(&self) -> Vec<usize> {
        self.shape.clone()
    }

    /// Judges the parameters of all designs.
    fn validate(&self, py: Python<'_>) -> PyResult<()> {
        self.collect::<f64, 0>(py, None, 1, |_, _, _, _| Ok(())).map(|_| ())
    }

    /// Each matrix of the form, in the order M, C-1, C0, C1, Kc, K0, K1, K2.
    fn matrices<'py>(&self, py: Python<'py>, threads: Option<Threads>) -> PyResult<Vec<Array<'py, f64>>> {
        let arrays: [Vec<f64>; 8] = self.collect(py, threads, 1, at_speeds::matrices)?;
        let n = self.coordinates();
        arrays.into_iter().map(|numbers| self.array(py, numbers, &[&[n, n]])).collect()
    }

    /// M, C and K at speeds.
    fn system<'py>(
        &self,
        py: Python<'py>,
        v: Speeds,
        paired: bool,
        threads: Option<Threads>,
    ) -> PyResult<Vec<Array<'py, f64>>> {
        let (arrays, shape) = self.at(py, v, Options { paired, threads, cost: 1 }, at_speeds::system)?;
        let n = self.coordinates();
        arrays.into_iter().map(|numbers| self.array(py, numbers, &[&shape, &[n, n]])).collect()
    }

    /// A and B at speeds.
    fn state_space<'py>(
        &self,
        py: Python<'py>,
        v: Speeds,
        paired: bool,
        threads: Option<Threads>,
    ) -> PyResult<(Array<'py, f64>, Array<'py, f64>)> {
        let ([a, b], shape) = self.at(py, v, Options { paired, threads, cost: 1 }, at_speeds::state_space)?;
        let (states, inputs) = (self.states(), self.coordinates());
        Ok((self.array(py, a, &[&shape, &[states, states]])?, self.array(py, b, &[&shape, &[states, inputs]])?))
    }

    /// The eigenvalues at speeds.
    fn eigenvalues<'py>(
        &self,
        py: Python<'py>,
        v: Speeds,
        paired: bool,
        threads: Option<Threads>,
    ) -> PyResult<Array<'py, Complex<f64>>> {
        let ([values], shape) = self.at(py, v, Options { paired, threads, cost: 1 }, at_speeds::eigenvalues)?;
        self.array(py, values, &[&shape, &[self.states()]])
    }

    /// The eigenvalues at speeds, and of each its right and its left eigenvector.
    fn eigenvectors<'py>(
        &self,
        py: Python<'py>,
        v: Speeds,
        paired: bool,
        threads: Option<Threads>,
    ) -> PyResult<Vec<Array<'py, Complex<f64>>>> {
        let (arrays, shape) = self.at(py, v, Options { paired, threads, cost: 8 }, at_speeds::eigenvectors)?;
        let (states, coordinates) = ([self.states()], [self.states(), self.coordinates()]);
        let shapes: [&[usize]; 3] = [&states, &coordinates, &coordinates];
        arrays.into_iter().zip(shapes).map(|(numbers, inner)| self.array(py, numbers, &[&shape, inner])).collect()
    }

    /// Columns about stability, as headings with what is in the column, the numbers and where there are any; and why a design
    /// has no results.
    fn sheet<'py>(
        &self,
        py: Python<'py>,
        speeds: Vec<f64>,
        threads: Option<Threads>,
    ) -> PyResult<(Vec<SheetColumn<'py>>, Vec<Option<String>>)> {
        let Sheet { headings, cells, present, errors } = self.fill(py, &Layout::new(self.model, speeds), threads)?;
        let columns = headings.into_iter().zip(cells.into_iter().zip(present));
        let column = |(Heading { name, unit, kind }, (cells, present)): (Heading, (Vec<f64>, Vec<bool>))| {
            let kind = match kind {
                Kind::Count => "count",
                Kind::Number => "number",
                Kind::Text => "verdict",
            };
            Ok((name, unit, kind, self.array(py, cells, &[])?, self.array(py, present, &[])?))
        };
        Ok((columns.map(column).collect::<PyResult<_>>()?, errors))
    }

    /// The critical speeds of one design, the ranges in which it is stable, and those in which one may be missing.
    fn critical(&self, py: Python<'_>) -> PyResult<Critical> {
        let held = Held::new(py, &self.columns)?;
        let (columns, mut found) = (held.values()?, Critical::default());
        let looked = self.visit(&columns, 0, &mut Vec::new(), &mut |equations, gravity| {
            let stability = equations.stability(gravity).map_err(|error| error.to_string())?;
            found = critical::of(&stability, self.model.info);
            Ok(())
        });
        looked.map_err(PyValueError::new_err)?;
        Ok(found)
    }
}

/// The heading of a column, its unit, what is in it, its numbers, and whether there is one.
type SheetColumn<'py> = (String, &'static str, &'static str, Array<'py, f64>, Array<'py, bool>);
