//! Pictures of one design.

use carvallo_design::Failure;
use carvallo_design::units::Units;
use carvallo_plot::analysis::Analysis;
use carvallo_plot::picture::{Limits, MOST_SPEEDS, draw_eigenvalues, draw_locus, draw_phasors, draw_side_view};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;

/// That a range goes from less to more.
pub fn limited(name: &str, (low, high): (f64, f64)) -> Result<(), Failure> {
    if low < high && high.is_finite() {
        return Ok(());
    }
    Err(Failure::usage(format!("`{name}` is from {low} to {high}; it must be from less to more")))
}

/// That speeds go from less to more, and not backward.
fn forward((low, high): (f64, f64)) -> Result<(), Failure> {
    limited("v", (low, high))?;
    if low < 0.0 { Err(Failure::usage(format!("the speed is {low} m/s; it must be >= 0"))) } else { Ok(()) }
}

#[pymethods]
impl Designs {
    /// The eigenvalues between two speeds, or as far as there is something to see, as SVG.
    fn eigenvalues_svg(
        &self,
        py: Python<'_>,
        about: About,
        v: Option<(f64, f64)>,
        values: Option<(f64, f64)>,
    ) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            let analysis = Analysis::new(described.build()?)?;
            let x = v.unwrap_or((0.0, analysis.reach));
            forward(x)?;
            values.map_or(Ok(()), |values| limited("values", values))?;
            Ok(draw_eigenvalues(&analysis, Limits { x, y: values })?.svg())
        };
        py.detach(draw).map_err(raise)
    }

    /// The side view of a bicycle, as SVG; none of other models.
    fn side_view_svg(&self, py: Python<'_>, about: About) -> PyResult<Option<String>> {
        let design = self.described(py, about)?.build().map_err(raise)?;
        Ok(draw_side_view(&design, &Units::default()).map(|(scene, _)| scene.svg()))
    }

    /// The eigenvalues in the complex plane while the speed grows from one to another, as SVG.
    fn locus_svg(&self, py: Python<'_>, about: About, v: Option<(f64, f64)>) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            let design = described.build()?;
            if !design.model.depends_on_speed() {
                let nothing = format!("nothing in the model {} depends on the speed", design.info().name);
                return Err(Failure::usage(format!("{nothing}, so there is no root locus along it")));
            }
            let analysis = Analysis::new(design)?;
            let (low, high) = v.unwrap_or((0.0, analysis.reach));
            forward((low, high))?;
            Ok(draw_locus(&analysis, (low, high))?.svg())
        };
        py.detach(draw).map_err(raise)
    }

    /// The eigenvectors at speeds as arrows on dials, as SVG.
    fn phasors_svg(&self, py: Python<'_>, about: About, speeds: Vec<f64>) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            if speeds.len() > MOST_SPEEDS {
                let count = speeds.len();
                return Err(Failure::usage(format!(
                    "there are {count} speeds; the picture has room for {MOST_SPEEDS}"
                )));
            }
            let analysis = Analysis::new(described.build()?)?;
            let rows = analysis.rows(&speeds)?;
            if rows.values().is_empty() {
                return Err(Failure::usage("at rest there are no equations of motion"));
            }
            let shapes = rows.values().into_iter().map(|(speed, values)| analysis.shapes(speed, values));
            let shapes = shapes.collect::<Result<Vec<_>, _>>()?;
            Ok(draw_phasors(&analysis, &rows, &shapes).svg())
        };
        py.detach(draw).map_err(raise)
    }
}
