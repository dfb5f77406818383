//! Pictures of one design.

use carvallo_design::Failure;
use carvallo_plot::analysis::Analysis;
use carvallo_plot::picture::{Limits, draw_eigenvalues, draw_side_view};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;

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
            for (name, limits) in [("v", Some(x)), ("values", values)] {
                if let Some((low, high)) = limits.filter(|(low, high)| !(low < high && high.is_finite())) {
                    return Err(Failure::usage(format!(
                        "`{name}` is from {low} to {high}; it must be from less to more"
                    )));
                }
            }
            if x.0 < 0.0 {
                return Err(Failure::usage(format!("the speed is {} m/s; it must be >= 0", x.0)));
            }
            Ok(draw_eigenvalues(&analysis, Limits { x, y: values })?.svg())
        };
        py.detach(draw).map_err(raise)
    }

    /// The side view of a bicycle, as SVG; none of other models.
    fn side_view_svg(&self, py: Python<'_>, about: About) -> PyResult<Option<String>> {
        let design = self.described(py, about)?.build().map_err(raise)?;
        Ok(draw_side_view(&design).map(|(scene, _)| scene.svg()))
    }
}
