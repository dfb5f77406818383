//! From designs to results: the part of a sweep that computes.

use std::any::Any;
use std::borrow::Cow;
use std::slice::IterMut;

use carvallo::{Coefficients, Complex, CriticalKind, Model, ModelInfo, Stability, Verdict};

use super::columns::Column;
use super::layout::{Layout, Most};
use crate::analysis;
use crate::model::Shipped;
use crate::number::with_unit;

/// Some designs, in columns.
#[derive(Debug)]
pub struct Designs {
    pub rows: usize,
    /// As they are written to the result.
    pub columns: Vec<Column>,
    /// Why a row is no design.
    pub faults: Vec<Option<String>>,
}

/// The results of some designs, in columns.
#[derive(Debug)]
pub struct Results {
    pub columns: Vec<Column>,
    pub errors: Vec<Option<String>>,
}

/// What is the same for all designs.
#[derive(Debug)]
pub struct Task {
    /// The parameters that no column gives.
    pub base: Vec<f64>,
    /// For each column of the designs the position of its parameter, if it is one.
    pub positions: Vec<Option<usize>>,
    pub layout: Layout,
    pub evaluate: Evaluate,
}

/// The results of designs, for one of the models.
pub type Evaluate = fn(&Task, &Designs) -> Results;

static EVALUATORS: &[(&ModelInfo, Evaluate)] = &carvallo_models::each_model!(evaluator);

const fn evaluator<const N: usize, M: Model<N, Scalar = f64>>() -> (&'static ModelInfo, Evaluate) {
    (M::INFO, evaluate::<N, M>)
}

/// The function for a model.
pub fn of(model: &Shipped) -> Option<Evaluate> {
    EVALUATORS.iter().find(|(info, _)| model.is_called(info.name)).map(|(_, evaluate)| *evaluate)
}

fn evaluate<const N: usize, M: Model<N, Scalar = f64>>(task: &Task, designs: &Designs) -> Results {
    let headings = task.layout.headings();
    let mut columns: Vec<Column> =
        headings.into_iter().map(|heading| Column::new(heading.kind, designs.rows)).collect();
    let mut errors = Vec::with_capacity(designs.rows);
    let mut values = task.base.clone();
    let mut spectra = Spectra::default();
    for row in 0..designs.rows {
        let found = match &designs.faults[row] {
            Some(fault) => Err(fault.clone()),
            None => {
                for (column, position) in designs.columns.iter().zip(&task.positions) {
                    if let (Some(position), Some(value)) = (position, column.number(row)) {
                        values[*position] = value;
                    }
                }
                design::<N, M>(&task.layout, &values, &mut spectra)
            }
        };
        match found {
            Ok(stability) => {
                let mut cells = Cells(columns.iter_mut());
                if let (Some(stability), Some(most)) = (&stability, &task.layout.critical) {
                    cells.stability(stability, most);
                }
                for (verdict, eigenvalues) in spectra.verdicts.iter().zip(spectra.eigenvalues.chunks(2 * N)) {
                    cells.eigenvalues(*verdict, eigenvalues);
                }
                errors.push(None);
            }
            Err(error) => {
                columns.iter_mut().for_each(Column::push_none);
                errors.push(Some(error));
            }
        }
    }
    Results { columns, errors }
}

/// What there is at the speeds, for one design after the other.
#[derive(Default)]
struct Spectra {
    verdicts: Vec<Verdict>,
    /// Those at one speed after those at another.
    eigenvalues: Vec<Complex<f64>>,
}

/// The stability of one design, if it has two coordinates; and the eigenvalues at all speeds.
fn design<const N: usize, M: Model<N, Scalar = f64>>(
    layout: &Layout,
    values: &[f64],
    spectra: &mut Spectra,
) -> Result<Option<Stability>, String> {
    let model = M::from_slice(values).map_err(|error| error.to_string())?;
    model.validate().map_err(|error| {
        let value = with_unit(error.value, error.unit);
        format!("`{}` is {value}; it must be {}", error.subject, error.required)
    })?;
    let (coefficients, gravity) = (model.coefficients(), model.gravity().unwrap_or(0.0));
    let two: Option<&Coefficients<f64, 2>> = (&coefficients as &dyn Any).downcast_ref();
    let stability = two.map(|two| Stability::new(two, gravity)).transpose().map_err(|error| error.to_string())?;
    if let (Some(stability), Some(most)) = (&stability, &layout.critical) {
        most.holds(stability)?;
    }
    spectra.verdicts.clear();
    spectra.eigenvalues.clear();
    for &speed in &layout.speeds {
        let fail = |error| format!("at {speed} m/s: {error}");
        let eigenvalues = &mut spectra.eigenvalues;
        let first = eigenvalues.len();
        match two {
            // Without allocation.
            Some(two) => {
                let found = two.at(speed, gravity).and_then(|system| system.quartic_eigenvalues());
                eigenvalues.extend(found.map_err(fail)?);
            }
            None => {
                let found = coefficients.at(speed, gravity).and_then(|system| system.eigenvalues());
                eigenvalues.extend(found.map_err(fail)?);
            }
        }
        spectra.verdicts.push(match &stability {
            Some(stability) => stability.verdict(speed).map_err(fail)?,
            None => analysis::verdict(&spectra.eigenvalues[first..]),
        });
    }
    Ok(stability)
}

impl Most {
    /// Nothing is left out unseen.
    fn holds(&self, stability: &Stability) -> Result<(), String> {
        let count = |kind| of_kind(stability, kind).count();
        for (found, most, what) in [
            (count(CriticalKind::Weave), self.weave, "weave speeds"),
            (count(CriticalKind::Capsize), self.capsize, "capsize speeds"),
            (count(CriticalKind::DoubleRoot), self.double_root, "double-root speeds"),
            (stability.stable_ranges.len(), self.stable, "stable ranges"),
        ] {
            if found > most {
                return Err(format!("it has {found} {what}; there are columns for {most}"));
            }
        }
        Ok(())
    }
}

fn of_kind(stability: &Stability, kind: CriticalKind) -> impl Iterator<Item = f64> {
    let speeds = stability.critical_speeds.iter().filter(move |critical| critical.kind == kind);
    speeds.map(|critical| critical.speed)
}

/// The columns that the next values of a row go to.
struct Cells<'a>(IterMut<'a, Column>);

impl Cells<'_> {
    fn stability(&mut self, stability: &Stability, most: &Most) {
        for (kind, most) in [
            (CriticalKind::Weave, most.weave),
            (CriticalKind::Capsize, most.capsize),
            (CriticalKind::DoubleRoot, most.double_root),
        ] {
            self.count(of_kind(stability, kind).count());
            let mut speeds = of_kind(stability, kind);
            (0..most).for_each(|_| self.number(speeds.next()));
        }
        self.count(stability.stable_ranges.len());
        for index in 0..most.stable {
            let range = stability.stable_ranges.get(index);
            self.number(range.map(|range| range.from));
            self.number(range.and_then(|range| range.to));
        }
    }

    fn eigenvalues(&mut self, verdict: Verdict, eigenvalues: &[Complex<f64>]) {
        if let Some(Column::Texts(values)) = self.0.next() {
            values.push(Some(Cow::Borrowed(match verdict {
                Verdict::Stable => "stable",
                Verdict::Marginal => "marginal",
                Verdict::Unstable => "unstable",
            })));
        }
        for eigenvalue in eigenvalues {
            self.number(Some(eigenvalue.re));
            self.number(Some(eigenvalue.im));
        }
    }

    fn number(&mut self, value: Option<f64>) {
        if let Some(Column::Numbers(values)) = self.0.next() {
            values.push(value);
        }
    }

    fn count(&mut self, count: usize) {
        if let Some(Column::Counts(values)) = self.0.next() {
            values.push(i32::try_from(count).ok());
        }
    }
}
